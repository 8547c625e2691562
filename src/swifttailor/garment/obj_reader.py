"""Reader of Wavefront OBJ that keeps the stitched vertices, the groups and the polylines."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from swifttailor.errors import InputError
from swifttailor.garment.seam_names import read_seam_name
from swifttailor.garment.triangle_mesh import TriangleMesh


def read_obj(path: Path | str) -> TriangleMesh:
    """Reads an OBJ file: positions as they are in the file, polygons as fans of triangles.

    Raises:
        InputError: The file cannot be read or is no OBJ mesh; the message gives the line.
    """
    path = Path(path)
    try:
        text = path.read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        raise InputError(f"Cannot read '{path}': {error.strerror or error}.") from error
    parts = _Parts()
    for number, line in enumerate(text.splitlines(), start=1):
        words = line.split()
        if not words or words[0].startswith("#"):
            continue
        try:
            parts.take(words)
        except (ValueError, IndexError) as error:
            raise InputError(
                f"'{path}', line {number}: cannot read {line[:60]!r} ({error}). "
                "An OBJ mesh has lines such as 'v 0 1 0' and 'f 1 2 3'."
            ) from None
    if not parts.faces:
        raise InputError(f"'{path}' holds no faces. Give an OBJ file with a triangle or polygon mesh.")
    return parts.mesh()


class _Parts:
    """What the lines of a file say, as far as it has been read."""

    def __init__(self) -> None:
        self.vertices: list[list[float]] = []
        self.uv: list[list[float]] = []
        self.faces: list[tuple[int, int, int]] = []
        self.uv_faces: list[tuple[int, int, int]] = []
        self.lines: list[np.ndarray] = []
        self.line_names: list[str] = []
        self.groups: dict[str, int] = {}
        self.face_group: list[int] = []
        self.current = ""

    def take(self, words: list[str]) -> None:
        """Reads one line, split into words."""
        kind = words[0]
        if kind == "v":
            self.vertices.append([float(words[1]), float(words[2]), float(words[3])])
        elif kind == "vt":
            self.uv.append([float(words[1]), float(words[2]) if len(words) > 2 else 0.0])
        elif kind == "f":
            self._take_face(words[1:])
        elif kind == "l":
            count = len(self.vertices)
            self.lines.append(np.array([_index(w.split("/")[0], count) for w in words[1:]], np.int32))
            self.line_names.append(self.current)
        elif kind in ("g", "o"):
            name = " ".join(words[1:])
            # An object's name counts until a group is named; GarmentCode writes neither.
            if kind == "g" or not self.groups:
                self.current = name

    def _take_face(self, corners: list[str]) -> None:
        if len(corners) < 3:
            raise ValueError("a face has at least 3 corners")
        at, place = [], []
        for corner in corners:
            fields = corner.split("/")
            at.append(_index(fields[0], len(self.vertices)))
            if len(fields) > 1 and fields[1]:
                place.append(_index(fields[1], len(self.uv)))
        group = self.groups.setdefault(self.current, len(self.groups))
        for k in range(1, len(at) - 1):
            self.faces.append((at[0], at[k], at[k + 1]))
            self.face_group.append(group)
            if len(place) == len(at):
                self.uv_faces.append((place[0], place[k], place[k + 1]))

    def mesh(self) -> TriangleMesh:
        """The whole mesh. Texture coordinates are kept when every face has them."""
        textured = len(self.uv_faces) == len(self.faces)
        named = any(self.groups)
        return TriangleMesh(
            np.array(self.vertices),
            np.array(self.faces, np.int64),
            np.array(self.uv) if textured else None,
            np.array(self.uv_faces, np.int64) if textured else None,
            tuple(name or "mesh" for name in self.groups) if named else (),
            np.array(self.face_group) if named else None,
            tuple(self.lines),
            line_names=tuple(self.line_names) if any(map(read_seam_name, self.line_names)) else (),
        )


def _index(text: str, count: int) -> int:
    index = int(text)
    index = index - 1 if index > 0 else count + index
    if not 0 <= index < count:
        raise ValueError(f"index {text} is outside the {count} seen so far")
    return index

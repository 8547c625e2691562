"""Which file ending is written and read by what."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Protocol

import numpy as np

from swifttailor.errors import InputError, SwiftTailorError
from swifttailor.garment import scene_reader
from swifttailor.garment.glb import write_glb
from swifttailor.garment.obj import write_obj
from swifttailor.garment.obj_reader import read_obj
from swifttailor.garment.ply import write_ply
from swifttailor.garment.stl import write_stl
from swifttailor.garment.triangle_mesh import TriangleMesh
from swifttailor.garment.usd import ENDINGS as USD_ENDINGS
from swifttailor.garment.usd import write_usd
from swifttailor.garment.usd_reader import read_usd

MAX_BYTES = 1_000_000_000
"""Larger mesh files are refused."""


class _Writer(Protocol):
    def __call__(self, mesh: TriangleMesh, path: Path | str, *, overwrite: bool = False) -> Path: ...


_Reader = Callable[[Path], TriangleMesh]
_WRITERS: dict[str, _Writer] = {
    ".glb": write_glb,
    ".obj": write_obj,
    ".ply": write_ply,
    ".stl": write_stl,
    **dict.fromkeys(USD_ENDINGS, write_usd),
}
_READERS: dict[str, _Reader] = {
    ".glb": scene_reader.read_glb,
    ".obj": read_obj,
    ".ply": scene_reader.read_ply,
    ".stl": scene_reader.read_stl,
    **dict.fromkeys(USD_ENDINGS, read_usd),
}
MESH_ENDINGS = tuple(_WRITERS)
"""Endings of mesh files, written and read alike."""


def write_garment_mesh(mesh: TriangleMesh, path: Path | str, *, overwrite: bool = False) -> Path:
    """Writes a mesh in the format of the file's ending; another file of that name stays unless `overwrite`.

    Raises:
        InputError: The ending is not among `MESH_ENDINGS`, or the file cannot be written.
        MissingExtraError: USD is wanted and usd-core is not installed.
    """
    path = Path(path)
    return _WRITERS[_known(path)](mesh, path, overwrite=overwrite)


def read_garment_mesh(path: Path | str) -> TriangleMesh:
    """Reads a mesh file by its ending.

    GLB and USD state their unit; OBJ, PLY and STL are taken as centimetres. Panels come back as groups, and
    seams are closed where the file holds or implies them.

    Raises:
        InputError: There is no such file, its ending is unknown, or it is no readable mesh.
        MissingExtraError: It is USD and usd-core is not installed.
    """
    path = Path(path)
    ending = _known(path)
    try:
        size = path.stat().st_size
        if not path.is_file():
            raise InputError(f"'{path}' is not a file. Give a mesh file ({', '.join(MESH_ENDINGS)}).")
    except OSError as error:
        raise InputError(f"Cannot read '{path}': {error.strerror or error}.") from error
    if size > MAX_BYTES:
        raise InputError(f"'{path}' has {size / 1e9:.1f} GB; at most {MAX_BYTES / 1e9:g} GB are read.")
    try:
        with np.errstate(all="ignore"):
            return _READERS[ending](path)
    except SwiftTailorError as error:
        if str(path) in str(error) or not isinstance(error, InputError):
            raise
        raise InputError(f"'{path}' is not a usable mesh: {error}") from error
    except Exception as error:  # parsers of other packages raise whatever a broken file makes them raise
        raise InputError(
            f"'{path}' cannot be read as {ending.removeprefix('.').upper()}: {_reason(error)}. "
            "Check that the file is complete and that its ending tells its format."
        ) from error


def _reason(error: Exception) -> str:
    """The first line of an error's text, or its kind; USD's errors can fail to say even that."""
    try:
        lines = str(error).strip().splitlines()
    except Exception:
        lines = []
    return lines[0][:200].rstrip(".") if lines else type(error).__name__


def _known(path: Path) -> str:
    ending = path.suffix.lower()
    if ending not in _WRITERS:
        raise InputError(
            f"'{path}' has the ending '{path.suffix}', which is not a known mesh format. "
            f"Accepted: {', '.join(MESH_ENDINGS)}."
        )
    return ending

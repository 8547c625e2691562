"""Bodies that people have loaded as meshes: files of a folder, named by the hash of their content."""

from __future__ import annotations

import io
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from swifttailor.atomic_files import write_bytes
from swifttailor.body import Body
from swifttailor.body.measurements import BodyMeasurements
from swifttailor.errors import InputError
from swifttailor.studio.mesh_record import name_of

MOST_KEPT = 100
_LARGEST = 64 * 2**20


@dataclass(frozen=True)
class OwnBodies:
    """The bodies of a folder."""

    folder: Path | None
    """None where none can be kept."""

    def add(self, body: Body) -> str:
        """Keeps a body, and says its name.

        Raises:
            InputError: It cannot be kept.
        """
        if self.folder is None:
            raise InputError("Bodies cannot be kept here.")
        names = list(body.measurements.as_dict())
        content = io.BytesIO()
        np.savez_compressed(
            content,
            name=np.array(body.name),
            vertices=body.vertices.astype(np.float32),
            faces=body.faces,
            vertex_part=body.vertex_part,
            measurement_names=np.array(names),
            measurement_values=np.array([body.measurements.as_dict()[name] for name in names]),
        )
        name = name_of(content.getvalue())
        path = self._path(name)
        try:
            if not path.exists() and len(list(self.folder.glob("*.npz"))) >= MOST_KEPT:
                raise InputError(
                    f"{MOST_KEPT} bodies are kept already. Delete those that are no longer needed from "
                    f"'{self.folder.name}' in the folder of the projects."
                )
            write_bytes(path, content.getvalue(), overwrite=True)
        except OSError as error:
            raise InputError(f"The body cannot be kept: {error.strerror or error}.") from error
        return name

    def has(self, name: str) -> bool:
        """Whether a body is kept under this name."""
        return self.folder is not None and self._path(name).is_file()

    def find(self, name: str) -> Body:
        """A body by its name.

        Raises:
            InputError: It is not kept here, or its file is damaged.
        """
        try:
            path = self._path(name)
            if path.stat().st_size > _LARGEST:
                raise ValueError("too large")
            content = path.read_bytes()
            if name_of(content) != name:
                raise ValueError("changed")
            with np.load(io.BytesIO(content), allow_pickle=False) as stored:
                values = stored["measurement_values"]
                measured = {
                    str(k): float(v) for k, v in zip(stored["measurement_names"], values, strict=True)
                }
                return Body(
                    name=str(stored["name"]),
                    vertices=stored["vertices"],
                    faces=stored["faces"],
                    vertex_part=stored["vertex_part"],
                    measurements=BodyMeasurements.from_mapping(measured),
                )
        except (OSError, ValueError, KeyError) as error:
            raise InputError("The mesh of this body is not kept here. Load its file again.") from error

    def _path(self, name: str) -> Path:
        assert self.folder is not None
        return self.folder / f"{name}.npz"


_kept = OwnBodies(None)


def keep_in(folder: Path | None) -> None:
    """Says where this process finds its bodies."""
    global _kept
    _kept = OwnBodies(folder)


def own_bodies() -> OwnBodies:
    """The bodies of this process."""
    return _kept

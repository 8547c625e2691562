"""One garment to learn from: a pattern and its drape, whatever it was read from."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

from swifttailor.arrays import Floats
from swifttailor.data.encoding import (
    EncodedPositions,
    decode_document,
    decode_positions,
    encode_document,
    encode_positions,
    mesh_checksum,
)
from swifttailor.errors import InputError
from swifttailor.garment.garment import Garment
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.pattern import Pattern, read_specification, to_specification


@dataclass(frozen=True, eq=False)
class Sample:
    """A pattern and where the vertices of its panel mesh came to rest."""

    id: str
    pattern: Pattern
    """In canonical order."""
    edge_length: float
    """Target edge length of the panel mesh, cm; pattern and edge length determine the mesh."""
    vertices: Floats
    """(v, 3) welded vertices at rest on the body, cm."""
    about: dict[str, Any] = field(default_factory=dict)
    """Where it comes from and how good it is: `source`, `position` in its input, `quality`, `mended`."""
    checksum: str = ""
    """`mesh_checksum` of the mesh that the vertices belong to; not checked when empty."""

    @cached_property
    def mesh(self) -> PatternMesh:
        """The panel mesh, made when first asked for (about 0.1 s).

        Raises:
            InputError: It is not the mesh that was draped.
        """
        mesh = mesh_pattern(self.pattern, self.edge_length)
        made = mesh_checksum(mesh)
        if mesh.vertex_count != len(self.vertices) or self.checksum not in ("", made):
            raise InputError(
                f"Sample '{self.id}': its panel mesh is not the one that was draped (checksum {made}, "
                f"{self.checksum} when it was built). Panels are meshed differently by this version of "
                "SwiftTailor or scipy: use the version named in index.json, or build the data again."
            )
        return mesh

    @cached_property
    def garment(self) -> Garment:
        """The drape as a garment."""
        return Garment(self.mesh, self.vertices, {"id": self.id} | self.about)

    @staticmethod
    def of_garment(id: str, garment: Garment, edge_length: float, about: dict[str, Any]) -> Sample:
        """The sample of a drape; the mesh must be `mesh_pattern` of the garment's canonical pattern."""
        sample = Sample(
            id, garment.pattern, edge_length, garment.vertices, about, mesh_checksum(garment.mesh)
        )
        sample.__dict__["mesh"] = garment.mesh
        return sample


@dataclass(frozen=True)
class StoredSample:
    """A sample as it lies in a shard."""

    document: bytes
    """All but the positions (`encode_document`)."""
    positions: bytes
    """`EncodedPositions.data`."""

    @property
    def size(self) -> int:
        """Bytes."""
        return len(self.document) + len(self.positions)


def store_sample(sample: Sample) -> StoredSample:
    """Packs a sample; the same sample gives the same bytes."""
    encoded = encode_positions(sample.vertices)
    readings = {panel.placement.reading for panel in sample.pattern.panels}
    document = {
        "id": sample.id,
        "edge_length": sample.edge_length,
        "rotation": readings.pop() if len(readings) == 1 else "intrinsic",
        "origin": list(encoded.origin),
        "step": encoded.step,
        "vertices": encoded.count,
        "mesh": sample.checksum,
        "about": sample.about,
        "pattern": to_specification(sample.pattern),
    }
    return StoredSample(encode_document(document), encoded.data)


def load_sample(stored: StoredSample) -> Sample:
    """Unpacks a sample.

    Raises:
        InputError: It is damaged.
        PatternError: Its pattern is damaged.
    """
    document = decode_document(stored.document)
    try:
        x, y, z = (float(value) for value in document["origin"])
        encoded = EncodedPositions(
            stored.positions, (x, y, z), float(document["step"]), int(document["vertices"])
        )
        reading = read_specification(document["pattern"], name=document["id"], rotation=document["rotation"])
        _require_quality(document["about"])
        return Sample(
            id=document["id"],
            pattern=replace(reading.pattern.canonical(), name=document["id"]),
            edge_length=float(document["edge_length"]),
            vertices=decode_positions(encoded),
            about=dict(document["about"]),
            checksum=document["mesh"],
        )
    except (KeyError, TypeError, ValueError, AttributeError, OverflowError) as error:
        raise InputError(f"The facts of a sample are damaged: {type(error).__name__} {error}.") from error


def _require_quality(about: dict[str, Any]) -> None:
    """Raises `TypeError` where the quality of a drape is not numbers, and texts that say what is wrong."""
    quality = about.get("quality", {}).copy()
    reasons = quality.pop("reasons", [])
    numbers = all(isinstance(value, int | float) for value in quality.values())
    if not numbers or not isinstance(reasons, list) or not all(isinstance(text, str) for text in reasons):
        raise TypeError("its quality is not numbers and reasons")

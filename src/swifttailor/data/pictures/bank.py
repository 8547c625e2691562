"""Garments to draw pictures of: their surfaces, and what is true of each, read from memory-mapped files."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats
from swifttailor.body.rig import Rig, Weights
from swifttailor.body.worn import garment_weights
from swifttailor.data.array_cache import ArrayCache, Arrays, name_with_code
from swifttailor.data.reader import SplitReader
from swifttailor.data.sample import Sample
from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import InputError
from swifttailor.garment.cloth_surfaces import border_edges
from swifttailor.looks.draw import ClothMesh
from swifttailor.pattern.digest import pattern_digest
from swifttailor.picture_reader.truth import Truth

UNIT_CM = 0.01
"""Of stored positions: 16-bit numbers."""
_REACH = 2**15 - 1

Report = Callable[[str], None]


@dataclass(frozen=True, eq=False)
class WornGarment(ClothMesh):
    """A garment as it is drawn on the default body, and what is true of it."""

    weights: Weights
    """Who carries its vertices when the body moves."""
    truth: Truth


class PictureBank:
    """The garments of a training or a validation."""

    def __init__(self, splits: Sequence[Path]) -> None:
        """Opens splits of sewn garments.

        Args:
            splits: Folders of splits (`data.SplitReader`).

        Raises:
            InputError: There is none, or one is damaged.
        """
        self._caches = [open_cache(folder) for folder in splits]
        self._places = [(n, k) for n, cache in enumerate(self._caches) for k in range(len(cache))]
        if not self._places:
            raise InputError(
                "There are no garments to draw. Sew some: swifttailor data build --engine network"
            )

    def __len__(self) -> int:
        return len(self._places)

    def prepare(self, *, workers: int = 1, report: Report | None = None) -> None:
        """Measures and meshes what has not been; may be stopped and started again.

        Args:
            workers: Processes.
            report: Called with lines to show.
        """
        for cache in self._caches:
            for done, of in cache.prepare(workers=workers):
                if report is not None:
                    report(f"measuring garments: {done} of {of} files of '{cache.reader.folder}'")

    def leave_out(self, digests: Iterable[str]) -> None:
        """Forgets the patterns of some digests, and all but one of equal ones of a split; after `prepare`.

        The same pattern in two splits is worn in two ways, and a split that was given twice counts twice.

        Raises:
            InputError: None is left.
        """
        unwanted = set(digests)
        known: set[tuple[int, str]] = set()
        kept = []
        for place in self._places:
            digest = self._digest(place)
            if digest not in unwanted and (place[0], digest) not in known:
                known.add((place[0], digest))
                kept.append(place)
        if not kept:
            raise InputError(
                f"There are no garments to draw: all {len(self._places)} are among those to validate with or "
                "to keep apart. Sew others: swifttailor data build --engine network"
            )
        self._places = kept

    def keep(self, count: int) -> None:
        """Forgets all but so many garments, spread evenly over those that there are.

        Raises:
            InputError: There are fewer.
        """
        found = len(self._places)
        if count > found:
            raise InputError(
                f"There are {found} garments to learn from, and {count} were asked for (training_garments). "
                f"1 to {found} are accepted, and 0 takes all."
            )
        self._places = [self._places[k * found // count] for k in range(count)]

    def checksum(self) -> str:
        """SHA-256 of the shards in their order."""
        shards = [s.sha256 for cache in self._caches for s in cache.reader.index.shards]
        return hashlib.sha256("".join(shards).encode()).hexdigest()

    def digests(self) -> set[str]:
        """`pattern_digest` of all patterns."""
        return {self._digest(place) for place in self._places}

    def __getitem__(self, k: int) -> WornGarment:
        number, place = self._places[k]
        a = self._caches[number][place]
        flat = a["flat"].astype(np.float32) * np.float32(UNIT_CM)
        truth = Truth(
            int(a["part"][0]), a["statements"], a["measures"], a["panels"], a["boxes"].astype(np.float32)
        )
        return WornGarment(
            a["vertices"].astype(np.float64) * UNIT_CM,
            a["faces"],
            a["face_panel"],
            flat[a["flat_faces"]],
            a["seams"],
            a["borders"],
            Weights(a["carrier"], a["share"].astype(np.float32)),
            truth,
        )

    @property
    def ids(self) -> list[str]:
        """Of all patterns."""
        return [self._caches[number].reader.ids[k] for number, k in self._places]

    def part(self, k: int) -> int:
        """Number of the part of the body that a garment covers."""
        number, place = self._places[k]
        return int(self._caches[number][place]["part"][0])

    def truths(self, numbers: Iterable[int]) -> dict[str, NDArray[Any]]:
        """What is true of some garments, joined along a first axis."""
        rows = []
        for k in numbers:
            number, place = self._places[k]
            a = self._caches[number][place]
            rows.append([a["part"][0], a["statements"], a["measures"], a["panels"], a["boxes"]])
        names = ("part", "statements", "measures", "panels", "boxes")
        return {name: np.stack(column) for name, column in zip(names, zip(*rows, strict=True), strict=True)}

    def _digest(self, place: tuple[int, int]) -> str:
        number, k = place
        return self._caches[number][k]["digest"].tobytes().hex()


def open_cache(folder: Path) -> ArrayCache:
    """What is kept of the garments of a split."""
    rooms = (
        "describing",
        "panel_mesh",
        "body/rig.py",
        "body/worn.py",
        "picture_reader/truth.py",
        "picture_reader/labels.py",
    )
    name = name_with_code("worn", *rooms, "data/pictures/bank.py")
    return ArrayCache(SplitReader(folder), folder / "worn", name, worn_arrays)


def worn_arrays(sample: Sample) -> Arrays:
    """What is kept of a sample."""
    mesh, truth = sample.mesh, Truth.of(sample.pattern, measure_facts(sample.pattern))
    carried = garment_weights(Rig.default(), sample.vertices, mesh.faces)
    seams = [np.stack([s.vertices[:-1], s.vertices[1:]], axis=1) for s in mesh.seams]
    return {
        "vertices": _whole(sample.vertices),
        "faces": mesh.faces.astype(np.int32),
        "face_panel": mesh.face_panel.astype(np.int16),
        "flat": _whole(mesh.flat_vertices),
        "flat_faces": mesh.flat_faces.astype(np.int32),
        "seams": (np.concatenate(seams) if seams else np.zeros((0, 2))).astype(np.int32),
        "borders": border_edges(mesh.faces).astype(np.int32),
        "carrier": carried.carrier,
        "share": carried.share.astype(np.float16),
        "part": np.array([truth.part], np.uint8),
        "statements": truth.statements,
        "measures": truth.measures,
        "panels": truth.panels,
        "boxes": truth.boxes.astype(np.float16),
        "digest": np.frombuffer(bytes.fromhex(pattern_digest(sample.pattern)), np.uint8),
    }


def _whole(positions: Floats) -> NDArray[np.int16]:
    return np.clip(np.round(positions / UNIT_CM), -_REACH, _REACH).astype(np.int16)

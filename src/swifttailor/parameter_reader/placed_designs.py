"""Designs of garments as a network learns them: of each value its place among those that may be."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats
from swifttailor.atomic_files import require_free, write_bytes
from swifttailor.errors import InputError
from swifttailor.parameter_reader.which_matter import matters
from swifttailor.programs.read_parameter import ReadParameter

NEXT_RANGE = 0.15
"""How right the ranges beside a number's are."""
_ABOUT, _IDS = "about", "ids"


@dataclass(frozen=True, eq=False)
class PlacedDesigns:
    """Of N garments, by their ids."""

    parameters: tuple[ReadParameter, ...]
    rows: Mapping[str, int]
    """The row of each id."""
    places: NDArray[np.uint8]
    """(N, parameters) of values among `ReadParameter.values`; 0 where they do not matter."""
    matter: NDArray[np.bool_]
    """(N, parameters) whether a garment follows from it."""

    @staticmethod
    def of(designs: Mapping[str, Mapping[str, Any]], parameters: Sequence[ReadParameter]) -> PlacedDesigns:
        """Places the values of complete designs; those with a choice that is not known are left out.

        Args:
            designs: By id.
            parameters: That are read.
        """
        rows: dict[str, int] = {}
        places, matter = [], []
        for id, design in designs.items():
            names = matters(design)
            counts = [one.name in names for one in parameters]
            read = [one for one, matters_here in zip(parameters, counts, strict=True) if matters_here]
            if all(one.is_number or design[one.name] in one.values for one in read):
                rows[id] = len(rows)
                places.append(
                    [one.place_of(design[one.name]) if one.name in names else 0 for one in parameters]
                )
                matter.append(counts)
        shape = len(rows), len(parameters)
        return PlacedDesigns(
            tuple(parameters),
            rows,
            np.array(places, np.uint8).reshape(shape),
            np.array(matter, bool).reshape(shape),
        )

    @property
    def values(self) -> tuple[int, ...]:
        """How many values each parameter may have."""
        return tuple(len(one.values) for one in self.parameters)

    def of_ids(self, ids: Sequence[str]) -> tuple[NDArray[np.uint8], NDArray[np.bool_]]:
        """Places and what matters of garments; nothing matters of those whose design is not known."""
        shape = len(ids), len(self.parameters)
        places, matter = np.zeros(shape, np.uint8), np.zeros(shape, bool)
        rows = np.array([self.rows.get(id, -1) for id in ids], np.intp)
        known = rows >= 0
        places[known], matter[known] = self.places[rows[known]], self.matter[rows[known]]
        return places, matter

    def write(self, path: Path, *, overwrite: bool = False) -> None:
        """Writes a .safetensors file: two bytes a parameter and garment at most.

        Raises:
            InputError: It cannot be written, or is there and may not be replaced.
        """
        from safetensors.numpy import save

        require_free(path, overwrite=overwrite)
        about = json.dumps([one.to_json() for one in self.parameters])
        ids = "\n".join(sorted(self.rows, key=lambda id: self.rows[id]))
        arrays = {
            "places": self.places,
            "matter": np.packbits(self.matter, axis=1),
            _IDS: np.frombuffer(ids.encode(), np.uint8),
        }
        write_bytes(path, save(arrays, {_ABOUT: about}), overwrite=overwrite)

    @staticmethod
    def read(path: Path) -> PlacedDesigns:
        """Reads what `write` wrote.

        Raises:
            InputError: It is missing or damaged.
        """
        from safetensors import SafetensorError, safe_open

        try:
            with safe_open(path, "np") as file:
                about = json.loads((file.metadata() or {})[_ABOUT])
                arrays = {name: file.get_tensor(name) for name in ("places", "matter", _IDS)}
            parameters = tuple(ReadParameter.from_json(one) for one in about)
            ids = arrays[_IDS].tobytes().decode().split("\n")
            matter = np.unpackbits(arrays["matter"], axis=1, count=len(parameters)).astype(bool)
            places = arrays["places"]
            counts = np.array([len(one.values) for one in parameters])
            if places.dtype != np.uint8 or places.shape != matter.shape or len(ids) != len(places):
                raise ValueError(f"its arrays have the shapes {places.shape} and {matter.shape}")
            if (places >= counts).any():
                raise ValueError("a value has no place among those of its parameter")
        except (
            SafetensorError,
            OSError,
            InputError,
            KeyError,
            TypeError,
            ValueError,
            RecursionError,
        ) as error:
            raise InputError(
                f"'{path}' holds no placed designs: {error}. Write it with scripts/place_designs.py."
            ) from error
        return PlacedDesigns(parameters, {id: k for k, id in enumerate(ids)}, places, matter)


def nearly_right(values: int, *, is_number: bool) -> Floats:
    """(values, values) how right each is where another is true: a little, of ranges beside each other."""
    if not is_number:
        return np.eye(values)
    apart = np.abs(np.arange(values)[:, None] - np.arange(values))
    right = np.where(apart == 0, 1 - 2 * NEXT_RANGE, np.where(apart == 1, NEXT_RANGE, 0.0))
    return right / right.sum(axis=1, keepdims=True)

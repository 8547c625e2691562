"""A design parameter as it is read: one of its choices, or one of the ranges of its number."""

from __future__ import annotations

import json
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from swifttailor.errors import InputError
from swifttailor.programs import DESIGN_PARAMETERS

RANGES = 32
"""A number is one of so many ranges, which equally many designs fall into."""


@dataclass(frozen=True)
class ReadParameter:
    """One of `DESIGN_PARAMETERS`, and what it may be."""

    name: str
    values: tuple[Any, ...]
    """Its choices, or the middles of the ranges."""
    edges: tuple[float, ...] | None = None
    """Between the ranges of a number, upwards; None for choices."""

    @property
    def is_number(self) -> bool:
        """Whether its values are ranges of a number."""
        return self.edges is not None

    def place_of(self, value: Any) -> int:
        """Of a value among `values`."""
        return self.values.index(value) if self.edges is None else int(np.searchsorted(self.edges, value))

    def to_json(self) -> dict[str, Any]:
        """For the card."""
        edges = None if self.edges is None else list(self.edges)
        return {"name": self.name, "values": list(self.values), "edges": edges}

    @staticmethod
    def from_json(about: dict[str, Any]) -> ReadParameter:
        """Of the card.

        Raises:
            InputError: There is no such parameter, or it has other values.
        """
        edges = about["edges"]
        found = ReadParameter(
            str(about["name"]), tuple(about["values"]), None if edges is None else tuple(map(float, edges))
        )
        known = DESIGN_PARAMETERS.get(found.name)
        if known is None:
            raise InputError(f"There is no design parameter '{found.name}'.")
        if found.edges is not None and len(found.edges) != len(found.values) - 1:
            raise InputError(f"'{found.name}' has {len(found.values)} ranges and {len(found.edges)} edges.")
        if not found.values or any(isinstance(value, list | dict) for value in found.values):
            raise InputError(f"'{found.name}' has no values that can be read.")
        return found


def read_parameters(
    designs: Sequence[dict[str, Any]], matter: Sequence[Collection[str]]
) -> tuple[ReadParameter, ...]:
    """The parameters that vary where they matter, with their choices or ranges.

    Args:
        designs: Complete ones.
        matter: For each the names of the parameters that its garment follows from (`matters`).
    """
    found = []
    for name in designs[0]:
        values = [design[name] for design, names in zip(designs, matter, strict=True) if name in names]
        unlike = {json.dumps(value): value for value in values}
        if len(unlike) < 2:
            continue
        if all(type(value) in (int, float) for value in values) and len(unlike) > RANGES:
            found.append(_number(name, values))
        else:
            found.append(ReadParameter(name, tuple(unlike[key] for key in sorted(unlike))))
    return tuple(found)


def _number(name: str, values: Sequence[float]) -> ReadParameter:
    among = np.sort(np.asarray(values, float))
    edges = np.unique(among[len(among) * np.arange(1, RANGES) // RANGES])
    edges = edges[edges < among[-1]]  # a range ends with a value that occurs, so that none is empty
    which = np.searchsorted(edges, among)
    counts = np.bincount(which, minlength=len(edges) + 1)
    middles = among[
        np.cumsum(counts) - (counts + 1) // 2
    ].tolist()  # values that occur: whole where they must be
    if DESIGN_PARAMETERS[name].kind == "int":
        middles = [int(value) for value in middles]
    return ReadParameter(name, tuple(middles), tuple(edges.tolist()))

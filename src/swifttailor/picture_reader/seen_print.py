"""What is printed on or woven into the cloth of a garment in a photograph."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

PrintKind = Literal["stripes", "checks", "dots", "figures"]
DOWN = 90.0
"""The angle of stripes that run down the body."""


@dataclass(frozen=True)
class SeenPrint:
    """What is printed on or woven into cloth."""

    kind: PrintKind
    certainty: float
    """0 to 1."""
    colors: tuple[str, ...]
    """Two or more, ``#rrggbb``, that of most of the cloth first."""
    shares: tuple[float, ...]
    """How much of the cloth has each."""
    angle: float = 0.0
    """Of stripes, degrees: 0 runs around the body, 90 down it."""
    repeat: float | None = None
    """After so many cm it comes again; None where that is not seen."""

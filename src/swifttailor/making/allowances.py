"""How much cloth is left around the sew line, for each kind of edge."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from enum import StrEnum

from swifttailor.errors import InputError

MOST_CM = 10.0
"""Wider allowances are refused: they meet across most pieces."""


class EdgeKind(StrEnum):
    """What an edge of a piece becomes in the garment."""

    SEAM = "seam"
    """Sewn to another edge."""
    DART = "dart"
    """A leg of a dart; it has no allowance, since the dart is not cut open."""
    HEM = "hem"
    """Folded up at the lower end of a skirt, sleeve or trouser leg."""
    CURVED_HEM = "curved hem"
    """A hem so curved that a wide allowance would pucker."""
    NECKLINE = "neckline"
    ARMHOLE = "armhole"
    TOP = "upper edge"
    """Of a skirt, trousers or strapless top."""
    SLIT = "slit"
    OPENING = "opening"
    """Any other edge that is sewn to nothing."""


FOLDED_UP = frozenset({EdgeKind.HEM, EdgeKind.CURVED_HEM})
"""Edges whose allowance is turned up against the piece, so that its corners are turned too."""


@dataclass(frozen=True)
class Allowances:
    """Seam allowances by kind of edge, cm."""

    seam: float = 1.0
    """Seams."""
    hem: float = 3.0
    """Hems."""
    curved_hem: float = 1.5
    """Hems that curve much; never more than `hem`."""
    edge: float = 1.0
    """Necklines, armholes, upper edges, slits and openings."""

    def __post_init__(self) -> None:
        for entry in fields(self):
            value = getattr(self, entry.name)
            if not (math.isfinite(value) and 0.0 <= value <= MOST_CM):
                raise InputError(
                    f"The allowance for '{entry.name}' is {value:g} cm; from 0 to {MOST_CM:g} cm is "
                    "accepted. "
                    "Usual are 1 for seams and 3 for hems."
                )

    def of(self, kind: EdgeKind) -> float:
        """Width of the allowance of an edge, cm."""
        if kind is EdgeKind.DART:
            return 0.0
        if kind is EdgeKind.SEAM:
            return self.seam
        if kind is EdgeKind.HEM:
            return self.hem
        return min(self.curved_hem, self.hem) if kind is EdgeKind.CURVED_HEM else self.edge

"""Straps under the feet, which hold the ends of close legs down."""

from __future__ import annotations

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.free_edges import leg_ends
from swifttailor.pattern.trims.shapes import Stirrup, Trim

_WIDTH = 3.0
"""Of a strap, cm."""
_HIGHEST = 30.0
"""How far above the floor legs with stirrups end at most, cm."""


def stirrups(chalk: Chalk, name: str) -> list[Trim]:
    """One under each foot; nothing where the legs end higher up."""
    pieces: list[Trim] = []
    for side in ("l", "r"):
        edges, low = leg_ends(chalk.pattern, side)
        if not edges or low > _HIGHEST * chalk.size:
            return []
        pieces.append(Stirrup(name, edges, _WIDTH * chalk.size))
    return pieces

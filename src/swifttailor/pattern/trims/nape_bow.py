"""A bow with two hanging ends at the back of the neck."""

from __future__ import annotations

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Bow, Trim

_BOW, _ENDS, _BELOW_NECK = 13.0, 17.0, 1.6
"""Width of the bow, length of its ends, and how far below the neckline its knot lies, cm."""
_LEAST = 12.0
"""Backs that are lower have no nape that a bow could be tied at, cm."""


def nape_bow(chalk: Chalk, name: str) -> list[Trim]:
    """In the middle of the back, below the neck; nothing where the back is bare there."""
    view = chalk.views.get("left_btorso")
    column = None if view is None else view.column(0.3)
    if view is None or column is None or column[1] < chalk.shoulder - _LEAST * chalk.size:
        return []
    at = (0.3, column[1] - _BELOW_NECK * chalk.size)
    if not view.holds([at]):
        return []
    u, v = view.local([at])[0].tolist()
    return [Bow(name, "left_btorso", (u, v), _BOW * chalk.size, _ENDS * chalk.size)]

"""A band around the waist, tied in a bow at the wearer's left side, as fronts that cross are closed."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.pattern.trims.belts import belt
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Belt, Bow, Trim

_BAND, _SLIPS = 3.0, 3.0
"""Width of the band, and how far from the waist of the pattern that of the sewn garment may be, cm."""
_AT = 0.5, 0.62
"""Where the bow is, as a part of half the front; the second where the edge of a front lies at the first."""
_BOW, _ENDS = 11.0, 20.0
"""Width of the bow, and how long its ends are, cm."""
_ABOVE_HEM, _BELOW_ARMHOLE = 2.0, 12.0
"""The bow is so far above the hem of what ends at the waist, and below the top of the front, at least, cm."""


def side_tie(chalk: Chalk, name: str) -> list[Trim]:
    """The band and the bow; of what ends above the waist the bow alone."""
    for panel in ("right_ftorso", "left_ftorso"):  # of crossed fronts the right one reaches to the left side
        view = chalk.views.get(panel)
        if view is None:
            continue
        y = max(chalk.waist, view.low + _ABOVE_HEM * chalk.size)
        span = view.span(y)
        if span is None or span[1] < 6.0 * chalk.size or y > view.high - _BELOW_ARMHOLE * chalk.size:
            continue
        at = next(([(part * span[1], y)] for part in _AT if view.holds([(part * span[1], y)])), None)
        if at is None:
            continue
        u, v = view.local(at)[0].tolist()
        bow = Bow(name, panel, (u, v), _BOW * chalk.size, _ENDS * chalk.size)
        around = [each for each in belt(chalk, name) if isinstance(each, Belt)]
        band = [replace(one, width=_BAND * chalk.size, reach=_SLIPS * chalk.size) for one in around]
        return [*band, bow]
    return []

"""An apron over the front of a skirt, with the band that is tied around the waist."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from swifttailor.pattern.trims.belts import belt
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.decorations import bow_at_waist
from swifttailor.pattern.trims.shapes import Belt, Trim

_APRON_BESIDE, _APRON_ABOVE_HEM, _APRON_LEAST = 0.5, 0.14, 20.0
"""An apron's half width as a part of the skirt's, how far above the hem it ends as a part of its length,
and the shortest skirt that has room for one, cm."""
_APRON_WIDEST, _APRON_CORNER = 22.0, 6.0
"""Half the width of the widest, and the radius of its lower corners, cm."""
_APRON_WIDER = 1.7
"""How much wider its lower edge may be than its waist."""
_APRON_SHARES, _APRON_SLANT = (1.0, 0.8, 0.65, 0.5, 0.4, 0.3), 0.25
"""Widths that are tried, as parts of the widest; how far its sides may begin below its middle, likewise."""
_BAND = 3.4
"""Width of the band, cm."""


def apron(chalk: Chalk, name: str) -> list[Trim]:
    """A piece over the front of the skirt, from the waist to above the hem."""
    view = chalk.views.get("skirt_front")
    column = None if view is None else view.column(0.0)
    if view is None or column is None or column[1] - column[0] < _APRON_LEAST * chalk.size:
        return []
    low, high = column
    span = view.span((low + high) / 2)
    if span is None:
        return []
    widest = min(_APRON_BESIDE * min(-span[0], span[1]), _APRON_WIDEST * chalk.size)
    for share in _APRON_SHARES:  # the waist of a round skirt is narrow
        found = _apron(chalk, name, share * widest, min(widest, _APRON_WIDER * share * widest))
        if found:
            return [*found, *_ties(chalk, name)]
    return []


def _ties(chalk: Chalk, name: str) -> list[Trim]:
    """The band that holds it around the waist, tied in a bow behind; nothing where no bow has a place."""
    bow = bow_at_waist(
        chalk, name, ("left_btorso", "wb_back", "skirt_back"), above=1.0, width=15.0, tail=24.0
    )
    band = [each for each in belt(chalk, name) if isinstance(each, Belt)] if bow else []
    return [*[replace(each, width=_BAND * chalk.size) for each in band], *bow]


def _apron(chalk: Chalk, name: str, half: float, low_half: float) -> list[Trim]:
    """One of half widths at the waist and at its lower edge, cm."""
    view = chalk.views["skirt_front"]
    xs = np.linspace(-half, half, 13)
    columns = [column for x in xs if (column := view.column(float(x))) is not None]
    if half < 4.0 * chalk.size or len(columns) < len(xs):
        return []
    low, high = columns[len(xs) // 2]
    if min(top for _, top in columns) < high - _APRON_SLANT * (high - low):
        return []
    corner = _APRON_CORNER * chalk.size
    lows = xs * (low_half / half)
    beside = np.clip((np.abs(lows) - low_half) / corner + 1.0, 0.0, 1.0)
    hem = low + _APRON_ABOVE_HEM * (high - low) + corner * (1.0 - np.sqrt(1.0 - 0.98 * beside**2))
    upper = [(float(x), top - 0.5) for x, (_, top) in zip(xs, columns, strict=True)]
    lower = [(float(x), float(y)) for x, y in zip(lows, hem, strict=True)]
    return chalk.ruled(name, view.panel.name, lower, upper)

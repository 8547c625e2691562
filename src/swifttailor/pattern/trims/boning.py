"""Channels that hold the bones of a corset, where a tailor would chalk them on the bodice."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.front_view import FrontView
from swifttailor.pattern.trims.shapes import Trim

_TORSO = ("left_ftorso", "left_btorso", "right_ftorso", "right_btorso")
_SHARES = (0.22, 0.56, 0.76)
"""Where channels lie, as parts of the width of a panel from the middle; darts lie between."""
_LINE = 0.1
"""Half the width of what is drawn of a bone, cm."""
_INSIDE, _HIGHEST, _SHORTEST, _STEP = 0.7, 22.0, 6.0, 0.8
"""What stays free at both ends, how far above the waist channels reach at most, how long they are at least,
and by how much they are made shorter until they lie on the cloth, cm."""
_BELOW_WAIST = 9.0
"""A torso that ends farther below the waist is no corset's, cm."""
_FEWEST = 2


def boning(chalk: Chalk, name: str) -> list[Trim]:
    """A line for each bone, from the waist up to the upper edge or to the dart at the bust."""
    pieces: list[Trim] = []
    for panel in _TORSO:
        view = chalk.views.get(panel)
        if view is None or view.low < chalk.waist - _BELOW_WAIST * chalk.size:
            return []
        found = _channels(chalk, name, view)
        if len(found) < _FEWEST:
            return []
        pieces += found
    return pieces


def _channels(chalk: Chalk, name: str, view: FrontView) -> list[Trim]:
    span = view.span(view.low + 3.0 * chalk.size)
    if span is None:
        return []
    sign = 1 if span[0] + span[1] > 0 else -1
    width = max(abs(span[0]), abs(span[1]))
    pieces: list[Trim] = []
    for share in _SHARES:
        pieces += _channel(chalk, name, view, sign * share * width)
    return pieces


def _channel(chalk: Chalk, name: str, view: FrontView, x: float) -> list[Trim]:
    """Nothing where a dart or the outline leaves no room."""
    column = view.column(x)
    if column is None:
        return []
    low = column[0] + _INSIDE
    top = min(column[1], chalk.waist + _HIGHEST * chalk.size) - _INSIDE
    while top - low >= _SHORTEST * chalk.size:
        heights = np.linspace(low, top, 6)
        found = chalk.line(name, view.panel.name, [(x, float(y)) for y in heights], width=_LINE)
        if found:
            return found
        top -= _STEP
    return []

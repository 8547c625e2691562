"""Cut-outs at the waist: openings in both side seams that show the wearer."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Trim

_SIDES = (("left", 1.0), ("right", -1.0))
_ABOVE_WAIST, _HEIGHT = 0.8, 12.0
"""How far above the waist an opening begins, and how high it is, cm."""
_DEEP = {"ftorso": 12.0, "btorso": 7.0}
"""How far it reaches in from the side seam, cm."""
_LEAST, _WIDEST = 0.06, 0.6
"""Width where it ends, cm, and at most as a part of the panel's."""


def cut_outs(chalk: Chalk, name: str) -> list[Trim]:
    """A half of an oval on both sides of each side seam, above the waist."""
    low = chalk.waist + _ABOVE_WAIST * chalk.size
    shares = np.linspace(0.0, 1.0, 17)
    heights = low + shares * _HEIGHT * chalk.size
    pieces: list[Trim] = []
    for part, deep in _DEEP.items():
        for side, sign in _SIDES:
            view = chalk.views.get(f"{side}_{part}")
            spans = [] if view is None else [view.span(float(y)) for y in heights]
            outer = [sign * (span[1] if sign > 0 else span[0]) for span in spans if span is not None]
            if view is None or len(outer) != len(heights):
                return []
            wide = np.maximum(
                min(deep * chalk.size, _WIDEST * min(outer)) * np.sqrt(np.sin(np.pi * shares).clip(0.0)),
                _LEAST,
            )
            edge = [(sign * (x - 0.02), float(y)) for x, y in zip(outer, heights, strict=True)]
            inner = [(sign * (x - float(w)), float(y)) for x, w, y in zip(outer, wide, heights, strict=True)]
            if not view.bridges([*edge, *inner]):
                return []
            pieces += chalk.ruled(name, view.panel.name, edge, inner, "hole", is_cut=False, to_the_edge=True)
    return pieces

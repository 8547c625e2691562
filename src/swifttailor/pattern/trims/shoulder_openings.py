"""Openings at the shoulders, on top of both sleeves: cold shoulders."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.front_view import FrontView
from swifttailor.pattern.trims.shapes import Trim

_BELOW_TIP, _LENGTH, _HALF_WIDTH, _LEAST = 0.8, 13.0, 6.5, 0.06
"""Where one begins below the top of the sleeve, how long it is along the arm, and half its width, cm."""
_ABOVE_END = 2.5
"""What is left of the sleeve below it at least, cm."""
_SHORTEST = 7.0
"""An opening shorter than this shows nothing, cm."""


def shoulder_openings(chalk: Chalk, name: str) -> list[Trim]:
    """An oval that shows the wearer, one half in front of the seam on top of the sleeve and one behind."""
    pieces: list[Trim] = []
    for side in ("left", "right"):
        for part in ("f", "b"):
            view = chalk.views.get(f"{side}_sleeve_{part}")
            seam = None if view is None else _seam_on_top(chalk, view, side)
            if view is None or seam is None:
                return []
            found = _half(chalk, name, view, *seam)
            if not found:
                return []
            pieces += found
    return pieces


def _half(chalk: Chalk, name: str, view: FrontView, tip: Floats, end: Floats) -> list[Trim]:
    s = chalk.size
    along = end - tip
    whole = float(np.linalg.norm(along))
    length = min(_LENGTH * s, whole - (_BELOW_TIP + _ABOVE_END) * s)
    if length < _SHORTEST * s:
        return []
    unit = along / whole
    # Towards the underarm, which lies below the seam and nearer to the body.
    down = np.array([unit[1], -unit[0]])
    down = down if down[1] < 0 else -down
    shares = np.linspace(0.0, 1.0, 13)
    wide = np.maximum(np.sqrt(np.clip(1.0 - (2.0 * shares - 1.0) ** 2, 0.0, 1.0)) * _HALF_WIDTH * s, _LEAST)
    base = tip + (_BELOW_TIP * s + shares * length)[:, None] * unit + 0.02 * down
    lower = base + wide[:, None] * down
    if not view.bridges(lower[1:-1]):
        return []
    first = [(float(x), float(y)) for x, y in base]
    second = [(float(x), float(y)) for x, y in lower]
    return chalk.ruled(name, view.panel.name, first, second, "hole", is_cut=False, to_the_edge=True)


def _seam_on_top(chalk: Chalk, view: FrontView, side: str) -> tuple[Floats, Floats] | None:
    """The upper and the lower end of the seam on top of a sleeve in the view; None where it has none."""
    panels = {f"{side}_sleeve_f", f"{side}_sleeve_b"}
    seams = []
    for stitch in chalk.pattern.stitches:
        if {ref.panel for ref in stitch.sides} != panels:
            continue
        ref = next(ref for ref in stitch.sides if ref.panel == view.panel.name)
        ends = view.seen(view.panel.chord(ref.edge))
        seams.append(ends[np.argsort(-ends[:, 1])])
    if not seams:
        return None
    highest = max(seams, key=lambda ends: float(ends[0, 1]))
    return highest[0], highest[1]

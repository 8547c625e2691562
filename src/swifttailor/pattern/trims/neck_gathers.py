"""Gathers all around a neck: folds that run down from the neckline, long and short ones in turn."""

from __future__ import annotations

from dataclasses import replace
from itertools import cycle

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk, Point
from swifttailor.pattern.trims.front_view import FrontView
from swifttailor.pattern.trims.shapes import Patch, Trim

_PARTS = (0.06, 0.15, 0.24, 0.33, 0.42, 0.51, 0.6, 0.69, 0.78, 0.86)
"""Where folds begin, as parts of the way from the middle to the shoulder."""
_LENGTHS = (8.5, 6.0, 10.0, 7.0, 9.0, 5.5)
"""How long they are in turn, cm."""
_SPREAD = 0.42
"""How far they spread: the way aside of the outermost over its length."""
_WIDTH, _SWELL = 0.62, 0.42
"""Half the width of a fold at the neckline, and how far it stands off there, cm; both go down to nothing."""
_INSIDE, _FEWEST, _STEPS = 0.7, 4, 9
_FACES = ("ftorso", "btorso")


def neck_gathers(chalk: Chalk, name: str) -> list[Trim]:
    """Short folds below the neckline, in front and behind; nothing where a front has no shoulders."""
    pieces: list[Trim] = []
    for face in _FACES:
        for half, sign in (("left", 1), ("right", -1)):
            view = chalk.views.get(f"{half}_{face}")
            found = [] if view is None or view.high <= chalk.shoulder else _of_half(chalk, name, view, sign)
            if len(found) < _FEWEST:
                if face == "ftorso":
                    return []
                continue
            pieces += found
    return pieces


def _of_half(chalk: Chalk, name: str, view: FrontView, sign: int) -> list[Trim]:
    end = abs(float(view.outline[int(np.argmax(view.outline[:, 1])), 0]))
    found: list[Trim] = []
    for part, length in zip(_PARTS, cycle(_LENGTHS), strict=False):
        x, down = part * end, length * chalk.size
        beside = _WIDTH * chalk.size
        top = min(chalk.top_at(view, sign * max(x + by, 0.0)) for by in (-beside, 0.0, beside)) - _INSIDE
        sides = _fold((sign * x, top), (sign * (x + _SPREAD * part * down), top - down), chalk.size)
        folds = chalk.ruled(name, view.panel.name, *sides, is_cut=False)
        found += [replace(fold, swell=_SWELL * chalk.size) for fold in folds if isinstance(fold, Patch)]
    return found


def _fold(start: Point, end: Point, size: float) -> tuple[list[Point], list[Point]]:
    """Both sides of a fold from `start`, where it is widest, to `end`."""
    way = np.linspace(0.0, 1.0, _STEPS)[:, None]
    line = (1.0 - way) * np.array(start) + way * np.array(end)
    half = _WIDTH * size * (1.0 - 0.9 * way) * np.array([1.0, 0.0])
    return [(float(x), float(y)) for x, y in line - half], [(float(x), float(y)) for x, y in line + half]

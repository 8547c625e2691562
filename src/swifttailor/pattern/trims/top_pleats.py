"""Pleats of tops: down the front, fanned below the neck, below the shoulders, down the middle of the back."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import cycle

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk, Point
from swifttailor.pattern.trims.front_view import FrontView, over_darts
from swifttailor.pattern.trims.shapes import Trim

_HALVES = (("left", 1), ("right", -1))
_FOLD, _FINE = 0.24, 0.2
"""Half the width of what is drawn of a fold, and of one of many fine ones, cm."""
_BESIDE, _APART, _FINE_APART = 3.6, 3.0, 1.6
"""How far from the middle the first fold lies, and how far from one to the next, cm."""
_INSIDE, _FROM_SIDE = 1.1, 2.0
"""What stays free above and below, and beside the side seams, cm."""
_UNDER_COLLAR, _BESIDE_NECK = 6.0, 2.5
"""The same below a collar that lies on the front, and how far beside the neck that lies there, cm."""
_SHORTEST, _FEWEST = 12.0, 3
_OF_NECK = (0.2, 0.4, 0.6, 0.8)
"""Where the folds below the neck begin, as parts of the way from the middle to the shoulder."""
_NECK, _SPREAD = (11.0, 14.0, 12.0, 9.0), 0.42
"""How long they are, cm, and how far they spread: the way aside of the outermost over its length."""
_ON_SHOULDER, _SHOULDER, _LEAST_SHOULDER = (0.3, 0.55, 0.8), (15.0, 17.0, 14.0), 4.0
"""The same of those below the shoulders, as parts of the seam; a shorter seam has none, cm."""
_ON_SHOULDER_GATHERS = (0.18, 0.32, 0.46, 0.6, 0.74, 0.86)
_GATHERS = (6.5, 4.5, 8.0, 5.0)
"""Where gathers begin, in the same parts, and how long they are in turn, cm."""
_BACK_FROM_MIDDLE, _BESIDE_HOLLOW, _BACK_BELOW = 2.0, 3.8, 11.0
"""How far both folds of a box pleat lie beside the middle of the back, and of one that is drawn in at the
waist; how far below the neck they begin, cm."""

_BOX_AT, _BOX = 0.62, 2.0
"""Where the middle of a box pleat is on the shoulder seam, as a part of it, and half its width, cm."""


def pleated_front(chalk: Chalk, name: str) -> list[Trim]:
    """Folds down both fronts, from below the neck and the shoulders to the hem or the waist seam."""
    return _all_down(chalk, name, "ftorso", _BESIDE, _APART, _FOLD)


def fine_pleats(chalk: Chalk, name: str) -> list[Trim]:
    """Many narrow folds down the fronts and the back."""
    front = _all_down(chalk, name, "ftorso", _FINE_APART, _FINE_APART, _FINE)
    back = _all_down(chalk, name, "btorso", _FINE_APART, _FINE_APART, _FINE)
    return [*front, *back] if front and back else []


def neck_pleats(chalk: Chalk, name: str) -> list[Trim]:
    """Short folds that fan out below the neckline."""
    return _from_neck(chalk, name, _OF_NECK, _NECK)


def shoulder_pleats(chalk: Chalk, name: str) -> list[Trim]:
    """Folds that fall from both shoulder seams, a little towards the middle."""
    return _from_shoulders(chalk, name, _ON_SHOULDER, _SHOULDER, inwards=0.6)


def shoulder_gathers(chalk: Chalk, name: str) -> list[Trim]:
    """Many short folds that run down from both shoulder seams."""
    return _from_shoulders(chalk, name, _ON_SHOULDER_GATHERS, _GATHERS, inwards=0.0)


def _from_neck(chalk: Chalk, name: str, parts: Sequence[float], lengths: Sequence[float]) -> list[Trim]:
    """Folds that begin at parts of the way to the shoulder, their lengths (cm) in turn."""

    def folds(view: FrontView, sign: int) -> list[list[Point]]:
        end = abs(_shoulder_of(view, sign)[0])
        found: list[list[Point]] = []
        for part, length in zip(parts, cycle(lengths), strict=False):
            x, down = part * end, length * chalk.size
            top = chalk.top_at(view, sign * x) - _free_above(chalk)
            found.append([(sign * x, top), (sign * (x + _SPREAD * part * down), top - down)])
        return found

    return _both(chalk, name, folds)


def _from_shoulders(
    chalk: Chalk, name: str, parts: Sequence[float], lengths: Sequence[float], *, inwards: float
) -> list[Trim]:
    """Folds that begin at parts of a shoulder seam, their lengths (cm) in turn, and end `inwards` (cm)."""

    def folds(view: FrontView, sign: int) -> list[list[Point]]:
        inner, outer = _shoulder_of(view, sign)
        if abs(outer - inner) < _LEAST_SHOULDER * chalk.size:
            return []
        found: list[list[Point]] = []
        for part, length in zip(parts, cycle(lengths), strict=False):
            x = inner + part * (outer - inner)
            top = chalk.top_at(view, x) - _INSIDE
            found.append([(x, top), (x - sign * inwards, top - length * chalk.size)])
        return found

    return _both(chalk, name, folds)


def back_pleat(chalk: Chalk, name: str) -> list[Trim]:
    """Both folds of a box pleat down the middle of the back, from the height of a yoke on.

    Where that is drawn in at the waist they lie farther apart.
    """
    found = _back_folds(chalk, name, _BACK_FROM_MIDDLE * chalk.size)
    return found or _back_folds(chalk, name, _BESIDE_HOLLOW * chalk.size)


def box_pleats(chalk: Chalk, name: str) -> list[Trim]:
    """Both folds of a box pleat down each front and each half of the back, from the shoulder to the hem."""
    front, back = (_box_pleats(chalk, name, part) for part in ("ftorso", "btorso"))
    return [*front, *back] if front and back else []


def _box_pleats(chalk: Chalk, name: str, part: str) -> list[Trim]:
    pieces: list[Trim] = []
    s = chalk.size
    for half, sign in _HALVES:
        view = chalk.views.get(f"{half}_{part}")
        if view is None or not _reaches_the_neck(chalk, view):
            return []
        inner, outer = _shoulder_of(view, sign)
        if abs(outer - inner) < _LEAST_SHOULDER * s:
            return []
        middle = inner + _BOX_AT * (outer - inner)
        for x in (middle - sign * _BOX * s, middle + sign * _BOX * s):
            column = view.column(x)
            if column is None:
                return []
            # Below a dart that lies in the way.
            tops = np.arange(column[1] - _INSIDE, column[0] + 2 * _SHORTEST * s, -2.0)
            folds = (_fold(chalk, name, view, [(x, y), (x, column[0] + _INSIDE)], _FOLD) for y in tops)
            found = next((fold for fold in folds if fold), [])
            if not found:
                return []
            pieces += found
    return pieces


def _back_folds(chalk: Chalk, name: str, aside: float) -> list[Trim]:
    """The same, so far from the middle, cm."""
    pieces: list[Trim] = []
    s = chalk.size
    for half, sign in _HALVES:
        view = chalk.views.get(f"{half}_btorso")
        column = None if view is None else view.column(sign * aside)
        if view is None or column is None:
            return []
        low, high = column[0] + _INSIDE, column[1] - _BACK_BELOW * s
        found = _fold(chalk, name, view, [(sign * aside, y) for y in (high, low)], _FOLD)
        if high - low < _SHORTEST * s or not found:
            return []
        pieces += found
    return pieces


def _all_down(chalk: Chalk, name: str, part: str, first: float, apart: float, width: float) -> list[Trim]:
    """Upright folds on both halves, as far aside as the panel is whole from top to bottom."""
    pieces: list[Trim] = []
    s = chalk.size
    for half, sign in _HALVES:
        view = chalk.views.get(f"{half}_{part}")
        if view is None:
            return []
        middle = abs(chalk.middle(sign, view.high)) if part == "ftorso" else 0.0
        widest = float((sign * view.outline[:, 0]).max()) - _FROM_SIDE * s
        found: list[Trim] = []
        for x in np.arange(middle + first * s, widest, apart * s):
            column = view.column(sign * x)
            if column is None:
                continue
            covered = part == "ftorso" and x < abs(_shoulder_of(view, sign)[0]) + _BESIDE_NECK * s
            above = _free_above(chalk) if covered else _INSIDE
            ends = [(sign * x, column[1] - above), (sign * x, column[0] + _INSIDE)]
            if ends[0][1] - ends[1][1] >= _SHORTEST * s:
                found += _fold(chalk, name, view, ends, width)
        if len(found) < _FEWEST:
            return []
        pieces += found
    return pieces


def _both(chalk: Chalk, name: str, folds: Callable[[FrontView, int], list[list[Point]]]) -> list[Trim]:
    """What `folds` draws on both fronts; nothing where a half would have too few."""
    pieces: list[Trim] = []
    for half, sign in _HALVES:
        view = chalk.views.get(f"{half}_ftorso")
        if view is None or not _reaches_the_neck(chalk, view):
            return []
        found = [piece for ends in folds(view, sign) for piece in _fold(chalk, name, view, ends, _FOLD)]
        if len(found) < _FEWEST:
            return []
        pieces += found
    return pieces


def _fold(chalk: Chalk, name: str, view: FrontView, ends: Sequence[Point], width: float) -> list[Trim]:
    (x0, y0), (x1, y1) = ends
    way = np.linspace(0.0, 1.0, max(int(abs(y1 - y0) / 1.5), 6))
    line: list[Point] = [(float(x0 + t * (x1 - x0)), float(y0 + t * (y1 - y0))) for t in way]
    return chalk.line(name, view.panel.name, over_darts(view, line), width)


def _free_above(chalk: Chalk) -> float:
    """What stays free below the neckline, cm: a collar lies over its first inches."""
    lies = any(
        stitch.right_wrong and any("collar" in side.panel for side in stitch.sides)
        for stitch in chalk.pattern.stitches
    )
    return _UNDER_COLLAR * chalk.size if lies else _INSIDE


def _reaches_the_neck(chalk: Chalk, view: FrontView) -> bool:
    """Whether a front has shoulders of its own: what is bare there or hangs on straps has none."""
    return view.high > chalk.shoulder


def _shoulder_of(view: FrontView, sign: int) -> tuple[float, float]:
    """The x of the ends of the shoulder seam, the one at the neck first."""
    at = int(np.argmax(view.outline[:, 1]))
    inner, high = view.outline[at]
    # The seam falls evenly; where a front falls off steeper its armhole begins.
    outer = float(inner)
    for x in np.arange(abs(inner) + 0.5, abs(inner) + 20.0, 0.5):
        column = view.column(sign * x)
        if column is None or high - column[1] > 1.0 * (x - abs(inner)) + 0.5:
            break
        outer = sign * float(x)
    return float(inner), outer

"""The folds that hang in arcs from the neckline of what has a cowl."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.front_view import FrontView
from swifttailor.pattern.trims.shapes import Patch, Trim

_FEWEST = 2
"""Fewer folds on a half are none."""
_DEEP = (3.2, 3.8, 4.4)
"""How deep each fold is in the middle, cm; the uppermost begins at the neckline itself."""
_APART = 1.3
"""How far apart folds end at most, on the shoulder or beside a strap, cm."""
_REACH, _JUMP, _STEP = 17.0, 4.0, 0.25
"""How far from the middle a neckline may end, cm; where it rises by more than so much in a step it meets a
strap."""
_ASIDE, _FREE = 0.45, 0.15
"""So far inside of the panel's edges folds lie, to the side and below, cm."""
_RISE = 15.0
"""Ends of folds are at most so much higher than the middle of the neckline, cm."""
_BEND = 1.9
"""Lower folds are flat in the middle and steep at their ends: a power of the way."""
_BESIDE, _SWELL = 0.02, 1.6
"""How near the middle folds begin, and how far they stand off there, cm."""
_STEPS = 24


def cowl_folds(chalk: Chalk, name: str) -> list[Trim]:
    """Folds from shoulder to shoulder, or from strap to strap, that hang one below the other."""
    pieces: list[Trim] = []
    for side, sign in (("left", 1), ("right", -1)):
        view = chalk.views.get(f"{side}_ftorso")
        if view is None:
            return []
        inner = abs(chalk.middle(sign, view.high)) + _BESIDE  # seams of slips slant
        arcs = _arcs(view, sign, inner, chalk.size)
        found: list[Trim] = []
        for upper, lower in pairwise(arcs):
            first, second = (np.stack([sign * line[:, 0], line[:, 1]], axis=1) for line in (upper, lower))
            held = np.logical_and(view.held(first), view.held(second))
            inside = len(first) if held.all() else int(np.argmin(held))
            if inside < _STEPS // 3:
                continue
            folds = chalk.ruled(
                name, view.panel.name, first[:inside].tolist(), second[:inside].tolist(), is_cut=False
            )
            found += [replace(fold, swell=_SWELL * chalk.size) for fold in folds if isinstance(fold, Patch)]
        if len(found) < _FEWEST:
            return []
        pieces += found
    return pieces


def _arcs(view: FrontView, sign: int, inner: float, size: float) -> list[Floats]:
    """Borders of the folds (n, 2), distance from the middle and height, cm: the neckline first.

    Args:
        view: The front's half.
        sign: 1 of the left one, -1 of the right one.
        inner: Where they begin, cm from the middle.
        size: Of the wearer, over that of an adult.
    """
    outer, shoulder = _neck_end(view, sign, inner, size)
    middle = _edge(view, sign, inner, inner)
    if middle is None:
        return []
    own = np.linspace(inner, outer, _STEPS)
    neckline = np.array([y if (y := _edge(view, sign, x, inner)) is not None else middle for x in own])
    drops = size * np.cumsum([0.0, *_DEEP])
    share = np.linspace(0.0, 1.0, _STEPS)
    end = min(float(neckline[-1]), middle + _RISE * size)
    along = np.clip((neckline - middle) / max(end - middle, 1.0), 0.0, 1.0)
    arcs = []
    for k, drop in enumerate(drops):
        at = outer + k * min(_APART * size, shoulder / len(_DEEP))
        top = _edge(view, sign, at, inner)
        high = end if top is None else min(top, end)  # a strap rises above it
        lower = k / (len(drops) - 1)
        shape = (1.0 - lower) * along + lower * share**_BEND
        low = middle - drop
        arcs.append(np.stack([inner + share * (at - inner), low + shape * (high - low)], axis=1))
    return arcs


def _neck_end(view: FrontView, sign: int, inner: float, size: float) -> tuple[float, float]:
    """Where the neckline ends, cm from the middle, and how much of a shoulder or an edge is beside that."""
    xs = np.arange(inner, _REACH * size, _STEP)
    tops = np.array([view.low if (column := view.column(sign * x)) is None else column[1] for x in xs])
    steep = np.flatnonzero(np.diff(tops) > _JUMP)
    if len(steep):  # a thin strap: what is beside it is the edge of the front
        return float(xs[steep[0]]) - _ASIDE, _APART * size * len(_DEEP)
    peak = int(np.argmax(tops))
    span = view.span(view.high - 3.0 * size)
    width = 0.0 if span is None else max(abs(span[0]), abs(span[1])) - float(xs[peak])
    return float(xs[peak]) + 2 * _ASIDE, max(width - 4 * _ASIDE, 0.0)


def _edge(view: FrontView, sign: int, x: float, inner: float) -> float | None:
    """Height of the front's upper edge at a distance from the middle, a little inside of it, cm.

    Args:
        view: The front's half.
        sign: 1 of the left one, -1 of the right one.
        x: Distance from the middle, cm.
        inner: Where the front begins up there: the seam in the middle may slant below.
    """
    columns = [view.column(sign * at) for at in (max(x - _ASIDE, inner), x, x + _ASIDE)]
    tops = [column[1] for column in columns if column is not None]
    return min(tops) - _FREE if tops else None

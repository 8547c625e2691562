"""What closes a garment behind: ties over an opening, a row of buttons, lacing, a bow at the waist."""

from __future__ import annotations

import itertools

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.decorations import bow_at_waist
from swifttailor.pattern.trims.front_view import FrontView
from swifttailor.pattern.trims.shapes import Bow, Trim

_HALVES = (("left_btorso", 1), ("right_btorso", -1))
_TIES_BELOW_NECK = (0.8, 19.0)
"""Where two ties are, below the neck; a third is at the waist, cm."""
_TIES_APART, _TIE, _TIE_TAIL = 8.0, 11.0, 12.0
"""Least distance of two, width of their loops and length of their ends, cm."""
_GAP, _OPEN_GAP = 1.4, 2.4
"""How far each edge lies from the middle between two ties, and at the hem below the last one, cm."""
_LEAST_GAP = 0.12
_BUTTON, _SPACING, _LAP = 0.6, 8.0, 1.5
"""Radius and distance of buttons, and how far from them the edge lies, cm."""
_LACED_APART, _LACES_RISE, _LACE, _LACED_MOST = 3.2, 3.6, 0.22, 34.0
_SHORTEST = 10.0
_NEAR_MIDDLE, _MOST_OF = (0.3, 1.2, 2.2), 0.7
_BOW, _BOW_TAIL = 16.0, 24.0


def back_ties(chalk: Chalk, name: str) -> list[Trim]:
    """An opening down the middle of the back, with ties at the neck, below it and at the waist."""
    ends = _middle(chalk)
    if ends is None:
        return []
    low, high = ends
    heights = [high - below * chalk.size for below in _TIES_BELOW_NECK]
    heights = [y for y in (*heights, chalk.waist) if y > low + 3.0]
    ties = [y for k, y in enumerate(heights) if not k or heights[k - 1] - y > _TIES_APART * chalk.size]
    pieces: list[Trim] = []
    for upper, lower in itertools.pairwise([*ties, low + 0.3]):
        at_hem = lower < low + 1.0
        for panel, sign in _HALVES:
            pieces += _gap(chalk, name, panel, sign, (upper, lower), at_hem=at_hem)
    for y in ties:
        found = _bow(chalk, name, y, _TIE, _TIE_TAIL)
        if not found:
            return []
        pieces += found
    return pieces


def back_buttons(chalk: Chalk, name: str) -> list[Trim]:
    """A row of buttons down the middle of the back, beside the edge of the half that lies above."""
    ends = _middle(chalk)
    if ends is None:
        return []
    low, high = ends
    count = max(round((high - low - 3.0) / (_SPACING * chalk.size)), 1) + 1
    view = chalk.views["left_btorso"]
    row = []
    for y in np.linspace(high - 1.4, low + 2.0, count):
        row += chalk.button(
            name, "left_btorso", (_inner(view, float(y)) + 0.05, float(y)), _BUTTON * chalk.size
        )
    heights = np.linspace(low + 0.3, high - 1.2, 14)
    edge = [(-_inner(chalk.views["right_btorso"], float(y)) - _LAP * chalk.size, float(y)) for y in heights]
    line = chalk.line(name, "right_btorso", edge)
    return [*line, *row] if line and len(row) == count else []


def back_lacing(chalk: Chalk, name: str) -> list[Trim]:
    """A lace that crosses the middle of the back from eyelet to eyelet."""
    ends = _middle(chalk)
    if ends is None:
        return []
    low, high = max(ends[0], ends[1] - _LACED_MOST * chalk.size), ends[1]
    count = max(round((high - low - 3.0) / (_LACES_RISE * chalk.size)), 2)
    heights = np.linspace(high - 1.5, low + 1.5, count + 1)
    pieces: list[Trim] = []
    for panel, sign in _HALVES:
        for upper, lower in itertools.pairwise(heights):
            middle = float(upper + lower) / 2
            for y in (upper, lower):
                x = _inner(chalk.views[panel], middle)
                ways = [(sign * _LACED_APART * chalk.size, float(y)), (sign * (x + 0.3), middle)]
                pieces += chalk.line(name, panel, ways, width=_LACE)
    return pieces


def back_bow(chalk: Chalk, name: str) -> list[Trim]:
    """In the middle of the waist behind, of a bodice, a dress without a waist seam or a skirt."""
    return bow_at_waist(chalk, name, ("left_btorso", "wb_back"), above=1.0, width=_BOW, tail=_BOW_TAIL)


def _middle(chalk: Chalk) -> tuple[float, float] | None:
    """Where the middle of a back in two halves begins and ends, cm; None where it is too short."""
    columns = []
    for panel, sign in _HALVES:
        view = chalk.views.get(panel)
        found = [view.column(sign * x) for x in _NEAR_MIDDLE] if view is not None else []
        tall = [column for column in found if column is not None]
        if not tall:
            return None
        # The middle of a back may slant, and is then crossed beside it alone.
        own = next((c for c in tall if c[1] - c[0] > _MOST_OF * max(d[1] - d[0] for d in tall)), tall[0])
        columns.append(own)
    low, high = max(column[0] for column in columns), min(column[1] for column in columns)
    return (low, high) if high - low >= _SHORTEST * chalk.size else None


def _inner(view: FrontView, y: float) -> float:
    """How far from the middle of the body a half of the back begins at a height, cm."""
    span = view.span(y)
    return 0.0 if span is None or span[0] * span[1] <= 0.0 else min(abs(span[0]), abs(span[1]))


def _gap(
    chalk: Chalk, name: str, panel: str, sign: int, ends: tuple[float, float], *, at_hem: bool
) -> list[Trim]:
    """What is seen of the wearer between two ties, or below the last one, on one half of the back."""
    view, (upper, lower) = chalk.views[panel], ends
    shares = np.linspace(0.0, 1.0, 9)
    wide = shares * _OPEN_GAP if at_hem else 4.0 * shares * (1.0 - shares) * _GAP
    heights = upper + shares * (lower - upper)
    inner = [_inner(view, float(y)) + 0.02 for y in heights]
    first = [(sign * x, float(y)) for x, y in zip(inner, heights, strict=True)]
    second = [
        (sign * (x + max(float(w) * chalk.size, _LEAST_GAP)), float(y))
        for x, w, y in zip(inner, wide, heights, strict=True)
    ]
    return chalk.ruled(name, panel, first, second, "hole", is_cut=False)


def _bow(chalk: Chalk, name: str, y: float, width: float, tail: float) -> list[Trim]:
    view = chalk.views["left_btorso"]
    at = (_inner(view, y) + 0.3, y)
    if not view.holds([at]):
        return []
    u, v = view.local([at])[0].tolist()
    return [Bow(name, "left_btorso", (u, v), width * chalk.size, tail * chalk.size)]

"""Ruching: folds that run in from side seams along which cloth is gathered, and those of draped fronts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.trims.chalk import Chalk, Point
from swifttailor.pattern.trims.front_view import FrontView, over_darts
from swifttailor.pattern.trims.shapes import Patch, Trim

_TORSO = (("left", 1.0), ("right", -1.0))
_APART, _BESIDE, _ABOVE = 2.6, 0.7, 2.2
"""Distance of folds, how far they stay from the seam, and from the armhole and the hem, cm."""
_LONG = (0.75, 0.5, 0.9, 0.6, 0.82, 0.45, 0.7)
"""How far folds reach, one after the other, as parts of the way to the middle."""
_HANG, _FOLD = 0.12, 0.13
"""How far folds hang in their middle, times their length, and half the width of what is drawn, cm."""
_FEWEST = 3
_FAN: tuple[tuple[float, float], ...] = (
    (26.0, -17.0),
    (20.0, -19.0),
    (14.0, -19.0),
    (8.0, -18.0),
    (3.0, -16.0),
)
"""Where the folds of a draped bodice end: above the waist, and beside the middle towards the right, cm."""
_FAN_BELOW: tuple[tuple[float, float], ...] = (
    (-4.0, -16.0), (-10.0, -15.0), (-17.0, -12.0), (-24.0, -7.0), (-31.0, 0.0),
)  # fmt: skip
"""The same of a skirt."""
_FROM_KNOT, _ENDS, _PLACES, _SHORTEST_RUN = 0.05, (0.96, 1.0, 0.9), 40, 6
"""Where draped folds begin and end, as parts of their way; at how many places each is looked at, and at how
many it lies on a panel at least."""
_NEAR_HEM, _BELOW_WAIST, _FLARES = 0.2, 0.8, 1.3
"""Where the width of a skirt is measured, as parts of its height; wide ones are so many times wider below."""
_SWELL = 1.1
"""How far draped folds stand off, cm."""


def ruching(chalk: Chalk, name: str) -> list[Trim]:
    """Folds along both side seams, in front and behind, from the armholes to the hem."""
    pieces: list[Trim] = []
    for part in ("ftorso", "btorso"):
        views = [chalk.views.get(f"{side}_{part}") for side, _ in _TORSO]
        if all(view is not None for view in views):
            shaped = [(view, sign) for view, (_, sign) in zip(views, _TORSO, strict=True) if view is not None]
            pieces += _both_sides(chalk, name, shaped)
    for panel in ("skirt_front", "skirt_back"):
        view = chalk.views.get(panel)
        if view is not None:
            pieces += _both_sides(chalk, name, [(view, 1.0), (view, -1.0)])
    return pieces if len(pieces) >= 4 * _FEWEST else []


def draped_folds(chalk: Chalk, name: str) -> list[Trim]:
    """Folds across the front that meet at the waist on the wearer's left."""
    pieces: list[Trim] = []
    for panels, ends in ((("left_ftorso", "right_ftorso"), _FAN), (("skirt_front",), _FAN_BELOW)):
        views = [chalk.views[panel] for panel in panels if panel in chalk.views]
        if len(views) == len(panels) and not (panels == ("skirt_front",) and pieces and _is_wide(views[0])):
            pieces += _fan(chalk, name, views, ends)
    return pieces if len(pieces) >= _FEWEST else []


def _is_wide(skirt: FrontView) -> bool:
    """Whether a skirt flares so much that it falls in folds of its own."""
    hem, above = (skirt.span(skirt.low + t * (skirt.high - skirt.low)) for t in (_NEAR_HEM, _BELOW_WAIST))
    return hem is not None and above is not None and hem[1] - hem[0] > _FLARES * (above[1] - above[0])


def _both_sides(chalk: Chalk, name: str, shaped: Sequence[tuple[FrontView, float]]) -> list[Trim]:
    """Folds on two halves, each of which has its mirror image."""
    s = chalk.size
    low = max(view.low for view, _ in shaped) + _ABOVE * s
    high = min(_underarm(view, sign) for view, sign in shaped) - _ABOVE * s
    pieces: list[Trim] = []
    for k, y in enumerate(np.arange(high, low, -_APART * s)):
        pair = [_fold(chalk, name, view, sign, float(y), _LONG[k % len(_LONG)]) for view, sign in shaped]
        if all(pair):
            pieces += [piece for half in pair for piece in half]
    return pieces


def _underarm(view: FrontView, sign: float) -> float:
    """Height of the outermost point of the upper part of a half: where its side seam begins."""
    outline = view.outline[view.outline[:, 1] > (view.low + view.high) / 2]
    if "torso" not in view.panel.name:
        return view.high
    out = sign * outline[:, 0]
    return float(outline[out >= out.max() - 0.3, 1].max())


def _fold(chalk: Chalk, name: str, view: FrontView, sign: float, y: float, share: float) -> list[Trim]:
    """A line that begins at the seam and hangs a little; shorter where it would leave the panel."""
    s = chalk.size
    span = view.span(y)
    if span is None:
        return []
    outer = sign * (span[1] if sign > 0 else span[0]) - _BESIDE * s
    for part in (share, 0.7 * share, 0.45 * share):
        length = part * outer
        along = np.linspace(0.0, 1.0, 25)
        line: list[Point] = [
            (sign * (outer - length * t), y - _HANG * length * float(t * (1.6 - t))) for t in along
        ]
        run = over_darts(view, line)
        ends = [(x, y + 2 * _FOLD * s) for x, y in reversed(run)]
        found = chalk.line(name, view.panel.name, run, _FOLD * s)
        if found and view.carries([*run, *ends]):  # slits for godets are no darts
            return found
    return []


def _fan(
    chalk: Chalk, name: str, views: Sequence[FrontView], ends: Sequence[tuple[float, float]]
) -> list[Trim]:
    """Folds from the waist on the left, each between two lines and cut off where a panel ends."""
    s = chalk.size
    side = max(views, key=lambda view: float(view.outline[:, 0].max()))
    start_y = chalk.waist + (1.5 if ends[0][0] > 0 else -2.5) * s
    span = side.span(start_y)
    if span is None:
        return []
    start = np.array([span[1] - 1.2 * s, start_y])
    lines = []
    for k, (above, x) in enumerate(ends):
        end = np.array([x * s, chalk.waist + above * s])
        share = np.linspace(_FROM_KNOT, _ENDS[k % len(_ENDS)], _PLACES)
        off = start + (end - start) * share[:, None]
        bend = np.linspace(0.0, 1.0, _PLACES)
        off[:, 1] -= 0.09 * float(np.linalg.norm(end - start)) * 4 * bend * (1 - bend)
        lines.append(off)
    return [
        piece
        for first, second in pairwise(lines)
        for view in views
        for piece in _draped(chalk, name, view, first, second)
    ]


def _draped(chalk: Chalk, name: str, view: FrontView, first: Floats, second: Floats) -> list[Trim]:
    """What of a fold between two lines (n, 2) lies on one panel; it runs on over darts, which are shut."""
    both = zip(first, second, strict=True)
    held = np.flatnonzero([view.bridges([one, other]) for one, other in both])
    if not len(held):
        return []
    runs = np.split(held, np.flatnonzero(np.diff(held) > 1) + 1)
    pieces: list[Trim] = []
    for run in runs:
        # Both lines may lie on it, and a corner of the neckline between them.
        if len(run) < _SHORTEST_RUN or not view.carries([*first[run], *second[run][::-1]]):
            continue
        lines = (second[run].tolist(), first[run].tolist())
        folds = chalk.ruled(name, view.panel.name, *lines, is_cut=False, to_the_edge=True)
        pieces += [replace(fold, swell=_SWELL * chalk.size) for fold in folds if isinstance(fold, Patch)]
    return pieces

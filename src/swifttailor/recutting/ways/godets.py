"""Godets: wedges let into the hem of a skirt, and taken out again."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import numpy as np

from swifttailor.pattern import EdgeRef, Line, Panel, Pattern, Placement
from swifttailor.pattern.panel import Edge
from swifttailor.recutting.table.workbench import Workbench
from swifttailor.recutting.ways.ends import find_ends

_WIDEST_NOTCH_CM = 10.0
_LEAST_GAP_CM = 3.0
"""Of hem between two notches."""
_IN_FRONT_CM = 5.0
"""How far godets stand off the panel before sewing."""
_LEFT_ABOVE_CM = 8.0
"""What stays at least above the point of a godet."""


def remove_godets(pattern: Pattern, names: Collection[str]) -> Pattern | None:
    """Takes godets out and closes the notches that they were let into.

    Args:
        pattern: Any pattern.
        names: Panels of the godets.

    Returns:
        The pattern without them; None where one is let into anything but a notch of one panel or a seam.
    """
    bench = Workbench(pattern)
    notches = []
    for name in names:
        partners = [bench.partner(s.id) for s in bench.pieces[name].sides]
        sewn = [p for p in partners if p is not None]
        if len(sewn) != 2:
            return None
        a, b = sewn
        notches.append((b, a) if bench.neighbour(b, 1) == a else (a, b))
    bench.remove(names)
    for a, b in notches:
        if bench.piece_of(a) is not bench.piece_of(b):
            bench.sew(a, b)
            continue
        if bench.neighbour(a, 1) != b:
            return None
        # The line that closes the notch is hem, until it is made one with what is beside it.
        bench.side(a).edge = replace(bench.side(a).edge, curve=Line())
        bench.drop(b)
        before = bench.neighbour(a, -1)
        kept = before if _join(bench, before, a) else a
        _join(bench, kept, bench.neighbour(kept, 1))
    return bench.pattern()


def _join(bench: Workbench, first: int, second: int) -> bool:
    """Makes one straight side of two that draw on each other and are sewn to nothing."""
    piece = bench.piece_of(first)
    if any(
        not isinstance(bench.side(s).edge.curve, Line) or bench.partner(s) is not None
        for s in (first, second)
    ):
        return False
    one, other = (np.diff(piece.chord(s), axis=0)[0] for s in (first, second))
    turn = abs(one[0] * other[1] - one[1] * other[0])
    if turn > 1e-3 * float(np.hypot(*one) * np.hypot(*other)) or one @ other <= 0:
        return False
    bench.drop(second)
    return True


def add_godets(
    pattern: Pattern, hem: Sequence[EdgeRef], count: int, width: float, height: float
) -> Pattern | None:
    """Cuts notches into a hem, evenly over every panel, and lets godets in.

    Args:
        pattern: Any pattern.
        hem: Its hem.
        count: Godets of each panel.
        width: Of a godet at the hem, cm.
        height: Of a godet, cm.

    Returns:
        The pattern with the godets; None where the hem of a panel is in several pieces, or they do not fit.
    """
    bench = Workbench(pattern)
    for end in find_ends(bench, pattern, hem):
        piece = bench.pieces[end.panel]
        run = _merged(bench, end.run)
        length, above = piece.length(run[0]), float(np.ptp(piece.panel.vertices[:, 1]))
        notch = min(_WIDEST_NOTCH_CM, length / count - _LEAST_GAP_CM, 0.8 * width)
        side_length = float(np.hypot(width / 2, height))
        if len(run) != 1 or notch < 1.0 or above < height + _LEFT_ABOVE_CM:
            return None
        sides = _notches(bench, run[0], count, notch, side_length)
        for k, (down, up) in enumerate(sides):
            name = f"ins_{end.panel}_{k}"
            if name in bench.pieces:
                return None
            godet = _godet(piece.panel, name, k - (count - 1) / 2, width, height)
            own = bench.add(godet)
            # Clockwise loops run along their hem the other way.
            left, right = (own[2], own[1]) if piece.panel.signed_area() >= 0 else (own[1], own[0])
            bench.sew(down, left)
            bench.sew(up, right)
    return bench.pattern()


def _merged(bench: Workbench, run: Sequence[int]) -> list[int]:
    """A run of sides in which straight ones that draw on each other are one."""
    kept = [run[0]]
    for id in run[1:]:
        if not _join(bench, kept[-1], id):
            kept.append(id)
    return kept


def _notches(
    bench: Workbench, side: int, count: int, notch: float, side_length: float
) -> list[tuple[int, int]]:
    """Cuts notches into a side; their two sides, in the order of the loop."""
    piece = bench.piece_of(side)
    total = piece.length(side)
    turn = 1.0 if piece.panel.signed_area() >= 0 else -1.0
    found = []
    for k in reversed(range(count)):
        middle = total * (k + 0.5) / count
        right = bench.split(side, (middle + notch / 2) / piece.length(side))
        wedge = bench.split(side, (middle - notch / 2) / piece.length(side))
        start, end = piece.chord(wedge)
        half = float(np.hypot(*(end - start))) / 2
        along = (end - start) / (2 * half)
        rise = float(np.sqrt(side_length**2 - half**2))
        apex = (start + end) / 2 + rise * turn * np.array([-along[1], along[0]])
        bench.side(wedge).edge = replace(bench.side(wedge).edge, curve=Line())
        found.append((wedge, bench.insert_line(right, apex)))
    return found[::-1]


def _godet(model: Panel, name: str, place: float, width: float, height: float) -> Panel:
    """A triangle in front of its panel, godets side by side."""
    box = model.to_world(model.vertices)
    middle, low = float(box[:, 0].mean()), float(box[:, 1].min())
    front = model.normal()[2] > 0
    z = float(box[:, 2].mean()) + (_IN_FRONT_CM if front else -_IN_FRONT_CM)
    corners = np.array([[0.0, 0.0], [width, 0.0], [width / 2, height]])
    if model.signed_area() < 0:
        corners = corners[[0, 2, 1]]
        place = -place
    x = middle + place * width - width / 2
    return Panel(name, corners, (Edge(Line()),) * 3, Placement((x, low, z), (0.0, 0.0, 0.0)), model.label)

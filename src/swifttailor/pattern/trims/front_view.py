"""A panel as it stands before draping, seen from the front: where trims are measured off."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from swifttailor.arrays import Bools, Floats
from swifttailor.pattern.panel import Panel
from swifttailor.pattern.pattern import EdgeRef, Pattern

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

_FACING = 0.5
"""Least determinant of a panel's turn that is seen from the front; sleeves' hoods stand edge on."""
_MARGIN = 0.4
"""Trims stay so far inside of what their panel covers, cm."""
_EXACT = 0.01
"""How far its outline is from the panel's curves, and what lies on it may lie outside, cm."""
_HANGING = 0.005
"""So much of a piece may lie beside its panel."""
_STEEP = 2.0
"""An edge that rises so many times as far as it goes aside runs down the front."""
_CLOSE_NECK = 16.0
"""Necks that fall less below the shoulder are close, cm."""
_MIDDLE = 3.0
"""Edges in the middle are at most so far from it, cm."""


@dataclass(frozen=True, eq=False)
class FrontView:
    """One panel; x to the wearer's left, y up from the floor, cm."""

    panel: Panel
    darts: tuple[int, ...] = ()
    """The corners at the tips of its darts, which are sewn shut; see `dart_tips`."""

    @cached_property
    def outline(self) -> Floats:
        """(n, 2) its outline in the view."""
        return self.seen(self.panel.outline(_EXACT))

    @property
    def low(self) -> float:
        """Its lowest height."""
        return float(self.outline[:, 1].min())

    @property
    def high(self) -> float:
        """Its greatest height."""
        return float(self.outline[:, 1].max())

    @property
    def side(self) -> int:
        """1 of a panel on the wearer's left, -1 of one on the right."""
        return 1 if self.outline[:, 0].mean() > 0 else -1

    @property
    def faces_front(self) -> bool:
        """Whether it can be drawn on in this view."""
        return abs(float(np.linalg.det(self._turn))) >= _FACING

    @cached_property
    def _turn(self) -> Floats:
        return self.panel.placement.matrix()[:2, :2]

    def seen(self, points: ArrayLike) -> Floats:
        """Panel-local points (n, 2) in the view."""
        return self.panel.to_world(points)[:, :2]

    def local(self, points: ArrayLike) -> Floats:
        """Points (n, 2) of the view on the panel."""
        shift = np.asarray(self.panel.placement.translation[:2])
        return np.linalg.solve(self._turn, (np.asarray(points, float) - shift).T).T

    def span(self, y: float) -> tuple[float, float] | None:
        """Its smallest and greatest x at a height; None where it does not reach it."""
        return self._crossed(1, y)

    def column(self, x: float) -> tuple[float, float] | None:
        """Its smallest and greatest height at distance `x` from the middle; None where it does not reach."""
        return self._crossed(0, x)

    def _crossed(self, axis: int, at: float) -> tuple[float, float] | None:
        a, b = self.outline, np.roll(self.outline, -1, axis=0)
        crossing = ((a[:, axis] - at) * (b[:, axis] - at) <= 0) & (a[:, axis] != b[:, axis])
        if not crossing.any():
            return None
        a, b, other = a[crossing], b[crossing], 1 - axis
        share = (at - a[:, axis]) / (b[:, axis] - a[:, axis])
        found = a[:, other] + share * (b[:, other] - a[:, other])
        return float(found.min()), float(found.max())

    @cached_property
    def _cloth(self) -> BaseGeometry:
        from shapely import Polygon, prepare

        cloth = Polygon(self.outline).buffer(_EXACT)
        prepare(cloth)
        return cloth

    @cached_property
    def _bridged(self) -> BaseGeometry:
        """With what its darts take away."""
        from shapely import Polygon, prepare, union_all

        corners = self.seen(self.panel.vertices)
        wedges = [np.take(corners, [tip - 1, tip, tip + 1], axis=0, mode="wrap") for tip in self.darts]
        bridged = union_all([self._cloth, *(Polygon(wedge).buffer(2 * _EXACT) for wedge in wedges)])
        prepare(bridged)
        return bridged

    def bridges(self, points: ArrayLike) -> bool:
        """Whether all points (n, 2) of the view lie on it or in its darts, borders included."""
        from shapely import intersects_xy

        return bool(np.all(intersects_xy(self._bridged, np.asarray(points, float))))

    def on_cloth(self, points: ArrayLike) -> list[bool]:
        """Which points (n, 2) of the view lie on it, and not in one of its darts."""
        from shapely import intersects_xy

        return [bool(held) for held in intersects_xy(self._cloth, np.asarray(points, float))]

    def carries(self, border: ArrayLike) -> bool:
        """Whether a piece with this border (n, 2) in the view lies on it, over no godet."""
        from shapely import Polygon

        piece = Polygon(border)
        return piece.is_valid and piece.difference(self._bridged).area <= _HANGING * piece.area

    def holds(self, points: ArrayLike) -> bool:
        """Whether all points (n, 2) of the view lie on it, away from its sides but for the middle one."""
        return bool(np.all(self.held(points)))

    def held(self, points: ArrayLike) -> Bools:
        """(n,) which points (n, 2) of the view do."""
        from shapely import intersects_xy

        points = np.asarray(points, float)
        beside = np.where(np.abs(points[:, :1]) > _MIDDLE, (_MARGIN, 0.0), 0.0)
        near = intersects_xy(self._bridged, points - beside) & intersects_xy(self._bridged, points + beside)
        return np.asarray(intersects_xy(self._cloth, points) & near, bool)


def over_darts(view: FrontView, line: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    """Those points of a line that lie on cloth: it runs on straight over darts, which are sewn shut."""
    on = view.on_cloth(line)
    return [point for point, held in zip(line, on, strict=True) if held]


def dart_tips(pattern: Pattern) -> dict[str, tuple[int, ...]]:
    """Of the panels that have darts, the corners at their tips: between two edges that are sewn together."""
    found: dict[str, tuple[int, ...]] = {}
    for stitch in pattern.stitches:
        first, second = stitch.sides
        if first.panel == second.panel:
            count = len(pattern.panel(first.panel).edges)
            for tip, before in ((first.edge, second.edge), (second.edge, first.edge)):
                if (before + 1) % count == tip:
                    found[first.panel] = (*found.get(first.panel, ()), tip)
    return found


def edge_at(pattern: Pattern, ref: EdgeRef, y: float) -> float:
    """The x of a front's edge in the middle at a height, cm: not 0 where a size was recut."""
    panel = pattern.panel(ref.panel)
    (x0, y0), (x1, y1) = sorted(FrontView(panel).seen(panel.chord(ref.edge)).tolist(), key=lambda end: end[1])
    return float(np.interp(y, (y0, y1), (x0, x1)))


def is_closed_to_the_neck(pattern: Pattern) -> bool:
    """Whether the seam down the front begins close below the neck, as it does not under lapels."""
    seam = front_edge(pattern)
    return seam is not None and FrontView(pattern.panel(seam[0].panel)).high - seam[3] < _CLOSE_NECK


def front_edge(pattern: Pattern) -> tuple[EdgeRef, EdgeRef, float, float] | None:
    """The seam that joins left and right fronts in the middle.

    Returns:
        Its uppermost edges on the right and on the left front, and the heights of its lower and upper end,
        cm; None where there is none.
    """
    found: list[tuple[float, float, EdgeRef, EdgeRef]] = []
    for stitch in pattern.stitches:
        names = sorted(ref.panel for ref in stitch.sides)
        if names != ["left_ftorso", "right_ftorso"]:
            continue
        right, left = sorted(stitch.sides, key=lambda ref: ref.panel, reverse=True)
        seen = FrontView(pattern.panel(right.panel)).seen(pattern.panel(right.panel).chord(right.edge))
        (x0, y0), (x1, y1) = seen
        if max(abs(x0), abs(x1)) <= _MIDDLE and abs(y1 - y0) >= _STEEP * abs(x1 - x0):
            found.append((min(y0, y1), max(y0, y1), right, left))
    if not found:
        return None
    top = max(found, key=lambda each: each[1])
    return top[2], top[3], min(each[0] for each in found), top[1]

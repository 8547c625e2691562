"""Runs of neighbouring edges of one panel, as lines with corners."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern import Panel

_FLATTEN_CM = 0.02
_CORNER_DEGREES = 25.0


def edge_runs(panel: Panel, edges: Collection[int]) -> list[list[int]]:
    """Groups edges of a panel into runs that follow each other around its loop, in loop order."""
    count = len(panel.edges)
    left = set(edges)
    if len(left) == count:
        return [list(range(count))]
    runs = []
    for start in sorted(k for k in left if (k - 1) % count not in left):
        run = [start]
        while (run[-1] + 1) % count in left:
            run.append((run[-1] + 1) % count)
        runs.append(run)
    return runs


@dataclass(frozen=True, eq=False)
class Line:
    """A polyline in the plane and where along it the cloth turns."""

    points: Floats
    """(n, 2) cm."""
    joints: tuple[int, ...]
    """Points where one edge ends and the next begins."""

    @classmethod
    def along(cls, panel: Panel, run: list[int], axes: tuple[int, int] = (0, 1)) -> Line:
        """The placed line of a run of edges, seen along a world axis.

        Args:
            panel: Their panel.
            run: Edges that follow each other.
            axes: World axes that become x and y; (0, 1) is the view from the front.
        """
        pieces = [panel.to_world(panel.flatten_edge(k, _FLATTEN_CM))[:, list(axes)] for k in run]
        joints = np.cumsum([len(p) - 1 for p in pieces])[:-1]
        points = np.concatenate([pieces[0][:1], *(p[1:] for p in pieces)])
        return cls(points, tuple(map(int, joints)))

    def turned_round(self) -> Line:
        """The same line from its other end."""
        last = len(self.points) - 1
        return Line(self.points[::-1], tuple(last - k for k in reversed(self.joints)))

    def mirrored(self) -> Line:
        """The line reflected in x = 0."""
        return Line(self.points * [-1.0, 1.0], self.joints)

    @property
    def chord_angle(self) -> float:
        """Direction from the first point to the last, degrees above +x."""
        x, y = self.points[-1] - self.points[0]
        return float(np.degrees(np.arctan2(y, x)))

    @property
    def length(self) -> float:
        """Along the line, cm."""
        return float(np.hypot(*np.diff(self.points, axis=0).T).sum())

    def directions(self) -> Floats:
        """(m,) direction of every piece that is not too short to have one, degrees, without jumps."""
        steps = np.diff(self.points, axis=0)
        steps = steps[np.hypot(*steps.T) > 1e-4]
        return np.degrees(np.unwrap(np.arctan2(steps[:, 1], steps[:, 0])))

    def turns(self) -> tuple[float, float]:
        """How far the line turns left, and how far right, in all, degrees."""
        change = np.diff(self.directions())
        return float(change[change > 0].sum()), float(-change[change < 0].sum())

    def corners(self) -> list[tuple[int, float]]:
        """Joints where the line turns sharply: point and turn in degrees, left positive."""
        found = []
        for k in self.joints:
            a, b = self.points[k] - self.points[k - 1], self.points[k + 1] - self.points[k]
            turn = np.degrees(np.arctan2(a[0] * b[1] - a[1] * b[0], a @ b))
            if abs(turn) > _CORNER_DEGREES:
                found.append((k, float(turn)))
        return found

    def cut_at_middle(self) -> tuple[Line, Line]:
        """The line before and after it first passes x = 0, or its point nearest to that."""
        x = self.points[:, 0]
        passing = np.flatnonzero((x[:-1] > 0) != (x[1:] > 0))
        if not len(passing):
            return self.split(int(np.abs(x).argmin()))
        k = int(passing[0])
        t = x[k] / (x[k] - x[k + 1])
        point = self.points[k] * (1 - t) + self.points[k + 1] * t
        whole = Line(
            np.insert(self.points, k + 1, point, axis=0), tuple(j if j <= k else j + 1 for j in self.joints)
        )
        return whole.split(k + 1)

    def split(self, at: int) -> tuple[Line, Line]:
        """The line before and after one of its points."""
        return (
            Line(self.points[: at + 1], tuple(k for k in self.joints if k < at)),
            Line(self.points[at:], tuple(k - at for k in self.joints if k > at)),
        )

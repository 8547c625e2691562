"""Which panels are the same piece of cloth: identical, mirrored, or their own mirror image."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.making.allowances import EdgeKind
from swifttailor.making.notches import Notch
from swifttailor.making.sewn_pattern import FlatPanel

SAME_CM = 0.03
"""Outlines that lie this close to each other are cut together."""
_SHARES = (0.0, 0.25, 0.5, 0.75, 1.0)


class Match(NamedTuple):
    """How one panel lies on another."""

    mirrored: bool
    shift: int
    """Edge j lies on edge j + shift of the other, or on shift - j where mirrored, modulo their number."""


@dataclass(frozen=True, eq=False)
class Shape:
    """A panel, reduced to what must agree."""

    points: Floats
    """(n, 5, 2) of every edge at quarters of its length, from the middle of its box, cm."""
    kinds: tuple[EdgeKind, ...]
    notches: tuple[Notch, ...]
    marks: tuple[str, ...]
    """Of every edge: darts, gathers."""

    @classmethod
    def of(cls, panel: FlatPanel, notches: tuple[Notch, ...], marks: tuple[str, ...]) -> Shape:
        """The shape of a panel."""
        points = np.array([along(e, _SHARES) for e in panel.edges])
        low, high = panel.outline.min(axis=0), panel.outline.max(axis=0)
        return cls(points - (low + high) / 2, panel.kinds, notches, marks)

    def onto(self, other: Shape, *, mirrored: bool) -> Match | None:
        """How this shape lies on another, upright; None where it does not."""
        count = len(self.points)
        if count != len(other.points):
            return None
        points = self.points[:, ::-1] * (-1.0, 1.0) if mirrored else self.points
        for shift in range(count):
            order = (shift - np.arange(count) if mirrored else np.arange(count) + shift) % count
            if np.abs(points[0] - other.points[order[0]]).max() > SAME_CM:
                continue
            match = Match(mirrored, shift)
            if np.abs(points - other.points[order]).max() <= SAME_CM and self._agrees(other, match):
                return match
        return None

    def _agrees(self, other: Shape, match: Match) -> bool:
        count = len(self.points)
        to = [on_edge(match, k, count) for k in range(count)]
        same = all(
            self.kinds[k] is other.kinds[j] and self.marks[k] == other.marks[j] for k, j in enumerate(to)
        )
        return same and {_moved(n, match, count) for n in self.notches} == {
            _rounded(n) for n in other.notches
        }


def on_edge(match: Match, edge: int, count: int) -> int:
    """The edge of the other panel on which an edge lies."""
    return (match.shift - edge if match.mirrored else edge + match.shift) % count


def along(points: Floats, fractions: tuple[float, ...] | Floats) -> Floats:
    """Points (k, 2) at fractions of the length of a polyline (n, 2)."""
    length = np.append(0.0, np.cumsum(np.hypot(*np.diff(points, axis=0).T)))
    at = np.asarray(fractions) * length[-1]
    return np.stack([np.interp(at, length, points[:, k]) for k in (0, 1)], axis=1)


def _moved(notch: Notch, match: Match, count: int) -> Notch:
    edge, fraction = on_edge(match, notch.edge, count), notch.fraction
    if match.mirrored:
        fraction = 1.0 - fraction
        if fraction == 1.0:  # the start of an edge is the end of its mirror image: the start of the next
            edge, fraction = (edge + 1) % count, 0.0
    return _rounded(Notch(edge, fraction, notch.teeth))


def _rounded(notch: Notch) -> Notch:
    return Notch(notch.edge, round(notch.fraction, 3), notch.teeth)

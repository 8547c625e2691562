"""Edges that are sewn together keep the ratio of their lengths: equal stays equal, gathers stay full."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import spsolve

from swifttailor.arrays import Floats, Longs
from swifttailor.pattern import Panel, Pattern
from swifttailor.pattern.curve import Arc, Line, length, scale

_MOST_ROUNDS = 12
_CLOSE = 2e-5
"""Ratios are kept to this share."""
_SEAM = 200.0
"""How much a centimetre between two sides of a seam counts beside one of an edge's shape."""
_HELD = 0.02
"""How much each corner stays where it is."""


def keep_seam_ratios(before: Pattern, after: Pattern) -> Pattern:
    """Moves corners as little as possible until each seam's sides have the ratio that they had.

    Args:
        before: The pattern whose ratios count.
        after: The same panels, edges and stitches in other sizes.
    """
    equations = _Equations(before, after)
    pattern = after
    for _ in range(_MOST_ROUNDS):
        if equations.worst_ratio(pattern) < _CLOSE:
            break
        pattern = equations.solved(pattern)
    return pattern


class _Equations:
    """What each round asks of the corners.

    Corners are numbered through all panels; the edge from a corner has its number.
    """

    def __init__(self, before: Pattern, target: Pattern) -> None:
        panels = target.panels
        self.start = np.cumsum([0, *(len(p.vertices) for p in panels)])
        self.next = np.concatenate([np.roll(np.arange(a, b), -1) for a, b in _pairs(self.start)])
        self.goals = np.concatenate([p.vertices for p in panels])
        sides = np.array(
            [[self.start[target.panel_index(r.panel)] + r.edge for r in s.sides] for s in target.stitches],
            np.int64,
        )
        self.sides = sides.reshape(-1, 2)
        first, second = (_edge_lengths(before, self.start, self.sides[:, k]) for k in (0, 1))
        self.weights = np.stack([np.ones(len(first)), -first / np.maximum(second, 1e-9)], axis=1)
        corners = np.arange(len(self.goals))
        x, to_x = 2 * corners, 2 * self.next
        # Of each corner: its edge's x, its own x, its edge's y, its own y; then a row for each stitch.
        columns = np.stack([to_x, x, x, to_x + 1, x + 1, x + 1], axis=1)
        rows = 4 * corners[:, None] + [0, 0, 1, 2, 2, 3]
        a, b = 2 * self.sides, 2 * self.next[self.sides]
        sewn = np.stack([b, b + 1, a, a + 1], axis=2).reshape(-1, 8)
        seams = 4 * len(corners) + np.repeat(np.arange(len(sewn)), 8)
        self.columns = np.concatenate([columns.ravel(), sewn.ravel()])
        self.rows = np.concatenate([rows.ravel(), seams])
        self.shape = (4 * len(corners) + len(sewn), 2 * len(corners))

    def worst_ratio(self, now: Pattern) -> float:
        """By what share the ratio of a seam's sides is off at most."""
        first, second = (_edge_lengths(now, self.start, self.sides[:, k]) for k in (0, 1))
        wanted = np.maximum(-self.weights[:, 1], 1e-9)
        return float(np.abs(first / np.maximum(second, 1e-9) / wanted - 1.0).max(initial=0.0))

    def solved(self, now: Pattern) -> Pattern:
        """The pattern after one round."""
        place = np.concatenate([p.vertices for p in now.panels])
        gaps = (self.goals[self.next] - self.goals) - (place[self.next] - place)
        held = _HELD * (self.goals - place)
        slopes, excess = self._seams(now, place)
        corner = np.tile([1.0, -1.0, _HELD], 2 * len(place))
        system = sparse.csr_array(
            (np.concatenate([corner, (_SEAM * slopes).ravel()]), (self.rows, self.columns)), shape=self.shape
        )
        right = np.concatenate([np.stack([gaps, held], axis=2).ravel(), -_SEAM * excess])
        moved = place + spsolve((system.T @ system).tocsc(), system.T @ right).reshape(-1, 2)
        panels = [
            with_corners(panel, moved[a:b])
            for panel, (a, b) in zip(now.panels, _pairs(self.start), strict=True)
        ]
        return replace(now, panels=tuple(panels))

    def _seams(self, now: Pattern, place: Floats) -> tuple[Floats, Floats]:
        """(s, 2, 4) how the sides' lengths go with their corners, (s,) what is too much on the first side."""
        along = place[self.next[self.sides]] - place[self.sides]
        chord = np.maximum(np.sqrt(np.vecdot(along, along)), 1e-9)
        lengths = np.stack([_edge_lengths(now, self.start, self.sides[:, k]) for k in (0, 1)], axis=1)
        # The curve goes with its chord: its length is a multiple of the chord's.
        pull = (self.weights * (lengths / chord))[..., None] * along / chord[..., None]
        return np.concatenate([pull, -pull], axis=2), (self.weights * lengths).sum(axis=1)


def _pairs(start: Longs) -> list[tuple[int, int]]:
    return list(zip(start[:-1].tolist(), start[1:].tolist(), strict=True))


def _edge_lengths(pattern: Pattern, start: Longs, numbers: Longs) -> Floats:
    """Lengths (n,) of edges that are numbered through all panels, cm."""
    straight = [
        np.hypot(*(np.roll(panel.vertices, -1, axis=0) - panel.vertices).T) for panel in pattern.panels
    ]
    lengths = np.concatenate(straight)
    edges = [edge for panel in pattern.panels for edge in panel.edges]
    owners = np.searchsorted(start, numbers, side="right") - 1
    for number, owner in zip(numbers.tolist(), owners.tolist(), strict=True):
        curve = edges[number].curve
        if not isinstance(curve, Line):
            lengths[number] = length(curve, pattern.panels[owner].chord(number - int(start[owner])))
    return lengths[numbers]


def with_corners(panel: Panel, vertices: Floats) -> Panel:
    """The panel with other corners, each edge a scaled copy of what it was."""
    edges = panel.edges
    if any(isinstance(edge.curve, Arc) for edge in edges):
        old = np.linalg.norm(np.roll(panel.vertices, -1, axis=0) - panel.vertices, axis=1)
        new = np.linalg.norm(np.roll(vertices, -1, axis=0) - vertices, axis=1)
        edges = tuple(
            edge.drawn_as(scale(edge.curve, float(b / max(a, 1e-9))))
            for edge, a, b in zip(edges, old, new, strict=True)
        )
    return replace(panel, vertices=vertices, edges=edges)

"""Lengths of many edges, and points on them, in one go: the batched form of `curve.length` and its kin."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from swifttailor.arrays import Floats, Longs
from swifttailor.pattern import curve as curves
from swifttailor.pattern.curve import Arc, Cubic, Curve, Line, Quadratic

_INTERVALS = 32
_TOLERANCE = 1e-11
_NEWTON_STEPS = 6


@dataclass(frozen=True, eq=False)
class EdgeSampler:
    """Many edges whose lengths are known, ready to be sampled by length.

    Agrees with `curve.length` and `curve.sample_by_length` to 1e-9 of the length; edges on which a fixed
    quadrature does not reach 1e-11 (cusps, loops) are left to those two functions.
    """

    curves: tuple[Curve, ...]
    chords: Floats
    """(n, 2, 2) start and end of each edge, cm."""
    lengths: Floats
    """(n,) arc lengths, cm."""
    control: Floats
    """(b, 4, 2) control points of the Bezier edges as cubics, cm."""
    bezier: Longs
    """(n,) row in `control`, or -1."""
    table: Floats
    """(b, k + 1) length up to each of k + 1 equally spaced parameters, cm."""

    @classmethod
    def of(cls, edges: Sequence[Curve], chords: ArrayLike) -> EdgeSampler:
        """Measures edges given as curves and chords (n, 2, 2) in cm."""
        chords = np.asarray(chords, np.float64).reshape(-1, 2, 2)
        along = chords[:, 1] - chords[:, 0]
        lengths = np.hypot(along[:, 0], along[:, 1])
        rows = np.array([k for k, c in enumerate(edges) if isinstance(c, Quadratic | Cubic)], np.int64)
        control = _cubic_control([edges[k] for k in rows], chords[rows])
        table = np.zeros((len(rows), _INTERVALS + 1))
        knots = np.linspace(0.0, 1.0, _INTERVALS + 1)
        np.cumsum(_interval_lengths(control, knots[:-1], knots[1:]), axis=1, out=table[:, 1:])
        coarse = _interval_lengths(control, knots[:-1:2], knots[2::2]).sum(axis=1)
        settled = np.abs(coarse - table[:, -1]) <= _TOLERANCE * table[:, -1]
        lengths[rows] = table[:, -1]
        bezier = np.full(len(chords), -1, np.int64)
        bezier[rows[settled]] = np.arange(int(settled.sum()))
        for k in [int(k) for k in rows[~settled]] + [k for k, c in enumerate(edges) if isinstance(c, Arc)]:
            lengths[k] = curves.length(edges[k], chords[k])
        return cls(tuple(edges), chords, lengths, control[settled], bezier, table[settled])

    def sample(self, counts: ArrayLike) -> Floats:
        """Points on every edge, equally spaced by length, from its start to before its end.

        Args:
            counts: (n,) segments of each edge, at least 1.

        Returns:
            (sum of counts, 2) cm, edge after edge; each begins exactly at its start.
        """
        counts = np.asarray(counts, np.int64)
        edge = np.repeat(np.arange(len(counts)), counts)
        step = np.arange(len(edge)) - np.repeat(np.cumsum(counts) - counts, counts)
        fraction = step / counts[edge]
        start, along = self.chords[:, 0], self.chords[:, 1] - self.chords[:, 0]
        points = start[edge] + along[edge] * fraction[:, None]
        row = self.bezier[edge]
        curved = np.flatnonzero((row >= 0) & (step > 0))
        points[curved] = _bezier(
            self.control[row[curved]], self._parameters(row[curved], fraction[curved])[:, None]
        )[:, 0]
        first = np.cumsum(counts) - counts
        for k, shape in enumerate(self.curves):
            if self.bezier[k] < 0 and not isinstance(shape, Line):
                own = slice(int(first[k]), int(first[k] + counts[k]))
                points[own] = curves.sample_by_length(shape, self.chords[k], int(counts[k]) + 1)[:-1]
        return points

    def _parameters(self, row: Longs, fraction: Floats) -> Floats:
        """Curve parameters (m,) at which a fraction of the length of Bezier `row` has been travelled."""
        total = self.table[row, -1]
        target = fraction * total
        # All tables in one ascending list, two apart, so that one search serves every edge.
        share = (
            self.table / np.maximum(self.table[:, -1:], 1e-300) + 2.0 * np.arange(len(self.table))[:, None]
        )
        place = np.searchsorted(share.ravel(), fraction + 2.0 * row, side="right") - 1
        cell = np.clip(place - row * (_INTERVALS + 1), 0, _INTERVALS - 1)
        low, done = cell / _INTERVALS, self.table[row, cell]
        size = self.table[row, cell + 1] - done
        t = low + np.divide(target - done, size, out=np.zeros_like(low), where=size > 0) / _INTERVALS
        control = self.control[row]
        for _ in range(_NEWTON_STEPS):
            excess = done + _interval_lengths(control, low[:, None], t[:, None])[:, 0] - target
            speed = _speed(control, t[:, None])[:, 0]
            moved = np.clip(
                t - np.divide(excess, speed, out=np.zeros_like(t), where=speed > 1e-12),
                low,
                low + 1 / _INTERVALS,
            )
            settled = bool((np.abs(moved - t) < 1e-13).all())
            t = moved
            if settled:
                break
        return t


def _cubic_control(edges: Sequence[Curve], chords: Floats) -> Floats:
    """Control points (b, 4, 2) in cm of Bezier edges over their chords, quadratic ones raised to cubic."""
    relative = np.zeros((len(edges), 2, 2))
    for k, edge in enumerate(edges):
        if isinstance(edge, Cubic):
            relative[k] = edge.control_1, edge.control_2
        elif isinstance(edge, Quadratic):
            x, y = edge.control
            relative[k] = (2 / 3 * x, 2 / 3 * y), (2 / 3 * x + 1 / 3, 2 / 3 * y)
    start, along = chords[:, :1], chords[:, 1:] - chords[:, :1]
    left = np.stack([-along[..., 1], along[..., 0]], axis=-1)
    inner = start + relative[..., :1] * along + relative[..., 1:] * left
    return np.concatenate([start, inner, chords[:, 1:]], axis=1)


def _bezier(control: Floats, t: Floats) -> Floats:
    """Points (b, m, d) of cubics (b, 4, d) at parameters that broadcast to (b, m)."""
    t = t[..., None]
    s = 1 - t
    p = control[:, None]
    return (
        s * s * s * p[:, :, 0]
        + 3 * s * s * t * p[:, :, 1]
        + 3 * s * t * t * p[:, :, 2]
        + t * t * t * p[:, :, 3]
    )


def _speed(control: Floats, t: Floats) -> Floats:
    """Length of the derivative (b, m) of cubics (b, 4, 2) at parameters that broadcast to (b, m)."""
    step = 3 * np.diff(control, axis=1)[:, None]
    s = 1 - t
    dx, dy = (
        s * s * step[:, :, 0, k] + 2 * s * t * step[:, :, 1, k] + t * t * step[:, :, 2, k] for k in (0, 1)
    )
    return np.sqrt(dx * dx + dy * dy)


def _interval_lengths(control: Floats, low: Floats, high: Floats) -> Floats:
    """Lengths (b, m) of cubics between parameters that broadcast to (b, m), by Gauss quadrature."""
    nodes, weights = curves.gauss_rule()
    low, high = np.broadcast_arrays(np.atleast_2d(low), np.atleast_2d(high))
    size = (high - low)[..., None]
    t = low[..., None] + size * nodes
    speed = _speed(control, t.reshape(len(t), low.shape[1] * len(nodes)))
    speed = speed.reshape(len(control), low.shape[1], len(nodes))
    return (speed @ weights) * size[..., 0]

"""Cubic curves bent until they leave and arrive in given directions and have a given length.

GarmentCode looks for the same curve, but its search stops short of it: at the sharpest bend the misfit has
kinks, and where the search gets stuck on them depends on the last digit of its numbers. Here the minimum
itself is found, as a sequence of small quadratic programs with the bends as bounds.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy.optimize import nnls

from swifttailor.arrays import Floats
from swifttailor.programs.design_error import DesignError
from swifttailor.programs.edges import BezierEdge, to_complex, to_vertex
from swifttailor.programs.planar_curves import CubicCurve

_SAMPLES = 70
"""Where the sharpest bend is sought: as many places as GarmentCode takes, for they are part of the misfit."""
_END_COST = 0.001
"""What a centimetre that the end moves along the chord costs, squared."""
_ENOUGH = 1e-11
_MOST_STEPS = 60
_LEAST_DAMPING, _MOST_DAMPING = 1e-7, 1e6


def curve_match_tangents(
    curve: CubicCurve,
    target_tan0: Sequence[float],
    target_tan1: Sequence[float],
    target_len: float | None = None,
) -> BezierEdge:
    """Bends a cubic curve until its ends point in given directions and it has a length.

    The start stays where it is, the end may move along the chord, and the sharpest bend is kept soft: the
    squares of what is missed, with lengths in cm and the bend per cm, are smallest together.

    Args:
        curve: A curve that is nearly right.
        target_tan0: Direction at the start; its size does not matter.
        target_tan1: Direction at the end.
        target_len: Length in cm; without it that of the curve.
    """
    first, last = to_complex(target_tan0), to_complex(target_tan1)
    length = curve.length() if target_len is None else target_len
    points = _bent(curve, first / abs(first), last / abs(last), length)
    start, control_1, control_2, end = (to_vertex(p) for p in points)
    return BezierEdge(start, end, [control_1, control_2], relative=False)


@lru_cache(maxsize=512)
def _bent(curve: CubicCurve, first: complex, last: complex, target_len: float) -> tuple[complex, ...]:
    """Control points of the bent curve."""
    start, end = curve.start, curve.end
    chord = (end - start) / abs(end - start)
    search = _Search(
        np.array([curve.control_1 - start, curve.control_2 - curve.control_1, end - curve.control_2]),
        np.array([[1, 1j, 0, 0, 0], [-1, -1j, 1, 1j, 0], [0, 0, -1, -1j, chord]]),
        np.array([first, last]),
        target_len,
    )
    x = search.minimum().tolist()
    moved_1, moved_2 = complex(x[0], x[1]), complex(x[2], x[3])
    return start, curve.control_1 + moved_1, curve.control_2 + moved_2, end + chord * x[4]


# What each side of the control polygon adds to the first and second derivative at a parameter.
_AT = np.linspace(0.0, 1.0, _SAMPLES)
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(16)
_LENGTH_AT = (np.linspace(0.0, 1.0, 5)[:-1, None] + (_NODES + 1) / 8).ravel()
_LENGTH_WEIGHT = np.tile(_WEIGHTS / 8, 4)
_ALL_AT = np.concatenate([_AT, _LENGTH_AT])
_FIRST = 3 * np.stack([(1 - _ALL_AT) ** 2, 2 * _ALL_AT * (1 - _ALL_AT), _ALL_AT**2], axis=1)
_SECOND = 6 * np.stack([_AT - 1, 1 - 2 * _AT, _AT], axis=1)


@dataclass(frozen=True)
class _Trial:
    """A curve on the way."""

    x: Floats
    sides: np.ndarray
    """Of its control polygon, complex."""
    velocity: np.ndarray
    acceleration: np.ndarray
    speed: Floats
    missed: Floats
    """Length, directions at both ends (two numbers each), and the weighed move of the end."""
    bends: Floats
    misfit: float


class _Search:
    """The search for one curve; its five unknowns move the inner control points, and the end on the chord."""

    def __init__(self, sides: np.ndarray, moves: np.ndarray, targets: np.ndarray, length: float) -> None:
        self._sides = sides
        self._moves = moves  # of the sides by the unknowns
        self._targets = targets
        self._length = length
        self._first = _FIRST @ moves
        self._second = _SECOND @ moves

    def minimum(self) -> Floats:
        """The unknowns of the best curve."""
        best, damping = self._trial(np.zeros(5)), 1e-3
        if not math.isfinite(best.misfit):
            raise DesignError(
                "A sleeve or a hood would begin with a curve whose points coincide. "
                "Change the parameters that give the depths of armhole or neckline."
            )
        for _ in range(_MOST_STEPS):
            linear = self._linear(best)
            while damping < _MOST_DAMPING:
                step, foreseen = _best_step(best, *linear, damping)
                trial = self._trial(best.x + step)
                if trial.misfit < best.misfit:
                    break
                damping *= 8
            else:
                break
            gain, expected = best.misfit - trial.misfit, best.misfit - foreseen
            best = trial
            if gain < _ENOUGH:
                break
            damping = (
                damping / 5 if gain > 0.7 * expected else damping * 2 if gain < 0.3 * expected else damping
            )
            damping = max(damping, _LEAST_DAMPING)
        return best.x

    def _trial(self, x: Floats) -> _Trial:
        sides = self._sides + self._moves @ x
        velocity, acceleration = _FIRST @ sides, _SECOND @ sides
        speed = np.abs(velocity)
        with np.errstate(all="ignore"):  # a curve that stands still somewhere misses by NaN and is not taken
            off = sides[[0, 2]] / np.abs(sides[[0, 2]]) - self._targets
            bends = (velocity[:_SAMPLES].conj() * acceleration).imag / speed[:_SAMPLES] ** 3
        excess = float(speed[_SAMPLES:] @ _LENGTH_WEIGHT) - self._length
        missed = np.array([excess, *off.real, *off.imag, _END_COST**0.5 * x[4]])
        misfit = float(missed @ missed + np.abs(bends).max() ** 2)
        return _Trial(x, sides, velocity, acceleration, speed, missed, bends, misfit)

    def _linear(self, at: _Trial) -> tuple[Floats, Floats, Floats]:
        """Change of what is missed by the unknowns; size and change of bends that may be the sharpest."""
        by = np.zeros((6, 5))
        weights = _LENGTH_WEIGHT / at.speed[_SAMPLES:]
        by[0] = ((weights * at.velocity[_SAMPLES:].conj()) @ self._first[_SAMPLES:]).real
        ends, moved = at.sides[[0, 2]], self._moves[[0, 2]]
        way = (ends / np.abs(ends))[:, None]
        turned = 1j * way * (way.conj() * moved).imag / np.abs(ends)[:, None]
        by[1:3], by[3:5] = turned.real, turned.imag
        by[5, 4] = _END_COST**0.5

        k = _candidates(np.abs(at.bends))
        velocity, speed, bends = at.velocity[k, None], at.speed[k, None], at.bends[k, None]
        first, second = self._first[k], self._second[k]
        crossed = (first.conj() * at.acceleration[k, None] + velocity.conj() * second).imag
        slope = crossed / speed**3 - 3 * bends / speed**2 * (velocity.conj() * first).real
        return by, np.abs(bends[:, 0]), np.sign(bends) * slope


def _candidates(sizes: Floats) -> list[int]:
    """Places of local maxima that are not much smaller than the largest, and their neighbours."""
    padded = np.concatenate([[-1.0], sizes, [-1.0]])
    inner = padded[1:-1]
    peaks = np.flatnonzero((inner >= padded[:-2]) & (inner >= padded[2:]) & (inner >= 0.3 * inner.max()))
    near = {int(p) + d for p in peaks for d in (-1, 0, 1)}
    return sorted(k for k in near if 0 <= k < len(sizes))


def _best_step(at: _Trial, by: Floats, bends: Floats, slope: Floats, damping: float) -> tuple[Floats, float]:
    """The step that is best if everything is linear, and the misfit that it would leave.

    Least squares under bounds (every bend below the sharpest one, which is the sixth unknown), solved as a
    problem of least distance (Lawson and Hanson, Solving Least Squares Problems, chapter 23).
    """
    system = np.zeros((12, 6))
    system[:6, :5] = by
    system[range(6, 11), range(5)] = damping**0.5
    system[11, 5] = 1.0
    q, upper = np.linalg.qr(system)
    free = -q[:6].T @ at.missed
    inverse = np.linalg.inv(upper)
    bounds = np.column_stack([-slope, np.ones(len(bends))]) @ inverse
    least = bends - bounds @ free
    weights, _ = nnls(np.vstack([bounds.T, least]), np.array([0.0] * 6 + [1.0]))
    shift = bounds.T @ weights / (1 - least @ weights)
    z = inverse @ (shift + free)
    left = at.missed + by @ z[:5]
    return z[:5], float(left @ left + z[5] ** 2)

"""Cubic curves bent until they leave and arrive in given directions and have a given length."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from scipy.optimize import minimize

from swifttailor.arrays import Floats
from swifttailor.programs.edges import BezierEdge, to_complex, to_vertex
from swifttailor.programs.planar_curves import CubicCurve

_BEND_SAMPLES = 70
"""Where the sharpest bend is sought. It is GarmentCode's number: with another one, other curves are found."""

_END_COST = 0.001
"""What a centimetre that the end moves along the chord costs, squared."""


def curve_match_tangents(
    curve: CubicCurve,
    target_tan0: Sequence[float],
    target_tan1: Sequence[float],
    target_len: float | None = None,
) -> BezierEdge:
    """Bends a cubic curve until its ends point in given directions and it has a length.

    The start stays where it is, the end may move along the chord, and the sharpest bend is kept soft. The
    search begins at the given curve and stops where it cannot better it, as GarmentCode's does.

    Args:
        curve: A curve that is nearly right.
        target_tan0: Direction at the start; its size does not matter.
        target_tan1: Direction at the end.
        target_len: Length in cm; without it that of the curve.
    """
    first, last = to_complex(target_tan0), to_complex(target_tan1)
    length = curve.length() if target_len is None else target_len
    points = _bend(curve, first / abs(first), last / abs(last), length)
    start, control_1, control_2, end = (to_vertex(p) for p in points)
    return BezierEdge(start, end, [control_1, control_2], relative=False)


# The search runs on the three sides of the control polygon, each a complex number. What a side adds to the
# derivative and to the second derivative at a parameter:
_AT = np.linspace(0.0, 1.0, _BEND_SAMPLES)
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(16)
_LENGTH_AT = (np.linspace(0.0, 1.0, 5)[:-1, None] + (_NODES + 1) / 8).ravel()
_LENGTH_WEIGHT = np.tile(_WEIGHTS / 8, 4)


def _first_of(t: Floats) -> Floats:
    return 3 * np.stack([(1 - t) ** 2, 2 * t * (1 - t), t**2], axis=1)


_FIRST = np.concatenate([_first_of(_AT), _first_of(_LENGTH_AT)])
_SECOND = 6 * np.stack([_AT - 1, 1 - 2 * _AT, _AT], axis=1)
_PER_LENGTH = _LENGTH_WEIGHT[:, None] * _first_of(_LENGTH_AT)


@lru_cache(maxsize=512)
def _bend(curve: CubicCurve, first: complex, last: complex, target_len: float) -> tuple[complex, ...]:
    """Control points of the bent curve."""
    start, end = curve.start, curve.end
    chord = (end - start) / abs(end - start)
    sides = np.array([curve.control_1 - start, curve.control_2 - curve.control_1, end - curve.control_2])

    def misfit(shift: Floats) -> tuple[float, Floats]:
        moved_1, moved_2 = complex(shift[0], shift[1]), complex(shift[2], shift[3])
        moved_end = chord * shift[4]
        now = sides + np.array([moved_1, moved_2 - moved_1, moved_end - moved_2])
        velocity = _FIRST @ now

        speed = np.abs(velocity[_BEND_SAMPLES:])
        excess = float(speed @ _LENGTH_WEIGHT) - target_len
        value = excess * excess
        slope = 2 * excess * ((velocity[_BEND_SAMPLES:] / speed) @ _PER_LENGTH)

        for side, target in ((0, first), (2, last)):
            way = complex(now[side])
            size = abs(way)
            off = way / size - target
            value += abs(off) ** 2
            across = 1j * way / size
            slope[side] += 2 * (off.conjugate() * across).real / size * across

        bend, bend_slope = _sharpest_bend(velocity[:_BEND_SAMPLES], _SECOND @ now)
        value += bend * bend + _END_COST * shift[4] ** 2
        slope += 2 * bend * bend_slope

        by_1, by_2, by_end = slope[0] - slope[1], slope[1] - slope[2], slope[2]
        along = (by_end * chord.conjugate()).real + 2 * _END_COST * shift[4]
        return value, np.array([by_1.real, by_1.imag, by_2.real, by_2.imag, along])

    x = minimize(misfit, np.zeros(5), jac=True, method="L-BFGS-B").x.tolist()
    return (
        start,
        curve.control_1 + complex(x[0], x[1]),
        curve.control_2 + complex(x[2], x[3]),
        end + chord * x[4],
    )


def _sharpest_bend(velocity: np.ndarray, acceleration: np.ndarray) -> tuple[float, np.ndarray]:
    """The largest curvature at the samples, per cm, and how each side of the control polygon changes it."""
    crossed = (velocity.conj() * acceleration).imag
    bends = np.abs(crossed) / np.abs(velocity) ** 3
    at = int(bends.argmax())
    v, a, bend = complex(velocity[at]), complex(acceleration[at]), float(bends[at])
    speed = abs(v)
    sign = 1.0 if crossed[at] > 0 else -1.0
    by_velocity = sign * -1j * a / speed**3 - 3 * bend * v / speed**2
    by_acceleration = sign * 1j * v / speed**3
    return bend, _FIRST[at] * by_velocity + _SECOND[at] * by_acceleration

"""Simple prints in plain numpy, to hold the compiled ones against."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Array

LinearColor = tuple[float, float, float]
"""Linear-light RGB."""
_SOFT_CM = 0.12
"""Over this much cloth one colour goes over into the next."""


@dataclass(frozen=True)
class Plain:
    """One colour with the unevenness of yarn."""

    color: LinearColor
    grain: float = 0.08
    """Relative unevenness."""
    seed: int = 0

    def colors(self, at: Array) -> Array:
        """See `Print`."""
        return np.asarray(self.color, np.float32) * _grain(at, self.grain, self.seed)[:, None]


@dataclass(frozen=True)
class Stripes:
    """Bands of two colours."""

    first: LinearColor
    second: LinearColor
    width: float
    """Of a band of the first colour, cm."""
    gap: float
    """Of a band of the second colour, cm."""
    angle: float = 0.0
    """Degrees: 0 runs across the panel, 90 along it."""
    grain: float = 0.05
    seed: int = 0

    def colors(self, at: Array) -> Array:
        """See `Print`."""
        share = _band(_turned(at, self.angle)[1], self.width, self.gap)
        return _mix(self.first, self.second, share) * _grain(at, self.grain, self.seed)[:, None]


@dataclass(frozen=True)
class Checks:
    """Bands that cross, darkest where both are: gingham."""

    first: LinearColor
    second: LinearColor
    width: float
    """Of a band, cm; gaps are as wide."""
    angle: float = 0.0
    """Degrees."""
    grain: float = 0.05
    seed: int = 0

    def colors(self, at: Array) -> Array:
        """See `Print`."""
        x, y = _turned(at, self.angle)
        share = (_band(x, self.width, self.width) + _band(y, self.width, self.width)) / 2
        return _mix(self.first, self.second, share) * _grain(at, self.grain, self.seed)[:, None]


@dataclass(frozen=True)
class Dots:
    """Dots of one colour on another, every second row shifted."""

    ground: LinearColor
    dot: LinearColor
    spacing: float
    """Between neighbours, cm."""
    radius: float
    """Of a dot, cm."""
    angle: float = 0.0
    """Degrees."""
    grain: float = 0.05
    seed: int = 0

    def colors(self, at: Array) -> Array:
        """See `Print`."""
        x, y = _turned(at, self.angle)
        rise = self.spacing * 0.8660254
        row = np.round(y / rise)
        across = x - 0.5 * self.spacing * (row % 2)
        away = np.hypot(across - self.spacing * np.round(across / self.spacing), y - rise * row)
        share = np.clip((self.radius - away) / _SOFT_CM + 0.5, 0, 1)
        return _mix(self.dot, self.ground, share) * _grain(at, self.grain, self.seed)[:, None]


def _turned(at: Array, degrees: float) -> tuple[Array, Array]:
    angle = np.deg2rad(degrees)
    c, s = np.float32(np.cos(angle)), np.float32(np.sin(angle))
    return c * at[:, 0] + s * at[:, 1], c * at[:, 1] - s * at[:, 0]


def _band(x: Array, width: float, gap: float) -> Array:
    """Share (n,) of the band at positions (n,): 1 inside bands, 0 in the gaps between."""
    period = width + gap
    from_middle = np.abs(x - period * np.round(x / period))
    return np.clip((width / 2 - from_middle) / _SOFT_CM + 0.5, 0, 1)


def _mix(first: LinearColor, second: LinearColor, share: Array) -> Array:
    a, b = np.asarray(first, np.float32), np.asarray(second, np.float32)
    return b + share.astype(np.float32)[:, None] * (a - b)


def _grain(at: Array, strength: float, seed: int) -> Array:
    """(n,) factors around 1 that change from thread to thread, in both directions."""
    threads = np.floor(at / 0.35).astype(np.int64)
    return (1 + strength * (_noise(threads[:, 0], 2 * seed) + _noise(threads[:, 1], 2 * seed + 1))).astype(
        np.float32
    )


def _noise(n: Array, seed: int) -> Array:
    """(n,) values from -0.5 to 0.5 that look random and depend on whole numbers alone."""
    mixed = (n.astype(np.uint64) + np.uint64(seed * 1_000_003 + 12_345)) * np.uint64(0x9E3779B97F4A7C15)
    mixed ^= mixed >> np.uint64(29)
    mixed *= np.uint64(0xBF58476D1CE4E5B9)
    return (mixed >> np.uint64(40)).astype(np.float64) / 2**24 - 0.5

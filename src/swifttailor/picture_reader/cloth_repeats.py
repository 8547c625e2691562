"""After how much cloth a print repeats, by the autocorrelation of pieces of it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Array
from swifttailor.picture_reader.flat_cloth import FlatCloth, blurred

_PIECES = (32, 64, 128)
"""Pixels along each side of a piece: folds shift what is far apart, wide stripes need room."""
_EVEN = 5
"""What is wider than this part of a piece is evened out in it."""
_LEAST_CLOTH = 0.6
"""Share of a piece that has to be cloth."""
_TURNED = np.arange(-15.0, 16.0, 5.0)
"""Degrees by which cloth may lie askew."""
_FARTHEST = 0.62
"""Of a piece: how far apart is compared."""
_NEAREST = 0.75
"""Of the best repeat: the first that is as good counts, as every multiple of it repeats, too."""
_SURE, _LEAST = 1.0, 0.15
"""How much more alike cloth is one repeat apart than in between, 0 to 2: enough, and hardly anything."""
_SMALLER = 0.65
"""Of the best of all sizes of pieces: the smallest that is as good counts."""


@dataclass(frozen=True)
class Repeat:
    """That a print comes again."""

    lag: float
    """After so many pixels of the cloth."""
    certainty: float
    """How much more alike it is there than in between, 0 to 2."""


def repeat_of(cloth: FlatCloth, angles: Sequence[float]) -> Repeat | None:
    """After which distance a print repeats; None where it does not, or no pixel tells.

    Args:
        cloth: That has it.
        angles: Directions of the picture, degrees: 0 to the right, 90 down. That in which it repeats most
            surely counts.
    """
    main, inside = cloth.main, cloth.inside.astype(np.float64)
    found: list[list[Repeat]] = [[] for _ in angles]
    for side in _PIECES:
        if side > _PIECES[0] and side > min(main.shape):
            break
        alike = _alike(main, inside, min(side, *main.shape))
        if alike is not None:
            for repeats, angle in zip(found, angles, strict=True):
                lines = _lines(alike, angle + _TURNED)
                repeats.append(max(map(_first, lines), key=lambda one: one.certainty))
            if any(repeats[-1].certainty >= _SURE for repeats in found):
                break
    best = max(found, key=lambda some: max((one.certainty for one in some), default=0.0), default=[])
    least = max(_SMALLER * max((one.certainty for one in best), default=0.0), _LEAST)
    return next((one for one in best if one.certainty >= least), None)


def _alike(main: Array, inside: Array, side: int) -> Array | None:
    """(2 side, 2 side) autocorrelation, its middle at (side, side): the mean of pieces of the cloth."""
    size = 2 * side, 2 * side
    products, counts = np.zeros(size), np.zeros(size)
    near = np.maximum(blurred(inside, side / _EVEN), 1e-3)
    main = (main - blurred(main, side / _EVEN) / near) * inside
    for row in _starts(main.shape[0], side):
        for column in _starts(main.shape[1], side):
            here = inside[row : row + side, column : column + side]
            if here.mean() < _LEAST_CLOTH:
                continue
            piece = main[row : row + side, column : column + side]
            piece = (piece - (piece * here).sum() / max(here.sum(), 1.0)) * here
            # Each piece counts as much as any: where folds are deep, they say nothing more.
            even = (piece**2).sum() / max(here.sum(), 1.0)
            if even <= 0.0:
                continue
            products += np.fft.irfft2(np.abs(np.fft.rfft2(piece, size)) ** 2, size) / even
            counts += np.fft.irfft2(np.abs(np.fft.rfft2(here, size)) ** 2, size)
    if products[0, 0] <= 0.0:
        return None
    alike = products / np.maximum(counts, 0.08 * counts[0, 0])
    return np.fft.fftshift(alike / alike[0, 0])


def _starts(length: int, side: int) -> list[int]:
    return [int(k) for k in np.linspace(0, length - side, max(-(-3 * length // (2 * side)) - 1, 1))]


def _lines(alike: Array, angles: Array) -> Array:
    """(angles, lags) the autocorrelation along lines from its middle."""
    from scipy.ndimage import map_coordinates

    middle = alike.shape[0] // 2
    lags = np.arange(int(_FARTHEST * middle))
    along = np.stack([np.sin(np.deg2rad(angles)), np.cos(np.deg2rad(angles))])[..., None] * lags
    found: Array = map_coordinates(alike, middle + along, order=1)
    return found


def _first(line: Array) -> Repeat:
    """The first peak that is nearly as high above what lies before it as any."""
    if len(line) < 4:
        return Repeat(0.0, 0.0)
    lowest = np.minimum.accumulate(line)
    peaks = 1 + np.flatnonzero((line[1:-1] >= line[:-2]) & (line[1:-1] > line[2:]))
    heights = line[peaks] - lowest[peaks]
    if not len(peaks) or heights.max() <= 0:
        return Repeat(0.0, 0.0)
    k = int(np.flatnonzero(heights >= _NEAREST * heights.max())[0])
    before, at, behind = line[peaks[k] - 1 : peaks[k] + 2]
    return Repeat(
        float(peaks[k] + (before - behind) / (2 * (before - 2 * at + behind) - 1e-12)), float(heights[k])
    )

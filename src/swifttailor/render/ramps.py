"""What pictures to print by name are made of: places on a ramp of colours, in cells that repeat."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from swifttailor.arrays import Array

NAMED_SIDE = 256
"""Cells along each side of such a picture."""
RAMP = 64
"""Steps from one colour of a print to its next: 2 * RAMP is its third colour, RAMP / 2 half its second."""


def cells() -> tuple[Array, Array]:
    """X and y (NAMED_SIDE, NAMED_SIDE) of the middles of all cells, 0 to 1, y up."""
    y, x = (np.mgrid[0:NAMED_SIDE, 0:NAMED_SIDE] + 0.5) / NAMED_SIDE
    return x, y


def stamped(
    picture: Array, at: tuple[float, float], reach: float, draw: Callable[..., tuple[Array, Array]]
) -> None:
    """Draws into a square of a picture, round its borders where need be.

    Args:
        picture: (n, n), changed.
        at: Middle of the square, parts of the side.
        reach: Half its side, the same.
        draw: From offsets x and y (m, m) to the cells it covers (bool) and what they become.
    """
    side = len(picture)
    half = int(np.ceil(reach * side))
    column, row = (int(np.floor(c * side)) for c in at)
    steps = np.arange(-half, half + 1)
    dx = (column + steps + 0.5) / side - at[0]
    dy = (row + steps + 0.5) / side - at[1]
    covered, values = draw(*np.meshgrid(dx, dy))
    places = np.ix_((row + steps) % side, (column + steps) % side)
    picture[places] = np.where(covered, values, picture[places])


def scattered(chance: np.random.Generator, count: int, jitter: float) -> Array:
    """(n, 2) places in rows of `count`, every second row shifted, each moved a little; count is even.

    Args:
        chance: Where the lots come from.
        count: In a row, and rows.
        jitter: Most that one is moved, as a part of the step between rows.
    """
    row, column = np.divmod(np.arange(count * count), count)
    places = np.stack([column + 0.5 * (row % 2), row.astype(np.float64)], axis=1)
    return (places + chance.uniform(-jitter, jitter, places.shape)) / count % 1.0


def even_noise(
    chance: np.random.Generator, cycles: float, *, stretch: float = 1.0, spread: float = 0.35
) -> Array:
    """(NAMED_SIDE, NAMED_SIDE) noise that repeats, mean 0, deviation 1, with blots of about one size.

    No repeat is told from the next.

    Args:
        chance: Where the lots come from.
        cycles: So many blots, and as many gaps, across.
        stretch: How much longer than wide they are, along the columns.
        spread: How unlike their sizes are, relative.
    """
    fy, fx = np.fft.fftfreq(NAMED_SIDE)[:, None] * NAMED_SIDE, np.fft.rfftfreq(NAMED_SIDE)[None] * NAMED_SIDE
    size = np.hypot(fy * stretch, fx)
    strength = np.exp(-(((size - cycles) / (spread * cycles)) ** 2))
    strength[0, 0] = 0.0
    field: Array = np.fft.irfft2(
        strength * np.exp(2j * np.pi * chance.random(size.shape)), (NAMED_SIDE, NAMED_SIDE)
    )
    return field / field.std()

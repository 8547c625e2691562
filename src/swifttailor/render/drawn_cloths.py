"""Cloths that are known by how they are woven or made: houndstooth, tartan, granny squares, marl, linen."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from swifttailor.arrays import Array
from swifttailor.render.ramps import NAMED_SIDE, RAMP, cells, even_noise, scattered, stamped

_TEETH = 8
"""Of houndstooth, in a repeat."""
_SETT = (0, 0, 0, 0, 0, 2, 0, 2, 2, 2, 2, 4, 2, 2, 2, 2, 0, 2, 0, 0, 0, 0, 0, 4)
"""Threads of a tartan across a repeat: 0 the ground, 2 the bands, 4 the lines; crossings lie between."""
_SQUARES = 3
"""Of granny squares, across a repeat."""
_ROUNDS = (0.34, 0.6, 0.84)
"""How far from its middle each round of a square reaches, half its side being 1."""


def houndstooth() -> Array:
    """Broken checks: four dark threads and four light ones both ways, in a twill of two over two."""
    column, row = (np.floor(8 * _TEETH * each).astype(np.int64) for each in cells())
    across, down = row % 8 < 4, column % 8 < 4
    over = (column + row) % 4 < 2
    return RAMP * np.where(over, down, across).astype(np.float64)


def tartan() -> Array:
    """Bands and lines that cross, darker where two bands do."""
    threads = np.array(_SETT)
    x, y = ((len(threads) * each).astype(np.int64) for each in cells())
    warp, weft = threads[x], threads[y]
    return RAMP * (warp + weft) / 2.0


def granny_squares() -> Array:
    """Squares of rounds in several colours, framed in the first, with holes between bunches of stitches."""
    x, y = cells()
    column, row = np.floor(_SQUARES * x), np.floor(_SQUARES * y)
    u, v = 2.0 * (_SQUARES * x % 1.0) - 1.0, 2.0 * (_SQUARES * y % 1.0) - 1.0
    away, along = np.maximum(np.abs(u), np.abs(v)), np.where(np.abs(u) > np.abs(v), v, u)
    ring = np.searchsorted(np.array(_ROUNDS), away)
    # A colour of each round, in another order from square to square; the frame has the first.
    inks = (column + 2 * row + ring) % 4 + 1.0
    bunch = np.abs(np.sin(np.pi * (2 + 2 * ring) * along / np.maximum(away, 0.1))) < 0.3
    inside = np.min([np.abs(away - edge) for edge in _ROUNDS], axis=0)
    hole = bunch & (inside < 0.07)
    return RAMP * np.where((ring == len(_ROUNDS)) | hole, 0.0, inks)


def palm_trees() -> Array:
    """Bent trunks of the third colour under crowns of the second, each on a patch of sand of the fourth."""
    chance = np.random.default_rng(61)
    picture = np.zeros((NAMED_SIDE, NAMED_SIDE))
    for k, place in enumerate(scattered(chance, 2, 0.06)):
        side = 1.0 if k % 2 else -1.0

        def tree(x: Array, y: Array, side: float = side):
            u, v = side * x / 0.2, y / 0.2
            lean = 0.22 * ((v + 0.95) / 1.25) ** 2
            trunk = (np.abs(u - lean) < 0.075 - 0.02 * v) & (v > -0.95) & (v < 0.32)
            sand = (u / 0.55) ** 2 + ((v + 0.95) / 0.12) ** 2 < 1.0
            cx, cy = u - 0.23, v - 0.33
            crown = np.zeros(x.shape, bool)
            for turn in (-0.35, 0.35, 0.95, 1.6, 2.2, 2.8, 3.5):
                along = cx * np.cos(turn) + cy * np.sin(turn)
                across = cy * np.cos(turn) - cx * np.sin(turn)
                across = across + (1.0 if np.cos(turn) > 0 else -1.0) * 0.55 * along**2
                thick = 0.13 * np.sqrt(np.clip(along / 0.75 * (1.0 - along / 0.75), 0.0, 1.0)) * 2.0
                crown |= (along > 0.0) & (along < 0.75) & (np.abs(across) < thick)
            ink = np.where(crown, RAMP, np.where(trunk, 2 * RAMP, 3 * RAMP))
            return trunk | crown | sand, ink

        stamped(picture, (place[0], place[1]), 0.24, tree)
    return picture


def marl() -> Array:
    """Short streaks of lighter and darker yarn along the wales."""
    chance = np.random.default_rng(62)
    streaks = even_noise(chance, 28, stretch=0.3).T + 0.5 * even_noise(chance, 14)
    return RAMP * np.clip(1.0 + 0.6 * streaks, 0.0, 2.0)


def linen() -> Array:
    """Threads that thicken here and there, both ways."""
    chance = np.random.default_rng(63)
    threads = even_noise(chance, 36, stretch=9.0), even_noise(chance, 36, stretch=9.0).T
    return RAMP * np.clip(1.0 + 0.55 * (threads[0] + threads[1]), 0.0, 2.0)


DRAWN: Mapping[str, Callable[[], Array]] = {
    "houndstooth": houndstooth,
    "tartan": tartan,
    "granny_squares": granny_squares,
    "palm_trees": palm_trees,
    "marl": marl,
    "linen": linen,
}

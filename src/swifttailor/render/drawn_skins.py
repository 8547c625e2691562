"""Coats of animals as prints: rosettes, stripes, patches and scales, each a picture that repeats."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from swifttailor.arrays import Array
from swifttailor.render.motifs import smooth_noise
from swifttailor.render.ramps import NAMED_SIDE, RAMP, cells, even_noise, scattered, stamped

_ROSETTES = 6


def leopard() -> Array:
    """Rings of a few thick strokes about a darker middle, with small spots between, on the first colour."""
    chance = np.random.default_rng(11)
    picture: Array = np.zeros((NAMED_SIDE, NAMED_SIDE))
    for place in scattered(chance, _ROSETTES, 0.16):
        size, phase = chance.uniform(0.062, 0.083), chance.uniform(0.0, 7.0, 3)
        lean = chance.uniform(0.8, 1.25)

        def rosette(x: Array, y: Array, size: float = size, phase: Array = phase, lean: float = lean):
            away, turn = np.hypot(x * lean, y / lean), np.arctan2(y, x)
            edge = size * (1 + 0.14 * np.cos(2 * turn + phase[0]) + 0.12 * np.cos(3 * turn + phase[1]))
            half = 0.24 * size * (1 + 0.35 * np.cos(5 * turn + phase[2]))
            stroke = (np.abs(away - 0.78 * edge) < half) & (np.cos(3 * turn + phase[2]) > -0.72)
            return stroke | (away < 0.78 * edge), np.where(stroke, RAMP, 2 * RAMP)

        stamped(picture, (place[0], place[1]), 0.13, rosette)
    for place in chance.random((90, 2)):
        size = chance.uniform(0.012, 0.022)
        row, column = (int(c * NAMED_SIDE) + np.arange(-7, 8) for c in (place[1], place[0]))
        if picture[np.ix_(row % NAMED_SIDE, column % NAMED_SIDE)].any():
            continue
        stamped(
            picture,
            (place[0], place[1]),
            0.03,
            lambda x, y, size=size: (np.hypot(x, 1.3 * y) < size, RAMP + 0 * x),
        )
    return picture


def zebra() -> Array:
    """Wavy stripes that fork."""
    return RAMP * _wavy(12, count=9, bend=0.8, thin=0.0)


def tiger() -> Array:
    """Stripes that end in points, on a ground that goes over into the second colour."""
    chance = np.random.default_rng(5)
    ground = np.clip(0.6 * even_noise(chance, 3.0), 0.0, 1.0)
    stripe = _wavy(9, count=8, bend=0.8, thin=0.55)
    return np.where(stripe > 0.5, 2.0, 0.9 * ground) * RAMP


def _wavy(seed: int, *, count: int, bend: float, thin: float) -> Array:
    chance = np.random.default_rng(seed)
    _, y = cells()
    wave = np.sin(
        2
        * np.pi
        * (count * y + bend * (0.42 * even_noise(chance, 2.5, spread=0.6) + 0.1 * even_noise(chance, 7.0)))
    )
    level = thin + 0.55 * thin * even_noise(chance, 4.0)
    return np.clip(2.0 * (wave - level) + 0.5, 0.0, 1.0)


def giraffe() -> Array:
    """Patches with narrow gaps in the first colour between."""
    chance = np.random.default_rng(3)
    nearest = _two_nearest(scattered(chance, 6, 0.3))
    rough = 0.006 * smooth_noise(chance, NAMED_SIDE, 1.6)
    gap = nearest[1] - nearest[0] + rough < 0.022
    shade = 1.0 + 0.5 * np.clip(1.0 - nearest[0] / 0.06, 0.0, 1.0)
    return np.where(gap, 0.0, shade) * RAMP


def cowhide() -> Array:
    """A few large patches of the second colour."""
    chance = np.random.default_rng(8)
    field = even_noise(chance, 2.6) + 0.18 * even_noise(chance, 9.0)
    return RAMP * np.clip(8.0 * (field - 0.55) + 0.5, 0.0, 1.0)


def dalmatian() -> Array:
    """Spots of many sizes, none of them quite round."""
    chance = np.random.default_rng(4)
    picture: Array = np.zeros((NAMED_SIDE, NAMED_SIDE))
    for place in scattered(chance, 8, 0.32):
        size, phase = 0.016 + 0.03 * chance.random() ** 1.5, chance.uniform(0.0, 7.0)

        def spot(x: Array, y: Array, size: float = size, phase: float = phase):
            rough = (
                1 + 0.18 * np.cos(2 * np.arctan2(y, x) + phase) + 0.1 * np.cos(5 * np.arctan2(y, x) + phase)
            )
            return np.hypot(x, y) < size * rough, RAMP + 0 * x

        stamped(picture, (place[0], place[1]), 0.07, spot)
    return picture


def scales() -> Array:
    """A snake's: small lozenges with dark edges, that make large ones of three shades."""
    x, y = cells()
    across, up = 24 * x + 16 * y, 24 * x - 16 * y
    # Each scale has one shade, that of its middle.
    middle_x = (np.floor(across) + np.floor(up) + 1.0) / 48
    middle_y = (np.floor(across) - np.floor(up)) / 32
    rough = even_noise(np.random.default_rng(12), 7.0)
    near = tuple([(at * NAMED_SIDE).astype(np.int64) % NAMED_SIDE for at in (middle_y, middle_x)])
    # Rough edges, or the large ones would be those of a jumper.
    large = np.abs((3 * middle_x) % 1.0 - 0.5) + np.abs((2 * middle_y) % 1.0 - 0.5) + 0.17 * rough[near]
    shade = np.select([large < 0.2, large < 0.42, large < 0.6], [1.6, 2.0, 0.8], 0.0)
    edge = np.maximum(np.abs(across % 1.0 - 0.5), np.abs(up % 1.0 - 0.5)) > 0.41
    return RAMP * np.where(edge, 2.0 - 0.5 * (shade > 1.8), shade)


def crocodile() -> Array:
    """Plates with dark grooves between, lighter in their middles."""
    chance = np.random.default_rng(6)
    near, far = _two_nearest(scattered(chance, 10, 0.22))
    return RAMP * np.clip(1.6 * (far - near) / 0.05, 0.0, 2.0)


def _two_nearest(places: Array) -> Array:
    """(2, side, side) how far off the nearest of some places (n, 2) and the next lie from each cell."""
    from scipy.spatial import KDTree

    at = np.stack([part.ravel() for part in cells()], axis=1)
    away, _ = KDTree(places, boxsize=1.0).query(at, k=2)
    return np.asarray(away).T.reshape(2, NAMED_SIDE, NAMED_SIDE)


DRAWN: Mapping[str, Callable[[], Array]] = {
    "leopard": leopard,
    "zebra": zebra,
    "tiger": tiger,
    "giraffe": giraffe,
    "cowhide": cowhide,
    "dalmatian": dalmatian,
    "scales": scales,
    "crocodile": crocodile,
}

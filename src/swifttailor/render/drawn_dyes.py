"""Dyed cloth as prints: tied, waxed, marbled, in soft blots; each a picture that repeats."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from swifttailor.arrays import Array
from swifttailor.render.motifs import smooth_noise
from swifttailor.render.ramps import NAMED_SIDE, RAMP, cells, even_noise, scattered, stamped

LOOP = 6
"""Colours that a tied spiral goes through before it begins anew."""
_MIDDLE = 0.55
"""How high above the lower edge of a panel the middle of a spiral lies, as a part of the repeat."""


def tie_dye() -> Array:
    """A spiral in all colours about the middle of a panel, among soft blots of the same."""
    chance = np.random.default_rng(21)
    x, y = cells()
    dx, dy = (x + 0.5) % 1.0 - 0.5, (y - _MIDDLE + 0.5) % 1.0 - 0.5
    away, turn = np.hypot(dx, dy), np.arctan2(dy, dx) / (2 * np.pi)
    rough = smooth_noise(chance, NAMED_SIDE, 1.7)
    spiral = np.exp(2j * np.pi * (turn + 2.1 * np.sqrt(away + 0.01) + 0.035 * rough))
    blots = np.exp(2j * np.pi * (0.32 * even_noise(chance, 2.4) + 0.035 * rough))
    # Turns are blended as points of a circle, so that no cut is seen where one begins anew.
    share = np.clip((0.46 - away) / 0.2, 0.0, 1.0)
    phase = np.angle(share * spiral + (1.0 - share) * blots) / (2 * np.pi) % 1.0
    return LOOP * RAMP * phase


def batik() -> Array:
    """Flowers and dots left out by wax on the first colour, with the fine lines of cracked wax."""
    chance = np.random.default_rng(22)
    field = smooth_noise(chance, NAMED_SIDE, 1.9), smooth_noise(chance, NAMED_SIDE, 1.9)
    cracks = np.maximum(*[np.clip(1.0 - np.abs(one) / 0.05, 0.0, 1.0) for one in field])
    picture: Array = RAMP * 0.45 * cracks

    def flower(x: Array, y: Array):
        away, turn = np.hypot(x, y), np.arctan2(y, x)
        petal = 0.088 * (0.66 + 0.34 * np.abs(np.cos(3 * turn)))
        line = (away < petal) & (away > petal - 0.02)
        return (away < petal) | (np.abs(away - 0.108) < 0.006), np.where(
            line | (away > petal), RAMP, np.where(away < 0.025, RAMP, 2.0 * RAMP)
        )

    for k, place in enumerate(scattered(chance, 4, 0.0)):
        if k % 2 == (k // 4) // 2 % 2:
            stamped(picture, (place[0], place[1]), 0.125, flower)
        else:
            for dx, dy in ((0.0, 0.0), (0.05, 0.0), (-0.05, 0.0), (0.0, 0.05), (0.0, -0.05)):
                at = (place[0] + dx) % 1.0, (place[1] + dy) % 1.0
                stamped(picture, at, 0.03, lambda x, y: (np.hypot(x, y) < 0.015, RAMP + 0 * x))
    return picture


def marble() -> Array:
    """Veins that wander through soft shades."""
    chance = np.random.default_rng(23)
    shades = np.clip(0.6 + 0.4 * even_noise(chance, 4.0), 0.0, 1.4)
    veins = [np.abs(smooth_noise(chance, NAMED_SIDE, 2.0, stretch)) for stretch in (1.5, 0.7)]
    depth = np.maximum(
        *[np.clip(1.0 - vein / width, 0.0, 1.0) for vein, width in zip(veins, (0.1, 0.05), strict=True)]
    )
    return RAMP * np.maximum(shades, 2.0 * depth)


def clouds() -> Array:
    """Soft blots of all colours that run into each other."""
    field = even_noise(np.random.default_rng(24), 3.2)
    return RAMP * np.clip(1.5 + 1.05 * field, 0.0, 3.0)


def galaxy() -> Array:
    """Clouds of all colours but the last, which stars have."""
    chance = np.random.default_rng(27)
    picture = RAMP * np.clip(1.2 + 1.0 * even_noise(chance, 2.6, spread=0.8), 0.0, 3.0)
    for x, y in chance.random((110, 2)):
        size = 0.003 + 0.008 * chance.random() ** 3
        stamped(picture, (x, y), 0.013, lambda x, y, size=size: (np.hypot(x, y) < size, 4.0 * RAMP + 0 * x))
    return picture


def camouflage() -> Array:
    """Patches of four colours, each over those before, of many sizes and with rough edges."""
    chance = np.random.default_rng(28)
    picture: Array = np.zeros((NAMED_SIDE, NAMED_SIDE))
    for ink, share in ((1, 0.25), (2, 0.6), (3, 0.95)):
        field = even_noise(chance, 3.6, stretch=0.7, spread=0.5)
        field += 0.25 * smooth_noise(chance, NAMED_SIDE, 1.3)
        picture[field > share] = RAMP * ink
    return picture


def splashes_of_bleach() -> Array:
    """Blots of the second colour with soft edges: acid washed, bleached."""
    chance = np.random.default_rng(25)
    field = even_noise(chance, 4.0) + 0.4 * smooth_noise(chance, NAMED_SIDE, 1.3)
    return RAMP * np.clip(0.5 + 0.7 * field, 0.0, 1.6)


def ikat() -> Array:
    """Lozenges whose edges are frayed along the threads."""
    x, y = cells()
    chance = np.random.default_rng(26)
    shift = np.repeat(chance.uniform(-0.02, 0.02, NAMED_SIDE // 2), 2)[None, :]
    away = np.abs((2 * x) % 1.0 - 0.5) + np.abs((2 * (y + shift)) % 1.0 - 0.5)
    return RAMP * np.select([away < 0.12, away < 0.3, away < 0.42], [1.0, 2.0, 1.0], 0.0)


DRAWN: Mapping[str, Callable[[], Array]] = {
    "tie_dye": tie_dye,
    "batik": batik,
    "marble": marble,
    "clouds": clouds,
    "bleach": splashes_of_bleach,
    "ikat": ikat,
    "galaxy": galaxy,
    "camouflage": camouflage,
}

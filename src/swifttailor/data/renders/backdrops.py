"""Backdrops behind the figure: parts of a bank of rooms, streets and parks.

A process makes each backdrop of a bank once, when it is first asked for; pictures show parts of them, turned
round and tinted.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy.ndimage import gaussian_filter

from swifttailor.arrays import Array
from swifttailor.data.renders.backdrop_colors import Chance, Rgb
from swifttailor.data.renders.backdrop_makers import MAKERS, SIDE, studio

BANK = 320
"""How many backdrops there are."""
MAKER_NAMES = tuple(name for name, _ in MAKERS)
"""What they show, by their number modulo as many."""


@dataclass(frozen=True)
class Scenery:
    """A part of a backdrop of the bank."""

    number: int
    corner: tuple[float, float] = (0.0, 0.0)
    """Upper left, as shares of what the part leaves free."""
    part: float = 1.0
    """Share of the backdrop's side that is seen."""
    flip: bool = False
    tint: Rgb = (1.0, 1.0, 1.0)

    def light(self, size: int) -> Array:
        """(size, size, 3) float32 linear light."""
        whole = backdrop(self.number % BANK)
        if self.flip:
            whole = whole[:, ::-1]
        reach = self.part * (SIDE - 1)
        start = np.asarray(self.corner) * (SIDE - 1 - reach)
        at = np.linspace(0, reach, size, dtype=np.float32)
        picture = _between(_between(whole, at + np.float32(start[0]), 0), at + np.float32(start[1]), 1)
        picture *= np.asarray(self.tint, np.float32)
        return picture


def random_scenery(chance: Chance) -> Scenery:
    """A part of a backdrop drawn by lot."""
    warmth, shade = chance.normal(0, 0.05), float(np.clip(chance.normal(1.0, 0.18), 0.5, 1.5))
    x, y = chance.random(2)
    return Scenery(
        number=int(chance.integers(BANK)),
        corner=(float(1.0 - 0.5 * y), float(x)),
        part=float(chance.uniform(0.55, 1.0)),
        flip=bool(chance.random() < 0.5),
        tint=(shade * (1 + warmth), shade, shade * (1 - warmth)),
    )


@lru_cache(maxsize=BANK)
def backdrop(number: int) -> Array:
    """(SIDE, SIDE, 3) float32 linear light of one of the bank, the same in every process."""
    chance = np.random.default_rng([91, number])
    _, maker = MAKERS[number % len(MAKERS)]
    picture = np.clip(maker(chance), 0.0, 1.0).astype(np.float32)
    picture = picture**2.2  # makers think in what the eye sees
    if maker is not studio:
        picture *= np.asarray(_light(chance), np.float32)
        blur = float(chance.choice([0.0, chance.uniform(0.4, 1.5), chance.uniform(1.5, 6.0)]))
        if blur:
            picture = gaussian_filter(picture, (blur, blur, 0), mode="nearest")
    return np.ascontiguousarray(picture, np.float32)


def _between(picture: Array, at: Array, axis: int) -> Array:
    """Rows or columns of a picture at places between them."""
    first = np.minimum(at.astype(np.int64), picture.shape[axis] - 2)
    share = (at - first).reshape((-1, 1, 1) if axis == 0 else (1, -1, 1))
    low, high = np.take(picture, first, axis), np.take(picture, first + 1, axis)
    high -= low
    high *= share
    high += low
    return high


def _light(chance: Chance) -> Array:
    """(SIDE, SIDE, 1) uneven light, from one side or a lamp."""
    y, x = np.mgrid[0 : 1 : SIDE * 1j, 0 : 1 : SIDE * 1j]
    slope = chance.uniform(-0.5, 0.5, 2)
    glow = np.exp(-((x - chance.random()) ** 2 + (y - chance.random() * 0.6) ** 2) / 0.15)
    lit = 1 + slope[0] * (x - 0.5) + slope[1] * (y - 0.5) + chance.uniform(-0.2, 0.5) * glow
    return np.clip(lit, 0.3, 1.7)[:, :, None]

"""What garments lie on or hang before: boards, sheets, rugs, tiles, walls; seen straight on."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from swifttailor.arrays import Array
from swifttailor.data.renders.backdrop_colors import Chance, mixed_color, random_tint
from swifttailor.data.renders.backdrops import random_scenery
from swifttailor.render import Checks, Dots, Print, Stripes
from swifttailor.render.motifs import smooth_noise

_GAMMA = 2.2
_SCENERY = 0.1
_PRINTED = 0.35
_SEEN_CM = (60.0, 160.0)
"""Sides of the picture, by lot: what decides how large the print of a sheet is."""


def random_ground(chance: Chance, size: int) -> Array:
    """(size, size, 3) float32 linear light, drawn by lot."""
    if chance.random() < _SCENERY:
        return random_scenery(chance).light(size)
    maker = _MAKERS[int(chance.choice(len(_MAKERS), p=_SHARES))]
    picture = np.clip(maker(chance, size), 0.0, 1.0) ** _GAMMA
    return (picture * _uneven_light(chance, size)).astype(np.float32)


def _places(chance: Chance, size: int, turned: float) -> tuple[Array, Array]:
    """(size, size) places along two axes that are turned by an angle, in sides of the picture."""
    y, x = np.mgrid[0 : 1 : size * 1j, 0 : 1 : size * 1j]
    cosine, sine = np.cos(turned), np.sin(turned)
    dx, dy = x - chance.random(), y - chance.random()
    return cosine * dx + sine * dy, cosine * dy - sine * dx


def _turned(chance: Chance) -> float:
    """Along the picture, across it, slantwise, or nearly so."""
    straight = chance.choice([0.0, np.pi / 2, np.pi / 4, chance.uniform(0, np.pi)])
    return float(straight + chance.normal(0, 0.04))


def _hashed(numbers: Array) -> Array:
    """From 0 to 1, another for each whole number."""
    return np.abs(np.sin(numbers * 12.9898 + 4.1) * 43758.5453) % 1


def _boards(chance: Chance, size: int) -> Array:
    """A floor or a door of wood; parquet where boards are short."""
    across, along = _places(chance, size, _turned(chance))
    wide = chance.uniform(0.04, 0.22)
    long = wide * chance.choice([3.0, 8.0, 40.0])
    board = np.floor(across / wide)
    along = along + _hashed(board) * long
    piece = board * 37 + np.floor(along / long)
    shade = 1 + chance.uniform(0.03, 0.25) * (_hashed(piece) - 0.5)
    grain = smooth_noise(chance, size, 0.9, float(chance.choice([0.12, 8.0])))
    shade = shade * (1 + chance.uniform(0.01, 0.07) * grain)
    joint = (across / wide % 1 < 0.04) | (along / long % 1 < 0.02 * wide / long)
    shade = np.where(joint, shade * chance.uniform(0.45, 0.9), shade)
    wood = mixed_color((0.86, 0.72, 0.54), (0.28, 0.17, 0.11), chance.random())
    if chance.random() < 0.25:
        wood = random_tint(chance, 0.5, 0.95, 0.05)
    return np.asarray(wood) * shade[:, :, None]


def _sheet(chance: Chance, size: int) -> Array:
    """A sheet, a bedspread, a rug: cloth in soft folds, often printed."""
    if chance.random() < _PRINTED:
        seen = chance.uniform(*_SEEN_CM)
        across, along = _places(chance, size, _turned(chance))
        at = (seen * np.stack([across, along], -1)).reshape(-1, 2).astype(np.float32)
        picture = np.asarray(_print(chance).colors(at), np.float64).reshape(size, size, 3)
        picture = np.clip(picture, 0, 1) ** (1 / _GAMMA)
    else:
        vivid = float(chance.choice([0.04, 0.2, 0.6]))
        picture = np.broadcast_to(np.asarray(random_tint(chance, 0.1, 0.98, vivid)), (size, size, 3))
    folds = smooth_noise(chance, size, chance.uniform(1.4, 2.2), float(chance.choice([0.4, 1.0, 2.5])))
    fine = chance.normal(0, chance.choice([0.0, 0.02, 0.08]), (size, size))
    return picture * (1 + chance.uniform(0.01, 0.12) * folds + fine)[:, :, None]


def _print(chance: Chance) -> Print:
    first, second = (random_tint(chance, 0.05, 0.95, 0.5) for _ in range(2))
    wide, turned = float(chance.uniform(1.0, 9.0)), float(chance.choice([0.0, 45.0, 90.0]))
    kind = int(chance.integers(3))
    if kind == 0:
        return Stripes(first, second, wide, wide * float(chance.uniform(0.2, 0.7)), turned, 0.02)
    if kind == 1:
        return Checks(first, second, wide, min(turned, 45.0), 0.02)
    return Dots(first, second, wide, wide * float(chance.uniform(0.15, 0.4)), turned, 0.02)


def _tiles(chance: Chance, size: int) -> Array:
    """Tiles of a floor or a wall, plain or in two colours."""
    across, along = _places(chance, size, _turned(chance))
    wide = chance.uniform(0.08, 0.5)
    tall = wide * float(chance.choice([1.0, 1.0, 0.5]))
    column, row = np.floor(across / wide), np.floor(along / tall)
    stone = smooth_noise(chance, size, chance.uniform(0.8, 1.8))
    shade = 1 + 0.06 * (_hashed(column * 57 + row) - 0.5) + chance.uniform(0.0, 0.08) * stone
    if chance.random() < 0.25:
        shade = np.where((column + row) % 2 < 1, shade, shade * chance.uniform(0.3, 0.8))
    joint = (across / wide % 1 < 0.02) | (along / tall % 1 < 0.02 * wide / tall)
    shade = np.where(joint, chance.uniform(0.5, 1.1), shade)
    return np.asarray(random_tint(chance, 0.3, 0.95, 0.12)) * shade[:, :, None]


def _wall(chance: Chance, size: int) -> Array:
    """Paint, paper or plaster; now and then a door's or a wardrobe's panels."""
    high, vivid = (1.0, 0.03) if chance.random() < 0.6 else (0.9, 0.3)
    color = np.asarray(random_tint(chance, 0.45, high, vivid))
    rough = smooth_noise(chance, size, chance.uniform(0.4, 1.6))
    shade = 1 + chance.uniform(0.0, 0.03) * rough
    if chance.random() < 0.3:
        for _ in range(int(chance.integers(1, 4))):
            a, b = sorted(chance.random(2))
            lines = np.zeros(size, bool)
            lines[[int(a * (size - 1)), int(b * (size - 1))]] = True
            depth = chance.uniform(0.75, 0.95)
            shade = np.where(lines[None] if chance.random() < 0.6 else lines[:, None], shade * depth, shade)
    return color * shade[:, :, None]


def _carpet(chance: Chance, size: int) -> Array:
    """A carpet, gravel, grass: noise of two colours."""
    first, second = random_tint(chance, 0.1, 0.9, 0.25), random_tint(chance, 0.1, 0.9, 0.25)
    share = np.clip(0.5 + 0.35 * smooth_noise(chance, size, chance.uniform(0.1, 1.4)), 0, 1)
    return np.asarray(first) + share[:, :, None] * (np.asarray(second) - np.asarray(first))


def _paper(chance: Chance, size: int) -> Array:
    """Nothing but one light colour, as shops show clothes."""
    shade = 1.0 if chance.random() < 0.5 else chance.uniform(0.8, 1.0)
    return np.full((size, size, 3), shade)


def _uneven_light(chance: Chance, size: int) -> Array:
    """(size, size, 1) a slope, and a lamp or a shadow somewhere."""
    y, x = np.mgrid[0 : 1 : size * 1j, 0 : 1 : size * 1j]
    slope = chance.uniform(-0.4, 0.4, 2)
    glow = np.exp(-((x - chance.random()) ** 2 + (y - chance.random()) ** 2) / chance.uniform(0.05, 0.4))
    lit = 1 + slope[0] * (x - 0.5) + slope[1] * (y - 0.5) + chance.uniform(-0.35, 0.4) * glow
    return np.clip(lit, 0.3, 1.6)[:, :, None]


_MAKERS: tuple[Callable[[Chance, int], Array], ...] = (_boards, _sheet, _tiles, _wall, _carpet, _paper)
_SHARES = (0.24, 0.3, 0.1, 0.22, 0.06, 0.08)

"""People cut out of photographs on white, as shops show them, and put before something else."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Pixels
from swifttailor.data.pictures.closer import coarsened
from swifttailor.data.pictures.linear_light import linear_light
from swifttailor.data.pictures.on_white import on_white
from swifttailor.data.renders.backdrops import random_scenery
from swifttailor.data.renders.camera_effects import random_effects
from swifttailor.picture_reader.cut_square import cut_square
from swifttailor.render.color import encode_srgb

_WHITE, _PURE = 244, 252
"""Least of red, green and blue that counts as white; and between arms and legs, where cloth may be, too."""
_WHITE_EDGE = 0.5
"""Share of a picture's edge that is white where it is a photograph on white."""
_HOLE = 0.0005
"""Least share of a picture that is a hole between arms and legs."""
_ON_A_GROUND = 0.6
"""Of photographs on white so many are put before something else."""
_SIDES, _FAR, _AWAY = (0.75, 1.12), (0.8, 1.8), 0.06
"""Of what is shown of people, in a photograph's longer sides; of those who are put before something else; and
how far off the middle."""
_OF_A_PORTRAIT = (0.28, 0.5)
"""Side of a portrait, in heights of what is shown of a person from the hips up; of all of one it is half of
that."""
_WHOLE_PERSON = 2.4
"""Height over width of what is not white, where most likely a whole person is shown."""
_DARK, _DARKEST = 0.4, 0.15
"""Share of dim photographs, and the light of the dimmest."""
_FINER = 2
"""Pixels of the mask along one of the picture."""
_EFFECTS = 0.5


def shown_person(
    pixels: Pixels, size: int, chance: np.random.Generator, *, near: bool, cut_out: float = 0.0
) -> tuple[Pixels, int]:
    """A photograph of somebody as other people take it, and how many pixels of it that is from side to side.

    Those on white are mostly put before something else. Whoever is cut off by an edge then stays at that edge
    of the picture, however far away; all may be dim, and coarse.

    Args:
        pixels: (h, w, 3).
        size: Pixels along each side of the result.
        chance: Decides.
        near: Whether only head and shoulders are shown.
        cut_out: Share of those on white that are shown as if cut out of something else, see `on_white`.
    """
    ground = white_around(pixels)
    cut = ground is not None and cut_out > 0 and chance.random() < cut_out
    replaced = ground is not None and not cut and chance.random() < _ON_A_GROUND
    square = _square(pixels.shape[:2], ground, chance, near=near, far=replaced)
    shown = cut_square(pixels, square, size)
    if ground is not None and replaced:
        shown = on_a_ground(shown, cover_of(ground, square, size), chance)
    elif cut and chance.random() < _EFFECTS:
        shown = random_effects(chance).apply(shown)
    if chance.random() < _DARK:
        light = float(np.exp(chance.uniform(np.log(_DARKEST), 0.0)))
        shown = encode_srgb(light * linear_light(shown))
    if ground is not None and cut:
        shown = on_white(shown, cover_of(ground, square, size), chance)
    return coarsened(shown, chance), square[2]


def _square(
    shape: tuple[int, int],
    ground: NDArray[np.bool_] | None,
    chance: np.random.Generator,
    *,
    near: bool,
    far: bool,
) -> tuple[int, int, int]:
    """Left, top, side of what is shown of a photograph (h, w)."""
    height, width = shape
    longer = max(shape)
    right, down = chance.normal(0, _AWAY, 2) * longer
    rows = np.arange(height) if ground is None else np.flatnonzero(~ground.all(axis=1))
    columns = np.arange(width) if ground is None else np.flatnonzero(~ground.all(axis=0))
    if near and len(rows) and len(columns):
        high, across = rows[-1] + 1 - rows[0], columns[-1] + 1 - columns[0]
        part = float(chance.uniform(*_OF_A_PORTRAIT)) / (2 if high > _WHOLE_PERSON * across else 1)
        side = max(round(1.5 * part * high), 1)
        middle = (columns[0] + columns[-1]) / 2
        return round(middle - side / 2 + 0.3 * right), round(rows[0] - 0.2 * side + 0.3 * down), side
    side = round(longer * float(chance.uniform(*(_FAR if far else _SIDES))))
    left, top = round((width - side) / 2 + right), round((height - side) / 2 + down)
    if far and ground is not None and side > height:
        if not ground[-1].all():
            top = height - side
        elif not ground[0].all():
            top = 0
    return left, top, side


def cover_of(ground: NDArray[np.bool_], square: tuple[int, int, int], size: int) -> NDArray[np.float32]:
    """(size, size) how much of each pixel shows somebody, in a square of a photograph on white.

    Args:
        ground: (h, w) what is white there, see `white_around`.
        square: Left, top, side, see `cut_square`.
        size: Pixels along each side of the result.
    """
    mask = np.where(ground, 0, 255).astype(np.uint8)
    fine = cut_square(np.repeat(mask[:, :, None], 3, axis=2), square, _FINER * size)[:, :, 0]
    cover = fine.reshape(size, _FINER, size, _FINER).mean(axis=(1, 3)).astype(np.float32) / 255
    return np.clip(1.5 * cover - 0.5, 0.0, 1.0)  # what is half white has the photograph's white in it


def on_a_ground(pixels: Pixels, cover: NDArray[np.float32], chance: np.random.Generator) -> Pixels:
    """(s, s, 3): somebody with something else behind, in another light.

    Args:
        pixels: (s, s, 3).
        cover: (s, s) how much of each pixel shows somebody.
        chance: Decides what is behind.
    """
    level, cover = float(chance.uniform(0.7, 1.1)), cover[:, :, None]
    light = random_scenery(chance).light(len(pixels)) * (1 - cover) + cover * level * linear_light(pixels)
    drawn = encode_srgb(light)
    return random_effects(chance).apply(drawn) if chance.random() < _EFFECTS else drawn


def white_around(pixels: Pixels) -> NDArray[np.bool_] | None:
    """(h, w) what is white around what a photograph shows; None where little of its edge is white."""
    from scipy import ndimage

    least = np.min(pixels, axis=2)
    white: NDArray[np.bool_] = least >= _WHITE
    if np.mean(_edge(white)) < _WHITE_EDGE:
        return None
    labels, _ = ndimage.label(white)
    of_edge = np.unique(_edge(labels))
    found = np.isin(labels, of_edge[of_edge > 0])
    holes, count = ndimage.label((least >= _PURE) & ~found)
    large = np.flatnonzero(np.bincount(holes.ravel(), minlength=count + 1) >= _HOLE * holes.size)
    return found | np.isin(holes, large[large > 0])


def _edge(values: NDArray[Any]) -> NDArray[Any]:
    return np.concatenate([values[0], values[-1], values[:, 0], values[:, -1]])

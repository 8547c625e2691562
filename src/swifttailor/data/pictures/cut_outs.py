"""People cut out of photographs on white, as shops show them, and put before something else."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Pixels
from swifttailor.data.pictures.scenes import linear_light
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
_FINER = 2
"""Pixels of the mask along one of the picture."""
_EFFECTS = 0.5


def on_a_ground(
    pixels: Pixels,
    ground: NDArray[np.bool_],
    square: tuple[int, int, int],
    size: int,
    chance: np.random.Generator,
) -> Pixels:
    """(size, size, 3): a square of a photograph on white with something else behind what it shows.

    Args:
        pixels: (h, w, 3) the photograph.
        ground: (h, w) what is white there, see `white_around`.
        square: Left, top, side, see `cut_square`.
        size: Pixels along each side of the result.
        chance: Decides what is behind.
    """
    mask = np.where(ground, 0, 255).astype(np.uint8)
    fine = cut_square(np.repeat(mask[:, :, None], 3, axis=2), square, _FINER * size)[:, :, :1]
    cover = fine.reshape(size, _FINER, size, _FINER, 1).mean(axis=(1, 3)).astype(np.float32) / 255
    cover = np.clip(1.5 * cover - 0.5, 0.0, 1.0)  # what is half white has the photograph's white in it
    shown = cut_square(pixels, square, size)
    level = float(chance.uniform(0.7, 1.1))
    light = random_scenery(chance).light(size) * (1 - cover) + cover * level * linear_light(shown)
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


def stands_free(ground: NDArray[np.bool_]) -> bool:
    """Whether nobody is cut off by an edge of a photograph on white (h, w)."""
    return bool(_edge(ground).all())


def _edge(values: NDArray[Any]) -> NDArray[Any]:
    return np.concatenate([values[0], values[-1], values[:, 0], values[:, -1]])

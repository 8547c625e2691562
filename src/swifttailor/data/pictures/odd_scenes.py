"""Pictures that no garment can be read from: none in it, a drawing, a group of people."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Pixels
from swifttailor.data.pictures.scenes import (
    VIEWS,
    Chance,
    Scene,
    Wardrobe,
    draw_scene,
    linear_light,
)
from swifttailor.data.renders.backdrops import random_scenery
from swifttailor.data.renders.camera_effects import random_effects
from swifttailor.data.renders.foreground import random_before
from swifttailor.picture_reader.figures import FIGURES
from swifttailor.picture_reader.labels import MASK_STRIDE, PARTS, VIEW
from swifttailor.render.color import encode_srgb

_NEAREST, _FARTHEST = 0.24, 0.42
"""How far from the middle people of a group stand, in sides of the picture."""
_HIGH = 130.0, 290.0
"""How many centimetres are seen from the bottom to the top of a picture of a group."""


def draw_nothing(chance: Chance, size: int) -> Scene:
    """A place with things in it, one colour, a slope of colours, noise, or strokes on paper.

    Args:
        chance: Decides everything.
        size: Pixels along each side.
    """
    lot = chance.random()
    if lot < 0.5:
        light = random_scenery(chance).light(size)
        cover = np.ones((size, size), np.float32)
        for _ in range(int(chance.integers(4))):
            for thing in random_before(chance):
                thing.put(light, cover)
        pixels = encode_srgb(light)
    elif lot < 0.75:
        pixels = _shades(chance, size)
    else:
        pixels = _strokes(chance, size)
    if chance.random() < 0.6:
        pixels = random_effects(chance).apply(pixels)
    return unread(pixels, "none")


def draw_group(wardrobe: Wardrobe, number: int, chance: Chance, size: int) -> Scene:
    """Two or three people side by side in one place.

    Args:
        wardrobe: What there is.
        number: Of a garment that one of them wears.
        chance: Decides everything else.
        size: Pixels along each side.
    """
    count = 3 if chance.random() < 0.35 else 2
    sides = np.linspace(-1, 1, count) * chance.uniform(_NEAREST, _FARTHEST)
    height = float(chance.uniform(*_HIGH))
    behind: NDArray[np.float32] | None = None
    pixels = np.zeros((size, size, 3), np.uint8)
    for k in chance.permutation(count):
        aside = float(sides[k] + chance.normal(0, 0.02)), height * float(chance.uniform(0.9, 1.1))
        view = VIEWS[int(chance.choice(3, p=(0.6, 0.1, 0.3)))]
        pixels = draw_scene(wardrobe, number, view, chance, size, behind=behind, aside=aside).pixels
        behind = linear_light(pixels)
        number = int(chance.integers(len(wardrobe.bank)))
    return unread(pixels, "several")


def unread(pixels: Pixels, figures: str) -> Scene:
    """A picture of which nothing is learnt but how many of `FIGURES` it shows."""
    cells = len(pixels) // MASK_STRIDE
    masks = np.zeros((cells, cells, len(PARTS)), np.uint8)
    nowhere = np.full((cells, cells, 3), np.float16(np.nan))
    none = np.full(len(PARTS), -1)
    no_panel = np.zeros((cells, cells), np.uint8)
    return Scene(
        pixels, masks, nowhere, no_panel, np.zeros(len(VIEW), np.float32), none, FIGURES.index(figures)
    )


def _shades(chance: Chance, size: int) -> Pixels:
    """One colour, black and white among them, a slope between two, or noise around one."""
    first = chance.integers(0, 256, 3) if chance.random() < 0.6 else np.full(3, chance.choice([0, 255, 128]))
    second = chance.integers(0, 256, 3) if chance.random() < 0.4 else first
    turned = chance.uniform(0, 2 * np.pi)
    y, x = np.mgrid[0:size, 0:size] / size
    along = np.clip(0.5 + (x - 0.5) * np.cos(turned) + (y - 0.5) * np.sin(turned), 0, 1)[..., None]
    noise = chance.choice([0.0, 3.0, 60.0]) * chance.standard_normal((size, size, 3))
    return np.clip((1 - along) * first + along * second + noise, 0, 255).astype(np.uint8)


def _strokes(chance: Chance, size: int) -> Pixels:
    """Lines and patches on paper: a drawing, a diagram, a page."""
    from PIL import Image, ImageDraw

    paper, ink = (245, 25) if chance.random() < 0.85 else (20, 235)
    image = Image.new("RGB", (size, size), (paper,) * 3)
    pen = ImageDraw.Draw(image)
    for _ in range(int(chance.integers(1, 40))):
        points = chance.uniform(0, size, 2) + np.cumsum(
            chance.normal(0, size * chance.uniform(0.03, 0.3), (int(chance.integers(2, 7)), 2)), axis=0
        )
        color = (ink,) * 3 if chance.random() < 0.7 else tuple(int(v) for v in chance.integers(0, 256, 3))
        corners = [(float(x), float(y)) for x, y in points]
        if chance.random() < 0.2 and len(corners) > 2:
            pen.polygon(corners, fill=color)
        else:
            pen.line(corners, fill=color, width=max(1, int(size * chance.uniform(0.004, 0.02))))
    return np.asarray(image)

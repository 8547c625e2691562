"""Tiles of prints, looked up as a texture that repeats, against the prints themselves."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.garment.cloth_print import MOTIFS, ClothPrint
from swifttailor.garment.print_tile import MOST_PIXELS, print_tile
from swifttailor.render.color import to_linear
from swifttailor.render.named_pictures import NAMED

_COLORS = ("#203050", "#ffffff", "#b03020", "#e0c040")
PRINTS = [
    ClothPrint("stripes", _COLORS[:2], {"width": 3.0, "gap": 1.4}),
    ClothPrint("checks", _COLORS[:2], {"width": 1.7}),
    ClothPrint("plaid", _COLORS[:3], {"spacing": 7.0}),
    ClothPrint("dots", _COLORS[:2], {"spacing": 3.1, "radius": 0.9}),
    *[ClothPrint("motif", _COLORS, {"repeat": 23.0}, motif) for motif in MOTIFS],
]


def looked_up(printed: ClothPrint, places: np.ndarray) -> np.ndarray:
    """(n, 3) linear light: the pixel of the repeated tile at each place."""
    tile = print_tile(printed)
    at = places @ tile.matrix().T % 1.0
    rows, columns = tile.picture.shape[:2]
    pixels = tile.picture[rows - 1 - (at[:, 1] * rows).astype(int), (at[:, 0] * columns).astype(int)]
    return np.array([to_linear(pixel) for pixel in pixels / 255.0])


@pytest.mark.parametrize("angle", [0.0, 45.0, 90.0, -30.0])
@pytest.mark.parametrize("printed", PRINTS, ids=lambda one: one.motif if one.kind == "motif" else one.kind)
def test_a_tile_that_repeats_is_the_print(printed, angle):
    turned = ClothPrint(printed.kind, printed.colors, {**printed.sizes, "angle": angle}, printed.motif)
    places = np.random.default_rng(3).uniform(-150.0, 150.0, (3000, 2))
    away = np.abs(looked_up(turned, places) - turned.drawn(grain=0.0).colors(places)).max(axis=1)
    # On the edge of two colours a pixel may have either, and fine shades differ within a pixel.
    soft = printed.motif in NAMED
    assert np.median(away) < (0.04 if soft else 0.01) and (away > 0.15).mean() < (0.06 if soft else 0.03)


def test_it_has_the_smallest_repeat_and_a_bound():
    tile = print_tile(ClothPrint("dots", _COLORS[:2], {"spacing": 4.0, "radius": 1.0}))
    assert (tile.width, tile.height) == pytest.approx((4.0, 4.0 * np.sqrt(3)))
    wide = print_tile(ClothPrint("plaid", _COLORS[:3], {"spacing": 200.0}))
    assert wide.picture.shape == (MOST_PIXELS, MOST_PIXELS, 3)
    small = print_tile(ClothPrint("checks", _COLORS[:2], {"width": 0.05}))
    assert min(small.picture.shape[:2]) >= 4

"""The picture that shows what was looked at."""

from __future__ import annotations

import numpy as np
from seeing import Seeing, worn

from swifttailor.picture_reader.panel_kinds import PANEL_KINDS
from swifttailor.picture_reader.reading import SeenCells
from swifttailor.tailor.looking import SeenPicture
from swifttailor.tailor.seen_sheet import _KIND_COLORS, SIZE, draw_seen


def seen_picture(cells: SeenCells | None) -> SeenPicture:
    """White, with a garment in its upper half."""
    pixels = np.full((64, 64, 3), 255, np.uint8)
    return SeenPicture(pixels, Seeing((worn("upper", {"kind": ("top", 0.9)}),), cells=cells).read(pixels))


def test_what_is_not_the_garment_is_dimmed():
    shown = draw_seen([seen_picture(None)], "upper")
    assert shown.shape == (SIZE, SIZE, 3)
    assert (shown[10] == 255).all() and (shown[-10] < 255).all()
    assert (draw_seen([seen_picture(None)], None) == 255).all(), "nothing is set off where nothing is named"


def test_panels_are_tinted_by_their_kind_and_named_in_the_picture():
    sleeve, hood = PANEL_KINDS.index("sleeve"), PANEL_KINDS.index("hood")
    mask, kinds = np.zeros((8, 8), np.float32), np.full((8, 8), sleeve, np.uint8)
    mask[4:] = 1.0
    kinds[6:] = hood
    cells = SeenCells((0, 0, 64, 64), mask, np.zeros((8, 8, 3), np.float32), kinds)
    shown = draw_seen([seen_picture(cells), seen_picture(None)], "upper")
    assert shown.shape == (SIZE, 3 * SIZE, 3), "two crops and the panels of one"
    tile = shown[:, SIZE : 2 * SIZE].astype(int)
    hues = [np.array([int(_KIND_COLORS[k][i : i + 2], 16) for i in (1, 3, 5)]) for k in (sleeve, hood)]
    for row, hue, other in ((4.5, *hues), (6.5, *hues[::-1])):
        pixel = tile[round(row * SIZE / 8), SIZE // 2]
        assert np.abs(pixel - hue).sum() < np.abs(pixel - other).sum()
    assert len(np.unique(tile[SIZE // 4, SIZE // 2 :], axis=0)) == 1, "no garment, no tint"
    assert not (tile[8:40, 26:120] == tile[SIZE // 4, SIZE - 1]).all(), "the kinds are named"

"""Cloths that are drawn as they are woven."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.garment.cloth_print import ClothPrint
from swifttailor.render.drawn_cloths import DRAWN
from swifttailor.render.named_pictures import number_of
from swifttailor.render.ramps import NAMED_SIDE, RAMP


@pytest.mark.parametrize(
    ("name", "last"),
    [
        *(("houndstooth", 1), ("tartan", 4), ("granny_squares", 4)),
        *(("palm_trees", 3), ("marl", 2), ("linen", 2)),
    ],
)
def test_every_color_of_a_cloth_is_in_it(name, last):
    drawn = DRAWN[name]()
    assert drawn.shape == (NAMED_SIDE, NAMED_SIDE)
    assert drawn.min() == 0.0 and drawn.max() == last * RAMP
    assert np.array_equal(drawn, DRAWN[name]())


def test_houndstooth_is_half_of_each_color_and_no_plain_check():
    drawn = DRAWN["houndstooth"]() > 0
    assert drawn.mean() == pytest.approx(0.5)
    solid, broken = drawn[:16, :16], drawn[:16, 16:32]
    assert solid.all() and 0.4 < broken.mean() < 0.6


def test_a_plaid_of_three_colors_is_a_tartan_and_window_panes_are_none():
    tartan = ClothPrint("plaid", ("#b0242d", "#1e3a36", "#eadfc6"), {"spacing": 8.0})
    panes = ClothPrint("plaid", ("#efeadf", "#efeadf", "#3a4f70"), {"spacing": 5.0})
    assert tartan.is_tartan and not panes.is_tartan
    drawn = tartan.drawn()
    assert (drawn.motif, drawn.repeat, len(drawn.colors_of)) == (number_of("tartan"), 20.0, 5)

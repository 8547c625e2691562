"""Figures that are printed by name."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.render.drawn_figures import FIGURES, figure_picture
from swifttailor.render.motifs import BANDS, FIRST_MOTIF, SIDE, bank
from swifttailor.render.prints import Motif

INKS = ((1.0, 1.0, 1.0), (0.6, 0.0, 0.0), (0.0, 0.4, 0.0), (0.0, 0.0, 0.3))


@pytest.mark.parametrize("name", FIGURES)
def test_a_figure_leaves_its_ground_and_lies_in_the_bank(name):
    picture = figure_picture(name, SIDE)
    assert 0.05 < np.mean(picture > 0) < 0.5 and picture.max() <= 3
    first = FIRST_MOTIF + (BANDS + 1 + FIGURES.index(name)) * SIDE**2
    assert (bank()[first : first + SIDE**2].reshape(SIDE, SIDE) == picture).all()


def test_figures_stand_upright_and_every_second_row_is_shifted():
    cherries = figure_picture("cherries", SIDE)
    heights = [np.nonzero(cherries[: SIDE // 2, : SIDE // 2] == ink)[0].mean() for ink in (1, 2)]
    assert heights[0] < heights[1], "fruit hangs below its stalks; the first row is the lowest"
    half = SIDE // 2
    assert not cherries[:half, half:].any() and (cherries[:half, :half] == cherries[half:, half:]).all()


def test_cloth_has_the_inks_of_its_figures():
    places = np.random.default_rng(0).uniform(0.0, 20.0, (4000, 2))
    foxes = Motif(INKS, BANDS + 1 + FIGURES.index("foxes"), 10.0, grain=0.0)
    assert len(np.unique(np.round(foxes.colors(places), 3), axis=0)) == 4

"""Figures that are printed by name."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.ndimage import label

from swifttailor.render.drawn_figures import FIGURES, figure_picture
from swifttailor.render.drawn_naps import CHANNELS
from swifttailor.render.named_pictures import NAMED, named_picture, number_of
from swifttailor.render.prints import Motif
from swifttailor.render.ramps import NAMED_SIDE, RAMP

INKS = ((1.0, 1.0, 1.0), (0.6, 0.0, 0.0), (0.0, 0.4, 0.0), (0.0, 0.0, 0.3))


SIDE = 128


@pytest.mark.parametrize("name", FIGURES)
def test_a_figure_leaves_its_ground(name):
    picture = figure_picture(name, SIDE)
    assert 0.05 < np.mean(picture > 0) < 0.5 and picture.max() <= 3


@pytest.mark.parametrize("name", NAMED)
def test_a_named_picture_has_several_inks_and_repeats_without_a_seam(name):
    picture = named_picture(number_of(name)).reshape(NAMED_SIDE, NAMED_SIDE).astype(int)
    assert 0 <= picture.min() and picture.max() <= 6 * RAMP and len(np.unique(picture)) > 1
    share = np.bincount((picture // RAMP).ravel(), minlength=7) / picture.size
    assert share.max() < 0.97
    for one in (picture, picture.T):
        steps = (np.abs(one - np.roll(one, 1, axis=0)) > RAMP // 2).mean(axis=1)
        assert steps[0] <= steps.max(), "from the last row to the first no more changes than elsewhere"


def test_figures_stand_upright_and_every_second_row_is_shifted():
    cherries = figure_picture("cherries", SIDE)
    heights = [np.nonzero(cherries[: SIDE // 2, : SIDE // 2] == ink)[0].mean() for ink in (1, 2)]
    assert heights[0] < heights[1], "fruit hangs below its stalks; the first row is the lowest"
    half = SIDE // 2
    assert not cherries[:half, half:].any() and (cherries[:half, :half] == cherries[half:, half:]).all()


def test_cloth_has_the_inks_of_its_figures():
    places = np.random.default_rng(0).uniform(0.0, 20.0, (4000, 2))
    foxes = Motif(INKS, number_of("foxes"), 10.0, grain=0.0)
    away = np.abs(foxes.colors(places)[:, None] - np.array(INKS)).max(axis=2).min(axis=1)
    assert (away < 1e-3).mean() > 0.75, "all but the soft borders between two inks"


def test_a_ramp_of_colours_is_blended():
    curls = Motif(((0.0, 0.0, 0.0), (1.0, 1.0, 1.0)), number_of("pile"), 10.0, grain=0.0)
    places = np.random.default_rng(0).uniform(0.0, 20.0, (4000, 2))
    assert len(np.unique(np.round(curls.colors(places), 2), axis=0)) > 40


COLORS = ((0.02, 0.03, 0.08), (0.5, 0.66, 0.8), (0.55, 0.35, 0.03))


@pytest.mark.parametrize("color", COLORS)
def test_sequins_have_the_colour_of_their_cloth_and_few_of_them_sparkle(color):
    red, green, blue = color
    bright = tuple(0.5 + 0.5 * part for part in color)
    sequins = Motif(((red / 3, green / 3, blue / 3), color, bright), number_of("sequins"), 11.0, grain=0.0)
    seen = sequins.colors(np.random.default_rng(0).uniform(0.0, 44.0, (8000, 2)))
    assert np.abs(seen.mean(axis=0) - color).max() < 0.06
    assert 0.01 < (np.abs(seen - bright).max(axis=1) < 0.05).mean() < 0.06


def test_curls_are_fine_and_lie_no_way_more_than_another():
    picture = named_picture(number_of("curls")).reshape(NAMED_SIDE, NAMED_SIDE) - float(RAMP)
    strength = np.abs(np.fft.fft2(picture)) ** 2
    way = np.fft.fftfreq(NAMED_SIDE) * NAMED_SIDE
    across, down = way[None, :], way[:, None]
    assert strength[np.hypot(across, down) < 20].sum() < 0.05 * strength.sum(), "no pebbles"
    steep = strength[np.abs(down) > np.abs(across)].sum() / strength.sum()
    assert 0.4 < steep < 0.6


def test_cushions_are_even_across_and_darkest_at_their_stitches():
    picture = named_picture(number_of("channels")).reshape(NAMED_SIDE, NAMED_SIDE)
    assert (picture == picture[:, :1]).all(), "smooth lines"
    rows = picture[: NAMED_SIDE // CHANNELS, 0]
    assert rows[0] == rows[-1] == 0 and rows[len(rows) // 2] > RAMP
    assert np.abs(np.diff(rows[2:-2])).max() < RAMP / 4, "soft shades between"


def test_sprigs_lie_apart_on_their_ground():
    picture = named_picture(number_of("sprigs")).reshape(NAMED_SIDE, NAMED_SIDE)
    assert (picture == 0).mean() > 0.75
    assert label(picture > 0)[1] >= 14, "sixteen, one or two of which may touch"

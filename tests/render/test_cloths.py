"""Prints and cloths as the compiled loop sees them."""

from __future__ import annotations

import numpy as np
import plain_prints
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scenes import sheet

from swifttailor.errors import InputError
from swifttailor.render import Camera, Checks, Dots, Plain, Stripes, Surface, render_view
from swifttailor.render.cloths import Block, Cloth, Fade, Folds, Graphic, Mark, Wear, Weave
from swifttailor.render.motifs import FIRST_GRAPHIC, FIRST_MOTIF, GRAPHIC_SIDE, GRAPHICS, SIDE, bank
from swifttailor.render.prints import Motif, Plaid
from swifttailor.render.view import render_seen

RED, BLUE, GREY, GREEN = (0.8, 0.05, 0.05), (0.05, 0.05, 0.8), (0.4, 0.4, 0.4), (0.05, 0.6, 0.05)
NUMBERS = st.floats(0.5, 12.0, width=32)


@given(NUMBERS, NUMBERS, st.floats(0, 180, width=32), st.floats(0, 0.25, width=32), st.integers(0, 10**6))
@settings(max_examples=40, deadline=None)
def test_prints_are_those_of_plain_numpy(width, gap, angle, grain, seed):
    at = np.random.default_rng(seed).uniform(-60, 60, (500, 2))
    rest = grain, seed
    pairs = [(kind(RED, *rest), plain(RED, *rest)) for kind, plain in ((Plain, plain_prints.Plain),)]
    pairs += [
        (
            Stripes(RED, BLUE, width, gap, angle, *rest),
            plain_prints.Stripes(RED, BLUE, width, gap, angle, *rest),
        ),
        (Checks(RED, BLUE, width, angle, *rest), plain_prints.Checks(RED, BLUE, width, angle, *rest)),
        (
            Dots(RED, BLUE, gap, width / 8, angle, *rest),
            plain_prints.Dots(RED, BLUE, gap, width / 8, angle, *rest),
        ),
    ]
    for compiled, plain in pairs:
        found, expected = compiled.colors(at), plain.colors(at)
        # Borders are soft over a millimetre; the table's angle and widths are single precision.
        assert np.abs(found - expected).max() < 2e-3


def test_plaid_has_bands_lines_and_ground():
    plaid = Plaid(GREY, RED, BLUE, spacing=10.0, width=0.4, thin=0.1, grain=0.0)
    at = np.array([[0.0, 0], [0, 3.5], [3.5, 3.5], [5, 3.5]])
    both, one, none, line = plaid.colors(at).astype(float)
    np.testing.assert_allclose(both, RED, atol=1e-6)
    np.testing.assert_allclose(one, (np.array(RED) + GREY) / 2, atol=1e-6)
    np.testing.assert_allclose(none, GREY, atol=1e-6)
    np.testing.assert_allclose(line, np.array(GREY) + 0.8 * (np.array(BLUE) - GREY), atol=1e-6)


@given(st.integers(0, 39), st.floats(5, 60, width=32), st.integers(0, 10**6))
@settings(max_examples=20, deadline=None)
def test_motifs_show_their_picture_again_and_again(number, repeat, seed):
    motif = Motif((RED, BLUE, GREY, GREEN), number, repeat, grain=0.0)
    cell = np.random.default_rng(seed).integers(0, SIDE, (200, 2))
    at = (cell + 0.5) / SIDE * np.float64(np.float32(repeat))
    start = FIRST_MOTIF + number * SIDE**2
    picture = bank()[start : start + SIDE**2].reshape(SIDE, SIDE)
    expected = np.array([RED, BLUE, GREY, GREEN])[picture[cell[:, 1], cell[:, 0]]]
    for shift in ((0, 0), (repeat, -2 * repeat)):
        np.testing.assert_allclose(motif.colors(at + shift), expected, atol=1e-6)


def test_a_bank_has_motifs_that_are_more_than_one_colour():
    side = bank()[FIRST_MOTIF:FIRST_GRAPHIC].reshape(-1, SIDE**2)
    assert (side.min(axis=1) >= 0).all() and (side.max(axis=1) <= 3).all()
    assert (side.std(axis=1) > 0.2).mean() > 0.9
    graphics = bank()[FIRST_GRAPHIC : FIRST_GRAPHIC + GRAPHICS * GRAPHIC_SIDE**2].reshape(-1, GRAPHIC_SIDE**2)
    assert set(np.unique(graphics)) <= {0, 1, 2} and ((graphics > 0).mean(axis=1) > 0.05).all()


def test_what_is_put_on_a_place_of_the_garment():
    plain = Plain(GREY, 0.0)
    at, high = np.zeros((4, 2)), 100.0
    rest = np.array([[0.0, high, 5], [0, high, -5], [30, high, 5], [0, 20, 5]])
    block = Cloth(plain, block=Block("below", RED, 60.0)).colors(at, rest)
    np.testing.assert_allclose(block, [GREY, GREY, GREY, RED], atol=1e-6)
    fade = Cloth(plain, fade=Fade(BLUE, 100.0, 60.0, 0.0)).colors(at, rest + np.array([0, -20.0, 0]))
    np.testing.assert_allclose(fade[0], (np.array(GREY) + BLUE) / 2, atol=1e-5)
    np.testing.assert_allclose(fade[3], BLUE, atol=1e-5)
    marks = (Mark("line", (0.0, high), (2.0, 10.0), RED),)
    line = Cloth(plain, marks=marks).colors(at, rest)
    assert np.abs(line[0] - GREY).max() > 0.2, "on the front"
    np.testing.assert_allclose(line[1:], [GREY] * 3, atol=1e-6)
    number = int(
        np.argmax([(bank()[FIRST_GRAPHIC:].reshape(-1, GRAPHIC_SIDE**2)[k] > 0).mean() for k in range(48)])
    )
    graphic = Cloth(plain, graphic=Graphic(number, (0.0, high), (20.0, 20.0), (RED, BLUE)))
    x, y = (v.ravel() for v in np.meshgrid(np.linspace(-9, 9, 20), np.linspace(91, 109, 20)))
    for z, share in ((5.0, 0.4), (-5.0, 0.0)):
        found = graphic.colors(np.zeros((400, 2)), np.stack([x, y, np.full(400, z)], axis=1))
        assert (np.abs(found - GREY).max(axis=1) > 0.1).mean() >= share
        assert share or not np.abs(found - GREY).max() > 1e-6


@pytest.mark.parametrize("kind", ["rib", "jersey", "cable", "twill", "quilt", "cord"])
def test_weaves_repeat_and_only_darken(kind):
    cloth = Cloth(Plain(GREY, 0.0), Weave(kind, 2.0, dark=0.3))
    at = np.random.default_rng(0).uniform(0, 40, (2000, 2))
    found = cloth.colors(at)
    assert found.max() <= GREY[0] + 1e-6 and found.min() >= 0.69 * GREY[0] and found.std() > 0.01
    np.testing.assert_allclose(cloth.colors(at + np.array([2.0, 0.0])), found, atol=1e-4)


def test_mesh_is_open_by_its_share():
    cloth = Cloth(Plain(GREY, 0.0), Weave("mesh", 2.0, 0.0, 0.0, hole=0.4, behind=RED))
    found = cloth.colors(np.random.default_rng(0).uniform(0, 80, (20_000, 2)))
    assert (found[:, 0] > 0.6).mean() == pytest.approx(0.4, abs=0.05)


def test_wear_lightens():
    at = np.random.default_rng(0).uniform(0, 80, (5000, 2))
    rest = np.tile([10.0, 62.0, 8.0], (5000, 1))
    worn = Cloth(Plain(BLUE, 0.0), wear=Wear((0.7, 0.7, 0.8), 0.5))
    thigh, hem = (
        worn.colors(at, rest)[:, 0].mean(),
        worn.colors(at, rest + np.array([15.0, 60, 0]))[:, 0].mean(),
    )
    assert thigh > hem + 0.1 > BLUE[0]


def test_folds_change_light_and_not_colour():
    at = np.array([[[0, 0], [20, 0], [20, 20]], [[0, 0], [20, 20], [0, 20]]], float)
    corners = (-10, -10, 0), (10, -10, 0), (10, 10, 0)

    def draw(cloth: Cloth) -> np.ndarray:
        flat = sheet(*corners, back_color=np.array(GREY), print=cloth, print_at=at)
        return render_view([flat], Camera((0, 0, 0), 20), (64, 64), shadows=False).astype(float)

    smooth, folded = (draw(Cloth(Plain(GREY, 0.0), folds=f)) for f in (None, Folds(0.3, 12.0)))
    assert smooth[8:-8, 8:-8].std(axis=(0, 1)).max() < 1.0 < 4.0 < folded[8:-8, 8:-8].std(axis=(0, 1)).max()
    assert abs(smooth.mean() - folded.mean()) < 12
    np.testing.assert_array_equal(draw(Cloth(Plain(GREY, 0.0))), draw(Plain(GREY, 0.0)))


def test_too_much_is_refused():
    with pytest.raises(InputError, match="at most 6 marks, got 7"):
        Cloth(Plain(GREY), marks=(Mark("line", (0, 0), (1, 1), RED),) * 7).table()


def test_which_surface_is_seen_where():
    near = sheet((-5, -5, 5), (5, -5, 5), (5, 5, 5), back_color=np.array(GREY))
    far = sheet((-10, -10, 0), (10, -10, 0), (10, 10, 0), back_color=np.array(GREY))
    camera, size = Camera((0, 0, 0), 40), (40, 40)
    seen = render_seen([far, near], camera, size)
    np.testing.assert_array_equal(seen.pixels, render_view([far, near], camera, size))
    rows = np.arange(40) + 0.5 - 20
    inner = (np.abs(rows)[:, None] < 5) & (np.abs(rows)[None] < 5)
    outer = (np.abs(rows)[:, None] < 10) & (np.abs(rows)[None] < 10) & ~inner
    np.testing.assert_allclose(seen.shares, np.stack([outer, inner], axis=2), atol=1e-6)
    assert set(np.unique(seen.face[inner])) == {2, 3} and set(np.unique(seen.face[outer])) == {0, 1}
    assert (seen.face[~inner & ~outer] == -1).all()


def test_shares_are_means_of_samples():
    slanted = Surface(np.array([[-9.0, -8, 0], [8, -3, 0], [1, 9, 0]]), np.array([[0, 1, 2]]), np.array(GREY))
    fine = render_seen([slanted], Camera((0, 0, 0), 30), (60, 60), samples=1).shares
    coarse = render_seen([slanted], Camera((0, 0, 0), 30), (30, 30), samples=2).shares
    np.testing.assert_allclose(
        coarse[:, :, 0], fine[:, :, 0].reshape(30, 2, 30, 2).mean(axis=(1, 3)), atol=1e-6
    )
    assert {0.25, 0.5, 0.75} <= set(np.unique(coarse))

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scenes import sheet

from swifttailor.errors import InputError
from swifttailor.render import Camera, Checks, Dots, Light, Lighting, Plain, Stripes, Surface, render_view
from swifttailor.render.color import encode_srgb
from swifttailor.render.prints import Motif, Plaid

RED, BLUE = (0.8, 0.05, 0.05), (0.05, 0.05, 0.8)


def at(*points) -> np.ndarray:
    return np.array(points, np.float32)


def is_like(color: np.ndarray, expected) -> np.ndarray:
    return np.abs(color - np.asarray(expected)).max(axis=-1) < 1e-6


def test_stripes_have_their_widths_in_both_directions():
    stripes = Stripes(RED, BLUE, width=2.0, gap=3.0, grain=0.0)
    y = np.arange(0, 50, 0.01)
    for x in (0.0, 17.3):
        red = is_like(stripes.colors(at(*[(x, v) for v in y])), RED).mean()
        assert red == pytest.approx(0.4, abs=0.03)  # soft borders belong to neither
    assert is_like(stripes.colors(at((0, 0), (9, 5), (0, 2.5), (3, -2.5))), [RED, RED, BLUE, BLUE]).all()
    upright = Stripes(RED, BLUE, 2.0, 3.0, angle=90.0, grain=0.0)
    points = np.random.default_rng(1).uniform(-40, 40, (500, 2)).astype(np.float32)
    turned = np.stack([-points[:, 1], points[:, 0]], axis=1)
    np.testing.assert_allclose(upright.colors(turned), stripes.colors(points), atol=2e-3)


def test_checks_are_two_crossing_bands():
    checks = Checks(RED, BLUE, width=2.0, grain=0.0)
    middle = (np.array(RED) + BLUE) / 2
    found = checks.colors(at((0, 0), (2, 2), (0, 2), (2, 0), (4, -4)))
    assert is_like(found, [RED, BLUE, middle, middle, RED]).all()


def test_dots_sit_on_a_triangular_grid():
    dots = Dots(RED, BLUE, spacing=4.0, radius=1.0, grain=0.0)
    rise = 4.0 * np.sqrt(3) / 2
    centres = at((0, 0), (4, 0), (-8, 0), (2, rise), (-2, -rise), (0, 2 * rise))
    for offset in ((0, 0), (0.9, 0), (0, -0.9)):
        assert is_like(dots.colors(centres + at(offset)), BLUE).all()
    for offset in ((1.1, 0), (0, 1.1), (2, 0)):
        assert is_like(dots.colors(centres + at(offset)), RED).all()
    points = np.random.default_rng(2).uniform(-50, 50, (20_000, 2)).astype(np.float32)
    share = is_like(dots.colors(points), BLUE).mean()
    assert share == pytest.approx(np.pi / (4.0 * rise), abs=0.03)


@given(st.floats(0, 0.2), st.integers(0, 10**6))
def test_grain_is_even_on_the_whole_and_repeatable(grain, seed):
    points = np.random.default_rng(3).uniform(-30, 30, (4000, 2)).astype(np.float32)
    plain = Plain((0.4, 0.5, 0.6), grain, seed)
    found = plain.colors(points)
    assert found.dtype == np.float32 and (found == plain.colors(points)).all()
    assert np.abs(found / np.array([0.4, 0.5, 0.6], np.float32) - 1).max() <= grain + 1e-5
    assert np.abs(found.mean(axis=0, dtype=np.float64) / (0.4, 0.5, 0.6) - 1).max() < 0.2 * grain + 1e-5
    if grain > 0.05:
        assert (Plain((0.4, 0.5, 0.6), grain, seed + 1).colors(points) != found).any()


def test_prints_lie_on_the_right_side_where_they_were_put():
    """An upright sheet of 20 x 20 cm seen square on: a pixel shows the cloth under it."""
    plain = sheet((-10, -10, 0), (10, -10, 0), (10, 10, 0))
    corners = plain.vertices[plain.faces][:, :, :2]
    stripes = Stripes(RED, BLUE, 4.0, 4.0, grain=0.0)
    dark = np.array([0.02, 0.02, 0.02])
    surface = Surface(
        plain.vertices, plain.faces, np.ones(3), dark, print=stripes, print_at=corners + np.array([3, 4])
    )
    size = (40, 40)

    def seen(camera):
        return render_view([surface], camera, size, background=None, shadows=False, samples=1)[:, :, :3]

    picture = seen(Camera((0, 0, 0), 20.0)).astype(int)
    y = 10 - (np.arange(40) + 0.5) / 2 + 4  # of the cloth, at each row of pixels
    expected = stripes.colors(np.stack([np.zeros(40), y], axis=1).astype(np.float32))
    is_red = expected[:, 0] > 0.6
    clear = np.abs(expected[:, 0] - 0.425) > 0.35
    assert clear.sum() >= 36 and 14 < is_red.sum() < 26
    assert (picture[clear & is_red][:, :, 0] > 2 * picture[clear & is_red][:, :, 2]).all()
    assert (picture[clear & ~is_red][:, :, 2] > 2 * picture[clear & ~is_red][:, :, 0]).all()
    assert seen(Camera((0, 0, 0), 20.0, azimuth=180.0)).max() < 90, "the wrong side has no print"


def test_prints_in_perspective_follow_the_surface():
    """A sheet that runs away from the camera: the same point of it shows the same colour from everywhere."""
    plain = sheet((-40, -10, 20), (40, -10, 20), (40, -10, -200))
    coordinates = plain.vertices[plain.faces][:, :, [0, 2]]
    surface = Surface(
        plain.vertices, plain.faces, np.ones(3), np.ones(3) * 0.3, print=Checks(RED, BLUE, 20.0, grain=0.0),
        print_at=coordinates,
    )  # fmt: skip
    camera, size = Camera((0, 0, 0), 60, 0, 20, 60.0), (80, 60)
    picture = render_view([surface], camera, size, background=None, shadows=False, samples=1)
    light = Lighting()
    x, y = (a.ravel() + 0.5 for a in np.meshgrid(np.arange(80), np.arange(60)))
    origin, direction = camera.rays(x, y, size)
    along = (-10 - origin[:, 1]) / direction[:, 1]
    hit = (origin + along[:, None] * direction)[:, [0, 2]]
    color = Checks(RED, BLUE, 20.0, grain=0.0).colors(hit.astype(np.float32))
    ratio = (color[:, 0] / color[:, 2]).reshape(60, 80)
    shown = (picture[:, :, 3] == 255) & (along > 0).reshape(60, 80)
    red, blue = shown & (ratio > 3), shown & (ratio < 1 / 3)
    assert red.sum() > 100 and blue.sum() > 100 and light.key.wrap == 0.10
    assert (picture[red][:, 0] > picture[red][:, 2]).mean() > 0.99
    assert (picture[blue][:, 2] > picture[blue][:, 0]).mean() > 0.99


def test_a_print_needs_its_place_on_the_cloth():
    plain = sheet((-1, -1, 0), (1, -1, 0), (1, 1, 0))
    with pytest.raises(InputError, match=r"print_at of shape \(2, 3, 2\), got \(\)"):
        Surface(plain.vertices, plain.faces, np.ones(3), print=Plain(RED))
    with pytest.raises(InputError, match=r"got \(2, 3\)"):
        Surface(plain.vertices, plain.faces, np.ones(3), print=Plain(RED), print_at=np.zeros((2, 3)))


def test_light_comes_from_where_it_is_said_to():
    dark = (0.0, 0.0, 0.0)
    plain = sheet((-10, -10, 0), (10, -10, 0), (10, 10, 0), color=(0.5, 0.5, 0.5))

    def brightness(direction) -> int:
        only = Lighting(
            Light(direction, (1, 1, 1)), Light((1, 0, 0), dark), Light((1, 0, 0), dark), dark, dark
        )
        return int(render_view([plain], Camera((0, 0, 0), 20), (9, 9), lighting=only, shadows=False)[4, 4, 0])

    straight, slanting = brightness((0, 0, 1)), brightness((1, 0, 1))
    assert straight == encode_srgb(np.array(0.5)) and brightness((0, 0, -1)) == 0
    assert slanting == pytest.approx(int(encode_srgb(np.array(0.5 * np.sqrt(0.5)))), abs=1)


def test_a_backdrop_of_ones_own():
    picture = np.zeros((12, 9, 3))
    picture[:4, :, 0] = 1.0
    seen = render_view([], Camera(), (9, 12), background=picture)
    assert (seen[:4] == (255, 0, 0)).all() and (seen[4:] == 0).all()
    with pytest.raises(InputError, match=r"has the shape \(12, 9, 3\), got \(9, 12, 3\)"):
        render_view([], Camera(), (9, 12), background=np.zeros((9, 12, 3)))


def test_bands_and_dots_are_coloured_without_the_bank_of_motifs(monkeypatch):
    def made():
        raise AssertionError("the bank takes seconds to make")

    monkeypatch.setattr("swifttailor.render.motifs.bank", made)
    black, white = (0.0, 0.0, 0.0), (1.0, 1.0, 1.0)
    points = np.random.default_rng(4).uniform(-30.0, 30.0, (200, 2))
    for one in (
        Stripes(black, white, 2.0, 1.0),
        Checks(black, white, 2.0),
        Dots(black, white, 4.0, 1.0),
        Plaid(black, white, white, 6.0),
    ):
        assert np.ptp(one.colors(points)) > 0.5
    with pytest.raises(AssertionError, match="seconds"):
        Motif((black, white), 0).colors(points)


def test_bands_of_figures_lie_behind_all_that_lots_decide():
    """What training draws stays as it was; a band repeats across, and its rows differ."""
    from swifttailor.render.motifs import (
        BANDS,
        FIRST_GRAPHIC,
        FIRST_MOTIF,
        GRAPHIC_SIDE,
        GRAPHICS,
        SIDE,
        bank,
    )

    first = FIRST_MOTIF + BANDS * SIDE**2
    assert first == FIRST_GRAPHIC + GRAPHICS * GRAPHIC_SIDE**2 and len(bank()) == first + SIDE**2
    figures = bank()[first : first + SIDE**2].reshape(SIDE, SIDE)
    assert set(np.unique(figures)) == {0, 1, 2, 3}
    assert (figures[:, : SIDE // 2] == figures[:, SIDE // 2 :]).all()
    assert len(np.unique(figures, axis=0)) > 8


@pytest.mark.parametrize("angle", [0.0, 90.0])
def test_stripes_finer_than_pixels_fade_to_their_mean(angle):
    """They would beat against the pixels, and look like wood; wide ones stay as they are."""
    plain = sheet((-10, -10, 0), (10, -10, 0), (10, 10, 0))
    corners = plain.vertices[plain.faces][:, :, :2]
    spread = {}
    for width, gap in ((0.5, 0.7), (4.0, 4.0)):
        stripes = Stripes(RED, BLUE, width, gap, angle, grain=0.0)
        surface = Surface(plain.vertices, plain.faces, np.ones(3), print=stripes, print_at=corners)
        picture = render_view([surface], Camera((0, 0, 0), 20.0), (20, 20), background=None, shadows=False)
        inner = picture[2:-2, 2:-2, :3].astype(float)
        spread[width] = float(np.ptp(inner[..., 0] / inner.sum(axis=2)))
    assert spread[0.5] < 0.3 < 0.45 < spread[4.0]

"""The compiled renderer draws what the plain one draws."""

from __future__ import annotations

import numpy as np
import plain_renderer
import pytest
from scenes import ball, box, random_triangles, sheet

from swifttailor.body import Body
from swifttailor.body.mannequin import mannequin
from swifttailor.render import Camera, LineSet, Stripes, Surface
from swifttailor.render.color import encode_srgb
from swifttailor.render.rasterize import rasterize
from swifttailor.render.scene import Scene
from swifttailor.render.view import draw_figure

CAMERAS = {
    "orthographic": Camera((1, 0, 0), 34, 25, 20),
    "perspective": Camera((1, 0, 0), 34, 250, -20, 40.0),
}


def still_life() -> list[Surface]:
    """Closed and open surfaces, with lines, lift, sheen, gloss and a print, that shade each other."""
    corners = (-12, 4, 6), (12, 3, 7), (13, 12, 2)
    at = np.array([[[0, 0], [25, 0], [26, 10]], [[0, 0], [26, 10], [1, 10]]], float)
    edges = LineSet(np.array([[0, 1], [1, 2], [2, 3], [3, 0]]), strength=0.5, width=2.0)
    light = LineSet(np.array([[0, 1], [1, 3], [4, 6]]), strength=-0.6, width=1.5)
    printed = Stripes((0.8, 0.1, 0.1), (0.1, 0.1, 0.8), 2.0, 3.0)
    back = np.array([0.2, 0.3, 0.1])
    return [
        ball(9.0, sheen=0.2, gloss=0.1),
        box((8, -8, 3), 4.0, (0.2, 0.6, 0.3), gloss=0.3, lines=(light,)),
        sheet(*corners, back_color=back, lines=(edges,), lift=0.3, sheen=0.1, print=printed, print_at=at),
    ]


def assert_alike(surfaces: list[Surface], camera: Camera, size: tuple[int, int], **options) -> None:
    """Within one grey level everywhere but at about a pixel in a thousand."""
    scene = Scene(surfaces)
    drawn, expected = (
        np.concatenate([encode_srgb(light), np.round(coverage * 255)], axis=2).astype(int)
        for light, coverage in (
            draw(scene, camera, size, **options) for draw in (draw_figure, plain_renderer.draw_figure)
        )
    )
    assert 0.1 < (expected[:, :, 3] > 0).mean() < 1.0
    assert expected[:, :, :3].std() > 10
    assert (np.abs(drawn - expected).max(axis=2) > 1).mean() <= 0.0012


@pytest.mark.parametrize("camera", CAMERAS)
@pytest.mark.parametrize("samples", [1, 2, 3])
@pytest.mark.parametrize("shadows", [False, True])
def test_still_life(camera, samples, shadows):
    assert_alike(still_life(), CAMERAS[camera], (173, 140), samples=samples, shadows=shadows)


def test_a_body_of_many_small_triangles():
    vertices, faces = mannequin(Body.default())
    surface = Surface(vertices, faces, np.array([0.6, 0.5, 0.4]), gloss=0.02)
    assert_alike([surface], Camera((0, 85, 0), 190, 30, 5, 16.0), (220, 400))


@pytest.mark.parametrize("seed", range(4))
def test_same_triangles_at_every_pixel(seed):
    size = 211, 167
    corners = random_triangles(3000, size, seed)
    differ = rasterize(corners, size) != plain_renderer.rasterize(corners, size)
    assert differ.mean() < 1e-4  # equal depths, to the last bit, may be rounded either way

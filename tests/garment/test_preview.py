from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from swifttailor.body import Body
from swifttailor.garment.cloth_surfaces import border_edges, cloth_surface
from swifttailor.garment.garment import Garment
from swifttailor.garment.preview import body_surface, render_preview
from swifttailor.panel_mesh.pattern_mesh import PatternMesh, Seam
from swifttailor.pattern import Edge, EdgeRef, Panel, Pattern, Stitch
from swifttailor.render.framing import frame_views


def sleeve_around(center: tuple[float, float, float], radius: float, length: float) -> Garment:
    """One rectangle stitched to itself: an upright tube around a point of the world, seam in the back."""
    n, m = 24, 12
    u, v = np.meshgrid(np.linspace(0, 1, n + 1), np.linspace(0, 1, m + 1))
    width = 2 * np.pi * radius
    loop = np.array([[0.0, 0], [width, 0], [width, length], [0, length]])
    pattern = Pattern(
        (Panel("tube", loop, (Edge(),) * 4),), (Stitch(EdgeRef("tube", 1), EdgeRef("tube", 3)),)
    )
    index = np.arange((n + 1) * (m + 1)).reshape(m + 1, n + 1)
    a, b, c, d = (q.ravel() for q in (index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]))
    faces = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)]).astype(np.int32)
    weld = np.arange(m + 1)[:, None] * n + np.arange(n + 1)[None] % n
    flat = np.stack([u.ravel() * width, v.ravel() * length], axis=1)
    mesh = PatternMesh(
        pattern,
        flat,
        np.zeros(len(flat), np.int32),
        faces,
        weld.ravel().astype(np.int32),
        (Seam(0, weld[:, 0].astype(np.int32)),),
        (tuple(index[0]), tuple(index[:, -1]), tuple(index[-1, ::-1]), tuple(index[::-1, 0])),
    )
    angle = 2 * np.pi * (np.arange(n) / n) + np.pi
    ring = np.stack([np.sin(angle), np.zeros(n), np.cos(angle)], axis=1) * radius
    rings = ring[None] + np.array(center) + np.linspace(0, length, m + 1)[:, None, None] * [0, 1, 0]
    return Garment(mesh, rings.reshape(-1, 3))


@pytest.fixture(scope="module")
def body() -> Body:
    return Body.default()


def is_cloth(picture, low: float = 60) -> np.ndarray:
    """Where an orange-red cloth is seen on the grey body and backdrop."""
    pixels = np.asarray(picture).astype(int)
    return pixels[:, :, 0] - pixels[:, :, 2] > low


SIZE = (450, 270)
RED = "#c03020"


def test_three_views_show_the_garment_on_its_side(body):
    """A ring hung beside the wearer's left hip: right of the body in front, left of it from the back."""
    garment = sleeve_around((40.0, 60, 0), 6, 30)
    assert border_edges(garment.faces).shape == (48, 2)
    picture = render_preview(garment, body, size=SIZE, color=RED)
    assert picture.size == SIZE and picture.mode == "RGB"
    cloth = is_cloth(picture)
    views = frame_views(garment.vertices, body.vertices, SIZE)
    for view, sign in zip(views, (1, -1, 0), strict=True):
        part = cloth[:, view.first : view.first + view.width]
        columns = np.nonzero(part)[1]
        assert len(columns) > 60
        off_center = columns.mean() / view.width - 0.5
        assert abs(off_center) < 0.1 if sign == 0 else sign * off_center > 0.15


@pytest.mark.parametrize(("low", "length", "shows_feet"), [(110, 35, False), (10, 125, True), (35, 60, True)])
def test_framing(body, low, length, shows_feet):
    garment = sleeve_around((0.0, low, 0), 25, length)
    picture = np.asarray(render_preview(garment, body, size=SIZE, color=RED)).astype(int)
    cloth = is_cloth(picture)
    assert not cloth[:3].any() and not cloth[-2:].any(), "the garment is whole"
    rows = np.flatnonzero(cloth.any(axis=1))
    assert np.ptp(rows) > 0.25 * SIZE[1], "and large"
    last = picture[-1]
    body_at_the_border = np.abs(np.diff(last.sum(axis=1))).max() > 40
    assert body_at_the_border != shows_feet


def test_preview_without_a_body_and_with_other_colours(body):
    garment = sleeve_around((0.0, 70, 0), 22, 60)
    picture = np.asarray(render_preview(garment, None, size=SIZE, color="#208040", background="#101030"))
    assert picture[0, 0].max() < 60
    green = picture[:, :, 1].astype(int) - picture[:, :, 0] > 20
    assert 0.1 < green.mean() < 0.9


def test_preview_is_deterministic(body):
    garment = sleeve_around((0.0, 70, 0), 22, 60)
    one, two = (render_preview(garment, body, size=SIZE).tobytes() for _ in range(2))
    assert one == two


def test_very_small_and_very_large_garments(body):
    for garment in (sleeve_around((0.0, 140, 0), 0.05, 0.1), sleeve_around((0.0, -300, 0), 400, 500)):
        assert render_preview(garment, body, size=SIZE).size == SIZE


def test_seams_and_hems_become_lines():
    garment = sleeve_around((0.0, 70, 0), 22, 60)
    seams, hems = cloth_surface(garment).lines
    assert len(seams.edges) == 12 and len(hems.edges) == 48
    assert cloth_surface(garment, lines=False).lines == ()
    assert cloth_surface(garment, tint_panels=False).color.shape == (720 - 144, 3)


def test_body_is_a_closed_surface(body):
    surface = body_surface(body)
    assert surface.back_color is None and not len(border_edges(surface.faces))
    assert np.abs(np.ptp(surface.vertices, axis=0) - np.ptp(body.vertices, axis=0)).max() < 4.0


def test_silk_shines_more_than_cotton_and_satin_and_metals_more_than_silk():
    tube = sleeve_around((0.0, 100.0, 0.0), 10.0, 30.0)

    def shine(cloth: str | None, color: str = RED) -> float:
        seen = cloth_surface(replace(tube, cloth=cloth, color=color))
        return seen.sheen + seen.gloss

    assert shine("cotton") < shine("silk") < shine("satin") < shine(None, "#c9a227")
    assert shine("cotton", "#c9a227") == shine("cotton")

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scenes import ball, box, ray_trace, sheet

from swifttailor.errors import InputError
from swifttailor.render import Camera, LineSet, Surface, render_view, to_linear
from swifttailor.render.color import encode_srgb

CAMERA = Camera((0, 0, 0), 30)


def picture(*surfaces, camera=CAMERA, size=(60, 60), **options) -> np.ndarray:
    return render_view(surfaces, camera, size, **options).astype(int)


@pytest.mark.parametrize(
    "camera",
    [
        Camera((1, 0, 0), 26, 20, 15),
        Camera((1, 0, 0), 26, 250, -30, 50.0),
        Camera((0, 3, 0), 44, 0, 80, 90.0),
    ],
)
@pytest.mark.parametrize("open_surface", [False, True])
def test_same_as_ray_tracing(camera, open_surface):
    surface = ball(count=10, sheen=0.2, gloss=0.1)
    if open_surface:
        keep = surface.vertices[surface.faces].mean(axis=1)[:, 0] < 5
        surface = Surface(
            surface.vertices,
            surface.faces[keep],
            surface.color,
            np.array([0.1, 0.4, 0.1]),
            sheen=0.2,
            gloss=0.1,
        )
    size = (40, 36)
    light, seen = ray_trace(surface, camera, size)
    got = render_view([surface], camera, size, background=None, shadows=False, samples=1).astype(int)
    alike = (got[:, :, 3] == 255) == (seen >= 0)
    assert alike.mean() > 0.998
    difference = np.abs(got[:, :, :3] - encode_srgb(light)).max(axis=2)[alike & (seen >= 0)]
    # A pixel on a border between two triangles may go either way; smooth normals keep even those close.
    assert (difference <= 1).mean() > 0.98


def test_large_triangles_in_strong_perspective():
    """Two crossing tents, far from affine in the picture: their line of crossing and their smooth normals."""
    tent = np.array(
        [[-30.0, -6, 10], [30, -6, 10], [-30, 7, -4], [30, 9, -40], [-30, -6, -90], [30, -6, -90]]
    )
    faces = np.array([[0, 1, 2], [1, 3, 2], [2, 3, 4], [3, 5, 4]])
    points = np.concatenate([tent, tent * (1, -1, 1) + (0, 3, -5)])
    colors = np.repeat([[0.8, 0.1, 0.1], [0.1, 0.1, 0.8]], 4, axis=0)
    surface = Surface(points, np.concatenate([faces, faces + 6]), colors, np.full(3, 0.4))
    camera = Camera((0, 0, 0), 30, 5, 3, 70.0)
    light, seen = ray_trace(surface, camera, (60, 48))
    got = render_view([surface], camera, (60, 48), background=None, shadows=False, samples=1).astype(int)
    assert len(np.unique(seen)) >= 5 and (seen >= 0).mean() > 0.4
    alike = (got[:, :, 3] == 255) == (seen >= 0)
    assert alike.mean() > 0.998
    difference = np.abs(got[:, :, :3] - encode_srgb(light)).max(axis=2)[alike & (seen >= 0)]
    assert (difference <= 1).mean() > 0.985


def test_surfaces_cross_where_they_do_in_perspective():
    """A ramp that runs far away cuts a wall; depth that were affine would move the cut."""
    points = np.array(
        [
            *([-30.0, -8, 10], [30, -8, 10], [30, 10, -90], [-30, 10, -90]),
            *([-30.0, -30, -15], [30, -30, -15], [30, 30, -15], [-30, 30, -15]),
        ]
    )
    faces = np.array([[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]])
    colors = np.repeat([[0.9, 0.0, 0.0], [0.0, 0.0, 0.9]], 2, axis=0)
    surface = Surface(points, faces, colors, np.full(3, 0.4))
    camera = Camera((0, 0, 0), 30, field_of_view=70.0)
    _, seen = ray_trace(surface, camera, (40, 80))
    got = render_view([surface], camera, (40, 80), background=None, shadows=False, samples=1).astype(int)
    red = got[:, :, 0] > got[:, :, 2]
    covered = (got[:, :, 3] == 255) & (seen >= 0)
    assert covered.mean() > 0.95 and 0.2 < red.mean() < 0.8
    assert (red == (seen < 2))[covered].mean() > 0.99


def test_wearers_left_is_on_the_right_of_the_front_view():
    red, green = box((8, 0, 0), 3, (0.8, 0.02, 0.02)), box((-8, 0, 0), 3, (0.02, 0.8, 0.02))
    for azimuth, sign in ((0, 1), (180, -1)):
        seen = picture(red, green, camera=Camera((0, 0, 0), 30, azimuth))
        is_red = (seen[:, :, 0] > 2 * seen[:, :, 1]) & (seen[:, :, 0] > 60)
        assert is_red.sum() > 50
        columns = np.nonzero(is_red)[1]
        assert np.sign(columns.mean() - 30) == sign


def test_nearer_hides_farther_whatever_the_order():
    near, far = box((0, 0, 8), 3, (0.9, 0, 0)), box((0, 0, -8), 6, (0, 0, 0.9))
    for field_of_view in (0.0, 40.0):
        camera = Camera((0, 0, 0), 30, field_of_view=field_of_view)
        one = picture(near, far, camera=camera, background=None, shadows=False)
        two = picture(far, near, camera=camera, background=None, shadows=False)
        np.testing.assert_array_equal(one, two)
        assert one[30, 30, 0] > 3 * one[30, 30, 2]


def test_inside_of_cloth_is_drawn_in_its_own_colour():
    front = sheet(
        (-8, -8, 0), (8, -8, 0), (8, 8, 0), (0.8, 0.02, 0.02), back_color=np.array([0.02, 0.02, 0.8])
    )
    outside = picture(front)[30, 30]
    inside = picture(front, camera=Camera((0, 0, 0), 30, 180))[30, 30]
    assert outside[0] > 3 * outside[2] and inside[2] > 3 * inside[0]


def test_inside_of_closed_surfaces_is_not_drawn():
    single = sheet((-8, -8, 0), (8, -8, 0), (8, 8, 0))
    assert picture(single, background=None)[30, 30, 3] == 255
    assert picture(single, camera=Camera((0, 0, 0), 30, 180), background=None)[:, :, 3].max() == 0


def test_edges_are_smoothed():
    coverage = picture(ball(), background=None, size=(50, 50))[:, :, 3]
    assert {0, 255} < set(np.unique(coverage)) <= {0, 64, 128, 191, 255}
    area = coverage.sum() / 255 * (30 / 50) ** 2
    assert area == pytest.approx(np.pi * 100, rel=0.02)


def test_key_light_casts_a_shadow():
    table = sheet((-14, 0, 14), (14, 0, 14), (14, 0, -14), (0.6, 0.6, 0.6), back_color=np.full(3, 0.6))
    camera = Camera((0, 0, 0), 34, elevation=40)
    free, shaded = (
        picture(table, *hat, camera=camera, floor=False) for hat in ((), (ball(3.0, (0, 7.0, 0)),))
    )
    assert free[40:58, 20:50].min() > 90
    change = free.sum(axis=2) - shaded.sum(axis=2)
    ball_pixels = picture(ball(3.0, (0, 7.0, 0)), camera=camera, background=None)[:, :, 3] > 0
    on_table = np.where(ball_pixels, 0, change)
    rows, columns = np.nonzero(on_table > 60)
    assert len(rows) > 30
    assert columns.mean() > 30  # the light stands to the left
    lit = picture(table, ball(3.0, (0, 7.0, 0)), camera=camera, shadows=False, floor=False)
    assert np.abs(np.where(ball_pixels[:, :, None], 0, lit - free)).max() < 120


def test_a_lone_convex_body_does_not_shade_itself():
    lit, plain = (picture(ball(count=24), shadows=s, background=None, size=(120, 120)) for s in (True, False))
    towards_light = np.s_[40:60, 35:60]
    assert np.abs(lit[towards_light] - plain[towards_light]).max() <= 6


def test_folds_are_darkened():
    """The bottom of a narrow groove gets less light than a flat sheet."""
    profile = np.array([[-14.0, 0], [-1.2, 0], [-1.0, -4], [1.0, -4], [1.2, 0], [14, 0]])
    points = np.array([[x, y, z] for x, z in profile for y in (-14, 14)])
    quads = [(2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1) for k in range(5)]
    faces = np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])
    groove = Surface(points, faces, np.full(3, 0.6), np.full(3, 0.6))
    with_shadows, without = (picture(groove, size=(120, 120), shadows=s) for s in (True, False))
    assert with_shadows[60, 60].sum() < 0.8 * without[60, 60].sum()
    assert np.abs(with_shadows[60, 15:30] - without[60, 15:30]).max() < 12


def test_floor_is_darkened_where_something_stands():
    camera = Camera((0, 10, 0), 40, elevation=15, field_of_view=20)
    standing = box((0, 5.001, 0), 5)
    bright = picture(standing, camera=camera, floor=False, size=(100, 80))
    dark = picture(standing, camera=camera, size=(100, 80))
    change = (bright - dark).sum(axis=2)
    assert change.min() >= 0 and change.max() > 40
    assert change[:20].max() == 0  # the wall has none
    hanging = picture(box((0, 200.0, 0), 5), camera=camera, size=(100, 80))
    assert (bright.sum(axis=2) - hanging.sum(axis=2))[60:, :10].max() < 25


def test_lines_are_seen_only_from_their_side():
    cloth = sheet((-8, -8, 0), (8, -8, 0), (8, 8, 0), (0.7, 0.7, 0.7), back_color=np.full(3, 0.7))
    line = LineSet(np.array([[0, 2]]), strength=0.8, width=2.0)
    lined = Surface(cloth.vertices, cloth.faces, cloth.color, cloth.back_color, (line,))
    plain, drawn = picture(cloth), picture(lined)
    dark = (plain - drawn).sum(axis=2) > 60
    assert 30 < dark.sum() < 200
    rows, columns = np.nonzero(dark)
    assert np.abs((59 - rows) - columns).max() <= 3  # from the lower left to the upper right
    behind_box = box((0, 0, 9), 9)
    np.testing.assert_array_equal(picture(lined, behind_box), picture(cloth, behind_box))


def linear(pixels: np.ndarray) -> np.ndarray:
    """Light of sRGB from 0 to 255."""
    share = pixels / 255.0
    return np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)


@pytest.mark.parametrize("strength", [-1.3, -0.4, -0.01, 0.01, 0.4, 1.0])
def test_a_line_darkens_by_its_strength_and_lightens_below_0(strength):
    cloth = sheet((-8, -8, 0), (8, -8, 0), (8, 8, 0), (0.1, 0.1, 0.1), back_color=np.full(3, 0.1))
    line = LineSet(np.array([[0, 2]]), strength=strength, width=3.0)
    plain, drawn = (linear(picture(replace(cloth, lines=lines))) for lines in ((), (line,)))
    change = drawn - plain
    assert (np.sign(change[np.abs(change) > 1e-3]) == -np.sign(strength)).all()
    rows, columns = np.nonzero(np.abs(change).sum(axis=2) > 1e-3)
    assert np.abs((59 - rows) - columns).max(initial=0) <= 4
    share = (drawn[30, 29:31] / plain[30, 29:31]).mean()
    assert share == pytest.approx(1 - strength, abs=0.12)


def test_lift_brings_cloth_before_what_pokes_through():
    skin = sheet((-8, -8, 0.2), (8, -8, 0.2), (8, 8, 0.2), (0.8, 0.02, 0.02), back_color=np.zeros(3))
    cloth = sheet((-8, -8, 0), (8, -8, 0), (8, 8, 0), (0.02, 0.02, 0.8), back_color=np.zeros(3), lift=0.5)
    for field_of_view in (0.0, 30.0):
        seen = picture(skin, cloth, camera=Camera((0, 0, 0), 30, field_of_view=field_of_view))[30, 30]
        assert seen[2] > 3 * seen[0]


def test_what_is_behind_a_perspective_camera_is_left_out():
    camera = Camera((0, 0, 0), 30, field_of_view=60)
    around = box((0, 0, camera.distance), 8)
    assert picture(around, camera=camera, background=None)[:, :, 3].max() == 0


@pytest.mark.parametrize("surfaces", [(), (Surface(np.zeros((0, 3)), np.zeros((0, 3), int), np.ones(3)),)])
def test_nothing_is_just_the_backdrop(surfaces):
    seen = render_view(surfaces, Camera(elevation=5), (30, 20), background="#808080")
    assert seen.shape == (20, 30, 3) and seen.dtype == np.uint8
    assert 90 < seen.min() and seen.max() <= 128
    assert render_view(surfaces, Camera(), (30, 20), background=None)[:, :, 3].max() == 0


def test_degenerate_faces_and_loose_vertices_are_harmless():
    good = ball()
    points = np.concatenate([good.vertices, [[0.0, 50, 0], [0, 0, 0]]])
    n = len(points)
    bad = np.array([[0, 0, 0], [0, 1, 1], [n - 2, n - 2, n - 1]])
    faces = np.concatenate([good.faces, bad])
    np.testing.assert_array_equal(
        picture(good, background=None, shadows=False),
        picture(Surface(points, faces, good.color), background=None, shadows=False),
    )


def test_pictures_are_deterministic():
    np.testing.assert_array_equal(picture(ball(), box((5, 5, 5), 4)), picture(ball(), box((5, 5, 5), 4)))


@pytest.mark.parametrize("size", [(0, 5), (5, -1), (100_000, 100_000)])
def test_impossible_sizes_are_refused(size):
    with pytest.raises(InputError, match="picture"):
        render_view([], CAMERA, size)


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (([[0.0, 0, np.nan]] * 3, [[0, 1, 2]], np.ones(3)), "3 of 3 are NaN"),
        (([[0.0, 0]] * 3, [[0, 1, 2]], np.ones(3)), r"\(n, 3\)"),
        (([[0.0, 0, 0]] * 3, [[0, 1, 3]], np.ones(3)), "0 to 2"),
        (([[0.0, 0, 0]] * 3, [[0.0, 1, 2]], np.ones(3)), "integers"),
        (([[0.0, 0, 0]] * 3, [[0, 1, 2]], np.ones(4)), "color"),
        (([[0.0, 0, 0]] * 3, [[0, 1, 2]], np.ones(3), None, (LineSet(np.array([[0, 7]])),)), "Lines"),
    ],
)
def test_broken_surfaces_are_refused(arguments, reason):
    vertices, faces, *rest = arguments
    with pytest.raises(InputError, match=reason):
        Surface(np.array(vertices), np.array(faces), *rest)


def test_colours():
    np.testing.assert_allclose(to_linear("#ffffff"), 1.0)
    np.testing.assert_allclose(to_linear((0.5, 0.5, 0.5)), 0.21404, atol=1e-5)
    levels = np.arange(256)
    linear = np.array([to_linear((v / 255,) * 3)[0] for v in levels])
    assert np.abs(encode_srgb(linear).astype(int) - levels).max() <= 1
    assert encode_srgb(np.array([-1.0, 2.0])).tolist() == [0, 255]
    for bad in ("blue", "#12", "#gggggg", (1, 2, 3), (0.1, 0.2), (np.nan,) * 3):
        with pytest.raises(InputError, match="colour"):
            to_linear(bad)

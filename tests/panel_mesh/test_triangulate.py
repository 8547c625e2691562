import numpy as np
import pytest
import shapely
from filled_polygons import areas, assert_fills, delaunay
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from swifttailor.errors import GeometryError
from swifttailor.panel_mesh.constrained_edges import interior_triangles, recover_edges
from swifttailor.panel_mesh.smoothing import smooth, triangle_quality
from swifttailor.panel_mesh.triangulate import triangulate_polygon, triangulate_polygons


def resample(corners, step):
    pieces = []
    for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        count = max(1, int(np.ceil(np.linalg.norm(b - a) / step)))
        pieces.append(a + (b - a) * (np.arange(count) / count)[:, None])
    return np.concatenate(pieces)


@pytest.mark.parametrize("edge_length", [0.7, 2.0, 5.0])
@pytest.mark.parametrize(
    "corners",
    [
        [[0, 0], [20, 0], [20, 30], [0, 30]],
        [[0, 0], [0, 30], [20, 30], [20, 0]],  # clockwise
        [[0, 0], [30, 0], [30, 30], [16, 30], [15, 2], [14, 30], [0, 30]],  # a deep dart
        [[0, 0], [40, 0], [40, 0.01], [0, 0.01]],  # a sliver cuff
        [[0, 0], [10, 0], [10.001, 0.001], [10, 12], [0, 12]],  # a split vertex next to a corner
        [[0, 0], [9, 1], [18, 0], [17, 9], [18, 18], [9, 17], [0, 18], [1, 9]],
    ],
)
def test_fills_the_polygon_exactly(corners, edge_length):
    boundary = resample(np.array(corners, float), edge_length)
    points, faces = triangulate_polygon(boundary, edge_length)
    assert_fills(boundary, points, faces)


@given(
    radii=st.lists(st.floats(3.0, 30.0), min_size=3, max_size=16),
    edge_length=st.floats(0.8, 6.0),
    clockwise=st.booleans(),
)
@settings(max_examples=60, deadline=None)
def test_fills_any_star_shaped_polygon(radii, edge_length, clockwise):
    angles = np.linspace(0, 2 * np.pi, len(radii), endpoint=False)
    corners = np.array(radii)[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    boundary = resample(corners[::-1] if clockwise else corners, edge_length)
    points, faces = triangulate_polygon(boundary, edge_length)
    assert_fills(boundary, points, faces)


def test_inner_triangles_are_well_shaped():
    boundary = resample(np.array([[0.0, 0], [40, 0], [40, 40], [0, 40]]), 2.0)
    points, faces = triangulate_polygon(boundary, 2.0)
    corners = points[faces]
    sides = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)
    quality = 4 * np.sqrt(3) * areas(points, faces) / (sides**2).sum(axis=1)
    assert np.percentile(quality, 5) > 0.8 and quality.min() > 0.5
    assert 1.6 < np.median(sides) < 2.4


def test_refuses_a_boundary_that_crosses_itself():
    with pytest.raises(GeometryError, match="crosses or touches itself"):
        triangulate_polygon(np.array([[0.0, 0], [10, 10], [10, 0], [0, 10], [-5, 5]]), 2.0)
    with pytest.raises(GeometryError, match="3 points"):
        triangulate_polygon(np.array([[0.0, 0], [10, 10]]), 2.0)


def test_refuses_a_thin_strip_across_a_wide_box():
    """Little cloth, and a box around it of which a fine lattice would take gigabytes."""
    strip = np.array([[0.0, 0.0], [1.0, 0.0], [2000.0, 2000.0], [1999.0, 2000.0]])
    with pytest.raises(GeometryError, match=r"2000 x 2000 cm; at an edge length of 0\.05 cm"):
        triangulate_polygon(strip, 0.05)
    points, faces = triangulate_polygon(strip, 2.0)
    assert len(points) >= 4 and len(faces) >= 2


def test_recovers_an_edge_that_delaunay_leaves_out():
    points = np.array([[0.0, 0], [10, 0], [5, 1], [5, -1], [2.5, 0.8], [7.5, -0.8]])
    faces, neighbors = delaunay(points)
    following = np.array([1, 2, 0, -1, -1, -1])
    before = {tuple(sorted((f[k], f[(k + 1) % 3]))) for f in faces for k in range(3)}
    assert (0, 1) not in before
    recovered, across = recover_edges(points, faces, neighbors, following)
    after = {tuple(sorted((int(f[k]), int(f[(k + 1) % 3])))) for f in recovered for k in range(3)}
    assert {(0, 1), (1, 2), (0, 2)} <= after
    assert np.isclose(areas(points, recovered).sum(), areas(points, faces).sum())
    assert (areas(points, recovered) > 0).all()
    for face, others in zip(recovered.tolist(), across.tolist(), strict=True):
        for k, other in enumerate(others):
            shared = {face[(k + 1) % 3], face[(k + 2) % 3]}
            holders = [t for t, f in enumerate(recovered.tolist()) if shared <= set(f) and f != face]
            assert holders == ([other] if other >= 0 else [])


def flooded(faces, following):
    """Plain reference of `interior_triangles`."""
    left = {(f[k], f[(k + 1) % 3]): t for t, f in enumerate(faces.tolist()) for k in range(3)}
    wall = {(a, b) for a, b in enumerate(following.tolist()) if b >= 0}
    reached, stack = set(), [left[edge] for edge in wall]
    while stack:
        t = stack.pop()
        if t not in reached:
            reached.add(t)
            a, b, c = faces[t].tolist()
            edges = [e for e in ((a, b), (b, c), (c, a)) if e not in wall and e[::-1] not in wall]
            stack += [left[b, a] for a, b in edges if (b, a) in left]
    return [t in reached for t in range(len(faces))]


@given(seed=st.integers(0, 2**32 - 1), count=st.integers(4, 30))
@settings(max_examples=40, deadline=None)
def test_interior_is_what_lies_left_of_the_boundary(seed, count):
    rng = np.random.default_rng(seed)
    angles = np.sort(rng.uniform(0, 2 * np.pi, count))
    ring = (1 + rng.uniform(0, 3, count))[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    points = np.concatenate([ring, rng.uniform(-0.5, 0.5, (10, 2))])
    following = np.append((np.arange(count) + 1) % count, np.full(10, -1))
    if shapely.LinearRing(ring).is_simple and np.diff(angles, append=angles[0] + 2 * np.pi).max() < np.pi:
        faces, neighbors = recover_edges(points, *delaunay(points), following)
        inside = interior_triangles(points, faces, neighbors, following)
        assert inside.tolist() == flooded(faces, following)
        assert np.isclose(areas(points, faces[inside]).sum(), shapely.Polygon(ring).area)


@given(seed=st.integers(0, 2**32 - 1), edge_length=st.sampled_from([1.0, 2.0, 3.0, 8.0]))
@settings(max_examples=100, deadline=None)
def test_slits_whose_pieces_end_on_one_line_stay_open(seed, edge_length):
    """A skirt with godets: the hems of its pieces are on one line, and between them there is no cloth."""
    rng = np.random.default_rng(seed)
    piece, gap, lean, tilt = (
        rng.uniform(0.5, 6),
        rng.uniform(1, 15),
        rng.uniform(-8, 8),
        rng.uniform(-0.5, 0.5),
    )
    corners = [[0.0, 0.0]]
    for k in range(rng.integers(1, 7)):
        left = (piece + gap) * k + piece
        corners += [[left, 0], [left + gap / 2 + lean, 30], [left + gap, 0]]
    width = corners[-1][0] + piece
    corners += [[width, 0], [width + 8, 60], [-8, 60]]
    turn = np.array([[np.cos(tilt), -np.sin(tilt)], [np.sin(tilt), np.cos(tilt)]])
    ring = resample(np.array(corners) @ turn.T, edge_length)
    assume(shapely.Polygon(ring).is_valid)
    points, faces = triangulate_polygon(ring, edge_length)
    assert np.isclose(areas(points, faces).sum(), shapely.Polygon(ring).area, rtol=1e-9)
    assert (areas(points, faces) > 0).all()
    start, end = faces.ravel().tolist(), faces[:, [1, 2, 0]].ravel().tolist()
    around = range(len(ring))
    assert {(k, (k + 1) % len(ring)) for k in around} <= set(zip(start, end, strict=True))


def test_polygons_together_are_as_each_alone():
    shapes = [
        resample(np.array([[0.0, 0], [20, 0], [20, 30], [0, 30]]), 2.0),
        resample(np.array([[0.0, 0], [0, 9], [30, 9], [30, 0]]), 2.0),  # clockwise
        resample(np.array([[0.0, 0], [40, 0], [40, 0.01], [0, 0.01]]), 2.0),
        resample(np.array([[0.0, 0], [30, 0], [30, 30], [16, 30], [15, 2], [14, 30], [0, 30]]), 2.0)[7:],
    ]
    points, faces, starts = triangulate_polygons(shapes, 2.0, ["a", "b", "c", "d"])
    assert starts[0] == 0 and starts[-1] == len(points)
    for shape, first, last in zip(shapes, starts[:-1], starts[1:], strict=True):
        alone, triangles = triangulate_polygon(shape, 2.0)
        own = faces[(faces[:, 0] >= first) & (faces[:, 0] < last)]
        assert np.array_equal(own - first, triangles)
        # Sums over one big sparse matrix and over a small one may round differently.
        assert np.allclose(points[first:last], alone, rtol=0, atol=1e-12)
    with pytest.raises(GeometryError, match="Panel 'crossed'"):
        triangulate_polygons([shapes[0], np.array([[0.0, 0], [9, 9], [9, 0], [0, 9]])], 2.0, ["a", "crossed"])


def test_smoothing_evens_out_but_never_turns_a_triangle_over():
    rng = np.random.default_rng(3)
    ring = resample(np.array([[0.0, 0], [20, 0], [20, 4], [4, 4], [4, 20], [0, 20]]), 1.0)
    points, faces = triangulate_polygon(ring, 1.0)
    fixed = np.arange(len(points)) < len(ring)
    shaken = points.copy()
    for k in np.flatnonzero(~fixed):  # as wild a start as the triangles allow
        trial = shaken.copy()
        trial[k] += rng.normal(0, 0.5, 2)
        if (areas(trial, faces) > 1e-3).all():
            shaken = trial
    smoothed = smooth(shaken, faces, fixed)
    assert np.array_equal(smoothed[fixed], shaken[fixed])
    before, after = triangle_quality(shaken, faces), triangle_quality(smoothed, faces)
    assert (after >= np.minimum(before, 0.35) - 1e-12).all()
    assert after.mean() > before.mean() + 0.1

    # The mean of its neighbours would carry this point out of the notch: it has to stay.
    notch = np.array([[0.0, 0], [10, 0], [10, 10], [9.9, 0.2], [-20, 0.2], [5, 0.1]])
    fan = np.array([[0, 1, 5], [1, 3, 5], [3, 4, 5], [4, 0, 5]])
    assert (areas(notch, fan) > 0).all()
    assert (areas(smooth(notch, fan, np.arange(6) < 5), fan) > 0).all()


def test_quality_of_known_triangles():
    points = np.array([[0.0, 0], [1, 0], [0.5, np.sqrt(0.75)], [2, 0]])
    quality = triangle_quality(points, np.array([[0, 1, 2], [0, 2, 1], [0, 1, 3]]))
    assert np.allclose(quality, [1, -1, 0])

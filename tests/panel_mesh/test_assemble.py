from collections import Counter

import numpy as np
import pytest

from swifttailor.errors import InputError, PatternError
from swifttailor.panel_mesh import assemble, mesh_pattern
from swifttailor.panel_mesh.edge_sampling import edge_segments
from swifttailor.panel_mesh.topology import topology
from swifttailor.pattern import (
    Edge,
    EdgeRef,
    Panel,
    Pattern,
    Placement,
    Stitch,
    read_specification,
)
from swifttailor.pattern.drafts import draft, list_drafts


def square(name, size=20.0, z=0.0, height=None):
    height = size if height is None else height
    vertices = [[0, 0], [size, 0], [size, height], [0, height]]
    return Panel(name, np.array(vertices), (Edge(),) * 4, Placement((0.0, 0.0, z)))


def assert_sound(mesh):
    """Welding is consistent: seams closed, surface edge-manifold, areas kept, nothing dropped."""
    pattern = mesh.pattern
    measured = topology(mesh.faces, mesh.vertex_count)
    assert measured.nonmanifold_edges == 0
    assert measured.components == len(pattern.components())
    folds = [seam for seam in mesh.seams if pattern.stitches[seam.stitch].right_wrong]
    assert measured.inconsistent_edges == sum(len(seam.vertices) - 1 for seam in folds)
    faces = mesh.faces
    assert (faces != np.roll(faces, 1, axis=1)).all()
    corners = mesh.flat_vertices[mesh.flat_faces]
    u, w = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    area = (u[:, 0] * w[:, 1] - u[:, 1] * w[:, 0]) / 2
    for k, panel in enumerate(pattern.panels):
        own = area[mesh.face_panel == k]
        assert np.isclose(own.sum(), panel.signed_area(), rtol=0.02, atol=1.0)
        assert (own * np.sign(panel.signed_area()) > 0).all()
    assert (np.diff(mesh.flat_panel) >= 0).all()
    for stitch in pattern.stitches:
        first, second = (
            mesh.weld[mesh.edge_vertices[pattern.panel_index(r.panel)][r.edge]] for r in stitch.sides
        )
        assert np.array_equal(first, second if stitch.right_wrong else second[::-1])


def test_a_tube_of_two_panels_is_an_annulus():
    back = square("back", z=-10.0).mirrored()
    pattern = Pattern(
        (square("front"), back),
        (Stitch(EdgeRef("front", 1), EdgeRef("back", 3)), Stitch(EdgeRef("front", 3), EdgeRef("back", 1))),
    )
    mesh = mesh_pattern(pattern, 2.0)
    assert_sound(mesh)
    measured = topology(mesh.faces, mesh.vertex_count)
    assert (measured.boundary_loops, measured.euler_characteristic) == (2, 0)


def test_a_gather_samples_both_sides_alike():
    pattern = Pattern(
        (square("band", 20.0, height=4.0), square("skirt", 50.0)),
        (Stitch(EdgeRef("band", 0), EdgeRef("skirt", 2)),),
    )
    counts = edge_segments(pattern, 2.0)
    assert counts[EdgeRef("band", 0)] == counts[EdgeRef("skirt", 2)] == 25
    assert_sound(mesh_pattern(pattern, 2.0))


def test_a_dart_closes_into_a_cone():
    vertices = np.array([[0, 0], [9, 0], [10, 12], [11, 0], [20, 0], [20, 20], [0, 20]], float)
    panel = Panel("front", vertices, (Edge(),) * 7)
    pattern = Pattern((panel,), (Stitch(EdgeRef("front", 1), EdgeRef("front", 2)),))
    mesh = mesh_pattern(pattern, 2.0)
    assert_sound(mesh)
    run = mesh.edge_vertices[0][1]
    assert mesh.weld[run[-1]] == mesh.weld[mesh.edge_vertices[0][2][0]]


def test_an_edge_that_would_close_onto_a_point_is_sampled_finer():
    # A one-segment hem whose two ends are one corner of the tube.
    panel = square("leg", 1.5, height=30.0)
    pattern = Pattern((panel,), (Stitch(EdgeRef("leg", 1), EdgeRef("leg", 3)),))
    mesh = mesh_pattern(pattern, 2.0)
    assert_sound(mesh)
    assert len(mesh.edge_vertices[0][0]) >= 3


def test_order_in_the_file_does_not_matter():
    pattern = draft("t-shirt")
    shuffled = Pattern(
        pattern.panels[::-1],
        tuple(Stitch(s.second, s.first, s.right_wrong) for s in pattern.stitches[::-1]),
    )
    one, two = mesh_pattern(pattern.canonical(), 3.0), mesh_pattern(shuffled.canonical(), 3.0)
    assert np.array_equal(one.flat_vertices, two.flat_vertices)
    assert np.array_equal(one.faces, two.faces) and np.array_equal(one.weld, two.weld)


@pytest.mark.parametrize("name", [d.name for d in list_drafts()])
def test_every_draft_meshes(name):
    assert_sound(mesh_pattern(draft(name), 2.5))


def plain_coincident_edges(mesh):
    """Plain reference of `_coincident_inner_edges`, over all edges."""
    uses, welded = Counter(), Counter()
    for a, b, c in mesh.flat_faces.tolist():
        for u, v in ((a, b), (b, c), (c, a)):
            uses[min(u, v), max(u, v)] += 1
            welded[tuple(sorted(mesh.weld[[u, v]].tolist()))] += 1
    return [
        list(edge)
        for edge, count in sorted(uses.items())
        if count == 2
        and (welded[key := tuple(sorted(mesh.weld[list(edge)].tolist()))] > 2 or len(set(key)) == 1)
    ]


@pytest.mark.parametrize("name", ["trousers", "hoodie"])
def test_edges_that_welding_folds_together_are_found_and_parted(name, monkeypatch):
    seen = []
    find = assemble._coincident_inner_edges
    monkeypatch.setattr(
        assemble, "_coincident_inner_edges", lambda mesh: seen.append((mesh, find(mesh))) or seen[-1][1]
    )
    mesh = mesh_pattern(draft(name), 16.0)
    assert len(seen[0][1]) > 0
    assert all(found.tolist() == plain_coincident_edges(given) for given, found in seen)
    assert plain_coincident_edges(mesh) == []


def test_impossible_stitches_are_refused_by_name():
    panels = (square("a"), square("b"), square("c"))
    twice = (Stitch(EdgeRef("a", 0), EdgeRef("b", 0)), Stitch(EdgeRef("a", 0), EdgeRef("c", 0)))
    with pytest.raises(PatternError, match="'a' is in stitch 0 and in stitch 1"):
        mesh_pattern(Pattern(panels, twice))
    with pytest.raises(PatternError, match="does not exist"):
        mesh_pattern(Pattern(panels, (Stitch(EdgeRef("a", 9), EdgeRef("b", 0)),)))
    with pytest.raises(PatternError, match="stitch 0 and in stitch 0"):
        mesh_pattern(Pattern(panels, (Stitch(EdgeRef("a", 0), EdgeRef("a", 0)),)))


@pytest.mark.parametrize("edge_length", [0.0, -1.0, float("nan"), float("inf"), 1e-3, 1e3])
def test_edge_length_is_bounded(edge_length):
    with pytest.raises(InputError, match="edge length"):
        mesh_pattern(Pattern((square("a"),)), edge_length)


def test_a_pattern_without_panels_is_refused():
    with pytest.raises(PatternError, match="no panels"):
        mesh_pattern(Pattern(()))


def test_too_many_vertices_are_refused_before_the_work():
    with pytest.raises(InputError, match="vertices"):
        mesh_pattern(Pattern((square("a", 700.0),)), 0.1)
    with pytest.raises(InputError, match="outlines"):
        mesh_pattern(Pattern((square("a", 1e6, height=0.1),)), 0.1)


def test_more_cloth_than_any_garment_has_is_refused_at_any_edge_length():
    with pytest.raises(PatternError, match=r"64 m2 of cloth; at most 60 .* in cm"):
        mesh_pattern(Pattern((square("a", 800.0),)), 10.0)
    assert mesh_pattern(Pattern((square("a", 770.0),)), 10.0).vertex_count > 5000


def test_real_patterns_mesh(real_samples):
    records = [*real_samples("repository"), *real_samples("validation", every=20)]
    assert len(records) >= 20
    for record in records:
        pattern = read_specification(record["pattern"]).pattern.canonical()
        if not any(s.right_wrong for s in pattern.stitches):
            assert_sound(mesh_pattern(pattern, 3.0))

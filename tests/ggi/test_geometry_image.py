import numpy as np
import pytest
from geometry_reference import geometry_image
from ggi_patterns import HARD_CASES, any_garment, dart_pattern, panels, rectangle
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.errors import GeometryError, InputError, PatternError
from swifttailor.garment.garment import Garment
from swifttailor.ggi import encode, geometry, lay_out
from swifttailor.ggi.geometry import geometry_raster, rasterize_geometry
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern import Arc, Edge, Panel, Pattern
from swifttailor.pattern.drafts import draft


def lifted(pattern, edge_length, surface):
    """A garment without seams, each flat vertex carried to ``surface(x, y)`` from its panel's local cm."""
    mesh = mesh_pattern(pattern.canonical(), edge_length)
    assert (np.sort(mesh.weld) == np.arange(len(mesh.weld))).all()
    vertices = np.zeros((mesh.vertex_count, 3))
    vertices[mesh.weld] = surface(*mesh.flat_vertices.T)
    return Garment(mesh, vertices)


@pytest.mark.parametrize("case", ["dart", "right_wrong", "sleeve"])
def test_the_fast_way_agrees_with_the_plain_one(case):
    # Smooth positions: beside the chord of a curved edge the two ways take points a sagitta apart.
    pattern = HARD_CASES[case]().canonical()
    mesh = mesh_pattern(pattern, 5.0)
    rng = np.random.default_rng(1)
    matrix = rng.normal(size=(2, 3))
    vertices = np.zeros((mesh.vertex_count, 3))
    vertices[mesh.weld] = mesh.flat_vertices @ matrix + rng.normal(size=(len(mesh.weld), 3)) * 0.1
    layout = lay_out(pattern, 40)
    image, occupancy = rasterize_geometry(layout, mesh, vertices)
    plain = geometry_image(layout, mesh, vertices)
    assert np.array_equal(occupancy, layout.raster.occupancy)
    off = np.abs(image - plain).max(axis=2)
    straight = 1e-4  # float32, and the tie between faces that share an edge
    assert np.median(off[occupancy]) < straight
    assert off.max() < 0.25
    inside = layout.raster.spread((layout.raster.edge < 0).astype(np.uint8), 0) > 0
    assert np.quantile(off[inside], 0.995) < straight


def test_on_straight_edges_the_two_ways_are_equal():
    pattern = Pattern((rectangle("a", 20.3, 11.7), rectangle("b", 9.0, 30.1, clockwise=True)))
    garment = any_garment(pattern, 2.7)
    layout = lay_out(garment.pattern, 40)
    image, _ = rasterize_geometry(layout, garment.mesh, garment.vertices)
    assert np.abs(image - geometry_image(layout, garment.mesh, garment.vertices)).max() < 1e-3


@settings(max_examples=30, deadline=None)
@given(panels("p0", ("line",)), st.sampled_from([40, 128]), st.floats(0.05, 0.5))
def test_a_plane_is_drawn_exactly(panel, resolution, share):
    size = np.ptp(panel.vertices, axis=0)
    edge_length = float(np.clip(share * size.min(), max(0.05, size.max() / 60), 50.0))
    try:
        garment = lifted(
            Pattern((panel,)), edge_length, lambda x, y: np.stack([x + 2 * y, 3 - y, 0.5 * x], axis=1)
        )
    except (GeometryError, InputError, PatternError):
        return  # too thin to be meshed
    images = encode(garment, resolution)
    x, y = images.layout.local_points().T
    expected = np.stack([x + 2 * y, 3 - y, 0.5 * x], axis=1)
    found = images.geometry.reshape(-1, 3)[images.layout.raster.pixels]
    assert np.abs(found - expected).max() < 1e-5 * max(np.abs(expected).max(), 1.0)


@pytest.mark.parametrize("radius", [8.0, 30.0])
def test_a_cylinder_is_drawn_to_second_order_in_the_meshs_edges(radius):
    def cylinder(x, y):
        return np.stack([radius * np.sin(x / radius), y, radius * np.cos(x / radius)], axis=1)

    errors = []
    for edge_length in (4.0, 2.0, 1.0):
        images = encode(lifted(Pattern((rectangle("a", 40.0, 30.0),)), edge_length, cylinder), 200)
        found = images.geometry.reshape(-1, 3)[images.layout.raster.pixels]
        off = np.linalg.norm(found - cylinder(*images.layout.local_points().T), axis=1)
        assert off.max() <= (1.6 * edge_length) ** 2 / (8 * radius)  # the sagitta of a face's longest side
        errors.append(off.mean())
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert (orders > 1.6).all()


def test_hems_are_smooth_where_barycentric_values_alone_are_jagged():
    """Along an edge the values of the contour lie on the drape's border, pixel for pixel (paper, App. B)."""
    garment = any_garment(Pattern((rectangle("a", 37.0, 23.0),)), 2.0)
    images = encode(garment, 100)
    drawn = images.layout.raster
    values = images.geometry.reshape(-1, 3)[drawn.pixels].astype(float)
    for edge, run in enumerate(garment.mesh.edge_vertices[0]):
        line = garment.flat_positions[run]
        shown = drawn.edge == edge
        there = [np.interp(drawn.fraction[shown], np.linspace(0, 1, len(line)), c) for c in line.T]
        assert np.abs(values[shown] - np.stack(there, axis=1)).max() < 1e-3


def test_one_raster_serves_many_drapes():
    garment = any_garment(draft("fitted-dress"), 4.0)
    layout = lay_out(garment.pattern, 128)
    prepared = geometry_raster(layout, garment.mesh)
    assert np.allclose(prepared.weights.sum(axis=1), 1.0) and prepared.weights.min() >= -1e-8
    assert (prepared.vertices >= 0).all()
    panel = garment.mesh.flat_panel[prepared.vertices]
    assert (panel == layout.raster.pixel_panel[:, None]).all()
    for seed in range(3):
        vertices = any_garment(garment.pattern, 4.0, seed).vertices
        image, occupancy = rasterize_geometry(layout, garment.mesh, vertices)
        assert np.array_equal(prepared.image(vertices), image)
        assert np.isfinite(image).all() and not image[~occupancy].any()
        flat = vertices[garment.mesh.weld]
        direct = (flat[prepared.vertices] * prepared.weights[:, :, None]).sum(axis=1)
        assert np.allclose(prepared.values(vertices), direct)


def test_drawing_in_parts_changes_nothing(monkeypatch):
    garment = any_garment(draft("fitted-dress"), 4.0)
    layout = lay_out(garment.pattern, 128)
    whole = geometry_raster(layout, garment.mesh)
    monkeypatch.setattr(geometry, "_CANDIDATES", 500)
    parts = geometry_raster(layout, garment.mesh)
    assert np.array_equal(whole.vertices, parts.vertices) and np.array_equal(whole.weights, parts.weights)


def test_the_order_of_panels_in_the_mesh_does_not_matter():
    pattern = Pattern(dart_pattern().panels)
    for mesh in (mesh_pattern(pattern, 3.0), mesh_pattern(Pattern(pattern.panels[::-1]), 3.0)):
        flat = np.array([[*p, 100.0 * len(mesh.pattern.panels[k].name)] for k, p in
                         zip(mesh.flat_panel, mesh.flat_vertices, strict=True)])  # fmt: skip
        vertices = np.zeros((mesh.vertex_count, 3))
        vertices[mesh.weld] = flat
        layout = lay_out(mesh.pattern, 64)
        found = geometry_raster(layout, mesh).values(vertices)
        inside = layout.raster.edge < 0
        assert np.abs(found[inside, :2] - layout.local_points()[inside]).max() < 0.1
        names = np.array([100.0 * len(p.name) for p in layout.pattern.panels])
        assert np.allclose(found[:, 2], names[layout.raster.pixel_panel])


@pytest.mark.parametrize("case", HARD_CASES)
@pytest.mark.parametrize("resolution", [16, 64, 256])
def test_hard_cases_leave_no_pixel_without_a_position(case, resolution):
    garment = any_garment(HARD_CASES[case](), 8.0)
    images = encode(garment, resolution)
    bounds = np.abs(garment.vertices).max()
    assert np.isfinite(images.geometry).all() and np.abs(images.geometry).max() <= bounds * 1.001
    assert (np.abs(images.geometry).max(axis=2)[images.occupancy] > 0).all()


def test_pixels_between_a_curve_and_its_chords_take_the_chord():
    """A coarse mesh of a round panel leaves pixels outside the mesh; they must not fly away."""
    disc = Panel("disc", np.array([[-20.0, 0.0], [20.0, 0.0]]), (Edge(Arc(20.0, False, True)),) * 2)
    garment = lifted(Pattern((disc,)), 12.0, lambda x, y: np.stack([x, y, 0 * x], axis=1))
    images = encode(garment, 256)
    found = images.geometry.reshape(-1, 3)[images.layout.raster.pixels, :2]
    off = np.linalg.norm(found - images.layout.local_points(), axis=1)
    chord = np.linalg.norm(np.diff(garment.flat_positions[garment.mesh.edge_vertices[0][0]], axis=0), axis=1)
    assert off.max() <= 1.05 * chord.max() ** 2 / (8 * 20)


def test_a_mesh_of_another_pattern_is_refused():
    garment = any_garment(dart_pattern())
    with pytest.raises(InputError, match="layout is of the pattern 'sleeve' and the mesh of another"):
        rasterize_geometry(lay_out(HARD_CASES["sleeve"]()), garment.mesh, garment.vertices)


def test_vertices_of_another_mesh_are_refused():
    garment = any_garment(dart_pattern())
    with pytest.raises(GeometryError, match="vertices of shape"):
        rasterize_geometry(lay_out(garment.pattern), garment.mesh, garment.vertices[:-1])

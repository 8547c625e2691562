import dataclasses

import numpy as np
import pytest
from ggi_patterns import HARD_CASES, any_garment, dart_pattern, panels, rectangle
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from swifttailor.errors import GeometryError, InputError
from swifttailor.ggi import encode, lay_out
from swifttailor.ggi.outline_decode import OutlineSampler, decode_outline, outline_sampler
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.panel_mesh.assemble import MAX_AREA_M2
from swifttailor.pattern import Arc, Edge, EdgeRef, Panel, Pattern, Quadratic, Stitch
from swifttailor.pattern.drafts import draft

angles = st.floats(0, 6.3)


def turned(a, b, c):
    """A rotation matrix from three angles."""
    x = np.array([[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]])
    y = np.array([[np.cos(b), 0, np.sin(b)], [0, 1, 0], [-np.sin(b), 0, np.cos(b)]])
    z = np.array([[np.cos(c), -np.sin(c), 0], [np.sin(c), np.cos(c), 0], [0, 0, 1]])
    return x @ y @ z


def plane(x, y, radius):
    return np.stack([x, y, 0 * x], axis=1)


def cylinder(x, y, radius):
    return np.stack([radius * np.sin(x / radius), y, radius * np.cos(x / radius)], axis=1)


def sphere(x, y, radius):
    bend, rise = x / radius, y / radius
    return radius * np.stack([np.sin(bend) * np.cos(rise), np.sin(rise), np.cos(bend) * np.cos(rise)], axis=1)


def curved_panel():
    """Straight, concave and convex edges."""
    corners = np.array([[-15.0, -14.0], [16.0, -12.0], [14.0, 15.0], [-16.0, 13.0]])
    edges = (Edge(Quadratic((0.5, 0.15))), Edge(), Edge(Arc(30.0, False, False)), Edge())
    return Panel("front", corners, edges)


def shown(layout, surface, radius, rotation):
    """The geometry image of a surface over the local coordinates of every panel, without any mesh."""
    points = surface(*layout.local_points().T, radius) @ rotation
    return layout.raster.spread(points.astype(np.float32), 0.0)


def error(surface, radius, rotation, resolution, panel, edge_length):
    layout = lay_out(Pattern((panel,)), resolution)
    garment = decode_outline(layout, shown(layout, surface, radius, rotation), edge_length)
    true = surface(*garment.mesh.flat_vertices.T, radius) @ rotation
    return np.linalg.norm(garment.flat_positions - true, axis=1), layout.cm_per_pixel


@settings(max_examples=25, deadline=None)
@given(angles, angles, angles, st.sampled_from([32, 100, 256]), st.floats(0.7, 6.0))
def test_a_plane_is_read_exactly(a, b, c, resolution, edge_length):
    panel = rectangle("front", 31.0, 17.0, -9.0, 4.0)
    away, _ = error(plane, 1.0, turned(a, b, c), resolution, panel, edge_length)
    assert away.max() < 1e-4


@settings(max_examples=25, deadline=None)
@given(st.sampled_from([cylinder, sphere]), st.floats(12.0, 60.0), angles, angles, st.floats(0.8, 2.0))
def test_curved_surfaces_converge_at_second_order(surface, radius, a, b, edge_length):
    """Off by the square of the pixel over the radius, whatever the mesh: a quarter or less at half of it."""
    corners = np.array([[-15.0, -14.0], [16.0, -12.0], [14.0, 15.0], [-1.0, 9.0], [-16.0, 13.0]])
    panel = Panel("front", corners, (Edge(),) * 5)
    measured = []
    for resolution in (48, 96, 192):
        away, pixel = error(surface, radius, turned(a, b, 0.0), resolution, panel, edge_length)
        assert away.max() < 1.2 * pixel**2 / radius + 2e-5
        measured.append((np.sqrt((away**2).mean()), pixel))
    (coarse, wide), _, (fine, narrow) = measured
    assert np.log(coarse / fine) / np.log(wide / narrow) > 1.5  # pixels lie well or ill by chance


@pytest.mark.parametrize("surface", [plane, cylinder, sphere])
def test_curved_edges_are_met(surface):
    for resolution in (48, 96, 192):
        away, pixel = error(surface, 25.0, turned(1.0, 2.0, 0.3), resolution, curved_panel(), 1.5)
        traced = 2e-3  # curved outlines are drawn as polylines
        assert away.max() < pixel**2 * (1 / 25 + 1 / 20) + traced


@settings(max_examples=40, deadline=None)
@given(panels("p0", ("line",)), st.sampled_from([40, 128]), st.floats(0.05, 0.5))
def test_any_straight_panel_in_a_plane_comes_back(panel, resolution, share):
    """Slivers thinner than a pixel too: there positions across the sliver are not known to better than it."""
    size = np.ptp(panel.vertices, axis=0)
    assume(size.prod() < MAX_AREA_M2 * 1e4)  # more cloth is not meshed
    edge_length = float(np.clip(share * size.min(), max(0.05, size.max() / 60), 50.0))
    layout = lay_out(Pattern((panel,)), resolution)
    try:
        mesh = mesh_pattern(layout.pattern, edge_length)
    except GeometryError:
        return
    image = shown(layout, plane, 1.0, np.eye(3))
    away = np.linalg.norm(
        outline_sampler(layout, mesh).positions(image)[mesh.weld, :2] - mesh.flat_vertices, axis=1
    )
    assert away.max() < 1.5 * layout.cm_per_pixel
    if size.min() > 6 * layout.cm_per_pixel:
        assert np.median(away) < 1e-4 * max(1.0, size.max())


@pytest.mark.parametrize("case", [*HARD_CASES, "hoodie"])
@pytest.mark.parametrize("resolution", [64, 256])
def test_empty_pixels_are_never_read(case, resolution):
    pattern = HARD_CASES[case]() if case in HARD_CASES else draft(case)
    images = encode(any_garment(pattern, 4.0), resolution)
    first = decode_outline(images.layout, images.geometry, 3.0)
    dirty = images.geometry.copy()
    dirty[~images.occupancy] = np.nan
    second = decode_outline(images.layout, dirty, 3.0)
    assert np.array_equal(first.vertices, second.vertices)


def test_panels_do_not_read_each_other():
    layout = lay_out(draft("hoodie"), 128, gutter=1)
    sampler = outline_sampler(layout, mesh_pattern(layout.pattern, 1.0))
    raster = layout.raster
    rows, columns = sampler.weights.nonzero()
    assert np.array_equal(sampler.mesh.flat_panel[rows], raster.pixel_panel[columns])
    assert np.allclose(sampler.weights.sum(axis=1), 1.0)


def plain_reading(layout, mesh, values, vertex, on_edge):
    """What one vertex reads, one pixel at a time; None where the fast way fits a plane."""
    raster, panel = layout.raster, int(mesh.flat_panel[vertex])
    if on_edge:
        return None
    at = layout.to_pixels(panel, mesh.flat_vertices[vertex : vertex + 1])[0] - 0.5
    low = np.floor(at).astype(int)
    total = np.zeros(3)
    for row in (0, 1):
        for column in (0, 1):
            pixel = (low[1] + row) * layout.resolution + low[0] + column
            slot = np.searchsorted(raster.pixels, pixel)
            if slot == len(raster.pixels) or raster.pixels[slot] != pixel:
                return None
            if raster.pixel_panel[slot] != panel or raster.edge[slot] >= 0:
                return None
            share = np.abs(1 - row - (at - low)[1]) * np.abs(1 - column - (at - low)[0])
            total += share * values[slot]
    return total


def test_inside_it_is_bilinear_and_on_edges_linear():
    garment = any_garment(dart_pattern(), 4.0)
    images = encode(garment, 128)
    layout, mesh = images.layout, mesh_pattern(garment.pattern, 3.0)
    sampler = outline_sampler(layout, mesh)
    values = images.geometry.reshape(-1, 3)[layout.raster.pixels].astype(float)
    flat = sampler.weights @ values
    edges = {int(v) for panel in mesh.edge_vertices for run in panel for v in run}
    compared = 0
    for vertex in range(len(flat)):
        plain = plain_reading(layout, mesh, values, vertex, vertex in edges)
        if plain is not None:
            compared += 1
            assert np.allclose(flat[vertex], plain, atol=1e-6)
    assert compared > 300

    raster, outlines = layout.raster, layout.outlines
    linear = 0
    for panel, runs in enumerate(mesh.edge_vertices):
        for k, run in enumerate(runs):
            number = int(outlines.first_edge[panel]) + k
            own = np.flatnonzero(raster.edge == number)
            own = own[np.argsort(raster.fraction[own])]
            place = np.linspace(0, 1, len(run))
            inner = (place > raster.fraction[own][0]) & (place < raster.fraction[own][-1])
            near = np.diff(raster.fraction[own]).max() * layout.pattern.panels[panel].edge_length(k)
            if near > 2 * layout.cm_per_pixel:
                continue  # part of the edge shares its pixels with another
            expected = np.stack(
                [np.interp(place, raster.fraction[own], values[own, a]) for a in range(3)], axis=1
            )
            assert np.allclose(flat[run][inner], expected[inner], atol=1e-5)
            linear += int(inner.sum())
    assert linear > 60


@pytest.mark.parametrize("name", ["t-shirt", "jumpsuit", "gathered-skirt"])
def test_stitched_vertices_become_one_in_their_middle(name):
    images = encode(any_garment(draft(name), 4.0), 128)
    garment = decode_outline(images.layout, images.geometry, 3.0)
    mesh = garment.mesh
    sampler = outline_sampler(images.layout, mesh)
    flat = sampler.weights @ images.geometry.reshape(-1, 3)[images.layout.raster.pixels].astype(float)
    for stitch in garment.pattern.stitches:
        one, other = (mesh.edge_vertices[garment.pattern.panel_index(r.panel)][r.edge] for r in stitch.sides)
        other = other if stitch.right_wrong else other[::-1]
        gap = np.linalg.norm(garment.flat_positions[one] - garment.flat_positions[other], axis=1)
        assert gap.max() == 0.0
    for vertex in np.unique(np.concatenate([s.vertices for s in garment.seams]))[::7]:
        assert np.allclose(garment.vertices[vertex], flat[mesh.weld == vertex].mean(axis=0))


def test_the_vertices_of_the_same_mesh_come_back_from_fine_images():
    pattern = draft("t-shirt").canonical()
    garment = any_garment(pattern, 4.0)
    mesh = garment.mesh
    smooth = np.zeros((mesh.vertex_count, 3))
    smooth[mesh.weld, :2] = mesh.flat_vertices  # panels fold onto each other, and seams are where they end
    smooth[:, 2] = 10 * np.sin(smooth[:, 0] / 9)
    error_at = []
    for resolution in (64, 128, 256):
        images = encode(dataclasses.replace(garment, vertices=smooth), resolution)
        sampler = outline_sampler(images.layout, mesh)
        inside = np.bincount(mesh.weld, minlength=mesh.vertex_count) == 1
        error_at.append(np.linalg.norm(sampler.positions(images.geometry) - smooth, axis=1)[inside].mean())
    assert error_at[2] < 0.1 and error_at[2] < 0.6 * error_at[1] < 0.4 * error_at[0]


def test_a_dart_closer_than_a_pixel_decodes():
    corners = np.array([[0, 0], [19.9, 0], [20, 25], [20.1, 0], [40, 0], [40, 40], [0, 40]], float)
    panel = Panel("skirt_front", corners, (Edge(),) * 7)
    pattern = Pattern((panel,), (Stitch(EdgeRef("skirt_front", 1), EdgeRef("skirt_front", 2)),))
    layout = lay_out(pattern, 64)
    image = shown(layout, plane, 1.0, np.eye(3))
    garment = decode_outline(layout, image, 2.0)
    away = np.linalg.norm(garment.flat_positions[:, :2] - garment.mesh.flat_vertices, axis=1)
    assert away.max() < layout.cm_per_pixel


def test_what_does_not_belong_together_is_refused():
    images = encode(any_garment(dart_pattern(), 4.0), 64)
    with pytest.raises(InputError, match=r"64 x 64 pixels; a geometry image of shape \(32, 32, 3\)"):
        decode_outline(images.layout, images.geometry[:32, :32], 3.0)
    with pytest.raises(InputError, match="not finite"):
        decode_outline(images.layout, np.full_like(images.geometry, np.inf), 3.0)
    with pytest.raises(InputError, match="Mesh the layout's own pattern"):
        outline_sampler(images.layout, mesh_pattern(draft("t-shirt").canonical(), 4.0))
    with pytest.raises(InputError, match="edge length"):
        decode_outline(images.layout, images.geometry, 0.0)
    elsewhere = dataclasses.replace(images.layout, origins=images.layout.origins + 500.0)
    elsewhere.__dict__["raster"] = images.layout.raster
    with pytest.raises(GeometryError, match="no pixel of its panel around it"):
        outline_sampler(elsewhere, mesh_pattern(images.layout.pattern, 4.0))


def test_the_sampler_serves_any_drape_of_its_pattern():
    images = encode(any_garment(dart_pattern(), 4.0, seed=1), 64)
    other = encode(any_garment(dart_pattern(), 4.0, seed=2), 64)
    sampler = outline_sampler(images.layout, mesh_pattern(images.layout.pattern, 2.0))
    assert isinstance(sampler, OutlineSampler)
    for geometry in (images.geometry, other.geometry):
        expected = decode_outline(images.layout, geometry, 2.0).vertices
        assert np.array_equal(sampler.positions(geometry), expected)

"""The coarse drape: near to the real one in a hundredth of the time."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial import KDTree

from swifttailor.body import Body
from swifttailor.draping import drape
from swifttailor.draping.attachment import find_attachment
from swifttailor.draping.cloth import build_cloth
from swifttailor.draping.coarse import CoarseSettings, coarse_edge_length, drape_coarsely
from swifttailor.draping.coarse_kernels import advance_freely
from swifttailor.draping.collider import ARMS, join_fields, vertices_ignoring_arms
from swifttailor.draping.field_kernels import sample_field
from swifttailor.draping.known_fabrics import get_fabric
from swifttailor.draping.loop_arguments import StepSettings, coarse_work
from swifttailor.draping.placement import place_vertices
from swifttailor.draping.simulation import Simulation, SimulationSettings
from swifttailor.draping.worn_height import worn_height
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.drafts import draft

GARMENTS = ["t-shirt", "shirt-dress", "trousers", "circle-skirt"]


@pytest.fixture(scope="module")
def fields():
    body = Body.default()
    return body.distance_field(spacing=1.0), body.distance_field(spacing=1.0, without=ARMS)


@pytest.fixture(scope="module", params=GARMENTS)
def mesh(request):
    pattern = draft(request.param).canonical()
    return mesh_pattern(pattern, coarse_edge_length(pattern, CoarseSettings()))


@pytest.fixture(scope="module")
def hung(mesh, fields):
    return drape_coarsely(mesh, *fields, Body.default().measurements)


def test_is_worn(mesh, hung):
    assert hung[:, 1].max() > worn_height(mesh.pattern, Body.default().measurements).lowest
    assert hung[:, 1].min() > -2


def test_vertices_are_outside_the_body(mesh, hung, fields):
    ignores = vertices_ignoring_arms(mesh).astype(bool)
    distance = np.where(ignores, fields[1].sample(hung)[0], fields[0].sample(hung)[0])
    assert (distance > -0.1).mean() > 0.98
    middle = np.abs(hung[:, 0]) < 10
    assert hung[middle, 2].max() > 5 and hung[middle, 2].min() < -5  # and go all around it


def test_cloth_keeps_its_size(mesh, hung):
    cloth = build_cloth(mesh, get_fabric("cotton")).arrays
    length = np.linalg.norm(hung[cloth.edges[:, 0]] - hung[cloth.edges[:, 1]], axis=1)
    strain = length / cloth.rest - 1
    assert np.median(np.abs(strain)) < 0.05
    assert np.percentile(strain, 95) < 0.2


def test_is_nearer_to_the_drape_than_the_placed_panels(mesh, hung):
    settings = SimulationSettings(max_frames=240)
    rest = drape(mesh.pattern, edge_length=4.0, settings=settings)
    tree = KDTree(rest.vertices)
    near = tree.query(hung)[0].mean()
    assert near < 3.5
    assert near < 0.5 * tree.query(place_vertices(mesh))[0].mean()


def test_is_the_same_every_time_and_leaves_the_mesh_alone(mesh, hung, fields):
    before = mesh.flat_vertices.copy()
    assert np.array_equal(hung, drape_coarsely(mesh, *fields, Body.default().measurements))
    assert np.array_equal(before, mesh.flat_vertices)


def test_frames_are_those_of_the_drape_without_self_collision():
    body, fabric = Body.default(), get_fabric("cotton")
    mesh = mesh_pattern(draft("t-shirt").canonical(), 5.0)
    cloth = build_cloth(mesh, fabric)
    attachment = find_attachment(mesh, body.measurements)
    settings = SimulationSettings(substeps=8, self_collision=False)
    plain = Simulation(mesh, cloth, body, fabric, attachment, place_vertices(mesh), settings)
    x = plain.positions.copy()
    work = coarse_work(len(x), len(cloth.arrays.edges), len(cloth.arrays.hinges))
    work.v[:] = plain.velocities
    step = StepSettings(
        substeps=8,
        step=1 / 480,
        gravity=981.0,
        damping=2.0,
        friction=fabric.friction,
        thickness=fabric.thickness,
        max_speed=250.0,
        bending_factor=1.0,
        lowest_level=2.0,
        long_edges=False,
        self_collision=False,
        untangling=0.0,
        contact_interval=5,
        still=0.03,
    )
    for _ in range(5):
        plain.frame(gravity=981.0, damping=2.0, friction=fabric.friction, self_collision=False)
        work.clearance[:] = 0.0
        advance_freely(x, cloth.arrays, plain.field, plain.held, step, work)
    assert np.abs(x - plain.positions).max() < 1e-9


def test_large_garments_get_longer_edges():
    pattern = draft("circle-skirt").canonical()
    wide = coarse_edge_length(pattern, CoarseSettings(most_vertices=100))
    assert wide > coarse_edge_length(pattern, CoarseSettings()) == 5.4
    assert mesh_pattern(pattern, wide).vertex_count < 200


def test_fields_on_parts_of_a_lattice_are_copied_onto_it(fields):
    full, armless = fields
    joined = join_fields(full, armless, np.zeros(3))
    assert joined.armless.shape == full.values.shape
    chance = np.random.default_rng(0)
    low = armless.origin
    high = low + armless.spacing * (np.array(armless.values.shape) - 1)
    points = chance.uniform(low, high, (500, 3))
    found = [sample_field(joined.armless, joined.origin, joined.spacing, *p)[0] for p in points]
    assert np.allclose(found, armless.sample(points)[0], atol=1e-4)
    # Beyond the armless lattice nothing is nearer than it says.
    beyond = np.indices(full.values.shape).reshape(3, -1).T[::997] * full.spacing + full.origin
    beyond = beyond[((beyond < low) | (beyond > high)).any(axis=1)]
    assert len(beyond) > 100
    found = [sample_field(joined.armless, joined.origin, joined.spacing, *p)[0] for p in beyond]
    inner = np.array(found) < 1e3  # at the last node there is no cell to interpolate in
    assert (np.array(found)[inner] <= armless.sample(beyond)[0][inner] + 1e-4).all()


def test_a_folded_collar_falls_on_the_shoulders(fields):
    pattern = draft("polo-shirt").canonical()
    mesh = mesh_pattern(pattern, coarse_edge_length(pattern, CoarseSettings()))
    positions = drape_coarsely(mesh, *fields, Body.default().measurements)
    collar = np.array(["collar" in pattern.panels[k].name for k in mesh.flat_panel])
    seams = np.concatenate([s.vertices for s in mesh.seams if mesh.pattern.stitches[s.stitch].right_wrong])
    free = np.setdiff1d(mesh.weld[collar], seams)
    assert positions[free, 1].mean() < positions[seams, 1].mean() - 1.5

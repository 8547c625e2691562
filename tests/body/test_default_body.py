from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import KDTree
from shapes import garmentcode_folder, mesh_of

from swifttailor.body import Body, BodyPart, girth, measure_body, signed_distance
from swifttailor.body.body import DEFAULT_FILE
from swifttailor.body.measuring import MEAN_BODY
from swifttailor.body.parts import ARMS, face_parts, surface_without
from swifttailor.errors import InputError


@pytest.fixture(scope="module")
def mesh(body):
    return mesh_of(body.vertices, body.faces)


def test_default_body_is_a_closed_outward_surface_in_one_piece(mesh):
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert 0.055e6 < mesh.volume < 0.09e6  # cm3
    assert mesh.area_faces.min() > 1e-6
    assert mesh.body_count == 1
    assert mesh.euler_number == 2
    assert len(mesh.vertices) <= 14_000
    assert DEFAULT_FILE.stat().st_size < 400_000


def test_default_body_stands_on_the_floor_facing_forward(body):
    low, high = body.vertices.min(axis=0), body.vertices.max(axis=0)
    assert low[1] == 0.0
    assert high[1] == pytest.approx(172.0, abs=1.0)
    feet = body.vertices[body.vertices[:, 1] < 4]
    shins = body.vertices[(body.vertices[:, 1] > 12) & (body.vertices[:, 1] < 20)]
    assert feet[:, 2].max() - shins[:, 2].max() > 5 > shins[:, 2].min() - feet[:, 2].min()
    left_arm = body.vertices[body.vertex_part == BodyPart.LEFT_ARM]
    assert left_arm[:, 0].min() > 10


def test_default_body_is_left_right_symmetric(body):
    mirrored = body.vertices * [-1, 1, 1]
    gap, index = KDTree(body.vertices).query(mirrored)
    assert gap.max() < 1e-5
    swap = np.array([0, 1, 3, 2, 5, 4])
    assert (body.vertex_part[index] == swap[body.vertex_part]).all()
    faces = {tuple(sorted(face)) for face in body.faces.tolist()}
    other = {tuple(sorted(face)) for face in index[body.faces].tolist()}
    assert len(faces & other) > 0.99 * len(faces)


def test_default_body_does_not_cut_itself(body, mesh):
    """Just below the skin the winding number is one; it would be two where parts overlap."""
    from swifttailor.body.surface_distance import SurfaceTree
    from swifttailor.body.surface_kernels import winding_number

    tree = SurfaceTree.build(body.vertices, body.faces)
    stack = np.zeros(128, np.int64)
    centres = mesh.triangles_center - 0.01 * mesh.face_normals
    numbers = np.array([winding_number(*p, tree.corners, tree.dipoles, stack) for p in centres])
    clothed = face_parts(body.faces, body.vertex_part) != BodyPart.HEAD
    assert (numbers[clothed] < 1.5).mean() > 0.998
    trunk = clothed & (np.abs(centres[:, 0]) < 50) & (centres[:, 1] > 10)
    assert (numbers[trunk] < 1.5).all()


def test_thighs_are_apart(body):
    m = body.measurements
    for level in np.arange(30.0, m.crotch_level - 3.0, 1.0):
        legs = body.vertices[np.abs(body.vertices[:, 1] - level) < 1.5]
        legs = legs[np.abs(legs[:, 0]) < 30]
        assert legs[legs[:, 0] > 0, 0].min() > 0.3


@pytest.mark.parametrize("part", list(BodyPart))
def test_each_part_is_connected(body, part):
    own = body.faces[(body.vertex_part[body.faces] == part).all(axis=1)]
    ends = np.concatenate([own[:, :2], own[:, 1:]])
    graph = coo_array((np.ones(len(ends)), ends.T), shape=(len(body.vertices),) * 2)
    sizes = np.bincount(connected_components(graph, directed=False)[1][own[:, 0]])
    assert max(sizes) > 0.98 * len(own)


def test_parts_lie_where_they_should(body):
    m, v, part = body.measurements, body.vertices, body.vertex_part
    assert v[part == BodyPart.HEAD, 1].min() > m.neck_level - 4
    assert m.crotch_level < v[np.isin(part, [4, 5]), 1].max() < m.waist_level
    assert v[np.isin(part, [4, 5]), 1].min() == 0
    assert v[part == BodyPart.TORSO, 1].min() > m.crotch_level - 3
    assert np.abs(v[np.isin(part, [2, 3]), 0]).min() < m.shoulder_w / 2


def test_measured_girths_are_those_of_the_measurements(body):
    levels = ("head_l", "vert_bust_line", "waist_line", "hips_line")
    known = {name: body.measurements.as_dict()[name] for name in levels}
    measured = measure_body(body.vertices, body.faces, body.vertex_part, known)
    for name, bound in {
        "bust": 2,
        "underbust": 3,
        "waist": 2,
        "hips": 2,
        "leg_circ": 3,
        "wrist": 1.5,
    }.items():
        assert getattr(measured, name) == pytest.approx(getattr(body.measurements, name), abs=bound), name
    assert measured.arm_length == pytest.approx(body.measurements.arm_length, abs=3)
    assert measured.arm_pose_angle == pytest.approx(body.measurements.arm_pose_angle, abs=6)


def test_measurements_are_those_of_the_mean_body(body):
    assert body.measurements.as_dict() == MEAN_BODY
    m = body.measurements
    assert m.waist_level == pytest.approx(m.height - m.head_l - m.waist_line)
    assert (
        0 < m.crotch_level < m.hips_level < m.waist_level < m.bust_level < m.armpit_level < m.shoulder_level
    )
    assert m.waist_front_width + m.waist_back_width == pytest.approx(m.waist)


def test_cutting_off_the_arms_leaves_a_closed_surface(body):
    vertices, faces = surface_without(body.vertices, body.faces, body.vertex_part, ARMS)
    rest = mesh_of(vertices, faces, process=True)
    assert rest.is_watertight
    assert rest.is_winding_consistent
    assert 0 < rest.volume < 0.09e6
    assert np.abs(vertices[np.unique(faces), 0]).max() < 26


def test_arrays_are_read_only_and_the_default_is_shared(body):
    assert Body.default() is body
    for array in (body.vertices, body.faces, body.vertex_part):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0


def test_a_body_refuses_arrays_that_do_not_fit(body):
    with pytest.raises(InputError, match="one part label per vertex"):
        Body("x", body.vertices, body.faces, body.vertex_part[:-1], body.measurements)
    with pytest.raises(InputError, match="refer to vertices"):
        Body("x", body.vertices[:-1], body.faces, body.vertex_part[:-1], body.measurements)
    with pytest.raises(InputError, match="finite"):
        Body("x", body.vertices * np.nan, body.faces, body.vertex_part, body.measurements)


def test_importing_the_room_imports_nothing_heavy():
    code = (
        "import sys, swifttailor.body as b; b.Body.default(); "
        "print([n for n in ('numba', 'trimesh', 'torch', 'scipy', 'anny', 'yaml') if n in sys.modules])"
    )
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert result.stdout.strip() == "[]"


def test_girth_of_a_cylinder():
    import trimesh

    mesh = trimesh.creation.cylinder(radius=12.0, height=40.0, sections=256)
    vertices = np.asarray(mesh.vertices)[:, [0, 2, 1]] * [1, 1, -1] + [0, 20, 0]
    assert girth(vertices, mesh.faces, 17.3) == pytest.approx(2 * np.pi * 12.0, rel=1e-3)
    assert girth(vertices, mesh.faces, 99.0) == 0.0


def test_default_body_lies_on_garmentcodes_mean_body(body):
    import trimesh

    target = trimesh.load_mesh(garmentcode_folder() / "body" / "mean_all.obj", process=False)
    gap = np.abs(signed_distance(np.asarray(target.vertices) * 100, target.faces, body.vertices)[0])
    assert gap.mean() < 0.35
    assert np.percentile(gap, 95) < 1.0


def test_the_armscye_measured_on_the_mesh_is_as_deep_as_garmentcode_says():
    body = Body.default()
    measured = measure_body(body.vertices, body.faces, body.vertex_part)
    assert measured.armscye_depth == pytest.approx(body.measurements.armscye_depth, abs=0.2)


@pytest.mark.parametrize("scale", [0.9, 1.1])
def test_measured_lengths_grow_with_the_body(scale):
    body = Body.default()
    small = measure_body(body.vertices, body.faces, body.vertex_part)
    large = measure_body(body.vertices * scale, body.faces, body.vertex_part)
    for name in ("armscye_depth", "waist", "bust", "arm_length", "shoulder_w"):
        assert getattr(large, name) == pytest.approx(scale * getattr(small, name), rel=0.03), name

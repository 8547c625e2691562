from __future__ import annotations

import numpy as np
import pytest
from sewn_tube import component_count, edge_counts, tube_garment

from swifttailor.garment.formats import read_garment_mesh, write_garment_mesh
from swifttailor.garment.obj import obj_text, safe_names
from swifttailor.garment.ply import ply_bytes
from swifttailor.garment.stl import stl_bytes
from swifttailor.garment.triangle_mesh import TriangleMesh, mesh_of_garment

trimesh = pytest.importorskip("trimesh")


def corner_set(mesh) -> np.ndarray:
    """Corner positions (and texture coordinates) of all faces, sorted, for comparison in any order."""
    corners = mesh.vertices[mesh.faces]
    if mesh.uv is not None:
        corners = np.concatenate([corners, 100 * mesh.uv[mesh.uv_faces]], axis=2)
    flat = corners.reshape(len(corners), -1)
    return flat[np.lexsort(np.round(flat, 3).T)]


def test_obj_is_one_stitched_mesh_with_one_island_per_panel(tube, tube_mesh, tmp_path):
    back = read_garment_mesh(write_garment_mesh(tube_mesh, tmp_path / "tube.obj"))
    assert len(back.vertices) == len(tube.vertices)
    assert component_count(back.faces) == 1
    counts = edge_counts(back.faces)
    assert counts.max() == 2
    np.testing.assert_array_equal(np.bincount(counts), np.bincount(edge_counts(tube.faces)))
    assert component_count(back.uv_faces) == len(tube.pattern.panels)
    for k in range(2):
        assert component_count(back.uv_faces[back.face_group == k]) == 1
    assert back.groups == ("front", "back")
    np.testing.assert_allclose(back.vertices, tube.vertices, atol=1e-6)
    np.testing.assert_allclose(back.uv, tube.uv, atol=1e-7)
    assert [line.tolist() for line in back.lines] == [s.vertices.tolist() for s in tube.seams]


def test_obj_in_trimesh_is_in_centimetres(tube, tube_mesh, tmp_path):
    path = write_garment_mesh(tube_mesh, tmp_path / "tube.obj")
    assert "units: centimetres" in path.read_text()
    scene = trimesh.load_scene(path, process=False)
    np.testing.assert_allclose(scene.extents, np.ptp(tube.vertices, axis=0), atol=1e-4)


def test_ply_keeps_everything_but_the_seams(tube, tube_mesh, tmp_path):
    path = write_garment_mesh(tube_mesh, tmp_path / "tube.ply")
    assert b"units: centimetres" in path.read_bytes()[:300]
    back = read_garment_mesh(path)
    np.testing.assert_allclose(back.vertices, tube.vertices, atol=1e-4)
    np.testing.assert_array_equal(back.faces, tube.faces)
    np.testing.assert_array_equal(back.face_group, tube.mesh.face_panel)
    assert back.groups == ("front", "back")
    np.testing.assert_allclose(corner_set(back), corner_set(tube_mesh), atol=1e-3)
    assert component_count(back.uv_faces) == 2
    plain = trimesh.load(path, process=False)
    np.testing.assert_allclose(plain.area, trimesh.Trimesh(tube.vertices, tube.faces).area, rtol=1e-5)


def test_stl_keeps_the_surface(tube, tube_mesh, tmp_path):
    back = read_garment_mesh(write_garment_mesh(tube_mesh, tmp_path / "tube.stl"))
    assert len(back.vertices) == len(tube.vertices) and component_count(back.faces) == 1
    np.testing.assert_allclose(back.vertices[back.faces], tube.vertices[tube.faces], atol=1e-4)


def test_stl_normals_point_out_of_the_right_side(tube, tube_mesh):
    rows = np.frombuffer(stl_bytes(tube_mesh)[84:], [("n", "<f4", 3), ("c", "<f4", (3, 3)), ("a", "<u2")])
    middle = tube.vertices[tube.faces].mean(axis=1)
    outward = (rows["n"] * middle * (1, 0, 1)).sum(axis=1)
    assert (outward > 0).mean() > 0.99
    np.testing.assert_allclose(np.linalg.norm(rows["n"], axis=1), 1.0, atol=1e-5)


def test_bare_mesh_keeps_its_faces(tube, tmp_path):
    """Without texture coordinates, groups and seams."""
    bare = TriangleMesh(tube.vertices, tube.faces)
    for ending in (".obj", ".ply", ".glb", ".usda"):
        back = read_garment_mesh(write_garment_mesh(bare, tmp_path / f"bare{ending}"))
        assert back.uv is None and back.lines == ()
        np.testing.assert_allclose(back.vertices[back.faces], tube.vertices[tube.faces], atol=1e-4)


@pytest.mark.parametrize("write", [obj_text, ply_bytes, stl_bytes])
def test_bytes_are_the_same_every_time(write):
    assert write(mesh_of_garment(tube_garment())) == write(mesh_of_garment(tube_garment()))


@pytest.mark.parametrize("ending", [".obj", ".ply"])
def test_awkward_names_do_not_break_lines(tmp_path, ending):
    garment = tube_garment(front="a b\nf 1 1 1 end_header", back="a b f 1 1 1 end_header")
    back = read_garment_mesh(write_garment_mesh(mesh_of_garment(garment), tmp_path / f"names{ending}"))
    assert len(back.faces) == len(garment.faces)
    assert back.groups == ("a_b_f_1_1_1_end_header", "a_b_f_1_1_1_end_header_2")


def test_safe_names_are_unique_and_never_empty():
    assert safe_names(("a", " ", "a ", "seams", "a_")) == ["a", "_", "a_", "seams_2", "a__2"]


def test_polygons_negative_indices_and_missing_parts_of_foreign_obj(tmp_path):
    path = tmp_path / "foreign.obj"
    path.write_text("v 0 0 0\nv 1 0 0 1 1 1\nv 1 1 0\nv 0 1 0\n\n# quad\nf -4 -3 -2 -1\n")
    mesh = read_garment_mesh(path)
    assert mesh.faces.tolist() == [[0, 1, 2], [0, 2, 3]]
    assert mesh.uv is None and mesh.groups == ()

from __future__ import annotations

import json
import struct

import numpy as np
import pytest
from sewn_tube import component_count, edge_counts, tube_garment

from swifttailor.garment.formats import read_garment_mesh, write_garment_mesh
from swifttailor.garment.glb import glb_bytes
from swifttailor.garment.seam_names import seam_names
from swifttailor.garment.triangle_mesh import mesh_of_garment

trimesh = pytest.importorskip("trimesh")


def document_of(content: bytes) -> dict:
    magic, version, total = struct.unpack_from("<4sII", content)
    assert (magic, version, total) == (b"glTF", 2, len(content))
    length, kind = struct.unpack_from("<I4s", content, 12)
    assert kind == b"JSON" and length % 4 == 0
    return json.loads(content[20 : 20 + length])


def test_one_node_per_panel_in_metres_with_uv(tube, tube_mesh, tmp_path):
    path = write_garment_mesh(tube_mesh, tmp_path / "tube.glb")
    scene = trimesh.load_scene(path, process=False)
    meshes = {k: g for k, g in scene.geometry.items() if isinstance(g, trimesh.Trimesh)}
    assert set(meshes) == {"front", "back"} <= set(scene.graph.nodes_geometry)
    for k, name in enumerate(("front", "back")):
        of = tube.mesh.flat_panel == k
        expected = tube.flat_positions[of] / 100
        order = np.lexsort(np.round(expected, 6).T)
        got = np.asarray(meshes[name].vertices)
        np.testing.assert_allclose(got[np.lexsort(np.round(got, 6).T)], expected[order], atol=1e-6)
        uv = np.asarray(meshes[name].visual.uv)
        np.testing.assert_allclose(np.sort(uv, axis=0), np.sort(tube.uv[of], axis=0), atol=1e-6)
        np.testing.assert_allclose(meshes[name].area, _area(tube, k) / 1e4, rtol=1e-5)
    np.testing.assert_allclose(scene.extents, np.ptp(tube.vertices, axis=0) / 100, rtol=1e-5)


def _area(garment, panel: int) -> float:
    corners = garment.vertices[garment.faces[garment.mesh.face_panel == panel]]
    return float(np.linalg.norm(np.cross(*np.diff(corners, axis=1).transpose(1, 0, 2)), axis=1).sum() / 2)


def test_seams_show_no_crease(tube, tube_mesh, tmp_path):
    """Vertices of different panels at one place have one normal."""
    path = write_garment_mesh(tube_mesh, tmp_path / "tube.glb")
    scene = trimesh.load_scene(path, process=False)
    normals: dict[int, np.ndarray] = {}
    shared = 0
    for name in ("front", "back"):
        mesh = scene.geometry[name]
        for weld, normal in zip(mesh.vertex_attributes["_WELD"], mesh.vertex_normals, strict=True):
            key = int(np.ravel(weld)[0])
            shared += key in normals
            np.testing.assert_allclose(normal, normals.setdefault(key, normal), atol=1e-6)
            np.testing.assert_allclose(normal, tube.vertex_normals[key], atol=1e-5)
    assert shared >= 2 * 20


def test_reading_closes_the_seams_again(tube, tube_mesh, tmp_path):
    back = read_garment_mesh(write_garment_mesh(tube_mesh, tmp_path / "tube.glb"))
    assert back.groups == ("front", "back")
    assert len(back.vertices) == len(tube.vertices)
    assert component_count(back.faces) == component_count(tube.faces) == 1
    np.testing.assert_array_equal(np.bincount(edge_counts(back.faces)), np.bincount(edge_counts(tube.faces)))
    np.testing.assert_allclose(np.sort(back.vertices, axis=0), np.sort(tube.vertices, axis=0), atol=1e-4)


def test_reading_joins_by_place_when_there_are_no_weld_numbers(tube, tube_mesh, tmp_path):
    path = write_garment_mesh(tube_mesh, tmp_path / "tube.glb")
    scene = trimesh.load_scene(path, process=False)
    scene.delete_geometry([name for name in scene.geometry if name.startswith("seam_")])
    for mesh in scene.geometry.values():
        del mesh.vertex_attributes["_WELD"]
    other = tmp_path / "other.glb"
    other.write_bytes(scene.export(file_type="glb"))
    back = read_garment_mesh(other)
    assert len(back.vertices) == len(tube.vertices)
    assert component_count(back.faces) == 1


def test_seam_lines_follow_the_stitches(tube, tube_mesh):
    content = glb_bytes(tube_mesh)
    document = document_of(content)
    nodes = [n["name"] for n in document["nodes"]]
    named = list(seam_names(tube.pattern))
    assert nodes == ["garment", "front", "back", "seams", *named]
    assert document["nodes"][3]["children"] == [4, 5, 6] and document["nodes"][0]["children"] == [1, 2, 3]
    for node, seam in zip(document["nodes"][4:], tube.seams, strict=True):
        lines = document["meshes"][node["mesh"]]["primitives"][0]
        assert lines["mode"] == 3
        assert document["accessors"][lines["attributes"]["POSITION"]]["count"] == len(seam.vertices)


def test_file_keeps_the_rules_of_gltf(tube_mesh):
    content = glb_bytes(tube_mesh)
    document = document_of(content)
    start = 20 + struct.unpack_from("<I", content, 12)[0]
    length, kind = struct.unpack_from("<I4s", content, start)
    assert kind == b"BIN\0" and length % 4 == 0 and start + 8 + length == len(content)
    assert document["buffers"][0]["byteLength"] <= length
    for accessor in document["accessors"]:
        view = document["bufferViews"][accessor["bufferView"]]
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}[accessor["type"]]
        assert view["byteLength"] == accessor["count"] * width * 4 and view["byteOffset"] % 4 == 0
        raw = content[start + 8 + view["byteOffset"] :][: view["byteLength"]]
        values = np.frombuffer(raw, "<f4" if accessor["componentType"] == 5126 else "<u4").reshape(-1, width)
        if "min" in accessor:
            np.testing.assert_array_equal(values.min(axis=0), np.float32(accessor["min"]))
            np.testing.assert_array_equal(values.max(axis=0), np.float32(accessor["max"]))
    for mesh in document["meshes"]:
        attributes = mesh["primitives"][0]["attributes"]
        count = document["accessors"][attributes["POSITION"]]["count"]
        assert {document["accessors"][a]["count"] for a in attributes.values()} == {count}
    assert all(m["doubleSided"] for m in document["materials"])


def test_bytes_are_the_same_every_time():
    assert glb_bytes(mesh_of_garment(tube_garment())) == glb_bytes(mesh_of_garment(tube_garment()))


def test_awkward_panel_names_survive(tmp_path):
    garment = tube_garment(front='<a "b">\n\\', back="küche 衣服")
    path = write_garment_mesh(mesh_of_garment(garment), tmp_path / "names.glb")
    names = [n["name"] for n in document_of(path.read_bytes())["nodes"]]
    assert names[1:3] == ['<a "b">\n\\', "küche 衣服"]
    assert len(read_garment_mesh(path).groups) == 2

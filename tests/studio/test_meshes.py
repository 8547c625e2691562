"""Mesh files: what clients read is the garment, and the garment can be built from it again."""

from __future__ import annotations

import json
import struct

import numpy as np
import pytest

from swifttailor.errors import GeometryError
from swifttailor.garment.garment import Garment
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.drafts import draft
from swifttailor.studio.bench.mesh_files import garment_of, garment_record, strain_of
from swifttailor.studio.body_mesh import body_record
from swifttailor.studio.compact_mesh import expand, shrink
from swifttailor.studio.mesh_record import MeshRecord, name_of, smooth_normals, unpack_mesh
from swifttailor.studio.mesh_store import MeshStore
from swifttailor.studio.shipped import FOLDER, shipped_body, shipped_examples


@pytest.fixture(scope="module")
def flat() -> Garment:
    """A shirt whose panels lie flat in space, one beside the other where the seams let them."""
    mesh = mesh_pattern(draft("t-shirt").canonical(), 3.0)
    placed = [
        mesh.pattern.panels[k].to_world(mesh.flat_vertices[mesh.flat_panel == k])
        for k in range(len(mesh.pattern.panels))
    ]
    return Garment(mesh, mesh.welded_mean(np.concatenate(placed)), {"quality": None}, "#102030")


def test_bytes_are_as_the_guide_of_the_api_says(flat):
    data = garment_record(flat, 3.0).data
    magic, length = struct.unpack("<8sI", data[:12])
    assert magic == b"STMESH01" and (12 + length) % 4 == 0
    header = json.loads(data[12 : 12 + length])
    blocks = {}
    for block in header["blocks"]:
        assert block["offset"] % 4 == 0
        kind = {"f32": "<f4", "u32": "<u4"}[block["type"]]
        blocks[block["name"]] = np.frombuffer(data, kind, block["count"], 12 + length + block["offset"])
    positions = blocks["positions"].reshape(-1, 3)
    assert np.abs(positions - flat.flat_positions).max() < 1e-4
    assert np.array_equal(blocks["triangles"].reshape(-1, 3), flat.mesh.flat_faces)
    assert np.array_equal(blocks["weld"], flat.mesh.weld)
    assert header["panels"] == [p.name for p in flat.pattern.panels] and header["color"] == "#102030"
    for k, place in enumerate(header["edges"]):
        run = blocks["edge_vertices"][blocks["edge_offsets"][k] : blocks["edge_offsets"][k + 1]]
        panel = flat.pattern.panels[flat.pattern.panel_index(place["panel"])]
        ends = blocks["uv"].reshape(-1, 2)[run[[0, -1]]]
        corners = panel.vertices[[place["edge"], (place["edge"] + 1) % len(panel.edges)]]
        assert np.abs(ends - corners).max() < 1e-3
    for k, seam in enumerate(header["seams"]):
        run = blocks["seam_vertices"][blocks["seam_offsets"][k] : blocks["seam_offsets"][k + 1]]
        first, second = np.split(blocks["weld"][run], 2)
        assert set(first) == set(second), seam


def test_the_garment_comes_back(flat):
    record = garment_record(flat, 3.0)
    again = garment_of(record)
    assert again.pattern == flat.pattern and again.color == flat.color
    assert np.abs(again.vertices - flat.vertices).max() < 1e-3
    assert garment_record(again, 3.0).name == record.name == name_of(record.data)


def test_a_mesh_of_another_version_is_not_taken_for_this_one(flat):
    record = garment_record(flat, 3.0)
    with pytest.raises(GeometryError, match="another version"):
        garment_of(MeshRecord(record.name, record.data, record.pattern, 2.0))


def test_small_files_are_the_same_garment(flat):
    data = garment_record(flat, 3.0).data
    small = shrink(data)
    assert len(small) < len(data) / 3
    header, blocks = unpack_mesh(expand(small))
    before_header, before = unpack_mesh(data)
    assert header["seams"] == before_header["seams"]
    assert list(blocks) == list(before)
    for name, tolerance in {"positions": 0.0051, "uv": 0.0051, "strain": 0.0051, "normals": 0.05}.items():
        assert np.abs(blocks[name] - before[name]).max() <= tolerance, name
    for name in (
        "triangles",
        "weld",
        "panel",
        "seam_vertices",
        "seam_offsets",
        "edge_vertices",
        "edge_offsets",
    ):
        assert np.array_equal(blocks[name], before[name]), name


def test_strain_of_cloth_that_is_stretched_by_a_tenth(flat):
    mesh = flat.mesh
    at = np.zeros((mesh.vertex_count, 3))
    lone = np.bincount(mesh.weld, minlength=mesh.vertex_count) == 1
    at[mesh.weld, :2] = mesh.flat_vertices * (1.1, 1.0)
    strain = strain_of(mesh, at)
    inner = np.ones(len(mesh.flat_vertices), bool)
    for face in mesh.flat_faces:  # corners of faces that touch a seam are of two panels at once
        if not lone[mesh.weld[face]].all():
            inner[face] = False
    assert inner.sum() > 50
    assert np.abs(strain[inner] - 0.1).max() < 1e-4


def test_normals_point_out_of_the_body():
    header, blocks = unpack_mesh(body_record().data)
    positions, normals = blocks["positions"].reshape(-1, 3), blocks["normals"].reshape(-1, 3)
    assert header["kind"] == "body" and np.abs(np.linalg.norm(normals, axis=1) - 1).max() < 1e-3
    trunk = (np.abs(positions[:, 1] - 110) < 15) & (np.abs(positions[:, 0]) < 15)
    assert (normals[trunk, 2] * positions[trunk, 2] > 0).mean() > 0.8


def test_normals_of_a_tetrahedron():
    corners = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    normals = smooth_normals(corners, faces)
    middle = corners.mean(axis=0)
    assert ((corners - middle) * normals).sum(axis=1).min() > 0


def test_what_ships_is_sound_and_small():
    examples = shipped_examples()
    assert 6 <= len(examples) <= 10
    assert sum(path.stat().st_size for path in FOLDER.iterdir()) < 1_500_000
    for name, example in examples.items():
        garment = garment_of(example.mesh)
        assert [p.name for p in garment.pattern.panels] == list(
            example.document["pattern"]["pattern"]["panels"]
        ), name
        assert len(example.document["mesh"]) == 32 and example.document["mesh"] == example.mesh.name
        assert example.document["quality"]["accepted"], name
        assert example.document["body"] == shipped_body().name
        assert example.thumbnail[8:12] == b"WEBP"


def test_the_shipped_options_are_the_program_s():
    from swifttailor.pattern.garmentcode_reader import MAX_EDGES, MAX_PANELS
    from swifttailor.studio.bench.claim_labels import claim_options, dimension_options
    from swifttailor.studio.shipped import shipped_options

    options = json.loads(json.dumps({"claims": claim_options(), "dimensions": dimension_options()}))
    shipped = shipped_options()
    stale = "stale: python scripts/make_studio_examples.py --words-only"
    assert shipped["claims"] == options["claims"] and shipped["dimensions"] == options["dimensions"], stale
    assert shipped["of_patterns"] == {"panels": MAX_PANELS, "edges": MAX_EDGES}, stale


def test_the_store_keeps_what_was_used_last():
    store = MeshStore(most_bytes=1000)
    for k in range(4):
        store.add(MeshRecord(str(k), bytes(400)))
        store.find("0")
    assert [store.find(str(k)) is not None for k in range(4)] == [True, False, False, True]
    assert store.size <= 1000

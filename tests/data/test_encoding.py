from __future__ import annotations

import dataclasses
import lzma
import tracemalloc

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from swifttailor.data.encoding import (
    STEP_CM,
    EncodedPositions,
    decode_document,
    decode_positions,
    encode_document,
    encode_positions,
    mesh_checksum,
    pack,
)
from swifttailor.data.sample import Sample, load_sample, store_sample
from swifttailor.errors import InputError
from swifttailor.garment.garment import Garment
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern import Arc, Edge, EdgeRef, Panel, Pattern, Placement, Quadratic, Stitch
from swifttailor.pattern.drafts import draft

POINTS = arrays(
    np.float64, st.tuples(st.integers(1, 40), st.just(3)), elements=st.floats(-3000, 3000, width=32)
)


@given(POINTS)
def test_positions_come_back_within_half_a_step(points):
    encoded = encode_positions(points)
    back = decode_positions(encoded)
    assert back.shape == points.shape
    assert np.abs(back - points).max() <= encoded.step / 2 * (1 + 1e-9) + 1e-12
    if np.ptp(points, axis=0).max() <= 655:
        assert encoded.step == STEP_CM
    again = encode_positions(back)
    assert np.abs(decode_positions(again) - back).max() < 1e-9


def test_positions_against_plain_numbers():
    points = np.array([[0.0, 100.0, -5.0], [0.011, 99.0, -5.004], [655.35, 100.0, -5.02]])
    encoded = encode_positions(points)
    assert encoded.origin == (0.0, 99.0, -5.02) and encoded.step == 0.01 and encoded.count == 3
    expected = [[0.0, 100.0, -5.0], [0.01, 99.0, -5.0], [655.35, 100.0, -5.02]]
    np.testing.assert_allclose(decode_positions(encoded), expected, atol=1e-9)


@given(POINTS, st.integers(0, 10**6), st.integers(1, 255))
def test_damaged_positions_never_pass_for_others_of_that_size(points, place, change):
    encoded = encode_positions(points)
    data = bytearray(encoded.data)
    data[place % len(data)] ^= change
    try:
        back = decode_positions(dataclasses.replace(encoded, data=bytes(data)))
    except InputError:
        return
    assert back.shape == points.shape and np.isfinite(back).all()  # the shard's checksum tells these


def test_damaged_data_are_refused():
    with pytest.raises(InputError, match="damaged"):
        decode_positions(EncodedPositions(b"nonsense", (0, 0, 0), 0.01, 4))
    encoded = encode_positions(np.zeros((5, 3)))
    with pytest.raises(InputError, match="30 bytes for 6 vertices"):
        decode_positions(dataclasses.replace(encoded, count=6))
    with pytest.raises(InputError, match="damaged"):
        decode_document(encode_document({"a": 1})[:-8])


@pytest.mark.parametrize("content", [b"[" * 100_000, b'{"a":' * 100_000, b"null", b"{", b""])
def test_facts_that_are_no_object_are_refused(content):
    with pytest.raises(InputError, match="damaged"):
        decode_document(pack(content))


def test_what_unpacks_to_far_more_than_a_sample_is_refused_without_unpacking_it():
    quickly = {"id": lzma.FILTER_LZMA1, "preset": 0}  # as thoroughly as `pack` it takes ten seconds
    packed = lzma.compress(bytes(1 << 28), format=lzma.FORMAT_ALONE, filters=[quickly])
    assert len(packed) < 100_000
    tracemalloc.start()
    try:
        with pytest.raises(InputError, match="unpacks to more than"):
            decode_document(packed)
        assert tracemalloc.get_traced_memory()[1] < 1 << 28
    finally:
        tracemalloc.stop()


@pytest.mark.parametrize(
    "quality", [[], "good", {"reasons": "none"}, {"reasons": [1]}, {"reasons": 3}, {"top_cm": "140"}]
)
def test_a_quality_that_is_not_numbers_and_reasons_is_refused(quality):
    mesh = mesh_pattern(draft("fitted-skirt").canonical(), 8.0)
    garment = Garment(mesh, np.zeros((mesh.vertex_count, 3)))
    stored = store_sample(Sample.of_garment("a", garment, 8.0, {"quality": quality}))
    with pytest.raises(InputError, match="damaged"):
        load_sample(stored)


def test_documents_keep_every_digit():
    document = {"a": 0.1 + 0.2, "b": [1e-300, -0.0], "c": "Rüsche", "d": None}
    assert decode_document(encode_document(document)) == document
    assert encode_document(document) == encode_document(dict(document))


@pytest.mark.parametrize("name", ["t-shirt", "circle-skirt"])
def test_samples_come_back(name):
    pattern = draft(name).canonical()
    mesh = mesh_pattern(pattern, 6.0)
    vertices = np.random.default_rng(3).uniform(-40, 160, (mesh.vertex_count, 3))
    about = {"source": "drafts", "quality": {"accepted": True, "strain_p95": 0.1 / 3}}
    sample = Sample.of_garment("one", Garment(mesh, vertices), 6.0, about)
    stored = store_sample(sample)
    assert store_sample(sample) == stored
    back = load_sample(stored)
    assert back.pattern == pattern and back.pattern.name == "one" and back.id == "one"
    assert back.about == about and back.edge_length == 6.0
    assert np.abs(back.vertices - vertices).max() <= STEP_CM / 2 + 1e-9
    np.testing.assert_array_equal(back.mesh.flat_faces, mesh.flat_faces)
    np.testing.assert_array_equal(back.mesh.flat_vertices, mesh.flat_vertices)
    assert back.garment.report["quality"] == about["quality"]
    assert store_sample(back) == stored  # a second trip changes nothing


def test_the_reading_of_angles_is_kept():
    pattern = draft("tank-top").with_rotation_reading("extrinsic").canonical()
    mesh = mesh_pattern(pattern, 8.0)
    garment = Garment(mesh, np.zeros((mesh.vertex_count, 3)))
    back = load_sample(store_sample(Sample.of_garment("x", garment, 8.0, {})))
    assert {p.placement.reading for p in back.pattern.panels} == {"extrinsic"}


def test_a_mesh_that_was_not_draped_is_refused():
    pattern = draft("tank-top").canonical()
    mesh = mesh_pattern(pattern, 8.0)
    sample = Sample("x", pattern, 8.0, np.zeros((mesh.vertex_count, 3)), {}, mesh_checksum(mesh))
    assert sample.mesh.vertex_count == mesh.vertex_count
    with pytest.raises(InputError, match=r"'x': its panel mesh is not the one .* use the version"):
        _ = dataclasses.replace(sample, checksum="0" * 32).mesh
    with pytest.raises(InputError, match="panel mesh"):
        _ = dataclasses.replace(sample, vertices=np.zeros((5, 3))).mesh


def test_mesh_checksum_sees_every_part():
    mesh = mesh_pattern(draft("fitted-skirt"), 8.0)
    checksum = mesh_checksum(mesh)
    moved = mesh.flat_vertices.copy()
    moved[7, 1] += 0.002
    noise = mesh.flat_vertices * (1 + 1e-15)
    assert mesh_checksum(dataclasses.replace(mesh, flat_vertices=noise)) == checksum
    others = [
        {"flat_vertices": moved},
        {"flat_faces": mesh.flat_faces[::-1]},
        {"weld": mesh.weld[::-1]},
        {"flat_panel": mesh.flat_panel[::-1]},
    ]
    assert len({checksum, *(mesh_checksum(dataclasses.replace(mesh, **o)) for o in others)}) == 5


def test_panel_meshes_stay_as_they_are():
    """Data sets hold positions on panel meshes but not the meshes.

    If this fails, panels are meshed differently than before, and every data set that was built can no longer
    be read: think again, and if it must be, say so in CHANGELOG.md and docs/data.md.
    """
    corners = [[-20.0, 0.0], [20.0, 0.0], [26.0, 55.0], [-26.0, 55.0]]
    edges = (Edge(Quadratic((0.5, -0.1))), Edge(), Edge(Arc(40.0, False, True)), Edge())
    front = Panel("front", corners, edges, Placement((0.0, 80.0, 25.0)))
    mirrored = [[-x, y] for x, y in corners]
    back = Panel("back", mirrored, (Edge(), Edge(), Edge(), Edge()), Placement((0.0, 80.0, -25.0)))
    sides = (Stitch(EdgeRef("front", 1), EdgeRef("back", 1)), Stitch(EdgeRef("front", 3), EdgeRef("back", 3)))
    mesh = mesh_pattern(Pattern((front, back), sides).canonical(), 2.0)
    assert (mesh.vertex_count, len(mesh.faces)) == (1597, 3098)
    assert mesh_checksum(mesh) == "99766a219e610c97b826d51c80752468"

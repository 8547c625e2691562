"""Prints of garments: what reports state, what files and previews show."""

from __future__ import annotations

import json
import struct
from dataclasses import replace

import numpy as np
import pytest

import swifttailor
from swifttailor.garment.cloth_print import ClothPrint, cloth_at, flat_places, stated_print, texture
from swifttailor.garment.garment import Garment
from swifttailor.garment.glb import glb_bytes
from swifttailor.garment.hung_prints import HUNG
from swifttailor.garment.triangle_mesh import mesh_of_garment
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.render.color import encode_srgb

STRIPES = ClothPrint("stripes", ("#ff0000", "#ffffff"), {"width": 4.0, "gap": 4.0, "angle": 0.0})


@pytest.fixture(scope="module")
def garment():
    mesh = mesh_pattern(swifttailor.draft("circle-skirt"), 4.0)
    return Garment(mesh, np.zeros((mesh.vertex_count, 3)), print=STRIPES)


def test_a_report_states_a_print_and_is_read_back():
    for found in (
        STRIPES,
        ClothPrint("motif", ("#000000", "#ffffff", "#ff0000"), {"repeat": 9.0}, "flowers"),
        ClothPrint("motif", tuple(f"#00000{k}" for k in range(6)), {"repeat": 70.0}, "tie_dye"),
    ):
        assert stated_print(json.loads(json.dumps({"print": found.to_json()}))) == found


@pytest.mark.parametrize(
    "said",
    [
        None,
        "stripes",
        {"kind": "holes", "colors": ["#000000", "#ffffff"]},
        {"kind": "stripes", "colors": ["#000000"]},
        {"kind": "stripes", "colors": ["red", "#ffffff"]},
        {"kind": "stripes", "colors": ["#000000", "#ffffff"], "sizes": {"width": 0.0}},
        {"kind": "stripes", "colors": ["#000000", "#ffffff"], "sizes": {"width": float("nan")}},
        {"kind": "motif", "colors": ["#000000", "#ffffff"], "motif": "dragons"},
    ],
)
def test_what_cannot_be_drawn_is_no_print(said):
    assert stated_print({"print": said}) is None


def test_stripes_of_a_texture_have_their_width(garment):
    picture = texture(garment, 512).astype(int)
    red = (picture[:, :, 1] < 128).mean()
    assert abs(red - 0.5) < 0.1
    column = picture[:, 256, 1] < 128
    bands = np.count_nonzero(np.diff(column.astype(int)) == 1)
    assert abs(bands - garment.uv_scale / 8.0) <= 1.5, "a band and a gap every 8 cm"
    assert np.ptp(picture[256, :, 1]) < 60, "around the body a stripe goes on"


def test_the_file_holds_the_texture(garment):
    content = glb_bytes(mesh_of_garment(garment))
    length = struct.unpack_from("<I", content, 12)[0]
    document = json.loads(content[20 : 20 + length])
    material = document["materials"][0]["pbrMetallicRoughness"]
    assert material["baseColorTexture"] == {"index": 0, "texCoord": 0}
    assert material["baseColorFactor"] == [1.0] * 4
    view = document["bufferViews"][document["images"][0]["bufferView"]]
    start = 20 + length + 8 + view["byteOffset"]
    assert content[start : start + 4] == b"\x89PNG" and view["byteOffset"] % 4 == 0
    plain = glb_bytes(mesh_of_garment(replace(garment, print=None, cloth="silk")))
    bare = json.loads(plain[20 : 20 + struct.unpack_from("<I", plain, 12)[0]])
    assert "images" not in bare and bare["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"] == 0.6


def test_corners_of_faces_lie_on_the_cloth_at_its_scale(garment):
    at = cloth_at(garment)
    flat = garment.mesh.flat_vertices[garment.mesh.flat_faces]
    sides = np.linalg.norm(at - np.roll(at, 1, axis=1), axis=2)
    assert np.allclose(sides, np.linalg.norm(flat - np.roll(flat, 1, axis=1), axis=2), atol=1e-6)


def test_stripes_meet_where_halves_are_sewn_together():
    mesh = mesh_pattern(swifttailor.draft("t-shirt"), 3.0)
    garment = Garment(mesh, np.zeros((mesh.vertex_count, 3)), print=STRIPES)
    heights = np.zeros(len(mesh.flat_vertices))
    heights[mesh.flat_faces] = cloth_at(garment)[:, :, 1]
    names = [panel.name for panel in mesh.pattern.panels]
    left, right = (mesh.flat_panel == names.index(f"{side}_ftorso") for side in ("left", "right"))
    shared = np.intersect1d(mesh.weld[left], mesh.weld[right])
    assert len(shared) > 10
    for welded in shared:
        a, b = (heights[(mesh.weld == welded) & half][0] for half in (left, right))
        assert a == pytest.approx(b, abs=0.02)


def test_prints_go_on_over_the_middle_of_front_and_back():
    mesh = mesh_pattern(swifttailor.draft("t-shirt"), 3.0)
    places = flat_places(Garment(mesh, np.zeros((mesh.vertex_count, 3)), print=STRIPES))
    names = [panel.name for panel in mesh.pattern.panels]
    for side in "fb":
        halves = [mesh.flat_panel == names.index(f"{half}_{side}torso") for half in ("left", "right")]
        for welded in np.intersect1d(*[mesh.weld[half] for half in halves]):
            there = [places[(mesh.weld == welded) & half][0] for half in halves]
            assert np.allclose(there, (0.0, there[0][1]), atol=0.05)
    sleeve = mesh.flat_panel == names.index("left_sleeve_f")
    assert places[sleeve, 0].min() == pytest.approx(-places[sleeve, 0].max())


@pytest.mark.parametrize("motif", sorted(HUNG))
def test_what_fades_goes_once_over_all_panels_as_they_are_worn(motif):
    mesh = mesh_pattern(swifttailor.draft("shift-dress"), 4.0)
    panels = mesh.pattern.panels
    world = np.zeros((mesh.vertex_count, 3))
    for k, panel in enumerate(panels):
        own = mesh.flat_panel == k
        world[mesh.weld[own]] = panel.to_world(mesh.flat_vertices[own])
    between = {"two_blocks": (), "four_blocks": ("#404040", "#a0a0a0")}.get(motif, ("#808080",))
    fading = ClothPrint("motif", ("#000000", *between, "#ffffff"), {"repeat": 100.0}, motif)
    garment = Garment(mesh, world, print=fading)
    height = world[mesh.weld, 1]
    places = flat_places(garment)
    assert np.allclose(places[:, 1] / 50.0, (height - height.min()) / np.ptp(height))
    shown = fading.drawn(grain=0.0).colors(places)[:, 0]
    assert shown[height.argmin()] > 0.9 and shown[height.argmax()] < 0.05, "the last colour below"
    assert not np.allclose(places, flat_places(garment, as_worn=False))
    # The picture of a panel shows the same as its vertices, but for seams that are bent in space.
    side = 512
    picture = texture(garment, side).astype(float)
    row, column = (
        np.clip((at * side).astype(int), 0, side - 1) for at in (1 - garment.uv[:, 1], garment.uv[:, 0])
    )
    away = np.abs(picture[row, column, 0] / 255.0 - encode_srgb(fading.drawn().colors(places))[:, 0] / 255.0)
    assert np.median(away) < 0.05

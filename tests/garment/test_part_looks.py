from __future__ import annotations

import io
import json
import struct
from dataclasses import replace

import numpy as np
import pytest
from sewn_tube import tube_garment

import swifttailor
from swifttailor.body import Body
from swifttailor.garment.cloth_print import ClothPrint
from swifttailor.garment.cloth_surfaces import cloth_surfaces
from swifttailor.garment.formats import read_garment_mesh
from swifttailor.garment.garment import Garment
from swifttailor.garment.glb import glb_bytes
from swifttailor.garment.lace import lace_opacity
from swifttailor.garment.part_looks import (
    LOOKS,
    OPACITIES,
    PARTS,
    PartLook,
    has_part,
    looks_of_panels,
    merged,
    panels_of,
    plain_but_for,
    stated_looks,
)
from swifttailor.garment.preview import draw_preview, trim_surfaces
from swifttailor.garment.triangle_mesh import mesh_of_garment
from swifttailor.garment.trim_colors import trim_color
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.drafts import draft
from swifttailor.render.color import encode_srgb, to_linear

WHITE_BAND, SHEER_SKIRT = PartLook("waistband", "#ffffff"), PartLook("skirt", None, "mesh")
LACE_SKIRT = PartLook("skirt", None, "lace")


@pytest.fixture(scope="module")
def skirt() -> Garment:
    """A tube of which the front is a skirt and the back a waistband."""
    return replace(tube_garment(front="skirt_front", back="wb_back"), color="#203080")


@pytest.fixture(scope="module")
def body() -> Body:
    return Body.default()


def face_colors(garment: Garment) -> dict[tuple[int, ...], tuple[float, ...]]:
    """Colour of each face, by its vertices."""
    found = {}
    for part in cloth_surfaces(garment):
        colors = np.broadcast_to(part.surface.color, part.surface.faces.shape)
        found |= {tuple(f): tuple(c) for f, c in zip(part.surface.faces.tolist(), colors, strict=True)}
    return found


def test_panels_are_told_by_what_they_are():
    shirt = draft("shirt")
    assert set(panels_of(shirt, "cuffs")) == {p.name for p in shirt.panels if "_cuff_" in p.name}
    assert set(panels_of(shirt, "cuffs")) < set(panels_of(shirt, "sleeves"))
    assert set(panels_of(shirt, "left_sleeve")) == {n for n in panels_of(shirt, "sleeves") if "left" in n}
    collar = set(panels_of(shirt, "collar"))
    assert collar == {p.name for p in shirt.panels if "collar" in p.name}
    assert set(panels_of(shirt, "all")) == {p.name for p in shirt.panels}
    assert not panels_of(shirt, "hood") and not has_part(shirt, "hood")
    assert set(panels_of(draft("skater-dress"), "skirt")) == {"skirt_front", "skirt_back"}


def test_what_is_put_on_is_a_part_where_it_is_put_on():
    shirt = draft("shirt")
    assert not has_part(shirt, "buttons")
    assert has_part(replace(shirt, trims=("button placket",)), "buttons")


@pytest.mark.parametrize("part", [part for part in PARTS if part not in ("all", "bodice")])
def test_faces_of_other_parts_are_drawn_as_before(skirt, part):
    before = face_colors(skirt)
    for cloth, opacity in ((None, None), ("mesh", None), ("lace", None), ("lace", 1.0)):
        after = face_colors(replace(skirt, looks=(PartLook(part, "#ffcc00", cloth, opacity),)))
        own = set(panels_of(skirt.pattern, part))
        others = [skirt.pattern.panels[p].name not in own for p in skirt.mesh.face_panel]
        assert before.keys() == after.keys()
        for face in skirt.faces[others].tolist():
            assert before[tuple(face)] == after[tuple(face)]
        for face in skirt.faces[~np.array(others)].tolist():
            assert before[tuple(face)] != after[tuple(face)]


def test_the_part_that_says_more_wins_whatever_comes_first(skirt):
    wide = PartLook("all", "#112233", "mesh")
    for looks in ((wide, WHITE_BAND), (WHITE_BAND, wide)):
        front, band = looks_of_panels(replace(skirt, looks=looks))
        assert (front.color, band.color) == ("#112233", "#ffffff")
        assert front.is_sheer and band.is_sheer, "a band that is white is of the same cloth"


def test_dark_cloth_hides_more_than_light_cloth_of_the_same_yarn(skirt):
    shares = [
        looks_of_panels(replace(skirt, color=color, looks=(SHEER_SKIRT,)))[0].opacity
        for color in ("#ffffff", "#808080", "#000000")
    ]
    assert OPACITIES["mesh"] == pytest.approx(shares[0])
    assert shares == sorted(shares) and shares[2] == pytest.approx(1 - (1 - OPACITIES["mesh"]) ** 2)


def test_sheer_cloth_is_seen_between_all_and_none_of_it(skirt, body):
    drawn = {
        share: draw_preview(
            replace(skirt, looks=(replace(SHEER_SKIRT, opacity=share),)), body, size=(420, 260)
        )
        for share in (0.0, 0.3, 0.6, 1.0)
    }
    assert np.array_equal(drawn[1.0], draw_preview(skirt, body, size=(420, 260)))
    none, some, more, whole = (drawn[share].astype(int) for share in drawn)
    low, high = np.minimum(none, whole), np.maximum(none, whole)
    changed = np.abs(none - whole).max(axis=2) > 40
    assert changed.mean() > 0.02
    # Where the far side of the tube is seen through the near one, it may be darker than both.
    inside = ((some >= low - 3) & (some <= high + 3)).all(axis=2)
    assert inside[changed].mean() > 0.9
    apart = [np.abs(picture - whole)[changed].mean() for picture in (none, some, more)]
    assert apart[0] > apart[1] > apart[2] > 0.5


def test_lace_lets_more_through_between_its_figures(skirt, body):
    even = PartLook("skirt", None, "net", OPACITIES["lace"])
    nets = [
        draw_preview(replace(skirt, looks=(look,)), body, size=(900, 560)).astype(float)
        for look in (LACE_SKIRT, even)
    ]
    opaque = draw_preview(skirt, body, size=(900, 560)).astype(float)
    bare = [np.abs(net - opaque).mean() for net in nets]
    assert 0.2 * bare[1] < bare[0] < 0.9 * bare[1]
    places = np.random.default_rng(1).uniform(0, 26, (4000, 2))
    shares = lace_opacity(0.38).colors(places)[:, 0]
    assert shares.min() == pytest.approx(0.38, abs=0.02) and shares.max() > 0.9
    assert 0.1 < (shares < 0.5).mean() < 0.6


def test_looks_come_back_from_the_report_they_are_stated_in():
    looks = (WHITE_BAND, SHEER_SKIRT, PartLook("all", None, "lace", 1.0))
    report = json.loads(json.dumps({LOOKS: [look.to_json() for look in looks]}))
    assert stated_looks(report) == looks
    assert stated_looks({}) == stated_looks({LOOKS: "sleeves"}) == ()
    wrong = [
        *({"part": "knees"}, {"part": "skirt", "color": "red"}, {"part": "skirt", "cloth": "glass"}),
        *({"part": "skirt", "opacity": 1.5}, {"part": "skirt", "opacity": True}, "skirt", None),
    ]
    assert stated_looks({LOOKS: [*wrong, WHITE_BAND.to_json()]}) == (WHITE_BAND,)


def test_later_looks_outdo_earlier_ones():
    assert merged([WHITE_BAND], [PartLook("waistband", "#000000")]) == (PartLook("waistband", "#000000"),)
    both = merged([PartLook("skirt", "#000000")], [SHEER_SKIRT])
    assert both == (PartLook("skirt", "#000000", "mesh"),)
    opaque = PartLook("all", None, "opaque")
    assert merged([SHEER_SKIRT, PartLook("waistband", "#ffffff", "lace")], [opaque]) == (WHITE_BAND,)
    assert merged([], [opaque]) == ()


def test_a_saved_garment_keeps_its_looks(skirt, tmp_path, body):
    looks = (WHITE_BAND, SHEER_SKIRT)
    report = skirt.report | {"edge_length_cm": 3.0, LOOKS: [look.to_json() for look in looks]}
    replace(skirt, looks=looks, report=report).save(tmp_path / "skirt", body=body, preview=False)
    assert Garment.load(tmp_path / "skirt").looks == looks


def glb_document(content: bytes) -> tuple[dict, bytes]:
    length = struct.unpack("<I", content[12:16])[0]
    return json.loads(content[20 : 20 + length]), content[28 + length :]


def materials(garment: Garment) -> dict[str, dict]:
    """The material of each panel, by its name."""
    document, _ = glb_document(glb_bytes(mesh_of_garment(garment)))
    return {
        node["name"]: document["materials"][document["meshes"][node["mesh"]]["primitives"][0]["material"]]
        for node in document["nodes"]
        if node["name"] in ("skirt_front", "wb_back")
    }


def test_glb_files_have_a_material_for_each_look(skirt, tmp_path):
    plain = materials(skirt)
    assert plain["skirt_front"] == plain["wb_back"]
    dressed = replace(skirt, looks=(WHITE_BAND, SHEER_SKIRT))
    found = materials(dressed)
    assert found["wb_back"]["pbrMetallicRoughness"]["baseColorFactor"] == [1.0, 1.0, 1.0, 1.0]
    assert "alphaMode" not in found["wb_back"] and "alphaMode" not in plain["skirt_front"]
    assert found["skirt_front"]["alphaMode"] == "BLEND"
    *rgb, share = found["skirt_front"]["pbrMetallicRoughness"]["baseColorFactor"]
    assert rgb == plain["skirt_front"]["pbrMetallicRoughness"]["baseColorFactor"][:3]
    assert share == pytest.approx(looks_of_panels(dressed)[0].opacity, abs=1e-4)
    (tmp_path / "plain.glb").write_bytes(glb_bytes(mesh_of_garment(skirt)))
    (tmp_path / "dressed.glb").write_bytes(glb_bytes(mesh_of_garment(dressed)))
    one, other = (read_garment_mesh(tmp_path / name) for name in ("plain.glb", "dressed.glb"))
    assert np.array_equal(one.faces, other.faces) and np.array_equal(one.vertices, other.vertices)
    assert one.groups == other.groups


def test_lace_in_glb_files_is_a_texture_with_holes(skirt):
    from PIL import Image

    document, binary = glb_document(glb_bytes(mesh_of_garment(replace(skirt, looks=(LACE_SKIRT,)))))
    (image,) = document["images"]
    view = document["bufferViews"][image["bufferView"]]
    content = binary[view["byteOffset"] : view["byteOffset"] + view["byteLength"]]
    picture = np.asarray(Image.open(io.BytesIO(content)))
    assert picture.shape[2] == 4
    assert (picture[:, :, :3] == encode_srgb(to_linear(skirt.color))).all()
    assert picture[:, :, 3].min() < 180 < picture[:, :, 3].max()
    textured = [m for m in document["materials"] if "baseColorTexture" in m["pbrMetallicRoughness"]]
    assert [m["alphaMode"] for m in textured] == ["BLEND"]


def test_usd_files_bind_other_looks_to_their_panels(skirt, tmp_path):
    pytest.importorskip("pxr")
    from pxr import Usd, UsdShade

    from swifttailor.garment.usd import write_usd

    dressed = replace(skirt, looks=(WHITE_BAND, SHEER_SKIRT))
    stage = Usd.Stage.Open(str(write_usd(mesh_of_garment(dressed), tmp_path / "skirt.usda")))
    bound = {}
    for name in ("skirt_front", "wb_back"):
        subset = stage.GetPrimAtPath(f"/garment/cloth/{name}")
        material, _ = UsdShade.MaterialBindingAPI(subset).ComputeBoundMaterial()
        shader = UsdShade.Shader(stage.GetPrimAtPath(f"{material.GetPath()}/surface"))
        opacity = shader.GetInput("opacity")
        bound[name] = tuple(shader.GetInput("diffuseColor").Get()), opacity.Get() if opacity else 1.0
    assert bound["wb_back"] == ((1.0, 1.0, 1.0), 1.0)
    assert bound["skirt_front"][1] == pytest.approx(looks_of_panels(dressed)[0].opacity)


def test_what_is_put_on_has_its_own_colour_and_a_buckle_stays_metal(skirt):
    red = replace(skirt, looks=(PartLook("belt", "#ff0000"), WHITE_BAND))
    assert trim_color(red, "leather", trim="buckle belt").tolist() == pytest.approx([1.0, 0.01, 0.01])
    assert np.array_equal(trim_color(red, "metal", trim="buckle belt"), trim_color(skirt, "metal"))
    assert np.array_equal(trim_color(red, "button", trim="buttons"), trim_color(skirt, "button"))
    on_band, on_skirt = (trim_color(red, "cloth", panel=name) for name in ("wb_back", "skirt_front"))
    assert on_band.min() > 0.9 and np.array_equal(on_skirt, trim_color(skirt, "cloth"))


def test_legs_and_halves_are_told_by_the_sides_of_their_panels():
    trousers = swifttailor.draft("trousers")
    assert set(panels_of(trousers, "left_leg")) == {"pant_f_l", "pant_b_l"}
    assert set(panels_of(trousers, "right_half")) == {"pant_f_r", "pant_b_r"}


def test_a_print_may_be_on_one_part_alone(skirt):
    stripes = ClothPrint("stripes", ("#ff0000", "#00ff00"), {"width": 2.0, "gap": 2.0})
    looks = plain_but_for([PartLook("skirt", printed=True)], "#808080")
    garment = replace(skirt, print=stripes, looks=looks)
    assert [look.color for look in looks_of_panels(garment)] == [None, "#808080"]
    assert {(seen.surface.print is None) for seen in cloth_surfaces(garment)} == {True, False}
    assert stated_looks({LOOKS: [look.to_json() for look in looks]}) == looks
    sheer = merged(looks, [PartLook("skirt", None, "sheer")])
    seen = looks_of_panels(replace(garment, looks=sheer))[0]
    assert seen.color is None and seen.is_sheer
    red = merged(looks, [PartLook("skirt", "#ff0000")])
    assert looks_of_panels(replace(garment, looks=red))[0].color == "#ff0000"


def test_bands_around_a_garment_whose_sleeves_alone_are_printed_are_plain():
    pattern = draft("t-shirt", sleeve_length=20.0)
    mesh = mesh_pattern(replace(pattern, trims=("bands",)), 6.0)
    world = np.zeros((mesh.vertex_count, 3))
    for k, panel in enumerate(pattern.panels):
        own = mesh.flat_panel == k
        world[mesh.weld[own]] = panel.to_world(mesh.flat_vertices[own])
    looks = plain_but_for([PartLook("sleeves", printed=True)], "#808080")
    dots = ClothPrint("dots", ("#ff0000", "#00ff00"))
    garment = Garment(mesh, world, color="#808080", print=dots, looks=looks)
    assert all(surface.print is None for surface in trim_surfaces(garment))

"""Trims on sewn garments: their meshes, their files, their colours."""

from __future__ import annotations

import json
import struct
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import shapely
from cloth_distance import away_from_cloth
from scipy.spatial import KDTree
from sewn_tube import edge_counts

from swifttailor.garment.cloth_print import CUSHIONS, ClothPrint
from swifttailor.garment.garment import Garment
from swifttailor.garment.glb import glb_bytes
from swifttailor.garment.obj import obj_text
from swifttailor.garment.preview import trim_surfaces
from swifttailor.garment.triangle_mesh import mesh_of_garment
from swifttailor.garment.trim_colors import trim_color
from swifttailor.garment.trim_meshes import TrimMesh, trim_meshes
from swifttailor.garment.trim_parts import trim_parts
from swifttailor.garment_sewer.sewer import GarmentSewer
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.names import body_region
from swifttailor.pattern.trims import TRIMS, Belt, Button, place_trims, trims_that_fit

DRAFTS = ("shirt", "coat", "jeans", "joggers", "hoodie", "dungarees", "shirt-dress", "circle-skirt")
DENSE = ("shirt", "jeans", "shirt-dress")
"""Of which the cloth is sampled densely, which takes seconds; between them they have every piece."""
BUTTONED = ("shirt", "coat", "shirt-dress", "circle-skirt")
BELTS = ("tie belt", "buckle belt", "sash", "side tie")
BELTED = ("coat", "jeans", "shirt-dress", "circle-skirt")
APRON = "apron"
FLAT = (
    "edging",
    "piping",
    "bands",
    "narrow bands",
    "lace trim",
    "neck lace",
    "fur trim",
    "neck fur",
    "sleeve fur",
    "neck rib",
    "armhole ribs",
    "hem rib",
    "knit bands",
    "side stripes",
    "satin stripes",
    "sleeve stripes",
    "sleeve turn-ups",
)
"""What lies on the cloth along its edges; frills, fringe and bows stand off."""
STAND_OFF = (
    *("neck frill", "sleeve frills", "hem frill", "hem fringe", "neck bow", "waist bow", "shoulder bows"),
    *("train", "long train", "overskirt", "tulle overskirt", "tulle layers", "peplum", "back cape"),
    *("bustle", "hoops", "outer skirt", "shoulder frills"),
    *("neck gathers", "cowl folds", "draped folds", "sash", "hip knot", "nape bow", "side tie"),
    *("stirrups", "frayed hem", "back bow", "back ties", "front frills", "waist frill", "scalloped edge"),
)
ON_CLOTH, LIFTED = 0.1, (0.1, 0.8)
"""Of vertices where a piece is brought down to the cloth, and of the others, cm."""


@cache
def worn(name: str) -> Garment:
    """A draft with every trim that finds a place, as it hangs on the body coarsely."""
    sewer = GarmentSewer.load(Path(__file__).parents[1] / "garment_sewer" / "tiny_sewer.onnx")
    pattern = draft(name)
    trims = [name for name in TRIMS if name != APRON]  # under which no buttons are seen
    return sewer.sew(replace(pattern, trims=trims_that_fit(pattern, trims)))


def with_trims(garment: Garment, *names: str) -> Garment:
    """The same garment with other trims."""
    mesh = replace(garment.mesh, pattern=replace(garment.pattern, trims=names))
    return replace(garment, mesh=mesh)


def areas(mesh: TrimMesh) -> np.ndarray:
    a, b, c = (mesh.vertices[mesh.faces[:, k]] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


@pytest.mark.parametrize("name", DRAFTS)
def test_meshes_are_sound(name):
    garment = worn(name)
    meshes = trim_meshes(garment)
    assert {mesh.trim for mesh in meshes} == set(garment.pattern.trims)
    for mesh in meshes:
        assert np.isfinite(mesh.vertices).all() and mesh.vertices.shape[1] == 3
        assert mesh.faces.dtype == np.int32 and mesh.faces.min() == 0
        assert mesh.faces.max() < len(mesh.vertices)
        assert areas(mesh).min() > 1e-6, f"{mesh.trim} ({mesh.look}) has degenerate triangles"
        assert len(mesh.lines) == 0 or mesh.lines.max() < len(mesh.vertices)
        assert mesh.cloth_at is None or mesh.cloth_at.shape == (len(mesh.faces), 3, 2)


@pytest.mark.parametrize("name", DENSE)
def test_pieces_lie_on_the_cloth(name):
    garment = worn(name)
    pieces = [m for m in trim_meshes(garment) if "belt" not in m.trim and m.look != "button"]
    pieces = [m for m in pieces if m.trim not in (*STAND_OFF, *FLAT)]
    assert pieces
    for mesh in pieces:
        away = away_from_cloth(garment, mesh.vertices)
        lifted = away > ON_CLOTH
        # Half of the points are lifted; of quilting, which lies low, some sink into folds.
        assert lifted.mean() > (0.3 if mesh.trim == "quilting" else 0.4), mesh.trim
        assert LIFTED[0] <= away[lifted].min() and away.max() <= LIFTED[1], mesh.trim


@pytest.mark.parametrize("name", BUTTONED)
def test_buttons_face_away_from_the_body(name):
    garment = worn(name)
    unbelted = tuple(trim for trim in garment.pattern.trims if trim not in BELTS)  # a belt hides some
    garment = with_trims(garment, *unbelted)
    buttons = [mesh for mesh in trim_meshes(garment) if mesh.look == "button"]
    assert len(buttons) == sum(isinstance(trim, Button) for trim in place_trims(garment.pattern))
    for mesh in buttons:
        if mesh.trim == "diagonal closing":  # runs on to the armhole, where cloth turns away
            continue
        a, b, c = (mesh.vertices[mesh.faces[:, k]] for k in range(3))
        facing = np.cross(b - a, c - a).sum(axis=0)
        middle = mesh.vertices.mean(axis=0)
        outward = middle * (1, 0, 1)
        assert facing @ outward > 0 and (facing[2] < 0) == (mesh.trim in ("back buttons", "back keyhole"))
        away = away_from_cloth(garment, mesh.vertices)
        assert away.max() < 1.35 and away[-1] > 0.1  # on a band that lies over the other front


@pytest.mark.parametrize("trim", ["tie belt", "buckle belt"])
@pytest.mark.parametrize("name", BELTED)
def test_a_belt_goes_around_the_cloth_and_is_closed(name, trim):
    garment = with_trims(worn(name), trim)
    (belt,) = (t for t in place_trims(garment.pattern) if isinstance(t, Belt))
    band, *closing = trim_meshes(garment)
    assert closing and {mesh.trim for mesh in closing} == {trim}
    counts = edge_counts(band.faces)
    rows = np.unique(np.round(band.vertices[:, 1], 6))
    assert set(counts) == {1, 2} and len(rows) == 3
    assert np.ptp(rows) == pytest.approx(belt.width)
    per_row, found = len(band.vertices) // 3, 0
    assert (counts == 1).sum() == 2 * per_row  # its upper and lower edge alone are open
    for start, y in enumerate(rows):
        ring = shapely.Polygon(band.vertices[start * per_row : (start + 1) * per_row][:, [0, 2]])
        assert ring.is_valid
        trunk = [body_region(p.name, p.label) != "arm" for p in garment.pattern.panels]
        points = garment.flat_positions[np.array(trunk)[garment.mesh.flat_panel]]
        level = points[np.abs(points[:, 1] - y) <= 0.3][:, [0, 2]]
        found += len(level)
        assert shapely.contains_xy(ring, level).all()
    assert found > 15


def test_a_pocket_follows_the_print_below_it():
    """Its corners have the places on the cloth of the points that it lies on."""
    garment = with_trims(worn("circle-skirt"), "patch pockets")
    (mesh, *_) = (m for m in trim_meshes(garment) if m.look == "cloth")
    assert mesh.cloth_at is not None
    size = np.ptp(mesh.cloth_at.reshape(-1, 2), axis=0)
    assert (np.abs(size - (14.0, 15.5)) < 2.0).all()


def document_of(content: bytes) -> dict:
    length = struct.unpack_from("<I", content, 12)[0]
    return json.loads(content[20 : 20 + length])


@pytest.mark.parametrize("name", ["coat", "jeans"])
def test_glb_holds_them_as_nodes_of_their_own(name):
    garment = worn(name)
    document = document_of(glb_bytes(mesh_of_garment(garment)))
    nodes = document["nodes"]
    (group,) = (node for node in nodes if node.get("name") == "trims")
    children = [nodes[k] for k in group["children"]]
    assert all(node["extras"] == {"role": "trim"} for node in children)
    parts = trim_parts(garment)
    assert [node["name"] for node in children] == [part.name for part in parts]
    assert {part.name.rpartition(" (")[0] for part in parts} == set(garment.pattern.trims)
    assert sum(node.get("extras", {}).get("role") == "trim" for node in nodes) == len(parts)
    reached = {k for node in nodes for k in node.get("children", ())} | set(document["scenes"][0]["nodes"])
    assert reached == set(range(len(nodes)))
    for node, part in zip(children, parts, strict=True):
        (primitive,) = document["meshes"][node["mesh"]]["primitives"]
        assert document["accessors"][primitive["indices"]]["count"] == 3 * len(part.faces)
        assert document["materials"][primitive["material"]]["name"] == part.name


@pytest.mark.parametrize("name", ["coat", "jeans"])
def test_saved_and_loaded_it_is_the_same_garment(name, tmp_path):
    garment = worn(name)
    garment.save(tmp_path / "out", preview=False)
    loaded = Garment.load(tmp_path / "out")
    np.testing.assert_allclose(loaded.vertices, garment.vertices, atol=1e-4)
    np.testing.assert_array_equal(loaded.faces, garment.faces)
    assert loaded.pattern == garment.pattern and loaded.pattern.trims == garment.pattern.trims
    for one, other in zip(trim_meshes(loaded), trim_meshes(garment), strict=True):
        np.testing.assert_allclose(one.vertices, other.vertices, atol=1e-2)


def test_obj_holds_none():
    garment = worn("jeans")
    bare = with_trims(garment)
    assert obj_text(mesh_of_garment(garment)) == obj_text(mesh_of_garment(bare))


def test_without_trims_the_file_is_as_it_was():
    bare = with_trims(worn("jeans"))
    mesh = mesh_of_garment(bare)
    assert mesh.trims == () and trim_meshes(bare) == [] and trim_surfaces(bare) == []
    content = glb_bytes(mesh)
    document = document_of(content)
    assert not any("trim" in json.dumps(node) for node in document["nodes"])
    assert content == glb_bytes(replace(mesh_of_garment(worn("jeans")), trims=()))


@pytest.mark.parametrize("color", ["#f4f1e8", "#101014"])
def test_trims_stand_out_from_cloth_of_any_colour(color):
    """Lines and buttons are lighter on dark cloth and darker on light; nothing leaves the range of light."""
    garment = replace(with_trims(worn("shirt"), "button placket", "chest pocket"), color=color)
    by_look = {part.name.rpartition(" (")[2]: part.color for part in trim_parts(garment)}
    grey = {look: sum(int(value[k : k + 2], 16) for k in (1, 3, 5)) for look, value in by_look.items()}
    assert set(grey) == {"cloth)", "dark)", "button)"}
    dark = color == "#101014"
    assert (grey["dark)"] > grey["cloth)"]) == dark
    assert (grey["button)"] > grey["cloth)"]) == dark
    for surface in trim_surfaces(garment):
        assert (np.asarray(surface.color) >= 0).all() and (np.asarray(surface.color) <= 1).all()
        assert all((line.strength < 0) == dark for line in surface.lines)


@pytest.mark.parametrize(("color", "brown"), [("#18181b", False), ("#2f4d8a", True)])
def test_a_leather_belt_on_black_cloth_is_black(color, brown):
    red, _, blue = trim_color(replace(with_trims(worn("coat")), color=color), "leather")
    assert (red > 2.0 * blue) == brown


@pytest.mark.parametrize(
    ("name", "trim", "reach"),
    [("shirt", "neck frill", 4.0), ("shirt", "sleeve frills", 5.0), ("circle-skirt", "hem frill", 8.0)],
)
def test_frills_begin_at_their_edge_and_go_on_beyond_it(name, trim, reach):
    garment = with_trims(worn(name), trim)
    (frill,) = place_trims(garment.pattern)
    ends = {
        int(garment.mesh.weld[flat])
        for ref in frill.edges
        for flat in garment.mesh.edge_vertices[garment.pattern.panel_index(ref.panel)][ref.edge]
    }
    edge = KDTree(garment.vertices[sorted(ends)])
    meshes = trim_meshes(garment)
    assert meshes
    for mesh in meshes:
        away, _ = edge.query(mesh.vertices)
        assert away.min() < 1.0 and 0.6 * reach < away.max() < 1.6 * reach
        assert areas(mesh).min() > 1e-6


def test_frills_stand_off_evenly_where_the_cloth_is_uneven():
    """As they do from smooth cloth: each fold at the edge would throw up a point of its own."""
    smooth = with_trims(worn("shirt"), "neck frill")
    noise = np.random.default_rng(1).normal(scale=0.15, size=smooth.vertices.shape)
    uneven = replace(smooth, vertices=smooth.vertices + noise)
    apart = []
    for one, other in zip(trim_meshes(smooth), trim_meshes(uneven), strict=True):
        away, _ = KDTree(one.vertices).query(other.vertices)
        apart.append(float(np.quantile(away, 0.95)))
    assert max(apart) < 0.68


def test_flat_strips_lie_on_the_cloth():
    garment = with_trims(worn("shirt-dress"), "edging")
    for mesh in trim_meshes(garment):
        away = away_from_cloth(garment, mesh.vertices)
        assert np.median(away) < 1.0 and away.max() < 3.0


def test_an_apron_lies_over_the_buttons_of_its_skirt():
    seen = {mesh.trim for mesh in trim_meshes(with_trims(worn("circle-skirt"), "buttons", APRON))}
    assert seen == {APRON}


def test_a_belt_slips_to_where_the_sewn_cloth_is_narrowest():
    garment = with_trims(worn("shirt-dress"), "tie belt")
    band = trim_meshes(garment)[0].vertices
    garment = replace(garment, vertices=garment.vertices + np.array([0.0, -6.0, 0.0]))  # it hangs lower
    lower = trim_meshes(garment)[0].vertices
    assert band[:, 1].mean() - lower[:, 1].mean() == pytest.approx(6.0, abs=2.0)


@pytest.mark.parametrize("name", ["robe", "kaftan"])
def test_a_belt_stays_at_the_waist_of_cloth_that_only_widens_downwards(name):
    garment = with_trims(worn(name), "tie belt")
    (belt,) = (t for t in place_trims(garment.pattern) if isinstance(t, Belt))
    assert trim_meshes(garment)[0].vertices[:, 1].mean() == pytest.approx(belt.height)


def test_stirrups_run_from_the_ends_of_the_legs_under_the_feet():
    garment = with_trims(worn("jeans"), "stirrups")
    straps = trim_meshes(garment)
    assert len(straps) == 2
    for strap, side in zip(straps, (1, -1), strict=True):
        assert strap.vertices[:, 1].min() < 0.0 < strap.vertices[:, 1].max()
        assert (side * strap.vertices[:, 0]).min() > 0.0
        assert areas(strap).min() > 0.1


def test_cushions_that_are_drawn_have_the_lines_of_quilting():
    garment = with_trims(worn("bomber-jacket"), "quilting")
    cushions = ClothPrint("motif", ("#111725", "#1f2a44", "#2d3d62"), {"repeat": 34.0}, CUSHIONS)
    assert trim_surfaces(garment) and not trim_surfaces(replace(garment, print=cushions))
    assert trim_surfaces(replace(garment, print=cushions), "#ab252e"), "in another colour nothing is printed"


@pytest.mark.parametrize(
    ("color", "copper"), [("#3b5578", True), ("#a9c3dc", True), ("#18181b", False), ("#f7f5ef", False)]
)
def test_stitches_are_of_copper_on_blue_denim_alone(color, copper):
    red, _, blue = trim_color(replace(worn("jeans"), color=color), "dark", trim="topstitching")
    assert (red > 2.0 * blue) == copper

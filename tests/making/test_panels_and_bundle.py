"""Flat panels with sewing springs, bundles for garment CAD, prints on cloth."""

from __future__ import annotations

import csv
import io
import json
import zipfile
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from benchmarks.sewing_files import seams_lost
from benchmarks.small_dxf import read_dxf
from swifttailor.errors import InputError, PatternError
from swifttailor.garment import Garment
from swifttailor.garment.formats import read_garment_mesh, write_garment_mesh
from swifttailor.garment.seam_names import read_seam_name
from swifttailor.garment.triangle_mesh import mesh_of_garment
from swifttailor.making import cutting_plan
from swifttailor.making.bundle import write_bundle
from swifttailor.making.cloth_print import cloth_print, places_on_cloth
from swifttailor.making.flat_panels import flat_panels, write_panels
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern import EdgeRef, Stitch, read_specification


def test_springs_join_the_points_that_are_sewn(shipped_patterns, tmp_path):
    pattern = shipped_patterns["gc_1000272"].canonical()
    mesh = read_garment_mesh(write_panels(pattern, tmp_path / "p.obj", edge_length=4.0))
    springs: dict[int, list[np.ndarray]] = {}
    for name, line in zip(mesh.line_names, mesh.lines, strict=True):
        number, stitch = read_seam_name(name)
        assert stitch == pattern.stitches[number] and len(line) == 2
        springs.setdefault(number, []).append(mesh.vertices[line] * 100.0)
    assert set(springs) == set(range(len(pattern.stitches)))
    for number, pairs in springs.items():
        for ends, ref in zip(np.array(pairs).transpose(1, 0, 2), pattern.stitches[number].sides, strict=True):
            panel = pattern.panel(ref.panel)
            edge = panel.to_world(panel.sample_edge(ref.edge, 4001))
            away = np.linalg.norm(ends[:, None] - edge[None], axis=2).min(axis=1)
            assert away.max() < 0.1
            # From one end of the edge to the other (but for the point of a dart, which is one vertex).
            length = panel.edge_length(ref.edge)
            reach = np.linalg.norm(ends[0] - ends[-1])
            assert reach > 0.5 * np.linalg.norm(edge[0] - edge[-1]) - 0.1 or length < 4.0
    assert mesh.groups == tuple(p.name for p in pattern.panels)


def test_every_seam_is_found_again_in_all_formats(shipped_plans):
    for name in ("gc_1000067", "gc_1000272", "gc_1003940"):
        seams, lost = seams_lost(shipped_plans[name])
        assert seams == len(shipped_plans[name].sewn.pattern.stitches) and lost == 0


def test_unsewable_patterns_have_no_springs(skirt):
    dangling = replace(skirt, stitches=(Stitch(EdgeRef("skirt_front", 1), EdgeRef("none", 0)),))
    with pytest.raises(PatternError, match="cannot be sewn"):
        flat_panels(dangling)


def test_a_bundle_holds_what_cad_programs_need(shipped_plans, tmp_path):
    plan = shipped_plans["gc_1000272"]
    path = write_bundle(plan, tmp_path / "b.zip", edge_length=4.0)
    with zipfile.ZipFile(path) as bundle:
        files = {name: bundle.read(name).decode() for name in bundle.namelist()}
        assert all(info.date_time[0] == 1980 for info in bundle.infolist())
    assert all(name in files["README.txt"] for name in files if name != "README.txt")
    pattern = read_specification(json.loads(files["pattern.json"])).pattern.canonical()
    assert pattern.stitches == plan.sewn.pattern.stitches
    rows = list(csv.DictReader(io.StringIO(files["seams.csv"])))
    assert len(rows) == len(pattern.stitches)
    blocks, _ = read_dxf(files["cut-lines-astm.dxf"])
    labels = {e.text for b in blocks.values() for e in b.on(15, "TEXT") if e.text.startswith("Seam ")}
    for row in rows:
        stitch = pattern.stitches[int(row["stitch"])]
        assert read_seam_name(row["name"]) == (int(row["stitch"]), stitch)
        assert float(row["first_length_cm"]) == pytest.approx(pattern.edge_length(stitch.first), abs=1e-3)
        assert f"g {row['name']}\n" in files["panels.obj"]
        assert row["kind"] == "darts" or f"Seam {row['number_on_pieces']}" in labels
    bare, _ = read_dxf(files["sew-lines-astm.dxf"])
    for name, block in bare.items():
        assert np.abs(np.ptp(block.outline(1), axis=0) - np.ptp(blocks[name].outline(14), axis=0)).max() < 0.1
    assert write_bundle(plan, tmp_path / "again.zip", edge_length=4.0).read_bytes() == path.read_bytes()


@pytest.fixture(scope="module")
def worn(shipped_patterns) -> Garment:
    """Not draped: its panels, sewn where they stand."""
    pattern = shipped_patterns["gc_1000272"].canonical()
    mesh = mesh_pattern(pattern, 4.0)
    flat = np.concatenate(
        [p.to_world(mesh.flat_vertices[mesh.flat_panel == k]) for k, p in enumerate(pattern.panels)]
    )
    return Garment(mesh, mesh.welded_mean(flat))


@pytest.fixture
def picture(tmp_path):
    path = tmp_path / "print.png"
    Image.new("RGB", (40, 20), "red").save(path)
    return path


def test_prints_have_their_true_size_and_are_not_mirrored(worn, picture):
    printed = cloth_print(worn, picture, 8.0)
    places = places_on_cloth(worn)
    np.testing.assert_allclose(printed.repeats * (8.0, 4.0), places)
    for a, b in ((0, 1), (1, 2)):
        flat = np.linalg.norm(
            np.diff(worn.mesh.flat_vertices[worn.mesh.flat_faces[:, [a, b]]], axis=1)[:, 0], axis=1
        )
        cloth = np.linalg.norm(np.diff(places[worn.mesh.flat_faces[:, [a, b]]], axis=1)[:, 0], axis=1)
        np.testing.assert_allclose(flat, cloth, atol=1e-9)
    corners = places[worn.mesh.flat_faces]
    one, two = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    assert (one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0] > 0).all()  # anticlockwise, seen from outside


def test_prints_meet_at_the_side_seams(worn):
    """A stripe across the front goes on across the back, where both panels' sides are equally long."""
    places, pattern = places_on_cloth(worn), worn.pattern
    front, back = pattern.panel_index("left_ftorso"), pattern.panel_index("left_btorso")
    for stitch in pattern.stitches:
        if {s.panel for s in stitch.sides} == {"left_ftorso", "left_btorso"} and pattern.edge_length(
            stitch.first
        ) > 20:
            runs = {
                s.panel: worn.mesh.edge_vertices[pattern.panel_index(s.panel)][s.edge] for s in stitch.sides
            }
            heights = {name: np.sort(places[run, 1]) for name, run in runs.items()}
            np.testing.assert_allclose(heights["left_ftorso"], heights["left_btorso"], atol=2.0)
            break
    else:
        raise AssertionError("there is no side seam")
    assert front != back


@pytest.mark.parametrize("ending", ["glb", "usdz"])
def test_a_printed_garment_is_read_back(worn, picture, tmp_path, ending):
    mesh = replace(mesh_of_garment(worn), print=cloth_print(worn, picture, 8.0))
    back = read_garment_mesh(write_garment_mesh(mesh, tmp_path / f"a.{ending}"))
    assert len(back.faces) == len(mesh.faces) and back.line_names == mesh.line_names
    # The panels' places in the unit square come back, not those on the print.
    assert back.uv.min() >= 0 and back.uv.max() <= 1
    np.testing.assert_allclose(
        np.sort(back.uv, axis=0)[[0, -1]], np.sort(mesh.uv, axis=0)[[0, -1]], atol=1e-6
    )


def test_a_glb_holds_the_picture_and_its_repeats(worn, picture, tmp_path):
    import trimesh

    mesh = replace(mesh_of_garment(worn), print=cloth_print(worn, picture, 8.0))
    scene = trimesh.load_scene(write_garment_mesh(mesh, tmp_path / "a.glb"), process=False)
    panel = scene.geometry["skirt_front"]
    texture = panel.visual.material.baseColorTexture
    assert texture.size == (40, 20) and texture.convert("RGB").getpixel((3, 3)) == (255, 0, 0)
    own = places_on_cloth(worn)[worn.mesh.flat_panel == worn.pattern.panel_index("skirt_front")] / (8.0, 4.0)
    np.testing.assert_allclose(np.ptp(panel.visual.uv, axis=0), np.ptp(own, axis=0), atol=1e-4)


def test_prints_need_a_format_with_pictures(worn, picture, tmp_path):
    mesh = replace(mesh_of_garment(worn), print=cloth_print(worn, picture, 8.0))
    with pytest.raises(InputError, match=r"usdz or \.glb"):
        write_garment_mesh(mesh, tmp_path / "a.usdc")
    for width in (0.0, 1e9, float("nan")):
        with pytest.raises(InputError, match="repeat"):
            cloth_print(worn, picture, width)


def test_plans_of_a_pattern_do_not_depend_on_the_order_of_its_file(shipped_patterns):
    pattern = shipped_patterns["gc_1000272"]
    turned = replace(pattern, panels=pattern.panels[::-1], stitches=pattern.stitches[::-1])
    one, two = cutting_plan(pattern), cutting_plan(turned)
    assert [p.name for p in one.pieces] == [p.name for p in two.pieces]
    assert all(
        np.array_equal(a.cut.outline, b.cut.outline) for a, b in zip(one.pieces, two.pieces, strict=True)
    )

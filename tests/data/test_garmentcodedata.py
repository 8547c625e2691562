from __future__ import annotations

import json
import shutil
from pathlib import Path

import numpy as np
import pytest
from gcd_files import BODY_SAMPLE, specification_of, write_failures, write_sample

from swifttailor.cli.main import run
from swifttailor.data.garmentcodedata import (
    GarmentCodeData,
    SampleFolder,
    read_captions,
    read_edit_pair,
    read_sample_folder,
    read_split_lists,
)
from swifttailor.data.garmentcodedata.split_mesh import read_segmentation, read_split_mesh
from swifttailor.data.reader import SplitReader
from swifttailor.data.verify import verify_dataset
from swifttailor.draping.placement import place_vertices
from swifttailor.errors import InputError, SwiftTailorError
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.pattern import EdgeRef, Panel, Pattern, Placement, Stitch
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.panel import Edge

BATCH = "garments_5000_3"


def placed(name: str, edge_length: float) -> tuple[PatternMesh, np.ndarray]:
    """A draft with its panels where they are placed: a garment with every seam, without a simulation."""
    mesh = mesh_pattern(draft(name).canonical(), edge_length)
    return mesh, place_vertices(mesh)


def tube(edge_length: float) -> tuple[PatternMesh, np.ndarray]:
    """Two rectangles sewn into a cylinder of 80 cm girth, and the analytic place of each vertex."""
    corners = [[-20.0, 0.0], [20.0, 0.0], [20.0, 60.0], [-20.0, 60.0]]
    front = Panel("front", corners, (Edge(),) * 4, Placement((0.0, 80.0, 25.0)))
    back = Panel("back", corners[::-1], (Edge(),) * 4, Placement((0.0, 80.0, -25.0)))
    sides = (Stitch(EdgeRef("front", 1), EdgeRef("back", 1)), Stitch(EdgeRef("front", 3), EdgeRef("back", 3)))
    mesh = mesh_pattern(Pattern((front, back), sides).canonical(), edge_length)
    return mesh, cylinder(mesh)


def cylinder(mesh: PatternMesh) -> np.ndarray:
    flat = mesh.flat_vertices[mesh.representative]
    is_front = np.array([p.name == "front" for p in mesh.pattern.panels])[
        mesh.flat_panel[mesh.representative]
    ]
    angle = flat[:, 0] / 80 * 2 * np.pi
    radius = 80 / (2 * np.pi)
    z = np.where(is_front, np.cos(angle), -np.cos(angle))
    return np.stack([radius * np.sin(angle), 80 + flat[:, 1], radius * z], axis=1)


def one(
    tmp_path: Path, mesh: PatternMesh, vertices: np.ndarray, name: str = "rand_ONE", **options
) -> SampleFolder:
    path = f"{BATCH}/default_body/{name}"
    write_sample(tmp_path / path, mesh, vertices, **options)
    return SampleFolder(tmp_path, path)


# Meshes


def test_the_trap_of_split_vertices_is_real_and_undone(tmp_path):
    mesh, vertices = placed("t-shirt", 6.0)
    folder = one(tmp_path, mesh, vertices)
    split = read_split_mesh(folder.file("sim.ply"))
    lines = read_segmentation(folder.file("sim_segmentation.txt"))
    assert len(split.vertices) == len(mesh.flat_vertices) > mesh.vertex_count == len(lines)
    assert split.weld.max() + 1 == mesh.vertex_count
    assert split.island.max() + 1 == len(mesh.pattern.panels)
    seams = np.array([line == "" for line in lines])
    assert seams[: seams.sum()].all() and 0 < seams.sum() < len(lines)
    welded = np.zeros((mesh.vertex_count, 3))
    welded[split.weld] = split.vertices
    gaps = np.linalg.norm(welded[:, None] - vertices, axis=2)
    assert gaps.min(axis=0).max() < 1e-3 and gaps.min(axis=1).max() < 1e-3


@pytest.mark.parametrize("name", ["t-shirt", "fitted-dress", "hoodie", "trousers"])
def test_a_mesh_like_ours_comes_back_vertex_by_vertex(name, tmp_path):
    """Darts, sleeves, hoods, gathers; the file's panels are in another order than the canonical one."""
    mesh, vertices = placed(name, 5.0)
    sample = read_sample_folder(one(tmp_path, mesh, vertices), edge_length=5.0)
    assert sample.pattern == mesh.pattern and sample.id == "rand_ONE"
    np.testing.assert_allclose(sample.vertices, vertices, atol=2e-4)
    assert sample.about["seam_spread_cm"] < 1e-3
    assert sample.about["source"] == f"{BATCH}/default_body/rand_ONE" and sample.about["body"] == "default"
    assert sample.about["quality"]["top_cm"] == pytest.approx(vertices[:, 1].max(), abs=1e-3)
    assert not (tmp_path / BATCH / "default_body" / "rand_ONE" / "mark").exists(), "a pickle was opened"


@pytest.mark.parametrize(("simulated", "wanted"), [(1.0, 2.5), (3.0, 2.0), (2.0, 6.0)])
def test_another_mesh_is_carried_over_to_ours(simulated, wanted, tmp_path):
    folder = one(tmp_path, *tube(simulated))
    sample = read_sample_folder(folder, edge_length=wanted)
    expected = cylinder(sample.mesh)
    radius = 80 / (2 * np.pi)
    sagitta = simulated**2 / (2 * radius)  # of the chords that the simulated triangles are
    assert np.linalg.norm(sample.vertices - expected, axis=1).max() < 1.5 * sagitta + 1e-3
    assert sample.about["quality"]["strain_p95"] < 0.02
    assert sample.about["seam_spread_cm"] < 1.5 * sagitta + 1e-3


def test_drapes_at_another_edge_length_stay_on_the_surface(tmp_path):
    import trimesh

    mesh, vertices = placed("fitted-skirt", 2.0)
    sample = read_sample_folder(one(tmp_path, mesh, vertices), edge_length=4.0)
    surface = trimesh.Trimesh(vertices, mesh.faces, process=False)
    inner = np.ones(len(sample.vertices), bool)
    for seam in sample.mesh.seams:  # between two panels that are apart, both are a guess
        inner[seam.vertices] = False
    samples = surface.sample(150_000, seed=1)
    gaps = [np.linalg.norm(samples - v, axis=1).min() for v in sample.vertices[inner]]
    assert max(gaps) < 1.0 and np.mean(gaps) < 0.3


@pytest.mark.parametrize("scale", [(1.0, 1.0), (250.0, 90.0), (1e-3, 7.0)])
@pytest.mark.parametrize("encoding", ["binary", "ascii"])
def test_any_scale_of_texture_coordinates(scale, encoding, tmp_path):
    mesh, vertices = placed("tank-top", 6.0)
    folder = one(tmp_path, mesh, vertices, uv_scale=scale, encoding=encoding)
    sample = read_sample_folder(folder, edge_length=6.0)
    np.testing.assert_allclose(sample.vertices, vertices, atol=5e-4)


def test_a_segmentation_that_does_not_fit_the_file(tmp_path):
    """The PLY has lost a vertex that no face used: panels are then told by their order."""
    mesh, vertices = placed("t-shirt", 6.0)
    folder = one(tmp_path, mesh, vertices, lost_vertex=True)
    lines = read_segmentation(folder.file("sim_segmentation.txt"))
    assert len(lines) == mesh.vertex_count + 1
    for missing in (False, True):
        if missing:
            folder.file("sim_segmentation.txt").unlink()
        np.testing.assert_allclose(read_sample_folder(folder, edge_length=6.0).vertices, vertices, atol=2e-4)


def test_files_that_do_not_belong_together(tmp_path):
    shirt, skirt = (
        one(tmp_path, *placed("t-shirt", 6.0)),
        one(tmp_path, *placed("fitted-skirt", 6.0), "rand_TWO"),
    )
    shutil.copy(skirt.file("sim.ply"), shirt.file("sim.ply"))
    with pytest.raises(InputError, match=r"The mesh has \d+ pieces and the pattern \d+ panels"):
        read_sample_folder(shirt)
    long = one(tmp_path, *tube(3.0), "rand_LONG")
    specification = json.loads(long.file("specification.json").read_text())
    for panel in specification["pattern"]["panels"].values():
        panel["vertices"] = [[x, y * (1.5 if x > 0 else 1.0)] for x, y in panel["vertices"]]
    specification["pattern"]["panels"]["back"]["vertices"][0][1] += 9
    long.file("specification.json").write_text(json.dumps(specification))
    with pytest.raises(InputError, match=r"does not fit the pattern: a corner of the panel"):
        read_sample_folder(long)
    segmentation = skirt.file("sim_segmentation.txt")
    lines = segmentation.read_text().splitlines()
    lines[-1] = next(line for line in lines if not line.startswith("stitch") and line != lines[-1])
    segmentation.write_text("\n".join(lines))
    with pytest.raises(InputError, match="names several panels for one piece"):
        read_sample_folder(skirt)


def test_damaged_files_are_named(tmp_path):
    import trimesh

    mesh, vertices = placed("tank-top", 6.0)
    folder = one(tmp_path, mesh, vertices)
    ply = folder.file("sim.ply")
    whole = ply.read_bytes()
    for what in (whole[: len(whole) // 2], b"ply\nformat", b"", b"\x00" * 500):
        ply.write_bytes(what)
        with pytest.raises(InputError, match=r"rand_ONE_sim\.ply"):
            read_sample_folder(folder)
    trimesh.Trimesh(vertices, mesh.faces, process=False).export(ply)
    with pytest.raises(InputError, match="has no texture coordinates"):
        read_sample_folder(folder)
    ply.write_bytes(whole)
    loaded = trimesh.load_mesh(ply, process=False)
    loaded.vertices[7] = np.nan
    loaded.export(ply)
    with pytest.raises(InputError, match="its simulation has failed"):
        read_sample_folder(folder)
    ply.unlink()
    with pytest.raises(InputError, match=r"Cannot read '.*rand_ONE_sim\.ply'"):
        read_sample_folder(folder)
    folder.file("specification.json").write_text("{")
    with pytest.raises(InputError, match=r"rand_ONE_specification\.json"):
        read_sample_folder(folder)


# Folders


@pytest.fixture
def download(tmp_path) -> Path:
    root = tmp_path / "gcd"
    for name, garment in (
        ("rand_B", "fitted-skirt"),
        ("rand_A", "tank-top"),
        ("rand_FAILED", "fitted-skirt"),
    ):
        write_sample(root / BATCH / "default_body" / name, *placed(garment, 5.0))
    write_sample(root / BATCH / "random_body" / "rand_A", *placed("tank-top", 6.0), random_body=True)
    write_sample(root / "garments_5000_12" / "default_body" / "rand_C", *placed("gathered-skirt", 5.0))
    (root / BATCH / "renders").mkdir()
    (root / BATCH / "default_body" / "rand_EMPTY").mkdir()
    failures = root / BATCH / "dataset_properties_default_body.yaml"
    write_failures(
        failures, cloth_self_intersection=["rand_FAILED"], static_equilibrium=[], crashes=["rand_X"]
    )
    return root


def test_samples_are_listed_without_failures(download):
    data = GarmentCodeData(download)
    paths = [s.path for s in data.samples()]
    assert paths == [
        f"{BATCH}/default_body/rand_A",
        f"{BATCH}/default_body/rand_B",
        "garments_5000_12/default_body/rand_C",
    ]
    everything = list(data.samples(with_failures=True))
    assert [s.failures for s in everything if s.failures] == [("cloth_self_intersection",)]
    assert [s.path for s in data.samples("random")] == [f"{BATCH}/random_body/rand_A"]
    only = GarmentCodeData(download / BATCH)
    assert [s.path for s in only.samples()] == paths[:2]
    assert data.sample(paths[1]).name == "rand_B"
    assert data.sample(f"{BATCH}/default_body/rand_FAILED").failures == ("cloth_self_intersection",)
    for wrong in ("../secret", "/etc", "garments_5000_3/default_body/rand_NONE"):
        with pytest.raises(InputError, match="There is no garment"):
            data.sample(wrong)
    with pytest.raises(InputError, match="holds no GarmentCodeData"):
        GarmentCodeData(download / BATCH / "renders")


def test_design_measurements_and_body(download):
    data = GarmentCodeData(download)
    default, random = data.sample(f"{BATCH}/default_body/rand_A"), data.sample(f"{BATCH}/random_body/rand_A")
    assert default.design()["skirt"]["length"]["v"] == 0.4
    assert random.measurements() == {"height": 171.99, "waist": 84.33}
    bodies = Path("bodies")
    assert default.body_mesh(bodies) == bodies / "neutral_body" / "mean_all.obj"
    meshes = bodies / "5000_body_shapes_and_measures" / "meshes"
    assert random.body_mesh(bodies) == meshes / f"{BODY_SAMPLE}.obj"
    file = random.file("body_measurements.yaml")
    file.write_text("body: {body_sample: '../../x'}")
    with pytest.raises(InputError, match="does not say which body"):
        random.body_mesh(bodies)
    for wrong in ("[1, 2]", "a: [", "!!python/object/apply:os.system ['touch mark']", "\x00"):
        file.write_text(wrong)
        with pytest.raises(InputError, match=r"body_measurements\.yaml"):
            random.measurements()
    file.unlink()
    with pytest.raises(InputError, match="Cannot read"):
        random.measurements()


def test_split_lists(tmp_path):
    path = tmp_path / "split.json"
    path.write_text(
        json.dumps({"training": ["a/default_body/x", "./b/c"], "validation": [], "test": ["d/e/"]})
    )
    assert read_split_lists(path) == {
        "train": ("a/default_body/x", "b/c"),
        "validation": (),
        "test": ("d/e",),
    }
    for wrong, message in (
        ({"training": ["x"], "test": ["./x"]}, "in the splits 'train' and 'test'"),
        ({"training": ["../x"]}, "no path of a sample folder"),
        ({"training": ["/x"]}, "no path of a sample folder"),
        ({"extra": []}, "a split named 'extra'"),
        ({"test": "x"}, "a list was expected"),
        ([], "an object was expected"),
    ):
        path.write_text(json.dumps(wrong))
        with pytest.raises(SwiftTailorError, match=message):
            read_split_lists(path)


# GCD-MM


def test_captions_and_edits(download, tmp_path):
    mm = tmp_path / "mm"
    (mm / "rand_A").mkdir(parents=True)
    original = GarmentCodeData(download).sample(f"{BATCH}/default_body/rand_A")
    (mm / "rand_A" / "captions.json").write_text(
        json.dumps({"description": " A top. ", "occasion": "Summer."})
    )
    texts = read_captions(mm, "rand_A")
    assert (texts.description, texts.occasion) == ("A top.", "Summer.")
    words = {
        "editing_description_forward": "include a hood",
        "editing_description_reverse": "remove the hood",
    }
    (mm / "rand_A" / "editing_caption.json").write_text(json.dumps(words))
    edited = mm / "rand_A" / "edited_specification.json"
    edited.write_text(json.dumps(specification_of(draft("hoodie"))))
    pair = read_edit_pair(mm, original)
    assert not pair.unchanged and pair.forward == "include a hood" and pair.backward == "remove the hood"
    assert {p.name for p in pair.before.panels} == {p.name for p in draft("tank-top").panels}
    # A known defect: the edited pattern is the original, its panels perhaps in another order.
    edited.write_text(json.dumps(specification_of(draft("tank-top"))))
    assert read_edit_pair(mm, original).unchanged
    (mm / "rand_A" / "editing_caption.json").write_text("{}")
    with pytest.raises(InputError, match="editing_description_forward"):
        read_edit_pair(mm, original)
    (mm / "rand_A" / "captions.json").write_text('{"occasion": "x"}')
    with pytest.raises(InputError, match="has no 'description'"):
        read_captions(mm, "rand_A")
    with pytest.raises(InputError, match="Cannot read"):
        read_captions(mm, "rand_B")


# Into shards


def test_import_of_official_splits(download, tmp_path, capsys):
    lists = tmp_path / "split.json"
    names = {"training": [f"{BATCH}/default_body/{n}" for n in ("rand_B", "rand_FAILED", "rand_MISSING")]}
    names |= {
        "validation": [],
        "test": ["garments_5000_12/default_body/rand_C", f"{BATCH}/random_body/rand_A"],
    }
    lists.write_text(json.dumps(names))
    out = tmp_path / "out"
    arguments = ["data", "import", str(download), "--splits", str(lists), "--edge-length", "4"]
    assert run([*arguments, "--out", str(out), "--workers", "2"]) == 0
    captured = capsys.readouterr()
    assert "'train': 1 garments of the list are not in" in captured.err
    assert "2 patterns: 1 accepted, 1 rejected, 0 failed." in captured.out
    assert list(verify_dataset(out)) == [1, 1]
    reader = SplitReader(out / "train")
    sample = reader.sample("rand_B")
    assert sample.about["source"] == f"{BATCH}/default_body/rand_B" and sample.edge_length == 4.0
    (rejected,) = reader.index.shards[0].rejected
    assert rejected.id == "rand_FAILED" and "cloth_self_intersection" in rejected.reasons[0]
    assert reader.index.settings["origin"] == "GarmentCodeData"
    assert str(tmp_path) not in (out / "train" / "index.json").read_text()
    assert run([*arguments, "--out", str(tmp_path / "again"), "--split", "test", "--workers", "1"]) == 0
    shards = [next((o / "test").glob("shard-*")).read_bytes() for o in (out, tmp_path / "again")]
    assert shards[0] == shards[1] and not (tmp_path / "again" / "train").exists()
    assert run([*arguments, "--out", str(out), "--split", "all"]) == 2
    assert "has no split 'all'" in capsys.readouterr().err


def test_import_with_captions_and_damaged_folders(download, tmp_path, capsys):
    mm = tmp_path / "mm"
    for name in ("rand_A", "rand_C"):
        (mm / name).mkdir(parents=True)
        (mm / name / "captions.json").write_text(json.dumps({"description": f"This is {name}."}))
    (download / "garments_5000_12" / "default_body" / "rand_C" / "rand_C_sim.ply").write_bytes(b"ply")
    out = tmp_path / "out"
    arguments = [
        "data",
        "import",
        str(download),
        "--out",
        str(out),
        "--captions",
        str(mm),
        "--edge-length",
        "5",
    ]
    assert run([*arguments, "--workers", "1"]) == 0
    assert "4 patterns: 1 accepted, 3 rejected" in capsys.readouterr().out
    reader = SplitReader(out / "train")
    assert reader[0].about["captions"] == {"description": "This is rand_A.", "occasion": ""}
    why = {r.id: r.reasons[0] for r in reader.index.shards[0].rejected}
    assert "captions.json" in why["rand_B"] and "rand_C_sim.ply" in why["rand_C"]
    assert str(download) not in why["rand_C"]


@pytest.mark.parametrize(
    "name", ["index.json", "results.jsonl", "shard-00000-0123456789ab.safetensors", "a.txt"]
)
def test_files_of_others_stay_where_is_imported(name, download, tmp_path, capsys):
    mine = tmp_path / "out" / "train" / name
    mine.parent.mkdir(parents=True)
    mine.write_text("my own work")
    before = mine.stat().st_mtime_ns
    asked = ["data", "import", str(download), "--out", str(tmp_path / "out"), "--edge-length", "4"]
    assert run([*asked, "--workers", "1"]) == 2
    said = capsys.readouterr().err
    assert str(mine.parent) in said and ("is not empty and holds no split" in said or "is damaged" in said)
    assert [p.name for p in mine.parent.iterdir()] == [name]
    assert mine.read_text() == "my own work" and mine.stat().st_mtime_ns == before

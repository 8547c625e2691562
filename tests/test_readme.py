"""Every command and every line of Python in the README and the guides works as printed."""

from __future__ import annotations

import json
import re
import shlex
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

import swifttailor
from swifttailor.cli.main import COMMANDS, run

ROOT = Path(__file__).parents[1]
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\(([^)#]+)(?:#[^)]*)?\)")
PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").glob("*.md")], key=lambda p: (p.parent != ROOT, p.name))

pytestmark = pytest.mark.skipif(
    not (ROOT / "README.md").is_file(), reason="only in the repository, not in an installed package"
)


def blocks(page: str, language: str) -> list[str]:
    return [text for kind, text in BLOCK.findall((ROOT / page).read_text()) if kind == language]


def commands(page: str) -> list[list[str]]:
    lines = "".join(blocks(page, "console")).splitlines()
    return [shlex.split(line, comments=True) for line in lines if line.strip()]


@pytest.fixture
def coarse(monkeypatch):
    """The README's drapes at 6 cm: what is tested is that the commands are right."""
    import swifttailor.draping

    real = swifttailor.draping.drape
    monkeypatch.setattr(swifttailor.draping, "drape", lambda p, **o: real(p, **o | {"edge_length": 6.0}))


def draw_worn(garment: swifttailor.Garment, path: str) -> None:
    """A picture of somebody who wears a garment."""
    from PIL import Image

    from swifttailor.looks.draw import draw_look
    from swifttailor.looks.plain_look import plain_look

    Image.fromarray(draw_look(garment, swifttailor.Body.default(), plain_look(), 320)).save(path)


def run_all(page: str) -> None:
    for command in commands(page):
        assert command[0] == "swifttailor"
        if "--batch" in command:
            command += ["--edge-length", "6"]
        assert run(command[1:]) in (0, 1), command


def test_the_guide_to_commands(tmp_path, monkeypatch, coarse, networks, capsys):
    monkeypatch.chdir(tmp_path)
    run_all("docs/commands.md")
    text = (ROOT / "docs/commands.md").read_text()
    folder = {p.name for p in (tmp_path / "shirt").iterdir()}
    assert folder == {
        "preview.png", "garment.glb", "garment.obj", "pattern.svg", "pattern.json", "report.json",
        ".swifttailor"
    }  # fmt: skip
    assert all(f"`{name}`" in text for name in folder)
    report = json.loads((tmp_path / "shirt" / "report.json").read_text())
    assert report["fabric"] == "jersey"
    table = text.split("## Reading report.json")[1].split("## ")[0]
    documented = set(re.findall(r"^\| `(\w+)` \|", table, re.MULTILINE))
    assert documented and documented <= set(report["quality"])
    assert (tmp_path / "many" / "sheet-01.png").is_file()
    assert json.loads((tmp_path / "many" / "summary.json").read_text())["counts"]["failed"] == 0


def test_the_guide_to_draping(tmp_path, monkeypatch, coarse, capsys):
    monkeypatch.chdir(tmp_path)
    run_all("docs/draping.md")
    for block in blocks("docs/draping.md", "python"):
        exec(compile(block, "draping.md", "exec"), {})
    for fabric in swifttailor.draping.FABRICS.values():
        row = next(
            line
            for line in (ROOT / "docs/draping.md").read_text().splitlines()
            if line.startswith(f"| `{fabric.name}`")
        )
        numbers = [float(cell) for cell in row.split("|")[2:-1]]
        assert numbers == [
            fabric.density, fabric.stretch, fabric.bending, fabric.friction, fabric.thickness
        ]  # fmt: skip


def test_the_guide_to_geometry_images(tmp_path, monkeypatch, coarse, capsys):
    monkeypatch.chdir(tmp_path)
    run_all("docs/ggi.md")
    names: dict = {}
    for block in blocks("docs/ggi.md", "python"):
        exec(compile(block, "ggi.md", "exec"), names)
    assert names["images"].geometry.shape == (256, 256, 3)
    assert {p.name for p in (tmp_path / "images").iterdir()} == {
        "ggi.npz", "semantic.png", "stitching.png", "geometry.png", ".swifttailor"
    }  # fmt: skip


def test_the_guide_to_data_sets(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    run_all("docs/data.md")
    names: dict = {}
    for block in blocks("docs/data.md", "python"):
        exec(compile(block, "data.md", "exec"), names)
    assert len(names["reader"]) >= 1 and names["picture"].shape == (128, 128, 3)
    assert {"index.html", "stats.json"} <= {p.name for p in (tmp_path / "garments" / "stats").iterdir()}


@pytest.fixture
def networks(monkeypatch):
    """The weights that this version does not have: a network that writes a dress, and an untrained one."""
    import importlib.util

    from swifttailor.garment_sewer.sewer import GarmentSewer
    from swifttailor.pattern_maker.maker import PatternMaker
    from swifttailor.refitting import first_body
    from swifttailor.tailor import one_pattern, tailored

    place = ROOT / "tests/tailor/scripted_maker.py"
    spec = importlib.util.spec_from_file_location("scripted_maker_of_the_guides", place)
    scripted = importlib.util.module_from_spec(spec)
    monkeypatch.setitem(sys.modules, spec.name, scripted)
    spec.loader.exec_module(scripted)
    maker = scripted.scripted_maker([swifttailor.draft("fitted-dress")])
    sewer = GarmentSewer.load(ROOT / "tests/garment_sewer/tiny_sewer.onnx")
    monkeypatch.setattr(PatternMaker, "load", staticmethod(lambda weights=None, threads=1: maker))
    monkeypatch.setattr(GarmentSewer, "load", staticmethod(lambda weights=None, threads=1: sewer))
    # Loaded once for a whole process: the tests that come after are to sew with the package's own.
    monkeypatch.setattr(one_pattern, "_tailor", cache(one_pattern._tailor.__wrapped__))
    monkeypatch.setattr(first_body, "_sewer", cache(first_body._sewer.__wrapped__))
    monkeypatch.setattr(tailored, "PREVIEW_SIZE", (100, 60))
    # What is sewn untrained comes out crumpled, and would fall longest.
    monkeypatch.setattr("swifttailor.draping.relax.SUBSTEPS", 3)


def test_the_readme_from_top_to_bottom(tmp_path, monkeypatch, coarse, capsys):
    """With the weights of the package, and the photograph of its figure."""
    monkeypatch.chdir(tmp_path)
    shutil.copy(ROOT / "docs/images/woman-with-dog.jpg", "photograph.jpg")
    assert [c[1] for c in commands("README.md")] == ["generate", "generate", "edit"]
    for command in commands("README.md"):
        assert run(command[1:]) in (0, 1), command
        report = json.loads((tmp_path / command[-1] / "report.json").read_text())
        assert all(wish["holds"] for wish in report["wishes"]), command
    for block in blocks("README.md", "python"):
        exec(compile(block, "README.md", "exec"), {})
    text = (ROOT / "README.md").read_text()
    folder = {p.name for p in (tmp_path / "longer-dress").iterdir()}
    assert folder == {p.name for p in (tmp_path / "longer").iterdir()}
    assert all(f"`{name}`" in text for name in folder)
    assert json.loads((tmp_path / "skirt" / "report.json").read_text())["fabric"] == "silk"


def test_the_readme_is_one_page():
    assert len((ROOT / "README.md").read_text().splitlines()) < 110


def test_the_figures_of_the_readme_stand_in_the_guides():
    readme = (ROOT / "README.md").read_text()
    maker = (ROOT / "docs/pattern-maker.md").read_text()
    sewer = (ROOT / "docs/garment-sewer.md").read_text()

    def cell(page: str, row: str, column: int) -> float:
        line = next(line for line in page.splitlines() if line.startswith(f"| {row} |"))
        return float(line.split("|")[column + 1].strip(" *%"))

    def ours(row: str) -> str:
        return next(line for line in readme.splitlines() if line.startswith(f"| {row}")).split("|")[2]

    eyes = (ROOT / "docs/picture-reader.md").read_text()
    assert f"{cell(eyes, 'words and plain, front', 2):.0f} %" in ours("right number of panels")
    for row in ("plain, front", "usual: plain, front"):
        assert f"{cell(eyes, row, 2):.0f} %" in ours("the same, **from a picture")
    results = (ROOT / "docs/results.md").read_text()
    for row in ("PatternMaker", "input unchanged"):
        assert f"{cell(results, row, 2):.0f} %" in ours("the same, after an edit")
    assert f"{cell(sewer, 'sewn', 1):.1f}" in ours("distance of the mesh")
    assert f"{cell(sewer, 'with `--finish`', 1):.1f}" in ours("distance of the mesh")
    for number in ("2.51", "1.27"):
        assert number in maker and number in readme
    time = ours("from the prompt to a mesh").split("**")[1]
    assert time.endswith(" s") and f"takes {time} (median" in (ROOT / "docs/generate.md").read_text()


def test_the_guide_to_garments_of_words(tmp_path, monkeypatch, networks, shipped_patterns, capsys):
    monkeypatch.chdir(tmp_path)
    draw_worn(swifttailor.sew(shipped_patterns["gc_1005537"]).garment, "photo.jpg")
    for command in commands("docs/generate.md"):
        assert run(command[1:]) == 0, command
    text = (ROOT / "docs/generate.md").read_text()
    folder = {p.name for p in (tmp_path / "dress").iterdir()}
    assert len(folder) == 8 and all(f"`{name}`" in text for name in folder)
    assert {p.name for p in (tmp_path / "skirts").iterdir()} == {
        "seed-100", "seed-101", "seed-102", "seed-103", "sheet.png", ".swifttailor"
    }  # fmt: skip
    report = json.loads((tmp_path / "both" / "report.json").read_text())
    for name in ("order", "seconds", "writing", "confidence", "findings", "warnings", "notes", "sewing"):
        assert name in report and f"`{name}`" in text
    for stage in report["seconds"]:
        assert f"`{stage}`" in text
    for block in blocks("docs/generate.md", "python"):
        exec(compile(block, "generate.md", "exec"), {})
    assert (tmp_path / "longer-dress" / "garment.glb").is_file()


def test_the_guide_lists_every_option_of_generate_and_edit():
    import dataclasses

    from swifttailor.cli.edit import Edit
    from swifttailor.cli.generate import Generate

    table = (ROOT / "docs/generate.md").read_text().split("## Options")[1].split("## ")[0]
    shown = {option.removeprefix("no-") for option in re.findall(r"`--([a-z-]+)`", table)}
    fields = {f.name.replace("_", "-") for kind in (Generate, Edit) for f in dataclasses.fields(kind)}
    assert shown == fields - {"text", "pattern", "instruction"}


@pytest.mark.skipif(not shutil.which("make"), reason="make is not installed")
@pytest.mark.parametrize(
    ("there", "does", "says"),
    [
        ((), "drape", "has no trained weights"),
        (("maker",), "drape", "has no trained weights"),
        (("sewer",), "sew", "has no weights that read words"),
        (("maker", "sewer"), "generate", "has trained weights"),
    ],
)
def test_the_demo_is_of_what_there_are_weights_for_and_says_so(there, does, says, tmp_path):
    files = {name: tmp_path / name for name in ("maker", "sewer")}
    for name in there:
        files[name].write_bytes(b"")
    variables = [f"MAKER_WEIGHTS={files['maker']}", f"SEWER_WEIGHTS={files['sewer']}"]
    done = subprocess.run(
        ["make", "-n", "demo", *variables], cwd=ROOT, capture_output=True, text=True, check=True
    )
    found = [name for name in ("generate", "drape", "sew") if f"swifttailor {name} " in done.stdout]
    assert found == [does] and says in done.stdout


def test_the_guide_to_wishes(capsys):
    for block in blocks("docs/wishes.md", "python"):
        exec(compile(block, "wishes.md", "exec"), {})
    assert "Step(quantity='length', direction=1, amount=15.0)" in capsys.readouterr().out


@pytest.mark.parametrize("page", ["captions", "edits"])
def test_the_guides_to_captions_and_edits(page, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    run_all(f"docs/{page}.md")
    names: dict = {}
    for block in blocks(f"docs/{page}.md", "python"):
        exec(compile(block, f"{page}.md", "exec"), names)
    shown = capsys.readouterr().out
    assert names["caption"].text in shown if page == "captions" else names["pair"].instruction.text in shown


def test_the_tables_of_claims_and_of_what_is_cut_are_whole():
    from swifttailor.describing import CLAIM_TYPES
    from swifttailor.describing.dimensions import DIMENSIONS
    from swifttailor.recutting.levers.all_levers import NOT_CUT
    from swifttailor.recutting.random_cuts import TOPICS

    claims = (ROOT / "docs/captions.md").read_text()
    for kind in CLAIM_TYPES.values():
        values = "number" if kind.measure else ", ".join(kind.words)
        assert f"| `{kind.name}` | {kind.about} | {values} |\n" in claims
    edits = (ROOT / "docs/edits.md").read_text()
    for topic, ways in TOPICS.items():
        assert f"| {topic} | {'; '.join(way.label for way in ways)} |\n" in edits
    for name, reason in NOT_CUT.items():
        assert f"| {name} | {DIMENSIONS[name].about} | {reason} |\n" in edits


def test_the_guide_lists_the_commands_that_exist():
    table = (ROOT / "docs/commands.md").read_text().split("```")[0]
    assert set(re.findall(r"^\| `swifttailor (\w+)", table, re.MULTILINE)) == set(COMMANDS)


def test_the_guide_lists_every_option_of_drape():
    import dataclasses

    from swifttailor.cli.drape import Drape

    table = (ROOT / "docs/commands.md").read_text().split("## Options of `drape`")[1].split("## ")[0]
    shown = set(re.findall(r"`--(?:no-)?([a-z-]+)`", table))
    fields = {f.name.replace("_", "-") for f in dataclasses.fields(Drape)} - {"pattern", "out"}
    assert shown == fields


@pytest.mark.parametrize("page", PAGES, ids=lambda p: str(p.relative_to(ROOT)))
def test_links_and_make_targets_exist(page):
    text = page.read_text()
    for target in LINK.findall(text):
        if not target.startswith("http"):
            assert (page.parent / target).exists(), target
    makefile = (ROOT / "Makefile").read_text()
    for targets in re.findall(r"^(?:`?)make ([a-z -]+?)(?:  |$|`)", text, re.MULTILINE):
        for target in targets.split():
            assert re.search(rf"^{target}:", makefile, re.MULTILINE), target


def test_the_pictures_are_small():
    for name in ("words-to-garment.jpg", "shirt-dress.png", "sewn-drafts.jpg"):
        assert (ROOT / "docs/images" / name).stat().st_size < 500_000

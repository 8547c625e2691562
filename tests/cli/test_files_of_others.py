"""Files that SwiftTailor did not write stay as they are, whatever the command and whatever their names."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from scripted_maker import scripted_maker

import swifttailor
from swifttailor.cli import main as cli
from swifttailor.cli.convert import LISTS, PATTERN_ENDINGS
from swifttailor.cli.data import DATA
from swifttailor.cli.evaluate import EVALUATE
from swifttailor.cli.main import run
from swifttailor.cli.train import TRAIN
from swifttailor.errors import InputError
from swifttailor.garment.formats import MESH_ENDINGS, write_garment_mesh
from swifttailor.garment.garment import Garment
from swifttailor.garment.triangle_mesh import mesh_of_garment
from swifttailor.ggi import encode
from swifttailor.ggi.file import write_ggi
from swifttailor.making.marker_files import ENDINGS as MARKER_ENDINGS
from swifttailor.output_folder import LIST
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern import write_pattern
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.garmentcode_writer import to_specification
from swifttailor.pattern.svg import write_svg
from swifttailor.pattern_maker.maker import PatternMaker

TESTS = Path(__file__).parents[1]
NETWORKS = ("garment-sewer", "pattern-maker", "wish-reader", "picture-reader")
TINY = str(TESTS / "garment_sewer" / "tiny_sewer.onnx")
FOLDER = ("pattern.json", "pattern.svg", "garment.glb", "garment.obj", "report.json")
MADE = (*FOLDER, "preview.png", "ggi.npz")
IMAGES = ("ggi.npz", "semantic.png", "stitching.png")
SAMPLES = *(f"seed-{k}/{name}" for k in (0, 1) for name in MADE), "sheet.png"
USD = ("usd", "usda", "usdc", "usdz")
SEWN = tuple(f"{pattern}/{name}" for pattern in ("skirt", "other") for name in (*FOLDER, "preview.png"))

# What is asked, with the inputs by name and OUT for the folder, and what it writes there.
COMMANDS: dict[str, tuple[str, tuple[str, ...]]] = {
    "draft": ("draft fitted-skirt --out OUT/a.json", ("a.json",)),
    "draft --design": ("draft --design design.yaml --out OUT/a.json", ("a.json",)),
    "draft --design --sizes": (
        "draft --design design.yaml --sizes 36,44 --out OUT",
        ("women-eu-36.json", "women-eu-44.json"),
    ),
    "convert to svg": ("convert skirt.json OUT/a.svg", ("a.svg",)),
    "convert to json": ("convert worn OUT/a.json", ("a.json",)),
    "convert to pdf": ("convert worn OUT/a.pdf", ("a.pdf",)),
    "convert to dxf": ("convert skirt.json OUT/a.dxf", ("a.dxf",)),
    "convert to md": ("convert skirt.json OUT/a.md", ("a.md",)),
    "convert to zip": ("convert skirt.json OUT/a.zip", ("a.zip",)),
    "convert to panels": ("convert skirt.json OUT/a.obj", ("a.obj",)),
    "convert to glb with body": ("convert worn OUT/a.glb --with-body --color #aa2233", ("a.glb",)),
    **{f"convert to {end}": (f"convert worn OUT/a.{end}", (f"a.{end}",)) for end in USD},
    **{f"convert sizes to {end}": (f"convert sizes OUT/a.{end}", (f"a.{end}",)) for end in ("pdf", "dxf")},
    "convert to obj": ("convert worn OUT/a.obj", ("a.obj",)),
    "convert to glb": ("convert worn OUT/a.glb", ("a.glb",)),
    "convert to ply": ("convert worn OUT/a.ply", ("a.ply",)),
    "convert to stl": ("convert worn OUT/a.stl", ("a.stl",)),
    "check --repair": ("check skirt.json --repair OUT/a.json", ("a.json",)),
    "fit": ("fit skirt.json --size 44 --out OUT/a.json", ("a.json",)),
    "fit --sizes": (
        "fit skirt.json --sizes 36,44 --out OUT",
        ("women-eu-36.json", "women-eu-44.json"),
    ),
    **{
        f"marker to {end}": (f"marker skirt.json --seconds 1 --out OUT/a.{end}", (f"a.{end}",))
        for end in ("svg", "pdf", "png", "dxf")
    },
    "sew": (f"sew skirt.json --out OUT --weights {TINY}", (*FOLDER, "preview.png")),
    "sew --no-preview": (f"sew skirt.json --out OUT --no-preview --weights {TINY}", FOLDER),
    "sew several": (f"sew skirt.json other.json --out OUT --weights {TINY}", SEWN),
    "drape": ("drape skirt.json --out OUT --edge-length 8", (*FOLDER, "preview.png")),
    "ggi": ("ggi skirt.json --out OUT", IMAGES),
    "ggi of a garment": ("ggi worn --out OUT", (*IMAGES, "geometry.png")),
    "ggi --decode": ("ggi --decode ggi.npz --out OUT", FOLDER),
    "ggi --decode, grid": (
        "ggi --decode ggi.npz --method grid --out OUT",
        ("garment.glb", "garment.obj", "report.json"),
    ),
    "generate": (f"generate dress --source writer --out OUT --sewer-weights {TINY}", MADE),
    "generate several": (
        f"generate dress --source writer --samples 2 --out OUT --sewer-weights {TINY}",
        SAMPLES,
    ),
    "edit": (f"edit skirt.json shorter --out OUT --sewer-weights {TINY}", MADE),
    "data edits": ("data edits skirt.json --out OUT/a.jsonl", ("a.jsonl",)),
    "data captions": ("data captions skirt.json --out OUT/a.jsonl", ("a.jsonl",)),
}
# Folders that are resumed: those of others are refused as a whole.
RESUMED: dict[str, tuple[str, tuple[str, ...]]] = {
    "generate --read": ("generate --image photo.png --read --out OUT", ("reading.json", "seen.png")),
    "generate --image": ("generate --image photo.png --out OUT", ("seen.png", "lower/garment.obj")),
    "drape --batch": (
        "drape --batch skirts.jsonl --out OUT --edge-length 8 --workers 1",
        ("batch.json", "results.jsonl", "summary.json", "sheet-01.png", "skirt/garment.obj"),
    ),
    "data build": (
        "data build --patterns skirts.jsonl --split . --out OUT --workers 1".replace(
            "--split .", "--split a"
        ),
        (
            *("a/index.json", "a/results.jsonl", "a/shard-00000-0123456789ab.safetensors"),
            "a/.samples/00000000.safetensors",
        ),
    ),
}

# Commands whose files need other inputs, and where their files of others are tested.
ELSEWHERE = {
    "data import": "data/test_garmentcodedata.py",
    "data render": "data/test_data_commands.py",
    "data stats": "data/test_data_commands.py",
    "evaluate garment-sewer": "evaluation/test_evaluate_command.py",
    "evaluate pattern-maker": "evaluation/test_evaluate_command.py",
    "evaluate picture-reader": "evaluation/test_evaluate_command.py",
    "evaluate systems": "evaluation/test_evaluate_command.py",
    "evaluate page": "evaluation/test_evaluate_command.py",
    "evaluate drape-floor": "evaluation/test_evaluate_command.py",
    **{f"train {network}": "training/test_run_record.py" for network in NETWORKS},
    "train export": "training/test_export_command.py",
    "studio": "studio/test_project_store.py",
}
WRITES_NOTHING = {"fabrics", "data verify"}


def every_command() -> set[str]:
    """Of one word or two, as the command line lists them."""
    groups = {group.name: group for group in (DATA, TRAIN, EVALUATE)}
    alone = set(cli.COMMANDS) - set(groups)
    return alone | {f"{name} {command}" for name, group in groups.items() for command in group.commands}


def test_no_command_is_left_out():
    here = {words for line, _ in (COMMANDS | RESUMED).values() for words in command_names(line)}
    assert here & every_command() | set(ELSEWHERE) | WRITES_NOTHING == every_command()
    assert not WRITES_NOTHING & (here | set(ELSEWHERE))


def command_names(line: str) -> tuple[str, str]:
    first, second = line.split()[:2]
    return first, f"{first} {second}"


@pytest.mark.parametrize("command", ELSEWHERE)
def test_tests_of_others_are_where_they_are_said_to_be(command):
    """Each has a test that is called by what it shows, and lists the command where it lists some."""
    text = (TESTS / ELSEWHERE[command]).read_text()
    assert re.search(r"def test_\w*(of_others|nobody_s_files)\w*\(", text)
    if "evaluat" in command or command in ("data render", "data stats"):
        assert f'("{command.split()[1]}", ' in text


def test_no_kind_of_file_is_left_out():
    written = {
        command: {
            "".join(Path(n).suffixes)
            for line, names in COMMANDS.values()
            for n in names
            if line.startswith(command)
        }
        for command in ("convert", "marker")
    }
    assert written["marker"] == set(MARKER_ENDINGS)
    lists = {".jsonl", ".jsonl.gz"}  # tests/cli/test_released_outputs.py
    assert written["convert"] == {*PATTERN_ENDINGS, *MESH_ENDINGS} - lists
    assert set(LISTS) == lists


@pytest.fixture(scope="module", autouse=True)
def _quickly_made(rough_falls) -> Iterator[None]:
    """What matters here is where files go, not what garments and pictures look like."""
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr("swifttailor.tailor.tailored.PREVIEW_SIZE", (100, 60))
        yield


@pytest.fixture(scope="module")
def inputs(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("inputs")
    for name in ("skirt", "other"):
        write_pattern(draft("fitted-skirt"), folder / f"{name}.json")
    worn().save(folder / "worn", preview=False)
    write_ggi(encode(worn(), 128), folder / "ggi.npz")
    line = {"id": "skirt", "pattern": to_specification(draft("fitted-skirt"))}
    (folder / "skirts.jsonl").write_text(json.dumps(line) + "\n")
    (folder / "design.yaml").write_text("meta.bottom: Skirt2\nskirt.ruffle: 1\n")
    Image.new("RGB", (200, 200), "white").save(folder / "photo.png")
    assert run(["fit", str(folder / "skirt.json"), "--sizes", "36,40", "--out", str(folder / "sizes")]) in (
        0,
        1,
    )
    return folder


def worn() -> Garment:
    mesh = mesh_pattern(draft("fitted-skirt"), edge_length=8.0)
    vertices = np.random.default_rng(0).normal(0.0, 40.0, (mesh.vertex_count, 3))
    return Garment(mesh, vertices, {"edge_length_cm": 8.0, "rotation": "intrinsic"})


@pytest.fixture
def ask(inputs, tmp_path, monkeypatch):
    """Runs a command line with its inputs, and OUT for a folder that is empty at first."""
    maker = scripted_maker(*([draft("fitted-skirt")] for _ in range(4)))
    monkeypatch.setattr(PatternMaker, "load", staticmethod(lambda weights=None, threads=1: maker))
    monkeypatch.chdir(tmp_path)
    out = tmp_path / "out"

    def asked(line: str, *more: str) -> int:
        words = [word.replace("OUT", str(out)) for word in line.split()]
        return run([str(inputs / w) if (inputs / w).exists() else w for w in words] + list(more))

    asked.out = out
    return asked


def files(folder: Path) -> set[str]:
    return {p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file() and p.name != LIST}


def kept(folder: Path) -> dict[str, tuple[bytes, int]]:
    return {n: ((folder / n).read_bytes(), (folder / n).stat().st_mtime_ns) for n in files(folder)}


@pytest.mark.parametrize("command", COMMANDS)
def test_what_a_command_writes(command, ask, capsys):
    """So that the lists above are complete; and a second time over what is there."""
    line, names = COMMANDS[command]
    assert ask(line) in (0, 1)
    assert files(ask.out) == set(names)
    if not command.startswith(("data edits", "data captions", "marker")) and command != "fit":
        # what takes longer is refused at once
        assert ask(line) in (0, 1), capsys.readouterr().err
    (ask.out / "mine.txt").write_text("mine")
    assert ask(line, "--overwrite") in (0, 1)
    assert files(ask.out) == {*names, "mine.txt"}


@pytest.mark.parametrize(
    ("command", "name"),
    [(c, n) for c, (_, names) in (COMMANDS | RESUMED).items() for n in names],
)
def test_a_file_of_that_name_stays(command, name, ask, capsys):
    (ask.out / name).parent.mkdir(parents=True)
    (ask.out / name).write_text("my own work")
    before = kept(ask.out)
    assert ask((COMMANDS | RESUMED)[command][0]) == 2
    said = capsys.readouterr().err
    if command in RESUMED and "would be replaced" not in said:
        assert f"'{ask.out}" in said and ("is not empty and holds no" in said or "is damaged" in said)
    else:
        assert f"'{ask.out / name}' would be replaced" in said
    assert kept(ask.out) == before


@pytest.mark.skipif(sys.platform == "win32", reason="has no such limit")
@pytest.mark.parametrize("limit", [50, 5_000], ids=["none fits", "some fit"])
@pytest.mark.parametrize("command", COMMANDS)
def test_where_files_may_not_be_so_large_nothing_is_left(command, limit, ask, capsys):
    import resource

    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (limit, hard))
    try:
        code = ask(COMMANDS[command][0])
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    if limit > 50 and code < 2:
        assert files(ask.out) == set(COMMANDS[command][1])
        return
    streams = capsys.readouterr()
    said = streams.err + streams.out
    assert code == 2 and not files(ask.out)
    # The solver may have to be compiled first, and cannot be kept.
    assert "`ulimit -f`" in said and (f"Cannot write '{ask.out}" in said or "compiled code" in said)


@pytest.mark.parametrize("command", ["sew", "ggi", "generate"])
def test_one_s_own_result_that_was_changed_stays(command, ask, capsys):
    line, names = COMMANDS[command]
    assert ask(line) in (0, 1)
    for name in names:
        original = (ask.out / name).read_bytes()
        (ask.out / name).write_bytes(original + b"\n")
        before = kept(ask.out)
        capsys.readouterr()
        assert ask(line) == 2
        assert f"'{ask.out / name}' would be replaced" in capsys.readouterr().err
        assert kept(ask.out) == before
        (ask.out / name).write_bytes(original)


def test_a_preview_that_was_not_asked_for_is_left_alone(ask):
    ask.out.mkdir()
    (ask.out / "preview.png").write_text("mine")
    assert ask(f"{COMMANDS['sew --no-preview'][0]}") == 0
    assert (ask.out / "preview.png").read_text() == "mine"


def test_images_decoded_into_their_own_folder_stay(ask):
    assert ask(COMMANDS["ggi of a garment"][0]) == 0
    before = kept(ask.out)
    assert run(["ggi", "--decode", str(ask.out / "ggi.npz"), "--out", str(ask.out)]) == 0
    after = kept(ask.out)
    assert {name: after[name] for name in before} == before and "garment.obj" in after


def test_places_where_none_is_given_are_new_ones(ask, tmp_path, capsys):
    for line, names in (
        ("draft fitted-skirt", ["fitted-skirt.json", "fitted-skirt-2.json"]),
        (f"sew skirt.json --no-preview --weights {TINY}", ["skirt-sewn", "skirt-sewn-2"]),
        ("drape skirt.json --no-preview --edge-length 8", ["skirt-draped", "skirt-draped-2"]),
        ("ggi skirt.json", ["skirt-ggi", "skirt-ggi-2"]),
        ("ggi --decode ggi.npz", ["ggi-garment", "ggi-garment-2"]),
        (f"edit skirt.json shorter --no-preview --sewer-weights {TINY}", ["skirt-edited", "skirt-edited-2"]),
        (f"generate Dress! --source writer --no-preview --sewer-weights {TINY}", ["dress", "dress-2"]),
    ):
        for name in names:
            assert ask(line) in (0, 1)
            assert name in capsys.readouterr().out
            assert (tmp_path / name).exists()


@pytest.mark.parametrize(
    ("name", "write"),
    [
        *((n, lambda folder, **o: worn().save(folder, **o)) for n in (*FOLDER, "preview.png")),
        ("a.json", lambda folder, **o: draft("fitted-skirt").save(folder / "a.json", **o)),
        ("a.svg", lambda folder, **o: write_svg(draft("fitted-skirt"), folder / "a.svg", **o)),
        ("a.npz", lambda folder, **o: write_ggi(encode(worn(), 64), folder / "a.npz", **o)),
        *(
            (f"a{e}", lambda f, e=e, **o: write_garment_mesh(mesh_of_garment(worn()), f / f"a{e}", **o))
            for e in (".obj", ".glb", ".ply", ".stl")
        ),
    ],
)
def test_in_python(name, write, tmp_path):
    (tmp_path / name).write_text("my own work")
    before = kept(tmp_path)
    with pytest.raises(InputError, match="would be replaced"):
        write(tmp_path)
    assert kept(tmp_path) == before
    write(tmp_path, overwrite=True)
    assert (tmp_path / name).read_bytes() != b"my own work"
    write(tmp_path)  # over the same


@pytest.mark.parametrize("name", MADE)
def test_what_a_tailor_hands_over(name, tmp_path, monkeypatch):
    made = swifttailor.Tailor(garment_sewer=TINY).sew(draft("fitted-skirt"))
    (tmp_path / name).write_text("my own work")
    before = kept(tmp_path)
    with pytest.raises(InputError, match="would be replaced"):
        made.save(tmp_path)
    assert kept(tmp_path) == before


def test_of_three_at_once_one_writes(inputs, tmp_path):
    out = tmp_path / "out"
    program = f"""
import sys, time
from pathlib import Path
from swifttailor.cli import main as cli
from swifttailor.cli.convert import LISTS, PATTERN_ENDINGS
from swifttailor.cli.data import DATA
from swifttailor.cli.evaluate import EVALUATE
from swifttailor.cli.main import run
from swifttailor.cli.train import TRAIN
from swifttailor.tailor import Tailor
real = Tailor.sew_all
def slowly(*arguments, **options):
    Path(sys.argv[1]).write_text("at work")
    while not Path({str(tmp_path / "go")!r}).exists():
        time.sleep(0.02)
    return real(*arguments, **options)
Tailor.sew_all = slowly
sys.exit(run(["sew", sys.argv[2], "--out", {str(out)!r}, "--no-preview", "--weights", {TINY!r}]))
"""
    running = []
    for k, pattern in enumerate(("skirt.json", "other.json", "worn/pattern.json")):
        command = [sys.executable, "-c", program, str(tmp_path / f"started-{k}"), str(inputs / pattern)]
        running.append(subprocess.Popen(command, stderr=subprocess.PIPE, text=True))
    ended = []
    while len(ended) < 2:
        ended = [p for p in running if p.poll() is not None]
    assert not out.joinpath("report.json").exists()
    (tmp_path / "go").write_text("")
    codes = sorted(p.wait() for p in running)
    said = [p.stderr.read() for p in running]
    assert codes == [0, 2, 2]
    assert sum(f"Another SwiftTailor is at work in '{out}'" in text for text in said) == 2
    assert files(out) == set(FOLDER) and Garment.load(out).report["findings"] == []

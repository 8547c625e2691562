"""Any generator with any constructor: what is counted, kept, gone on with and refused."""

from __future__ import annotations

import csv
import io
import json
from dataclasses import dataclass, field, replace

import numpy as np
import pytest
from maker_standins import write_patterns
from sewn_splits import EDGE_LENGTH, LOWER

from swifttailor.atomic_files import disk_full
from swifttailor.body import Body
from swifttailor.cli.item_progress import ItemProgress
from swifttailor.cli.main import run
from swifttailor.errors import InputError, PatternError
from swifttailor.evaluation.maker.ask import Asking
from swifttailor.evaluation.maker.run import Plan
from swifttailor.evaluation.systems import made_garments
from swifttailor.evaluation.systems.generator import Recorded, Truth
from swifttailor.evaluation.systems.run import Cell, SystemsResult, run_systems
from swifttailor.evaluation.systems.tables import tables_of
from swifttailor.evaluation.table import Table
from swifttailor.evaluation.text_table import Column
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.garment_sewer.pixels.sewn_prior import sew_around_body
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern import Pattern, to_specification
from swifttailor.pattern.drafts import draft
from swifttailor.workers.work_folder import RecordFile


@dataclass
class Lowered:
    """Somebody's constructor: as the drapes of `sewn_splits` are made, so much lower or higher."""

    name: str = "lowered"
    higher_cm: float = 0.0
    refuses: tuple[str, ...] = ()
    made: list[str] = field(default_factory=list)

    def identity(self):
        return {"higher_cm": self.higher_cm}

    def make(self, pattern: Pattern) -> Garment:
        self.made.append(pattern.name)
        if pattern.name in self.refuses:
            raise PatternError(f"'{pattern.name}' is not to be sewn.")
        mesh = mesh_pattern(pattern.canonical(), EDGE_LENGTH)
        vertices = sew_around_body(mesh, BodyDistance.of(Body.default())) + LOWER
        vertices = vertices + np.array([0.0, self.higher_cm, 0.0])
        accepted = self.higher_cm == 0
        quality = {"accepted": accepted, "reasons": [] if accepted else ["too high"]}
        return Garment(mesh, vertices, {"quality": quality, "seconds": {"sewing": 2.0}})


@pytest.fixture
def plan(data, tmp_path, monkeypatch) -> Plan:
    monkeypatch.setattr(made_garments, "FEW_POINTS", 300)
    return Plan((write_patterns(tmp_path),), data, tasks=("text",), asking=Asking(seed=3), samples=0)


def cell_of(found: SystemsResult, generator: str, constructor: str) -> Cell:
    (cell,) = [c for c in found.cells if (c.generator, c.constructor) == (generator, constructor)]
    return cell


def recorded(**patterns) -> Recorded:
    return Recorded("theirs", {id: draft(name, **options) for id, (name, options) in patterns.items()})


SHIRT = {"shirt": ("t-shirt", {})}
TWO = SHIRT | {"short": ("fitted-skirt", {"length": 45.0})}


def test_true_patterns_made_as_the_drapes_are_lie_on_them(plan, tmp_path):
    found = run_systems([Truth()], [Lowered(), Lowered("high", 10.0)], plan, tmp_path / "out", ItemProgress)
    near, far = cell_of(found, "truth", "lowered"), cell_of(found, "truth", "high")
    floor = found.floors["text"]
    assert near.asked == near.made == near.sound == near.accepted == 4
    assert near.compared == 3, "the trousers have no drape"
    assert near.chamfer and near.chamfer.count == 3
    assert near.sets is not None and far.sets is not None and near.chamfer and far.chamfer and near.emd
    assert near.sets.coverage == floor.coverage == 1.0
    assert near.sets.mmd == pytest.approx(floor.mmd, rel=0.1), "two draws of points from one surface"
    assert near.chamfer.mean == pytest.approx(near.sets.mmd), "each garment is the nearest to its drape"
    assert far.chamfer.mean > 10 * near.chamfer.mean and far.accepted == 0
    assert near.seconds == {"sewing": 2.0} and not near.failures
    assert not found.skipped
    (result,) = found.answers["truth"]
    assert result.patterns[0][1].aipparel["stitches"].mean == 1.0


def test_what_is_missing_counts_as_a_failure_of_that_system(plan, tmp_path):
    sewing = Lowered(refuses=("short",))
    found = run_systems([Truth(), recorded(**SHIRT)], [sewing], plan, tmp_path / "out", ItemProgress)
    theirs, ours = cell_of(found, "theirs", "lowered"), cell_of(found, "truth", "lowered")
    assert (theirs.asked, theirs.made, theirs.accepted) == (4, 1, 1)
    assert (
        theirs.failures.keys() == {"short", "long", "trousers"}
        and "no output for 'long'" in theirs.failures["long"]
    )
    assert theirs.sets is not None and theirs.sets.coverage == pytest.approx(1 / 3)
    assert theirs.sets.failed == 2
    assert (ours.made, ours.failures) == (3, {"short": "'short' is not to be sewn."})
    (result,) = found.answers["theirs"]
    assert result.patterns[0][1].missing == 3 and result.attempts == 0


def test_what_is_done_is_not_done_again(plan, tmp_path):
    out, first, again = tmp_path / "out", Lowered(), Lowered()
    before = run_systems([Truth()], [first], replace(plan, limit=1), out, ItemProgress)
    assert len(first.made) == 1
    run_systems([Truth()], [first], plan, out, ItemProgress)
    assert len(first.made) == 4, "a larger limit goes on with the same ones"
    after = run_systems([Truth(), recorded(**TWO)], [again], plan, out, ItemProgress)
    assert len(again.made) == 2, "only what the generator that joined has answered"
    assert cell_of(before, "truth", "lowered").asked == 1
    assert cell_of(after, "truth", "lowered").made == 4
    assert cell_of(after, "truth", "lowered").mebibytes is None, "nothing was made now"


def test_going_on_gives_the_same_numbers(plan, tmp_path):
    whole = run_systems([Truth()], [Lowered()], plan, tmp_path / "whole", ItemProgress)
    run_systems([Truth()], [Lowered()], replace(plan, limit=2), tmp_path / "parts", ItemProgress)
    parts = run_systems([Truth()], [Lowered()], plan, tmp_path / "parts", ItemProgress)
    one, other = (replace(r.cells[0], mebibytes=None) for r in (whole, parts))
    assert one == other


def test_other_settings_in_the_same_folder_are_refused(plan, tmp_path):
    out = tmp_path / "out"
    run_systems([recorded(**SHIRT)], [Lowered()], plan, out, ItemProgress)
    with pytest.raises(InputError, match="made in another way"):
        run_systems([recorded(**TWO)], [Lowered()], plan, out, ItemProgress)
    with pytest.raises(InputError, match="made in another way"):
        run_systems([recorded(**SHIRT)], [Lowered(higher_cm=1.0)], plan, out, ItemProgress)


def test_damaged_garments_are_named(plan, tmp_path):
    out = tmp_path / "out"
    run_systems([Truth()], [Lowered()], plan, out, ItemProgress)
    folder = out / "truth" / "garments-lowered"
    path = next((folder / "points").glob("*.npy"))
    path.write_bytes(path.read_bytes()[:400])
    with pytest.raises(InputError, match="is damaged"):
        run_systems([Truth()], [Lowered()], plan, out, ItemProgress)
    path.unlink()
    again = Lowered()
    run_systems([Truth()], [again], plan, out, ItemProgress)
    assert len(again.made) == 1, "what is gone is made again"


@pytest.mark.parametrize("name", ["", "../up", "a b", "x" * 41, ".hidden", "a/b"])
def test_names_that_cannot_be_folders_are_refused(plan, tmp_path, name):
    with pytest.raises(InputError, match="cannot name a system"):
        run_systems([Recorded(name, {})], [], plan, tmp_path / "out", ItemProgress)


def test_what_cannot_be_compared_is_refused(plan, tmp_path):
    out = tmp_path / "out"
    with pytest.raises(InputError, match="two systems of the name"):
        run_systems([Truth(), Truth()], [], plan, out, ItemProgress)
    with pytest.raises(InputError, match="--tasks"):
        run_systems([Truth()], [], replace(plan, tasks=("edit",)), out, ItemProgress)
    with pytest.raises(InputError, match="--data DIR"):
        run_systems([Truth()], [Lowered()], replace(plan, data=None), out, ItemProgress)


def test_without_drapes_patterns_alone_are_compared(plan, tmp_path):
    found = run_systems([Truth()], [], replace(plan, data=None), tmp_path / "out", ItemProgress)
    assert not found.cells and not found.skipped and found.about["questions"] == {"text": 4}
    assert [t.title for t in tables_of(found)] == [
        "Patterns from a text",
        "Patterns from a text, without conditions",
        "What was asked for, from a text",
    ]


def test_a_table_says_the_same_in_every_format():
    table = Table(
        "A & B",
        "In cm_2",
        [Column("x %", ".1f"), Column("n", "d")],
        [("a_b", [12.345, 3]), ("  c", [None, 4])],
    )
    rows = list(csv.reader(io.StringIO(table.csv())))
    assert rows == [
        ["table", "row", "x %", "n"],
        ["A & B", "a_b", "12.345", "3"],
        ["A & B", "c", "", "4"],
    ]
    latex = table.latex()
    assert r"a\_b & 12.3 & 3 \\" in latex and r"\quad c & -- & 4 \\" in latex
    assert r"\caption{A \& B. In cm\_2}" in latex and r"x \%" in latex and "{lrr}" in latex
    assert "12.3" in table.text() and "A & B" in table.text()


def test_the_command_fills_the_table_and_goes_on(data, tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(made_garments, "FEW_POINTS", 300)
    patterns, theirs, out = write_patterns(tmp_path), tmp_path / "theirs", tmp_path / "out"
    theirs.mkdir()
    (theirs / "shirt.json").write_text(json.dumps(to_specification(draft("t-shirt", length=50.0))))
    asked = ["evaluate", "systems", "--patterns", str(patterns), "--data", str(data), "--out", str(out)]
    asked += ["--tasks", "text", "--generators", "truth", "chance", f"theirs={theirs}"]
    assert run(asked) == 0
    shown = capsys.readouterr().out
    for row in ("truth + network", "chance + network", "theirs + network", "paper: AIpparel + GarmentCode"):
        assert row in shown
    assert "the drapes, points drawn again" in shown and "seed 0" in shown and "commit" in shown
    files = {p.name for p in out.iterdir() if p.is_file()} - {".swifttailor"}
    assert files == {"summary.json", "tables.txt", "tables.csv", "tables.tex", "failures.jsonl"}
    summary = json.loads((out / "summary.json").read_text())
    assert {(c["generator"], c["made"]) for c in summary["cells"]} == {
        ("truth", 4),
        ("chance", 4),
        ("theirs", 1),
    }
    lost = [json.loads(line) for line in (out / "failures.jsonl").read_text().splitlines()]
    assert {one["generator"] for one in lost} == {"theirs"}
    assert {one["id"] for one in lost} == {"short", "long", "trousers"}
    first = (out / "tables.csv").read_text()
    assert run(asked) == 0
    # What took memory and time is told of what was made now.
    cut = first.index("Running time")
    assert (out / "tables.csv").read_text()[:cut] == first[:cut]


@pytest.mark.parametrize(
    ("more", "said"),
    [
        (["--generators", "theirs"], "NAME=SOURCE"),
        (["--generators", "theirs=nowhere"], "nowhere"),
        (["--limit", "0"], "--limit"),
        (["--tasks", "image"], "--data"),
    ],
)
def test_bad_options_are_refused(tmp_path, capsys, more, said):
    asked = ["evaluate", "systems", "--patterns", str(write_patterns(tmp_path)), "--out", str(tmp_path / "o")]
    assert run([*asked, *more]) == 2
    assert said in capsys.readouterr().err


def test_recorded_tables_are_read_as_they_were():
    columns = [Column("x"), Column("n", "d")]
    table = Table("A", "note", columns, [("row | one", [1.5, 3]), ("  other", [None, 4])])
    assert Table.of_json(json.loads(json.dumps(table.to_json()))) == table
    lines = table.markdown().splitlines()
    assert lines[0] == "### A" and lines[-2:] == [r"| row \| one | 1.50 | 3 |", "| other | - | 4 |"]


@pytest.mark.parametrize(
    "value",
    [
        {},
        [],
        {"title": "A", "note": "", "columns": [["x", ".2f"]], "rows": [["a", [1.0, 2.0]]]},
        {"title": "A", "note": "", "columns": [["x", "%s%s"]], "rows": [["a", [1.0]]]},
        {"title": "A", "note": "", "columns": [["x", ".2f"]], "rows": [["a", ["1"]]]},
    ],
)
def test_recorded_tables_that_are_none_are_refused(value):
    with pytest.raises(InputError, match="damaged"):
        Table.of_json(value)


def test_a_page_has_the_tables_of_its_runs_and_where_they_come_from(tmp_path, capsys):
    patterns, out = write_patterns(tmp_path), tmp_path / "out"
    asked = ["evaluate", "systems", "--patterns", str(patterns), "--out", str(out), "--tasks", "text"]
    assert run([*asked, "--generators", "truth", "--sewers", "--seed", "5"]) == 0
    (tmp_path / "Drafts.json").write_bytes((out / "summary.json").read_bytes())
    page = tmp_path / "results.md"
    assert run(["evaluate", "page", str(tmp_path / "Drafts.json"), "--out", str(page)]) == 0
    text = page.read_text()
    assert "## Drafts" in text and "seed 5" in text and "### Patterns from a text" in text
    assert "swifttailor evaluate systems --patterns patterns.jsonl --generators truth" in text
    assert str(tmp_path) not in text, "the places of files are nobody's business"
    capsys.readouterr()
    page.write_text("somebody's")
    assert run(["evaluate", "page", str(tmp_path / "Drafts.json"), "--out", str(page)]) == 2
    assert page.read_text() == "somebody's"
    assert run(["evaluate", "page", str(patterns)]) == 2
    assert "Cannot read" in capsys.readouterr().err
    (tmp_path / "other.json").write_text('{"about": {}, "tables": []}')
    assert run(["evaluate", "page", str(tmp_path / "other.json")]) == 2
    assert "is no summary" in capsys.readouterr().err


def test_a_full_disk_is_told_with_how_to_go_on(tmp_path, capsys, monkeypatch):
    real, asked = RecordFile.add, ["evaluate", "systems", "--patterns", str(write_patterns(tmp_path))]
    asked += ["--out", str(tmp_path / "out"), "--tasks", "text", "--generators", "truth", "--sewers"]
    added = []

    def full_after_one(self, record):
        if added:
            raise disk_full(self.path)
        added.append(record)
        real(self, record)

    monkeypatch.setattr(RecordFile, "add", full_after_one)
    assert run(asked) == 2
    said = capsys.readouterr().err
    assert "the disk is full" in said and said.count("start the same command again") == 1
    monkeypatch.setattr(RecordFile, "add", real)
    assert run(asked) == 0 and "questions: 4 text" in capsys.readouterr().out
    lines = (tmp_path / "out" / "truth" / "answers.jsonl").read_text().splitlines()
    assert len(lines) == 4 and json.loads(lines[0]) == json.loads(json.dumps(added[0]))

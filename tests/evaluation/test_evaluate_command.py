"""``swifttailor evaluate``: garment-sewer with an untrained network, drape-floor with coarse drapes."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from sewn_splits import LOWER, make_sample, write_split

from swifttailor.cli.main import run
from swifttailor.data.builder.settings import BuildSettings
from swifttailor.data.reader import SplitReader
from swifttailor.draping import drape
from swifttailor.draping.batch import BatchSettings
from swifttailor.errors import GeometryError, InputError
from swifttailor.evaluation import results_page
from swifttailor.evaluation.garments.redrape import RECORDS, SETTINGS, Redraper
from swifttailor.evaluation.garments.sew_split import sew_split
from swifttailor.evaluation.provenance import choose_samples, provenance, provenance_lines
from swifttailor.garment_sewer.sewer import GarmentSewer

pytestmark = pytest.mark.usefixtures("fewer_points")

TINY = Path(__file__).parents[1] / "garment_sewer" / "tiny_sewer.onnx"
"""An untrained network: it predicts its prior."""
TINY_MAKER = Path(__file__).parents[1] / "pattern_maker" / "tiny_maker.zip"


def arguments(data: Path, *more: str) -> list[str]:
    given = ["evaluate", "garment-sewer", "--data", str(data), "--split", "validation"]
    return [*given, "--weights", str(TINY), *more]


@pytest.fixture(scope="module")
def sewer() -> GarmentSewer:
    return GarmentSewer.load(TINY)


def test_a_network_that_predicts_the_prior_is_as_far_off_as_the_drape_was_moved(data, sewer):
    """The drapes of this data set are the prior, 4 cm lower."""
    reader = SplitReader(data / "validation")
    done: list[int] = []
    made = sew_split(sewer, reader, [0, 1, 2], progress=done.append)
    assert sum(done) == 3 and not made.errors and list(made.vertices) == [0, 1, 2]
    assert [s.score.id for s in made.scored] == list(reader.ids)
    # The network sees 64 x 64 pixels, so that its prior is rough, and grows to its lengths as it relaxes.
    distances = [found.score.vertex_mean_cm for found in made.scored]
    assert min(distances) > 2.0 and np.mean(distances) == pytest.approx(-LOWER[1], abs=2.5)
    for found in made.scored:
        assert found.score.seam_gap_median_cm is not None and found.score.seconds is not None
        assert found.score.sound and found.score.inside <= 0.02
    alone = sew_split(sewer, reader, [1])
    assert alone.scored[0].score.chamfer_cm2 == pytest.approx(made.scored[1].score.chamfer_cm2, rel=1e-3)


def test_patterns_that_cannot_be_sewn_are_counted(data, sewer, monkeypatch):
    reader = SplitReader(data / "validation")
    prepare, decode = GarmentSewer.prepare, GarmentSewer.decode

    def no_shirts(self, pattern, **more):
        if any("torso" in p.name or "sleeve" in p.name for p in pattern.panels):
            raise GeometryError("A panel crosses itself.")
        return prepare(self, pattern, **more)

    def no_long_skirts(self, prepared, values):
        if max(np.ptp(p.vertices[:, 1]) for p in prepared.layout.pattern.panels) > 60:
            raise InputError("Not finite.")
        return decode(self, prepared, values)

    monkeypatch.setattr(GarmentSewer, "prepare", no_shirts)
    monkeypatch.setattr(GarmentSewer, "decode", no_long_skirts)
    made = sew_split(sewer, reader, [0, 1, 2])
    assert [s.score.id for s in made.scored] == ["short"]
    assert made.errors == {"shirt": "A panel crosses itself.", "long": "Not finite."}
    whole = reader.sample("shirt").garment.vertices
    assert np.abs(made.lost[0].points.mean(axis=0) - whole.mean(axis=0)).max() < 5


def test_the_command_prints_tables_and_writes_what_is_behind_them(data, tmp_path, capsys):
    out = tmp_path / "results"
    assert run(arguments(data, "--out", str(out), "--pictures", "1")) == 0
    shown = capsys.readouterr().out
    assert "split validation: 3 of 3 garments, seed 0" in shown and "tiny_sewer.onnx" in shown
    assert "commit" in shown and "cores" in shown and "paper: GarmentSewer, L_reg + L_stitch" in shown
    names = {p.name for p in out.iterdir()}
    assert names == {"tables.txt", "summary.json", "garments.jsonl", "sheet-01.png", ".swifttailor"}
    assert (out / "tables.txt").read_text() == shown
    lines = [json.loads(line) for line in (out / "garments.jsonl").read_text().splitlines()]
    assert [line["id"] for line in lines] == ["short", "shirt", "long"]
    summary = json.loads((out / "summary.json").read_text())
    mean = np.mean([line["vertex_mean_cm"] for line in lines])
    assert summary["result"]["means"]["vertex_mean_cm"]["mean"] == pytest.approx(mean)
    assert summary["about"]["split"] == "validation" and summary["about"]["samples"] == 3
    assert str(tmp_path) not in json.dumps(summary) and str(data) not in json.dumps(summary)
    assert f" {mean:.2f} " in next(line for line in shown.splitlines() if line.startswith("all"))


def test_finished_garments_are_judged_as_drapes_are(data, tmp_path, capsys):
    assert run(arguments(data, "--limit", "1", "--finish", "--json", "--out", str(tmp_path))) == 0
    finished = json.loads(capsys.readouterr().out)
    assert run(arguments(data, "--limit", "1", "--json")) == 0
    sewn = json.loads(capsys.readouterr().out)
    assert finished["about"]["finish"] and not sewn["about"]["finish"]
    after, before = (content["result"]["means"] for content in (finished, sewn))
    (line,) = (json.loads(line) for line in (tmp_path / "garments.jsonl").read_text().splitlines())
    assert after["accepted"]["mean"] == float(line["accepted"]) and "accepted" not in before
    assert line["accepted"] is (not line["rejected_for"])
    assert after["inside"]["mean"] == 0.0
    # It falls from where the network has put it onto the body.
    assert abs(after["vertex_mean_cm"]["mean"] - before["vertex_mean_cm"]["mean"]) > 0.1


def test_a_part_of_the_split_as_json(data, capsys):
    assert run(arguments(data, "--limit", "2", "--json", "--seed", "3")) == 0
    content = json.loads(capsys.readouterr().out)
    assert content["result"]["garments"] == 2 and content["about"]["of"] == 3
    assert content["about"]["seed"] == 3


@pytest.mark.parametrize(
    ("more", "said"),
    [
        (["--limit", "0"], "--limit is 0"),
        (["--split", "test"], "has no split 'test', only validation"),
        (["--pictures", "-1"], "from 0 to 200"),
        (["--threads", "0"], "from 1 to 256"),
        (["--weights", "nothing.onnx"], "Cannot read the weights"),
        (["--resolution", "100"], "multiple of 8"),
    ],
)
def test_what_cannot_be_evaluated_is_refused(data, more, said, capsys):
    code = run(arguments(data, *more))
    assert code == 2 and said in capsys.readouterr().err


def test_samples_are_chosen_by_seed_and_a_larger_limit_keeps_them(data):
    reader = SplitReader(data / "validation")
    assert choose_samples(reader, None, 0) == [0, 1, 2] == choose_samples(reader, 99, 5)
    for seed in range(4):
        one, two = (choose_samples(reader, n, seed) for n in (1, 2))
        assert set(one) < set(two) and two == sorted(two)
    assert len({choose_samples(reader, 1, seed)[0] for seed in range(20)}) > 1


def test_provenance_says_when_the_drapes_are_of_other_code(data, tmp_path):
    reader = SplitReader(data / "validation")
    about = provenance(reader, [0], 7)
    assert not about["drapes_of_this_code"] and "made by other code" in provenance_lines(about)
    assert "made by other code" not in provenance_lines(about | {"drapes_of_this_code": True})
    assert about["drapes"]["fabric"] == "cotton" and about["data"] == data.name


# Drapes again


@pytest.fixture(scope="module")
def draped(tmp_path_factory) -> Path:
    """A data set of two real, coarse drapes."""
    folder = tmp_path_factory.mktemp("draped")
    samples = []
    for id, length in (("a", 50.0), ("b", 60.0)):
        sample = make_sample(id, "fitted-skirt", length=length)
        garment = drape(sample.pattern, edge_length=sample.edge_length)
        samples.append(type(sample).of_garment(id, garment, sample.edge_length, {}))
    write_split(folder / "validation", samples)
    return folder


def test_the_floor_is_small_and_goes_on_where_it_stopped(draped, tmp_path, monkeypatch, capsys):
    out = tmp_path / "floor"
    given = ["evaluate", "drape-floor", "--data", str(draped), "--out", str(out), "--pictures", "0"]
    assert run([*given, "--limit", "1"]) == 0
    assert "1 of 2 garments" in capsys.readouterr().out
    draped_ids = []
    from swifttailor.evaluation.garments import redrape

    def watched(pattern, **more):
        draped_ids.append(pattern.name)
        assert more["seed"] == 1 and more["fabric"] == "cotton" and more["edge_length"] == 6.0
        return drape(pattern, **more)

    monkeypatch.setattr(redrape, "drape", watched)
    assert run(given) == 0
    assert len(draped_ids) == 1
    shown = capsys.readouterr().out
    assert "drape seed 1 against 0" in shown and "another drape, validation" in shown
    lines = [json.loads(line) for line in (out / "garments.jsonl").read_text().splitlines()]
    assert [line["id"] for line in lines] == ["a", "b"]
    # Another drape, not the same one, and yet near.
    assert all(0 < line["vertex_mean_cm"] < 5 for line in lines)
    assert all(line["strain_p95"] == pytest.approx(line["drape_strain_p95"], abs=0.05) for line in lines)
    tables = (out / "tables.txt").read_text()
    assert run(given) == 0 and len(draped_ids) == 1
    assert (out / "tables.txt").read_text() == tables


def test_a_pattern_that_cannot_be_draped_again_is_counted(draped, tmp_path, monkeypatch, capsys):
    from swifttailor.evaluation.garments import redrape

    def moved(pattern, **more):
        if pattern.name == "a":
            raise GeometryError("The cloth moved to infinity.")
        garment = SplitReader(draped / "validation").sample("b").garment
        quality = {"accepted": False, "reasons": ["too tight"]}
        return type(garment)(garment.mesh, garment.vertices + 1.0, {"quality": quality})

    monkeypatch.setattr(redrape, "drape", moved)
    given = ["evaluate", "drape-floor", "--data", str(draped), "--out", str(tmp_path), "--pictures", "0"]
    for _ in range(2):  # the second time from the records
        assert run(given) == 1
        shown = capsys.readouterr().out
        assert "a: The cloth moved to infinity." in shown and "1 more could not be made" in shown
        assert "1 of the new drapes are beyond the limits" in shown
    made, rejected = Redraper(SplitReader(draped / "validation"), tmp_path).run([0, 1])
    assert rejected == 1 and made.scored[0].score.vertex_mean_cm == pytest.approx(3**0.5)


def test_drapes_of_different_makes_are_not_mixed(draped, data, tmp_path):
    reader = SplitReader(draped / "validation")
    Redraper(reader, tmp_path)
    for other in ({"drape_seed": 2}, {"seed": 1}):
        with pytest.raises(InputError, match="made in another way"):
            Redraper(reader, tmp_path, **other)
    with pytest.raises(InputError, match="seed 0 as well"):
        Redraper(reader, tmp_path / "x", drape_seed=0)
    (tmp_path / SETTINGS).write_text("{")
    with pytest.raises(InputError, match="Cannot read"):
        Redraper(reader, tmp_path)


def test_damaged_records_are_named(draped, tmp_path):
    reader = SplitReader(draped / "validation")
    folder = tmp_path / RECORDS
    redraper = Redraper(reader, tmp_path)
    folder.mkdir()
    (folder / "000000.json").write_text("{")
    with pytest.raises(InputError, match=r"000000\.json' is damaged"):
        redraper.run([0])
    (folder / "000000.json").write_text('{"id": "z"}')
    with pytest.raises(InputError, match="of the garment 'z'"):
        redraper.run([0])
    score = {"id": "a", "score": {}, "accepted": True}
    (folder / "000000.json").write_text(json.dumps(score))
    with pytest.raises(InputError, match=r"000000\.npy' is missing or damaged"):
        redraper.run([0])


def test_drapes_of_others_cannot_be_made_again(tmp_path):
    sample = make_sample("a", "fitted-skirt")
    imported = BuildSettings(BatchSettings(), origin="GarmentCodeData", origin_body="mean_all").identity()
    for name, settings in (("one", {}), ("two", imported)):
        reader = SplitReader(write_split(tmp_path / name, [sample], settings))
        with pytest.raises(InputError, match="not made by SwiftTailor"):
            Redraper(reader, tmp_path / "out")


def test_unknown_and_no_evaluations(capsys):
    assert run(["evaluate"]) == 2 and "usage: swifttailor evaluate" in capsys.readouterr().err
    assert run(["evaluate", "taste"]) == 2 and "no command 'evaluate taste'" in capsys.readouterr().err
    assert run(["evaluate", "--help"]) == 0 and "drape-floor" in capsys.readouterr().out


def test_garments_are_meshed_as_asked_and_kept_ones_are_not_taken_for_others(data, tmp_path, capsys):
    asked = ["evaluate", "systems", "--patterns", str(data / "validation"), "--out", str(tmp_path)]
    asked += ["--data", str(data / "validation"), "--generators", "truth", "--sewers", "physics"]
    asked += ["--tasks", "text", "--limit", "1"]
    assert run([*asked, "--edge-length", "6"]) == 0
    about = json.loads((tmp_path / "summary.json").read_text())["about"]
    assert " --sewers physics --edge-length 6 --tasks text " in about["command"]
    capsys.readouterr()
    assert run([*asked, "--edge-length", "5"]) == 2, "garments of 6 cm are no garments of 5"
    assert "edge_length" in capsys.readouterr().err
    assert run([*asked, "--edge-length", "0"]) == 2
    assert "--edge-length is 0" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("command", "name"),
    [
        *(("garment-sewer", n) for n in ("garments.jsonl", "summary.json", "tables.txt", "sheet-01.png")),
        *(("drape-floor", n) for n in ("garments.jsonl", "summary.json", "tables.txt", "redrapes.json")),
        ("drape-floor", "redrapes/000000.npy"),
        *(("picture-reader", n) for n in ("summary.json", "tables.txt")),
        *(("pattern-maker", n) for n in ("scores.jsonl", "summary.json", "tables.txt", "settings.json")),
        *(("pattern-maker", n) for n in ("answers.jsonl", "samples.jsonl")),
        *(("systems", n) for n in ("summary.json", "tables.txt", "tables.csv", "tables.tex")),
        *(("systems", n) for n in ("failures.jsonl", "truth/settings.json", "truth/answers.jsonl")),
        *(("systems", f"truth/garments-physics/{n}") for n in ("settings.json", "garments.jsonl")),
        ("systems", "truth/garments-physics/points/0123.npy"),
        ("page", "page.md"),
    ],
)
def test_files_of_others_stay(command, name, data, tmp_path, capsys, monkeypatch):
    (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
    (tmp_path / name).write_text("my own work, without an end of line")
    before = (tmp_path / name).stat().st_mtime_ns
    asked = {
        "garment-sewer": arguments(data)[1:],
        "drape-floor": ["drape-floor", "--data", str(data), "--limit", "1"],
        "picture-reader": ["picture-reader", "--data", str(data), "--limit", "1"],
        "pattern-maker": [
            *("pattern-maker", "--patterns", str(data / "validation"), "--limit", "1", "--samples", "0"),
            *("--network-alone", "--weights", str(TINY_MAKER), "--tasks", "text"),
        ],
        "systems": [
            *("systems", "--patterns", str(data / "validation"), "--data", str(data / "validation")),
            *("--generators", "truth", "--sewers", "physics", "--tasks", "text", "--limit", "1"),
        ],
        "page": ["page", "summary.json"],
    }[command]
    monkeypatch.setattr(results_page, "results_page", lambda runs: "# Results\n")
    assert run(["evaluate", *asked, "--out", str(tmp_path / name if command == "page" else tmp_path)]) == 2
    said = capsys.readouterr().err
    assert str(tmp_path) in said
    assert "would be replaced" in said or "does not belong" in said or "Cannot read" in said
    assert (tmp_path / name).read_text() == "my own work, without an end of line"
    assert (tmp_path / name).stat().st_mtime_ns == before

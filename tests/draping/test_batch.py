from __future__ import annotations

import errno
import gzip
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from unittest import mock

import psutil
import pytest
from batch_makers import DiesWhenLoaded, make_quickly

from swifttailor.draping.batch import BatchSettings, run_batch
from swifttailor.draping.batch import make_garment as making
from swifttailor.draping.batch import run as running
from swifttailor.draping.batch.make_garment import DISK_FULL
from swifttailor.draping.batch.summary import kind_of_reason
from swifttailor.errors import DiskFullError, InputError, PatternError, SimulationError
from swifttailor.output_folder import OutputFolder
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.garmentcode_writer import to_specification
from swifttailor.pattern.pattern_list import count_patterns, folder_name, read_patterns
from swifttailor.workers import Outcome

COARSE = BatchSettings(edge_length=8.0, preview=False)


def line(id: object, pattern: object = None) -> bytes:
    return json.dumps({"id": id, "pattern": pattern if pattern is not None else {}}).encode() + b"\n"


def jsonl(path: Path, *lines: bytes) -> Path:
    path.write_bytes(b"".join(lines))
    return path


@pytest.fixture(scope="module")
def three_garments(tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("patterns") / "three.jsonl.gz"
    names = ("fitted-skirt", "tank-top", "t-shirt")
    path.write_bytes(gzip.compress(b"".join(line(n, to_specification(draft(n))) for n in names)))
    return path


def records(out: Path) -> list[dict]:
    return [json.loads(text) for text in (out / "results.jsonl").read_text().splitlines()]


def quick(source: Path, out: Path, settings: BatchSettings = COARSE, **options):
    """A batch in this process, without drapes: for all but the workers themselves."""

    def run_here(function, tasks, **more):
        yield from (Outcome(task, function(task)) for task in tasks)

    with mock.patch("swifttailor.draping.batch.run.run_tasks", run_here):
        return run_batch(source, out, settings, workers=1, **{"make": make_quickly} | options)


# The real thing


def test_workers_do_not_change_the_garments(three_garments, tmp_path):
    one = run_batch(three_garments, tmp_path / "one", COARSE, workers=1)
    two = run_batch(three_garments, tmp_path / "two", COARSE, workers=2)
    files = sorted(p.relative_to(tmp_path / "one") for p in (tmp_path / "one").glob("*/[!.]*"))
    assert len(files) == 3 * 5
    assert files == sorted(p.relative_to(tmp_path / "two") for p in (tmp_path / "two").glob("*/[!.]*"))
    for file in files:
        first, second = ((tmp_path / name / file).read_bytes() for name in ("one", "two"))
        if file.name == "report.json":
            first, second = (json.loads(data) | {"seconds": 0} for data in (first, second))
        assert first == second, file
    assert {"loading", "sewing", "saving", "total"} <= set(one["median_seconds"])
    del one["median_seconds"], two["median_seconds"]
    assert one == two
    assert one["complete"] and one["counts"]["patterns"] == 3 and one["counts"]["failed"] == 0
    assert [g["id"] for g in one["garments"]] == ["fitted-skirt", "t-shirt", "tank-top"]


def test_a_folder_of_patterns_with_previews_gives_a_sheet(tmp_path):
    from PIL import Image

    patterns = tmp_path / "patterns"
    draft("fitted-skirt").save(patterns / "My Skirt.json")
    (patterns / "broken.json").write_text("{")
    (patterns / "notes.txt").write_text("no pattern")
    summary = run_batch(patterns, tmp_path / "out", BatchSettings(edge_length=8.0), workers=1)
    assert summary["counts"]["patterns"] == 2 and summary["failures"] == {"InputError": 1}
    made = next(g for g in summary["garments"] if g["id"] == "My Skirt")
    assert made["folder"].startswith("My_Skirt-")
    assert (tmp_path / "out" / made["folder"] / "preview.png").is_file()
    with Image.open(tmp_path / "out" / "sheet-01.png") as sheet:
        assert sheet.width > 480 and sheet.height > 288


def test_kill_minus_nine_in_the_middle(three_garments, tmp_path):
    """The batch goes on where it stopped, and nothing of the killed run is left over or left out."""
    out = tmp_path / "out"
    command = [
        sys.executable,
        "-m",
        "swifttailor",
        "drape",
        "--batch",
        str(three_garments),
        "--out",
        str(out),
    ]
    command += ["--workers", "1", "--edge-length", "8", "--no-preview"]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    results = out / "results.jsonl"
    wait_for(lambda: results.exists() and b"\n" in results.read_bytes(), process)
    children = psutil.Process(process.pid).children(recursive=True)
    process.kill()
    process.wait()
    psutil.wait_procs(children, timeout=20)
    assert not any(child.is_running() for child in children), "workers outlived the batch"
    before = records(out)
    assert 1 <= len(before) < 3
    with results.open("ab") as stream:
        stream.write(b'{"id": "tank-top", "fol')
    (out / "t-shirt" / ".swifttailor-unfinished-1").mkdir(parents=True, exist_ok=True)
    stamps = {r["id"]: (out / r["folder"] / "garment.glb").stat().st_mtime_ns for r in before}

    new = []
    summary = run_batch(three_garments, out, COARSE, workers=2, on_record=new.append)
    assert summary["complete"] and summary["counts"]["patterns"] == 3
    assert {r["id"] for r in new} == {"fitted-skirt", "tank-top", "t-shirt"} - set(stamps)
    assert len(records(out)) == 3
    for id, stamp in stamps.items():
        assert (out / id / "garment.glb").stat().st_mtime_ns == stamp
    assert not list(out.glob("*/.swifttailor-unfinished-*"))


def wait_for(condition, process: subprocess.Popen, seconds: float = 120) -> None:
    end = time.monotonic() + seconds
    while not condition():
        assert process.poll() is None and time.monotonic() < end, "the batch ended, or took too long"
        time.sleep(0.02)


# Its way through trouble, with makers that do not drape


@pytest.mark.skipif(os.name == "nt", reason="POSIX signals")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_interrupted_batches_leave_a_summary(number, tmp_path):
    source = jsonl(tmp_path / "p.jsonl", *(line(f"p{k}") for k in range(50)))
    out = tmp_path / "out"
    program = (
        "import sys; from pathlib import Path; from batch_makers import make_slowly\n"
        "from swifttailor.draping.batch import BatchSettings, run_batch\n"
        "if __name__ == '__main__':\n"
        "    settings = BatchSettings(edge_length=8.0, preview=False)\n"
        "    try: run_batch(Path(sys.argv[1]), Path(sys.argv[2]), settings, workers=2, make=make_slowly)\n"
        "    except KeyboardInterrupt: sys.exit(130)\n"
    )
    script = tmp_path / "script.py"
    script.write_text(program)
    environment = os.environ | {"PYTHONPATH": os.pathsep.join([str(Path(__file__).parent), *sys.path])}
    process = subprocess.Popen(
        [sys.executable, str(script), str(source), str(out)],
        env=environment,
        # A shell that starts the tests in the background has them ignore Ctrl-C, and children inherit that.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    wait_for(lambda: (out / "results.jsonl").exists() and len(records(out)) > 1, process)
    process.send_signal(number)
    assert process.wait(timeout=30) == 130
    summary = json.loads((out / "summary.json").read_text())
    assert summary["complete"] is False and 2 <= summary["counts"]["patterns"] < 50
    summary = quick(source, out)
    assert summary["complete"] and summary["counts"]["accepted"] == 50
    assert len({r["id"] for r in records(out)}) == len(records(out)) == 50


def test_dead_and_hanging_workers_cost_one_garment_each(tmp_path):
    ids = ["a", "dies", "b", "hangs", "killed", "c", "d"]
    source = jsonl(tmp_path / "p.jsonl", *(line(i) for i in ids))
    summary = run_batch(source, tmp_path / "out", COARSE, workers=2, time_limit=10, make=make_quickly)
    assert summary["counts"] == {"patterns": 7, "accepted": 4, "not_accepted": 0, "failed": 3}
    why = {g["id"]: g["error"] for g in summary["garments"] if g["status"] == "failed"}
    assert "exit code 3" in why["dies"] and "signal 9" in why["killed"] and "time limit" in why["hangs"]


def test_failures_are_kept_unless_asked_to_retry(tmp_path):
    source = jsonl(tmp_path / "p.jsonl", line("a"), b"{\n")
    out = tmp_path / "out"
    quick(source, out)
    quick(source, out)
    assert len(records(out)) == 2
    quick(source, out, retry_failed=True)
    assert [r["id"] for r in records(out)[2:]] == ["#2"]
    assert (out / "made.txt").read_text() == "a\n"


def test_workers_that_cannot_start_end_the_batch(tmp_path):
    source = jsonl(tmp_path / "p.jsonl", line("a"))
    with pytest.raises(SimulationError, match="exit code 5"):
        run_batch(source, tmp_path / "out", COARSE, workers=1, make=DiesWhenLoaded())


def test_broken_lines_are_recorded_and_do_not_stop_the_batch(tmp_path, monkeypatch):
    monkeypatch.setattr("swifttailor.pattern.pattern_list.MAX_FILE_BYTES", 1000)
    lines = [
        line("good"), b"\n", b"{not json\n", b'{"id": "no-pattern"}\n', b"[1]\n", line(7), line(True),
        line(""), line("#1"), line("a\tb"), line("x" * 300), b"\xff\xfe\n", b"[" * 900 + b"\n",
        b"y" * 5000 + b"\n",
        line("good"), line("GOOD"), line("last")[:-1],
    ]  # fmt: skip
    source = jsonl(tmp_path / "p.jsonl", *lines)
    summary = quick(source, tmp_path / "out")
    by_id = {g["id"]: g for g in summary["garments"]}
    assert {i for i, g in by_id.items() if g["status"] == "made"} == {"good", "7", "last"}
    failed = {i: g["error"] for i, g in by_id.items() if g["status"] == "failed"}
    assert set(failed) == {f"#{n}" for n in (3, 4, 5, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16)}
    assert "is not JSON" in failed["#3"] and 'with "id" and "pattern"' in failed["#4"]
    assert "longer than" in failed["#14"]
    assert "'good' was used before (p.jsonl line 1)" in failed["#15"] and "'GOOD'" in failed["#16"]
    assert quick(source, tmp_path / "out") == summary
    assert len(records(tmp_path / "out")) == 16


def test_a_damaged_archive_gives_what_it_can(tmp_path):
    whole = gzip.compress(b"".join(line(f"p{k}", {"x": os.urandom(2000).hex()}) for k in range(200)))
    source = tmp_path / "p.jsonl.gz"
    source.write_bytes(whole[: len(whole) // 2])
    summary = quick(source, tmp_path / "out")
    assert 20 < summary["counts"]["accepted"] < 150 and summary["failures"] == {"Unreadable": 1}
    assert "damaged from here on" in next(g for g in summary["garments"] if g["status"] == "failed")["error"]


@pytest.mark.parametrize(
    "id",
    ["../up", "/tmp/x", "..", ".", "a/b", "a\\b", "C:x", "con", "NUL", "summary.json", "sheet-01.png",
     ".swifttailor", ".swifttailor.lock", ".swifttailor-unfinished-1", "k\u00f6rper", "a b",
     "-rf", "x" * 200],
)  # fmt: skip
def test_ids_never_leave_the_folder(id, tmp_path):
    name = folder_name(id)
    assert len(name) < 100 and Path(name).name == name and name not in (".", "..")
    out = tmp_path / "deep" / "out"
    summary = quick(jsonl(tmp_path / "p.jsonl", line(id)), out)
    assert summary["counts"]["accepted"] == 1 and summary["garments"][0]["id"] == id
    assert (out / name / "report.json").is_file() and (out / "summary.json").is_file()
    assert {p.name for p in tmp_path.iterdir()} == {"deep", "p.jsonl"}
    assert [p.name for p in (tmp_path / "deep").iterdir()] == ["out"]


def test_different_ids_get_different_folders():
    assert len({folder_name(i) for i in ("a b", "a_b", "a/b", "a\\b", "A/b", "../a_b")}) == 6


def test_results_that_are_no_records_are_made_again(tmp_path):
    source = jsonl(tmp_path / "p.jsonl", line("a"), line("b"), line("c"))
    out = tmp_path / "out"
    quick(source, out)
    lines = (out / "results.jsonl").read_text().splitlines()
    kept = next(text for text in lines if json.loads(text)["id"] == "a")
    (out / "results.jsonl").write_text(f'\0\0\n{kept}\n{{"id": 3}}\nnull\n{{"id": "b", "folder": "b", "sta')
    summary = quick(source, out)
    assert summary["counts"]["accepted"] == 3
    log = (out / "made.txt").read_text().split()
    assert log.count("a") == 1 and log.count("b") == log.count("c") == 2


def test_a_deleted_garment_is_made_again(tmp_path):
    source = jsonl(tmp_path / "p.jsonl", line("a"), line("b"))
    quick(source, tmp_path / "out")
    (tmp_path / "out" / "a" / "report.json").unlink()
    quick(source, tmp_path / "out")
    assert sorted((tmp_path / "out" / "made.txt").read_text().split()) == ["a", "a", "b"]


def make_listed(task):
    """As the real maker leaves a folder: with the list of what was written."""
    made = make_quickly(task)
    folder = task.out / task.pattern.folder
    (folder / "report.json").unlink()
    with OutputFolder(folder, overwrite=task.overwrite) as output, output.fill() as files:
        (files / "report.json").write_text("{}")
        (files / "garment.npz").write_bytes(task.pattern.id.encode() * 1000)
    return made


@pytest.mark.parametrize(
    ("name", "damage"),
    [
        ("garment.npz", lambda whole: whole[:500]),
        ("garment.npz", lambda whole: b""),
        ("garment.npz", lambda whole: whole[:500] + b"?" + whole[501:]),
        ("report.json", lambda whole: whole[:1]),
        (".swifttailor", lambda whole: whole[:30]),
    ],
)
def test_a_garment_cut_short_is_named_and_made_again_where_that_is_asked_for(name, damage, tmp_path):
    source = jsonl(tmp_path / "p.jsonl", line("a"), line("b"), line("c"))
    out = tmp_path / "out"
    assert "changed" not in quick(source, out, make=make_listed)
    whole = (out / "b" / name).read_bytes()
    (out / "b" / name).write_bytes(damage(whole))
    (out / "c" / "garment.npz").unlink()  # of this a person knows
    summary = quick(source, out, make=make_listed)
    assert summary["changed"] == {"b": [name]}
    assert summary["counts"]["patterns"] == 3
    assert (out / "b" / name).read_bytes() == damage(whole)  # it may be somebody's
    if name == ".swifttailor":
        return  # without the list nothing there is known to be SwiftTailor's
    summary = quick(source, out, make=make_listed, overwrite=True)
    assert "changed" not in summary
    assert (out / "b" / name).read_bytes() == whole
    assert (out / "made.txt").read_text().split() == ["a", "b", "c", "b"]
    assert "changed" not in quick(source, out, make=make_listed)


def test_a_limit_can_be_raised(tmp_path):
    source = jsonl(tmp_path / "p.jsonl", *(line(f"p{k}") for k in range(12)))
    assert quick(source, tmp_path / "out", limit=2)["counts"]["patterns"] == 2
    summary = quick(source, tmp_path / "out", limit=11)
    assert [g["id"] for g in summary["garments"]] == [f"p{k}" for k in range(11)]
    assert len(records(tmp_path / "out")) == 11


def test_other_settings_and_other_folders_are_refused(tmp_path):
    source = jsonl(tmp_path / "p.jsonl", line("a"))
    out = tmp_path / "out"
    quick(source, out)
    with pytest.raises(InputError, match=r"edge_length was 8\.0, now 4\.0"):
        quick(source, out, settings=BatchSettings(edge_length=4.0, preview=False))
    quick(source, out, settings=BatchSettings(edge_length=8.0))  # previews may differ
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "a").write_text("text")
    with pytest.raises(InputError, match="is not empty and holds no batch"):
        quick(source, tmp_path / "mine")
    assert [p.name for p in (tmp_path / "mine").iterdir()] == ["a"]
    (out / "batch.json").write_text("{")
    with pytest.raises(InputError, match="is damaged"):
        quick(source, out)


@pytest.mark.parametrize(
    "wrong", [BatchSettings(fabric="brocade"), BatchSettings(body=Path("none.obj"))], ids=["fabric", "body"]
)
def test_settings_that_cannot_work_leave_no_folder(wrong, tmp_path):
    source = jsonl(tmp_path / "p.jsonl", line("a"))
    with pytest.raises(InputError):
        quick(source, tmp_path / "out", settings=wrong)
    assert not (tmp_path / "out").exists()


@pytest.mark.skipif(os.name == "nt", reason="flock")
def test_two_batches_on_one_folder(tmp_path):
    from swifttailor.draping.batch.ledger import Ledger

    source = jsonl(tmp_path / "p.jsonl", line("a"))
    with (
        Ledger(tmp_path / "out", COARSE),
        pytest.raises(InputError, match="Another batch is at work"),
    ):
        quick(source, tmp_path / "out")
    assert quick(source, tmp_path / "out")["complete"]


def test_reasons_are_counted_by_kind(tmp_path):
    source = jsonl(tmp_path / "p.jsonl", line("bad1"), line("bad2"), line("a"))
    summary = quick(source, tmp_path / "out")
    assert summary["reasons"] == {"N edges pass through the body": 2, "did not come to rest": 2}
    assert summary["median_seconds"] == {"sewing": 2.0, "draping": 1.0, "total": 3.0}
    assert summary["median_quality"] == {"top_cm": 140.0}
    assert kind_of_reason("1.2% of the vertices are inside the body (limit 1%)").startswith("N% of the")


def test_counting(tmp_path):
    assert count_patterns(jsonl(tmp_path / "a.jsonl", line("a"), line("b")[:-1])) == 2
    assert count_patterns(jsonl(tmp_path / "b.jsonl", line("a"))) == 1
    assert count_patterns(tmp_path / "none.jsonl") == 0
    assert [p.id for p in read_patterns(tmp_path / "a.jsonl")] == ["a", "b"]


# No room on the disk


def fills_up(room: int):
    """A maker for whose garments there is room for so many more."""
    left = [room]

    def make(task):
        if left[0] == 0:
            return {"id": task.pattern.id, "folder": task.pattern.folder, "status": DISK_FULL}
        left[0] -= 1
        return make_quickly(task)

    return make


def test_a_full_disk_ends_the_batch_and_the_same_call_goes_on(tmp_path):
    source = jsonl(tmp_path / "p.jsonl", *(line(name) for name in "abcde"))
    out, shown = tmp_path / "out", []
    with pytest.raises(DiskFullError, match=r"disk is full.* start the same command again"):
        quick(source, out, make=fills_up(2), on_record=lambda r: shown.append(r["id"]))
    assert shown == ["a", "b"] == [r["id"] for r in records(out)]
    summary = json.loads((out / "summary.json").read_text())
    assert not summary["complete"] and summary["counts"]["failed"] == 0
    started = []
    again = quick(source, out, make=fills_up(9), on_start=lambda done, _: started.append(done))
    assert started == [2] and again["complete"] and again["counts"]["accepted"] == 5
    assert (out / "made.txt").read_text().split() == list("abcde")


def test_the_maker_tells_a_full_disk_from_a_fault_of_the_pattern(tmp_path, monkeypatch):
    pattern = next(
        iter(read_patterns(jsonl(tmp_path / "p.jsonl", line("a", to_specification(draft("t-shirt"))))))
    )
    for error, status in (
        (DiskFullError("full"), DISK_FULL),
        (OSError(errno.ENOSPC, "No space left on device"), DISK_FULL),
        (OSError(errno.EDQUOT, "Quota exceeded"), DISK_FULL),
        (OSError(errno.EACCES, "Permission denied"), "failed"),
        (PatternError("bad"), "failed"),
    ):
        monkeypatch.setattr(making, "drape_pattern", mock.Mock(side_effect=error))
        assert making.make_garment(making.GarmentTask(pattern, COARSE, tmp_path))["status"] == status


def test_a_summary_that_there_is_no_room_for_hides_no_reason(tmp_path, monkeypatch):
    source = jsonl(tmp_path / "p.jsonl", line("a"), line("b"))
    monkeypatch.setattr(running, "write_text", mock.Mock(side_effect=DiskFullError("summary")))
    with pytest.raises(DiskFullError, match="start the same command again"):
        quick(source, tmp_path / "out", make=fills_up(1))
    with pytest.raises(DiskFullError, match="summary"):
        quick(source, tmp_path / "out", make=fills_up(9))


@pytest.mark.parametrize(("limit", "retry", "done"), [(None, False, 4), (2, False, 2), (None, True, 3)])
def test_what_was_done_before_is_counted_of_these_patterns_alone(limit, retry, done, tmp_path):
    source = jsonl(tmp_path / "p.jsonl", line("a"), b"[]\n", line("c"), line("d"))
    quick(source, tmp_path / "out")
    started = []
    quick(
        source,
        tmp_path / "out",
        limit=limit,
        retry_failed=retry,
        on_start=lambda count, _: started.append(count),
    )
    assert started == [done]

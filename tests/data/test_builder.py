from __future__ import annotations

import errno
import json
import os
import signal
import subprocess
import sys
import time
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import psutil
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from sample_makers import COARSE, dies_the_first_time, make_quickly, run_here, split_content

from swifttailor.atomic_files import write_atomically
from swifttailor.data.builder import BuildSettings, build_split
from swifttailor.data.builder.make_sample import FAILED, guarded, not_made
from swifttailor.data.index import SplitIndex, read_index
from swifttailor.data.reader import SplitReader
from swifttailor.draping.batch import BatchSettings
from swifttailor.errors import DiskFullError, InputError
from swifttailor.pattern import Pattern
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.garmentcode_writer import to_specification
from swifttailor.pattern.pattern_list import read_patterns
from swifttailor.workers import Outcome, run_tasks


def write_lines(path: Path, patterns: dict[str, Pattern]) -> Path:
    lines = [json.dumps({"id": id, "pattern": to_specification(p)}) for id, p in patterns.items()]
    path.write_text("".join(line + "\n" for line in lines))
    return path


IDS = ("a", "b", "bad-c", "d", "e", "f", "bad-g", "h", "bad-i", "j")


def build(
    source: Path | list[Path], out: Path, *, split: str = "train", settings: BuildSettings = COARSE, **options
) -> SplitIndex:
    options = {"runner": run_here, "make": make_quickly} | options
    sources = source if isinstance(source, list) else [source]
    return build_split(read_patterns(*sources), out, split, settings, **options)


@pytest.fixture(scope="module")
def reference(patterns_into, tmp_path_factory) -> dict[str, Any]:
    """What comes of `IDS` when nothing goes wrong."""
    folder = tmp_path_factory.mktemp("reference")
    build(patterns_into(folder, *IDS), folder / "reference")
    return split_content(folder / "reference")


# What a build leaves


def test_a_split_holds_the_accepted_samples_in_the_order_of_the_input(patterns_file, tmp_path):
    index = build(patterns_file(*IDS), tmp_path / "out")
    assert index == read_index(tmp_path / "out" / "train")
    assert index.complete and index.patterns == 10
    assert [(s.first, s.last, s.ids) for s in index.shards] == [
        (0, 4, ("a", "b", "d")),
        (4, 8, ("e", "f", "h")),
        (8, 10, ("j",)),
    ]
    assert [s.positions for s in index.shards] == [(0, 1, 3), (4, 5, 7), (9,)]
    assert [(r.position, r.id, r.status, r.reasons) for s in index.shards for r in s.rejected] == [
        (k, IDS[k], "rejected", ("did not come to rest",)) for k in (2, 6, 8)
    ]
    assert sorted(split_content(tmp_path / "out")) == sorted(["index.json", *(s.file for s in index.shards)])
    reader = SplitReader(tmp_path / "out" / "train")
    assert [s.id for s in reader] == ["a", "b", "d", "e", "f", "h", "j"]
    assert index.settings["edge_length"] == 8.0 and len(index.settings["body"]["sha256"]) == 64
    assert index.built_with[0]["version"] == index.settings["version"]


def test_a_range_without_samples_has_no_file(patterns_file, tmp_path):
    index = build(patterns_file("bad1", "bad2", "bad3", "bad4", "a"), tmp_path / "out")
    assert [(s.file != "", s.ids) for s in index.shards] == [(False, ()), (True, ("a",))]
    assert SplitReader(tmp_path / "out" / "train").sample("a").id == "a"
    index = build(patterns_file("bad1", name="bad.jsonl"), tmp_path / "none")
    assert index.complete and len(SplitReader(tmp_path / "none" / "train")) == 0


def test_lines_that_are_no_patterns_are_recorded(patterns_file, tmp_path):
    source = patterns_file("a", "b")
    lines = source.read_text().splitlines()
    source.write_text("\n".join([lines[0], "{", lines[0], '{"id": "x", "pattern": {}}', lines[1]]) + "\n")
    index = build(source, tmp_path / "out")
    assert [i for s in index.shards for i in s.ids] == ["a", "b"]
    why = {r.position: r.reasons[0] for s in index.shards for r in s.rejected}
    assert set(why) == {1, 2, 3}
    assert "is not JSON" in why[1] and "used before" in why[2] and "no 'pattern' object" in why[3]


def test_several_sources_are_one_split(patterns_file, tmp_path, specification):
    folder = tmp_path / "folder"
    folder.mkdir()
    (folder / "c.json").write_text("\ufeff" + json.dumps(specification))
    (folder / "a.json").write_text(json.dumps(specification))
    (folder / "d.json").write_text("{")
    index = build([patterns_file("a", "b"), folder], tmp_path / "out")
    assert [i for s in index.shards for i in s.ids] == ["a", "b", "c"]
    why = {r.position: r.reasons[0] for s in index.shards for r in s.rejected}
    assert "'a' was used before" in why[2] and "d.json" in why[4]
    assert str(tmp_path) not in (tmp_path / "out" / "train" / "index.json").read_text()


# The same, however it comes about


@pytest.mark.parametrize("order", [lambda tasks: tasks[::-1], lambda tasks: sorted(tasks, key=str)])
def test_the_order_of_completion_does_not_matter(order, patterns_file, tmp_path, reference):
    build(patterns_file(*IDS), tmp_path / "out", runner=partial(run_here, order=order))
    assert split_content(tmp_path / "out") == reference


@given(st.lists(st.tuples(st.integers(0, 4), st.integers(1, 10)), max_size=5))
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=15, deadline=None)
def test_interruptions_and_growing_limits_change_nothing(tmp_path_factory, patterns_file, reference, runs):
    """Runs that are stopped after some samples, with limits, and at last one to the end."""
    out = tmp_path_factory.mktemp("runs")
    source = patterns_file(*IDS)
    made: list[str] = []

    def make(task):
        made.append(task.pattern.id)
        return make_quickly(task)

    for stop_after, limit in runs:
        try:
            build(source, out, runner=partial(run_here, stop_after=stop_after), limit=limit, make=make)
        except KeyboardInterrupt:
            pass
    build(source, out, make=make)
    assert split_content(out) == reference
    # What a stopped runner had just made and not handed over may be made again, nothing else.
    assert len(made) <= len(IDS) + len(runs)
    assert sorted(set(made)) == sorted(IDS)


class Killed(BaseException):
    """Ends a build as suddenly as can be had without a process."""


@pytest.mark.parametrize("file_number", range(24))
def test_a_sudden_end_at_any_file(file_number, patterns_file, tmp_path, reference, monkeypatch):
    """The build ends just before the n-th file gets its name, or just after."""
    for before in (True, False):
        out = tmp_path / f"out-{before}"
        left = file_number
        replace = os.replace

        def replace_or_end(*arguments, before=before, replace=replace):
            nonlocal left
            left -= 1
            if left < 0 and before:
                raise Killed
            replace(*arguments)
            if left < 0:
                raise Killed

        monkeypatch.setattr("os.replace", replace_or_end)
        try:
            build(patterns_file(*IDS), out)
        except Killed:
            pass
        monkeypatch.setattr("os.replace", replace)
        build(patterns_file(*IDS), out)
        assert split_content(out) == reference
        lines = [json.loads(t) for t in (out / "train" / "results.jsonl").read_text().splitlines()]
        assert sorted(r["position"] for r in lines) == sorted({*range(10)}) or len(lines) == 11


def test_workers_do_not_change_the_shards(tmp_path):
    """Real drapes; at this edge length some may be beyond the limits."""
    names = ("fitted-skirt", "tank-top", "t-shirt")
    source = tmp_path / "p.jsonl"
    lines = [json.dumps({"id": n, "pattern": to_specification(draft(n))}) for n in names]
    source.write_text("\n".join(lines))
    coarse = BuildSettings(BatchSettings(edge_length=5.0, preview=False), shard_size=2)
    for workers in (1, 2):
        build_split(
            read_patterns(source),
            tmp_path / f"{workers}",
            "train",
            coarse,
            runner=partial(run_tasks, workers=workers, time_limit=300, first_alone=True),
        )
    assert split_content(tmp_path / "1") == split_content(tmp_path / "2")
    reader = SplitReader(tmp_path / "1" / "train")
    assert len(reader) >= 1
    for sample in reader:
        assert sample.about["quality"]["accepted"] and sample.garment.vertices[:, 1].max() < 170
    lines = [json.loads(t) for t in (tmp_path / "1" / "train" / "results.jsonl").read_text().splitlines()]
    assert all({"sewing", "draping"} <= set(r["seconds"]) for r in lines)


# Trouble


def test_kill_minus_nine_in_the_middle(patterns_file, tmp_path):
    ids = [f"p{k}" for k in range(14)]
    source, out = patterns_file(*ids), tmp_path / "out"
    process = start_slow_build(source, out, tmp_path)
    results = out / "train" / "results.jsonl"
    wait_for(lambda: results.exists() and results.read_bytes().count(b"\n") >= 5, process)
    children = psutil.Process(process.pid).children(recursive=True)
    process.kill()
    process.wait()
    psutil.wait_procs(children, timeout=20)
    assert not any(child.is_running() for child in children), "workers outlived the build"
    before = results.read_bytes().splitlines(keepends=True)
    results.write_bytes(b"".join(before) + b'{"position": 11, "i')
    build(source, out)
    build(source, tmp_path / "reference")
    assert split_content(out) == split_content(tmp_path / "reference")
    positions = [json.loads(line)["position"] for line in results.read_bytes().splitlines()]
    assert sorted(positions) == list(range(14)), "a sample was lost or made twice"


@pytest.mark.skipif(os.name == "nt", reason="POSIX signals")
def test_ctrl_c(patterns_file, tmp_path):
    source, out = patterns_file(*(f"p{k}" for k in range(30))), tmp_path / "out"
    process = start_slow_build(source, out, tmp_path)
    results = out / "train" / "results.jsonl"
    wait_for(lambda: results.exists() and results.read_bytes().count(b"\n") >= 2, process)
    process.send_signal(signal.SIGINT)
    assert process.wait(timeout=30) == 130
    build(source, out)
    build(source, tmp_path / "reference")
    assert split_content(out) == split_content(tmp_path / "reference")


def start_slow_build(source: Path, out: Path, folder: Path) -> subprocess.Popen:
    script = folder / "script.py"
    script.write_text(
        "import sys; from functools import partial; from pathlib import Path\n"
        "from sample_makers import COARSE, make_slowly\n"
        "from swifttailor.data.builder import build_split; from swifttailor.workers import run_tasks\n"
        "from swifttailor.pattern.pattern_list import read_patterns\n"
        "if __name__ == '__main__':\n"
        "    runner = partial(run_tasks, workers=2, time_limit=60)\n"
        "    patterns, out = read_patterns(Path(sys.argv[1])), Path(sys.argv[2])\n"
        "    try: build_split(patterns, out, 'train', COARSE, runner=runner, make=make_slowly)\n"
        "    except KeyboardInterrupt: sys.exit(130)\n"
    )
    return subprocess.Popen(
        [sys.executable, str(script), str(source), str(out)],
        env=os.environ | {"PYTHONPATH": os.pathsep.join([str(Path(__file__).parent), *sys.path])},
        # A shell that starts the tests in the background has them ignore Ctrl-C, and children inherit that.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )


def wait_for(condition, process: subprocess.Popen, seconds: float = 120) -> None:
    end = time.monotonic() + seconds
    while not condition():
        assert process.poll() is None and time.monotonic() < end, "the build ended, or took too long"
        time.sleep(0.02)


def test_dead_and_hanging_workers_cost_one_sample_each(patterns_file, tmp_path, monkeypatch):
    monkeypatch.setenv("MARKS", str(tmp_path))
    ids = ("a", "dies", "b", "hangs", "shaky-c", "d", "shaky-e", "f")
    runner = partial(run_tasks, workers=2, time_limit=8, attempts=2)
    index = build(patterns_file(*ids), tmp_path / "out", runner=runner, make=dies_the_first_time)
    assert [i for s in index.shards for i in s.ids] == ["a", "b", "shaky-c", "d", "shaky-e", "f"]
    failed = {r.id: r for s in index.shards for r in s.rejected}
    assert set(failed) == {"dies", "hangs"} and {r.status for r in failed.values()} == {"failed"}
    assert "exit code 3" in failed["dies"].reasons[0] and "time limit" in failed["hangs"].reasons[0]


def test_failures_are_tried_again_when_asked(patterns_file, tmp_path, reference):
    source, out = patterns_file(*IDS), tmp_path / "out"

    def lose_some(function, tasks):
        for task in tasks:
            lost = "out of memory?" if task.pattern.id in ("b", "j") else ""
            yield Outcome(task, None if lost else function(task), lost)

    index = build(source, out, runner=lose_some)
    assert [r.id for s in index.shards for r in s.rejected if r.status == "failed"] == ["b", "j"]
    made = []

    def make(task):
        made.append(task.pattern.id)
        return make_quickly(task)

    build(source, out, make=make)
    assert made == []
    with pytest.raises(KeyboardInterrupt):
        build(source, out, make=make, retry_failed=True, runner=partial(run_here, stop_after=1))
    build(source, out, make=make, retry_failed=True)
    assert split_content(out) == reference and set(made) == {"b", "j"}


def test_the_largest_patterns_are_left_for_later(patterns_file, tmp_path):
    from swifttailor.data.builder.make_sample import make_sample

    source, out = patterns_file("a"), tmp_path / "out"
    index = build(source, out, make=partial(make_sample, largest=100))
    (left,) = index.shards[0].rejected
    assert left.status == "failed"
    assert "left for later" in left.reasons[0] and "more than 100" in left.reasons[0]
    index = build(source, out, make=partial(make_sample, largest=100_000), retry_failed=True)
    assert not [r for s in index.shards for r in s.rejected if "left for later" in r.reasons[0]]


@pytest.mark.parametrize("number", range(0, 14))
def test_a_full_disk_loses_nothing(number, patterns_file, tmp_path, reference, monkeypatch):
    """The disk is full at the n-th write to it, in the middle of a file."""
    out = tmp_path / "out"
    left = number
    fsync = os.fsync

    def fsync_or_full(descriptor):
        nonlocal left
        left -= 1
        if left < 0:
            size = os.fstat(descriptor).st_size
            os.ftruncate(descriptor, size - min(size, 7))
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        fsync(descriptor)

    monkeypatch.setattr("os.fsync", fsync_or_full)
    with pytest.raises(InputError, match=rf"Cannot write '{out}.*': the disk is full"):
        build(patterns_file(*IDS), out)
    kept = len(SplitReader(out / "train"))
    monkeypatch.setattr("os.fsync", fsync)
    made = []

    def make(task):
        made.append(task.pattern.id)
        return make_quickly(task)

    build(patterns_file(*IDS), out, make=make)
    assert split_content(out) == reference
    assert len(made) <= len(IDS) - kept
    if number >= 2:
        assert IDS[0] not in made


def test_an_index_that_cannot_be_written_loses_nothing(patterns_file, tmp_path, reference, monkeypatch):
    def full(path, write, **options):
        if path.name == "index.json" and path.exists():
            raise InputError(f"Cannot write '{path}': No space left on device.")
        return write_atomically(path, write, **options)

    monkeypatch.setattr("swifttailor.atomic_files.write_atomically", full)
    with pytest.raises(InputError, match=r"index\.json"):
        build(patterns_file(*IDS), tmp_path / "out")
    monkeypatch.undo()
    build(patterns_file(*IDS), tmp_path / "out")
    assert split_content(tmp_path / "out") == reference


def test_a_deleted_sample_is_made_again(patterns_file, tmp_path, reference):
    out = tmp_path / "out"
    with pytest.raises(KeyboardInterrupt):
        build(patterns_file(*IDS), out, runner=partial(run_here, stop_after=3))
    (out / "train" / ".samples" / "00000001.safetensors").unlink()
    build(patterns_file(*IDS), out)
    assert split_content(out) == reference


def test_a_damaged_sample_is_named(patterns_file, tmp_path, reference):
    out = tmp_path / "out"
    with pytest.raises(KeyboardInterrupt):
        build(patterns_file(*IDS), out, runner=partial(run_here, stop_after=3))
    path = out / "train" / ".samples" / "00000001.safetensors"
    path.write_bytes(path.read_bytes()[:-100])
    with pytest.raises(InputError, match=r"00000001\.safetensors' is damaged"):
        build(patterns_file(*IDS), out)
    path.unlink()
    build(patterns_file(*IDS), out)
    assert split_content(out) == reference


# What is refused


def test_another_input_is_refused(patterns_file, tmp_path):
    out = tmp_path / "out"
    build(patterns_file(*IDS), out)
    with pytest.raises(InputError, match=r"differs from the one .* \(patterns 5 to 8\)"):
        build(patterns_file("a", "b", "bad-c", "d", "other", *IDS[5:]), out)
    build(patterns_file(*IDS[:6]), out)  # less is no contradiction
    more = build(patterns_file(*IDS, "k"), out)
    assert [s.ids for s in more.shards][-1] == ("j", "k")
    with pytest.raises(KeyboardInterrupt):
        build(patterns_file(*IDS), tmp_path / "two", runner=partial(run_here, stop_after=2))
    with pytest.raises(InputError, match=r"\(pattern 2\)"):
        build(patterns_file("a", "x"), tmp_path / "two")


def test_splits_share_no_pattern(patterns_file, tmp_path):
    build(patterns_file(*IDS), tmp_path / "out")
    other = write_lines(tmp_path / "other.jsonl", {"k": draft("tank-top"), "l": draft("t-shirt")})
    index = build(other, tmp_path / "out", split="test")
    assert [s.ids for s in index.shards] == [("k", "l")]
    # The same pattern under another id, its panels in another order.
    top = draft("tank-top")
    copies = {"n": replace(top, panels=top.panels[::-1]), "o": draft("hoodie")}
    index = build(write_lines(tmp_path / "copies.jsonl", copies), tmp_path / "out", split="validation")
    (rejected,) = index.shards[0].rejected
    assert rejected.id == "n" and rejected.status == "rejected" and index.shards[0].ids == ("o",)
    assert rejected.reasons == ("the same pattern as 'k' of the split 'test'",)
    with pytest.raises(InputError, match=r"'bad-g' \(more.jsonl line 2\) is in the split 'train'"):
        build(patterns_file("m", "bad-g", name="more.jsonl"), tmp_path / "out", split="validation")


def test_other_settings_and_other_folders_are_refused(patterns_file, tmp_path):
    out, source = tmp_path / "out", patterns_file("a")
    build(source, out)
    other = BuildSettings(BatchSettings(edge_length=4.0, preview=False), shard_size=4)
    with pytest.raises(InputError, match=r"edge_length was 8\.0, now 4\.0"):
        build(source, out, settings=other)
    (tmp_path / "mine" / "train").mkdir(parents=True)
    (tmp_path / "mine" / "train" / "a").write_text("text")
    with pytest.raises(InputError, match="is not empty and holds no split"):
        build(source, tmp_path / "mine")
    (out / "train" / "index.json").write_text("{")
    with pytest.raises(InputError, match=r"index\.json' is damaged"):
        build(source, out)
    with pytest.raises(InputError, match="no file or folder"):
        build(tmp_path / "none.jsonl", tmp_path / "new")
    with pytest.raises(InputError, match="There are no patterns"):
        build(patterns_file(name="empty.jsonl"), tmp_path / "new")
    wrong = BuildSettings(BatchSettings(fabric="brocade"))
    with pytest.raises(InputError, match="brocade"):
        build(source, tmp_path / "new", settings=wrong)
    assert not (tmp_path / "new").exists()


@pytest.mark.skipif(os.name == "nt", reason="flock")
def test_two_builds_of_one_split(patterns_file, tmp_path):
    def meanwhile(function, tasks):
        with pytest.raises(InputError, match="Another build is at work"):
            build(patterns_file("a"), tmp_path / "out")
        yield from run_here(function, tasks)

    build(patterns_file("a"), tmp_path / "out", runner=meanwhile)


def test_other_code_is_noted(patterns_file, tmp_path, monkeypatch):
    out, notes = tmp_path / "out", []
    with pytest.raises(KeyboardInterrupt):
        build(patterns_file(*IDS), out, runner=partial(run_here, stop_after=1))
    other = {"version": "0.1.0", "commit": "", "code": "other"}
    monkeypatch.setattr("swifttailor.data.builder.split_folder.code_version", lambda: other)
    index = build(patterns_file(*IDS), out, on_start=lambda done, note: notes.append((done, note)))
    assert notes[0][0] == 1 and "other code than before" in notes[0][1]
    assert len(index.built_with) == 2 and index.built_with[1] == other
    build(patterns_file(*IDS), out, on_start=lambda done, note: notes.append((done, note)))
    assert notes[1] == (10, "")


def test_a_full_disk_at_a_worker_ends_the_build_and_the_same_call_goes_on(patterns_file, tmp_path, reference):
    left = [5]

    def make(task):
        left[0] -= 1
        return guarded(task, no_room) if left[0] < 0 else make_quickly(task)

    def no_room():
        raise OSError(errno.ENOSPC, "No space left on device")

    source, out = patterns_file(*IDS), tmp_path / "out"
    with pytest.raises(DiskFullError, match=r"disk is full.* start the same command again"):
        build(source, out, make=make)
    started = []
    build(source, out, on_start=lambda done, _: started.append(done))
    assert started == [5] and split_content(out) == reference


@pytest.mark.parametrize(("limit", "retry", "done"), [(None, False, 6), (3, False, 3), (None, True, 5)])
def test_what_was_built_before_is_counted_of_these_patterns_alone(
    limit, retry, done, patterns_file, tmp_path
):
    def make(task):
        return not_made(task, FAILED, "crashed") if task.pattern.id == "b" else make_quickly(task)

    source, out, started = patterns_file(*IDS[:6]), tmp_path / "out", []
    build(source, out, make=make)
    build(source, out, limit=limit, retry_failed=retry, on_start=lambda count, _: started.append(count))
    assert started == [done]

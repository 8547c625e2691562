"""Campaigns: whatever a reader does, every input is fed once, counted and found again."""

from __future__ import annotations

import json
import subprocess
import sys
from collections import Counter
from pathlib import Path

import faulty_target
import pytest

from fuzzing.campaign import Campaign
from fuzzing.mutation.message_mutations import fields_of, message_of
from fuzzing.registry import all_targets
from fuzzing.shrinking import shrunk

(TARGET,) = faulty_target.TARGETS
INPUTS = 24
FAULTS = {
    "raises": "KeyError in fuzzing",
    "talks": "message",
    "dies": "died of SIGSEGV",
    "hangs": "hang",
    "grows": "MemoryError in fuzzing",
    "exits": "exit code 3",
}


def expected(first: int, end: int) -> Counter[str]:
    return Counter(TARGET.input(5, number).data.decode().strip() for number in range(first, end))


def test_every_way_to_fail_is_survived_counted_and_kept(tmp_path):
    kinds = expected(0, INPUTS)
    assert set(kinds) == set(faulty_target.KINDS)
    progress = Campaign(TARGET, "faulty_target", 5, tmp_path).run(INPUTS)
    assert progress.next == INPUTS
    assert (progress.accepted, progress.refused) == (kinds["accepted"], kinds["refused"])
    assert progress.failures == {text: kinds[kind] for kind, text in FAULTS.items()}
    assert progress.failed == sum(progress.failures.values())
    for number in range(INPUTS):
        file = TARGET.input(5, number)
        kind = file.data.decode().strip()
        kept = list((tmp_path / "failures").rglob(f"5-{number}.txt"))
        assert bool(kept) <= (kind in FAULTS)
        if kind in FAULTS:
            first = [n for n in range(number + 1) if TARGET.input(5, n).data.decode().strip() == kind][:3]
            assert bool(kept) == (number in first)


def test_a_campaign_is_resumed_where_it_was(tmp_path):
    whole = Campaign(TARGET, "faulty_target", 5, tmp_path / "whole").run(8)
    for inputs in (3, 3, 8):
        parts = Campaign(TARGET, "faulty_target", 5, tmp_path / "parts").run(inputs)
        assert parts.next == inputs
    assert parts.failures == whole.failures and (parts.accepted, parts.refused) == (
        whole.accepted,
        whole.refused,
    )


def test_kept_inputs_that_fail_are_named(tmp_path):
    files = []
    for kind in ("accepted", "raises", "dies", "refused"):
        files.append(tmp_path / f"{kind}.txt")
        files[-1].write_text(kind)
    campaign = Campaign(TARGET, "faulty_target", 5, tmp_path / "out")
    assert campaign.replay(files) == {
        "raises.txt: KeyError in fuzzing": 1,
        "dies.txt: died of SIGSEGV": 1,
    }
    assert campaign.progress.next == 0 and not (tmp_path / "out").exists()


def test_a_reader_that_waits_for_ever_is_ended(tmp_path, monkeypatch):
    """It uses no processor time, so that no limit on that would end it."""
    monkeypatch.setattr("fuzzing.campaign._PATIENCE", 3.0)
    file = tmp_path / "waits.txt"
    file.write_text("waits")
    failures = Campaign(TARGET, "faulty_target", 5, tmp_path / "out").replay([file])
    assert failures == {"waits.txt: stuck": 1}


@pytest.mark.parametrize("seed", [0, 1])
def test_inputs_follow_from_target_seed_and_number(seed):
    program = (
        "import hashlib, sys; from fuzzing.registry import all_targets\n"
        "for name in ('pattern', 'picture', 'index', 'measurements', 'model'):\n"
        "    t = all_targets()[name]\n"
        f"    print([hashlib.sha256(t.input({seed}, n).data).hexdigest() for n in (7, 3, 250)])"
    )
    root = str(Path(__file__).parents[2])
    runs = [
        subprocess.run(
            [sys.executable, "-c", program], capture_output=True, text=True, check=True, cwd=root
        ).stdout
        for _ in range(2)
    ]
    assert runs[0] == runs[1]
    lines = [json.loads(line.replace("'", '"')) for line in runs[0].splitlines()]
    assert len(lines) == 5 and all(len(set(line)) == 3 for line in lines)


def test_inputs_shrink_to_what_makes_them_fail():
    value = {"a": [1, 2, {"b": 3, "c": [4]}], "d": "e"}
    small = shrunk(json.dumps(value).encode(), lambda data: b'"c"' in data)
    assert json.loads(small) == {"a": [{"c": []}]}
    assert shrunk(b"xx" * 40 + b"fault" + b"yy" * 40, lambda data: b"fault" in data) == b"fault"


def test_protocol_buffers_are_read_and_written_alike():
    (seed,) = all_targets()["model"].seeds
    fields = fields_of(seed.data)
    assert fields and {number for number, _, _ in fields} >= {1, 7, 8, 14}
    assert message_of(fields) == seed.data

"""Checks that several commands share."""

from __future__ import annotations

import math
import os

import pytest

from swifttailor.cli.option_checks import (
    in_range,
    require_edge_length,
    require_limit,
    require_max_minutes,
    require_seed,
    require_threads,
    require_time_limit,
    require_writable_folder,
    worker_count,
)
from swifttailor.cli.progress import CountProgress, StderrBar
from swifttailor.errors import InputError


@pytest.mark.parametrize("value", [None, 2, 3, 7])
def test_numbers_within_their_bounds_pass(value):
    in_range("--count", value, 2, 7)


@pytest.mark.parametrize(
    ("value", "low", "high", "message"),
    [
        (1, 2, 7, "--count is 1; from 2 to 7 is accepted."),
        (8, 2, 7, "--count is 8; from 2 to 7 is accepted."),
        (2**31 + 1, 0, 2**31, "--count is 2147483649; from 0 to 2147483648 is accepted."),
        (0.25, 0.5, 10.0, "--count is 0.25; from 0.5 to 10 is accepted."),
        (math.nan, 0.5, 10.0, "--count is nan; from 0.5 to 10 is accepted."),
        (math.inf, 0.5, 10.0, "--count is inf; from 0.5 to 10 is accepted."),
    ],
)
def test_others_are_refused_with_all_their_digits(value, low, high, message):
    with pytest.raises(InputError) as refused:
        in_range("--count", value, low, high)
    assert str(refused.value) == message


@pytest.mark.parametrize(
    ("check", "accepted", "refused"),
    [
        (require_threads, (None, 1, 256), (0, 257)),
        (require_edge_length, (0.5, 2.0, 10.0), (0.49, 10.1, math.nan)),
        (require_seed, (0, 2**63 - 1), (-1, 2**63)),
        (require_limit, (None, 1, 10**9), (0, -3)),
        (require_time_limit, (None, 1.0, 1e9), (0.5, math.inf, math.nan)),
        (require_max_minutes, (None, 0.01, 1e9), (0.0, -1.0, math.inf, math.nan)),
    ],
)
def test_every_check_has_its_bounds(check, accepted, refused):
    for value in accepted:
        check(value)
    for value in refused:
        with pytest.raises(InputError, match="is accepted"):
            check(value)


def test_workers_are_as_many_as_asked_for_or_as_cores(monkeypatch):
    assert worker_count(3) == 3
    monkeypatch.setattr(os, "sched_getaffinity", lambda process: {0, 5, 6}, raising=False)
    assert worker_count(None) == 3
    for wrong in (0, 1025):
        with pytest.raises(InputError, match=f"--workers is {wrong}; from 1 to 1024 is accepted"):
            worker_count(wrong)


def test_folders_that_cannot_be_written_are_refused(tmp_path):
    require_writable_folder(tmp_path / "new" / "folder")
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError, match="is a file, not a folder"):
        require_writable_folder(tmp_path / "file" / "folder")
    assert not (tmp_path / "new").exists()


def test_a_bar_must_say_what_it_shows():
    with pytest.raises(TypeError, match="_columns"):
        StderrBar()  # ty: ignore
    assert len(CountProgress(3)._columns()) == 4

"""A drape that would take too long is given up, by the time that was computed."""

from __future__ import annotations

from itertools import count

import pytest

from swifttailor.draping import time_limit
from swifttailor.draping.drape import drape
from swifttailor.draping.time_limit import USUAL_SECONDS, TimeLimit, usual_time_limit
from swifttailor.errors import TimeLimitError
from swifttailor.pattern.drafts import draft


@pytest.fixture
def clock(monkeypatch):
    """Ten seconds pass from call to call."""
    seconds = count(1000, 10)
    monkeypatch.setattr(time_limit.time, "process_time", lambda: next(seconds))


def test_counts_from_the_first_frame_on(clock):
    seen = []
    limit = TimeLimit(25.0, lambda stage, share: seen.append((stage, share)), instead="Do less.")
    for stage, share in (("meshing", 0.0), ("sewing", 0.0)) * 9:
        limit(stage, share)
    for share in (0.1, 0.2, 0.3):  # 0, 10 and 20 seconds
        limit("sewing", share)
    with pytest.raises(TimeLimitError, match=r"Gave up draping after 25 seconds: .* Do less\. .*check"):
        limit("draping", 0.1)
    assert seen[-1] == ("draping", 0.1) and len(seen) == 22


def test_of_a_solver_that_is_compiled_meshing_and_the_first_frame_count(clock):
    limit = TimeLimit(25.0, lambda stage, share: None, instead="", compiled=True)
    limit("meshing", 0.0)  # 0 seconds
    limit("meshing", 1.0)
    limit("sewing", 0.0)
    with pytest.raises(TimeLimitError, match="Gave up sewing after 25 seconds"):
        limit("sewing", 0.01)  # 30


def test_what_is_done_is_kept(clock):
    limit = TimeLimit(5.0, lambda stage, share: None, instead="")
    limit("draping", 0.5)
    limit("draping", 1.0)
    with pytest.raises(TimeLimitError):
        limit("draping", 0.9)


def test_finer_meshes_have_more_time():
    assert usual_time_limit(2.0) == usual_time_limit(10.0) == USUAL_SECONDS
    assert usual_time_limit(1.0) == 4 * USUAL_SECONDS and usual_time_limit(0.5) == 16 * USUAL_SECONDS


def test_a_drape_asks_after_every_frame(clock):
    frames = []
    limit = TimeLimit(95.0, lambda stage, share: frames.append(stage), instead="")
    with pytest.raises(TimeLimitError, match="Gave up sewing after 95 seconds"):
        drape(draft("circle-skirt"), edge_length=8.0, progress=limit)
    assert frames.count("sewing") == 11

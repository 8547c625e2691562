"""#Sampling: patterns until one can be made into a garment."""

from __future__ import annotations

from dataclasses import replace

import pytest

from swifttailor.errors import InputError, PatternError
from swifttailor.evaluation.patterns.attempts import (
    GATES,
    MAX_ATTEMPTS,
    Attempts,
    Fault,
    attempts_of,
    first_fault,
    summarize_attempts,
    until_sound,
)
from swifttailor.pattern import EdgeRef, Pattern, Stitch, read_specification
from swifttailor.pattern.drafts import draft, list_drafts


@pytest.fixture(scope="module")
def skirt() -> Pattern:
    return draft("fitted-skirt")


@pytest.fixture(scope="module")
def sewn_twice(skirt) -> Pattern:
    """An edge in two stitches: what GarmentCode calls a multi-stitch."""
    first, last = skirt.stitches[0], skirt.stitches[-1]
    return replace(skirt, stitches=(*skirt.stitches, Stitch(first.first, last.second)))


def test_patterns_are_counted_until_one_is_sound():
    bad = ("check", "edge-stitched-twice"), ("mesh", "no room")
    assert attempts_of([None, bad[0]]) == Attempts(1, True, ())
    assert attempts_of([*bad, None, bad[0]]) == Attempts(3, True, bad)
    assert attempts_of([*bad]) is None, "nobody knows yet"
    assert attempts_of([]) is None


def test_an_input_that_gives_nothing_counts_as_the_limit():
    bad: Fault = ("decode", "Two panels have no end.")
    assert attempts_of([bad] * 20) == Attempts(MAX_ATTEMPTS, False, (bad,) * 20)
    assert attempts_of([bad] * 19) is None
    assert attempts_of([bad] * 3, limit=3) == Attempts(3, False, (bad,) * 3)
    assert attempts_of([*[bad] * 3, None], limit=3) == Attempts(3, False, (bad,) * 3)


def test_those_after_the_first_sound_one_do_not_count(skirt, sewn_twice):
    assert until_sound([skirt]) == until_sound([skirt, sewn_twice, skirt]) == 1
    assert until_sound([sewn_twice, sewn_twice, skirt, skirt]) == 3
    assert until_sound([sewn_twice] * 2) == 2, "all of them, where none is"


def test_an_edge_sewn_twice_fails(sewn_twice):
    gate, why = first_fault(sewn_twice) or ("", "")
    assert (gate == "check" and why.startswith("edge-stitched-twice")) or "stitch" in why


def test_what_the_checker_lets_pass_must_be_meshed(skirt, monkeypatch):
    from swifttailor.evaluation.patterns import attempts

    def refuse(pattern, edge_length):
        raise PatternError("The panel 'front' cannot be meshed.")

    monkeypatch.setattr(attempts, "mesh_pattern", refuse)
    assert first_fault(skirt) == ("mesh", "The panel 'front' cannot be meshed.")


def test_a_mesh_with_three_faces_at_an_edge_fails(skirt, monkeypatch):
    from swifttailor.evaluation.patterns import attempts
    from swifttailor.panel_mesh.topology import Topology

    monkeypatch.setattr(attempts, "topology", lambda faces, count: Topology(1, 1, 0, 3, 0))
    gate, why = first_fault(skirt, 4.0) or ("", "")
    assert gate == "mesh" and why.startswith("3 edges")


def test_no_panels_is_no_garment():
    assert first_fault(Pattern(())) is not None


def test_a_stitch_to_nowhere_is_found(skirt):
    broken = replace(skirt, stitches=(*skirt.stitches, Stitch(EdgeRef("sleeve", 0), EdgeRef("sleeve", 1))))
    assert (first_fault(broken) or ("",))[0] == "check"


@pytest.mark.parametrize("name", [d.name for d in list_drafts()])
def test_drafts_pass(name):
    assert first_fault(draft(name), 4.0) is None


def test_real_patterns_pass(real_samples):
    faults = {}
    for sample in (*real_samples("repository", every=2), *real_samples("validation", every=20)):
        faults[sample["id"]] = first_fault(read_specification(sample["pattern"]).pattern, 4.0)
    assert len(faults) >= 10
    assert not {id: fault for id, fault in faults.items() if fault is not None}


def test_summary():
    attempts = [
        Attempts(1, True, ()),
        Attempts(4, True, (("decode", ""), ("mesh", ""), ("mesh", ""))),
        Attempts(20, False, (("check", ""),) * 20),
    ]
    found = summarize_attempts(attempts)
    assert (found.mean, found.inputs, found.succeeded) == (25 / 3, 3, 2)
    assert found.failures == {"decode": 1, "check": 20, "mesh": 2} and tuple(found.failures) == GATES
    with pytest.raises(InputError, match="No input"):
        summarize_attempts([])

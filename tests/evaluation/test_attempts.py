"""#Sampling: patterns until one can be made into a garment."""

from __future__ import annotations

import gzip
import json
from dataclasses import replace

import pytest

from swifttailor.errors import InputError, PatternError
from swifttailor.evaluation.patterns.attempts import (
    GATES,
    MAX_ATTEMPTS,
    Attempts,
    first_fault,
    make_until_sound,
    summarize_attempts,
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


def test_the_first_sound_pattern_is_taken(skirt, sewn_twice):
    asked: list[int] = []

    def generate(k: int) -> Pattern:
        asked.append(k)
        if k == 0:
            raise PatternError("Two panels have no end.")
        return sewn_twice if k == 1 else skirt

    found = make_until_sound(generate, edge_length=4.0)
    assert found.count == 3 and found.pattern is skirt and asked == [0, 1, 2]
    assert [gate for gate, _ in found.failures] == ["decode", "check"]
    assert found.failures[0][1] == "Two panels have no end."
    assert found.failures[1][1].startswith("edge-stitched-twice") or "stitch" in found.failures[1][1]


def test_an_input_that_gives_nothing_counts_as_the_limit(sewn_twice):
    found = make_until_sound(lambda k: sewn_twice)
    assert found.count == MAX_ATTEMPTS == 20 == len(found.failures) and found.pattern is None
    assert make_until_sound(lambda k: sewn_twice, limit=3).count == 3


def test_faults_of_the_program_are_not_taken_for_faults_of_the_pattern():
    with pytest.raises(ZeroDivisionError):
        make_until_sound(lambda k: 1 / 0)


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


def test_real_patterns_pass(garmentcode_folder):
    faults = {}
    with gzip.open(garmentcode_folder / "validation.jsonl.gz", "rt") as lines:
        for k, line in enumerate(lines):
            if k % 10 == 0:
                sample = json.loads(line)
                faults[sample["id"]] = first_fault(read_specification(sample["pattern"]).pattern, 4.0)
    assert len(faults) >= 10
    assert not {id: fault for id, fault in faults.items() if fault is not None}


def test_summary():
    attempts = [
        Attempts(1, Pattern(()), ()),
        Attempts(4, Pattern(()), (("decode", ""), ("mesh", ""), ("mesh", ""))),
        Attempts(20, None, (("check", ""),) * 20),
    ]
    found = summarize_attempts(attempts)
    assert (found.mean, found.inputs, found.succeeded) == (25 / 3, 3, 2)
    assert found.failures == {"decode": 1, "check": 20, "mesh": 2} and tuple(found.failures) == GATES
    with pytest.raises(InputError, match="No input"):
        summarize_attempts([])

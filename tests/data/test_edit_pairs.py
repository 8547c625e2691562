"""Editing pairs: both directions, valid patterns, instructions that the facts of both bear out."""

from __future__ import annotations

import pytest

from swifttailor.data.edits.pairs import geometric_pairs, pairs_of
from swifttailor.describing import measure_facts
from swifttailor.pattern import Severity, check_pattern
from swifttailor.pattern.drafts import draft
from swifttailor.recutting.random_cuts import TOPICS, WAYS

# A draft for each of some topics, and a way to recut it.
ON = {
    "length": ("t-shirt", "hem: longer or shorter"),
    "sleeve length": ("hoodie", "sleeves: longer or shorter"),
    "waistband height": ("circle-skirt", "band: higher or lower"),
    "leg end": ("trousers", "leg ends: wider or narrower"),
    "skirt gathers": ("gathered-skirt", "skirt at its seam: more gathered or less gathered"),
    "sleeves": ("t-shirt", "left sleeve taken off"),
    "hood": ("hoodie", "hood taken off"),
    "kind": ("jumpsuit", "upper part taken off"),
    "cuff length": ("t-shirt", "sleeve flounces sewn on"),
    "neck depth": ("t-shirt", "front neckline cut to a V: deeper or shallower"),
    "left slit": ("fitted-skirt", "slit left: higher or lower"),
    "chest": ("t-shirt", "chest: wider or narrower"),
    "collar height": ("t-shirt", "lapels sewn on"),
}


def faults(pattern):
    return {(f.code, f.panel) for f in check_pattern(pattern) if f.severity is not Severity.INFO}


def check_pairs(pairs):
    for pair in pairs:
        before, after = measure_facts(pair.base), measure_facts(pair.edited)
        assert pair.instruction.holds(before, after), pair.instruction
        assert not pair.instruction.holds(before, before), pair.instruction
        assert pair.instruction.text and pair.base != pair.edited


@pytest.mark.parametrize("topic", ON)
def test_ways_to_recut_make_valid_pairs_both_ways(topic):
    name, label = ON[topic]
    pattern = draft(name)
    pairs = geometric_pairs(pattern, 4, topics={topic: (WAYS[label],)})
    assert WAYS[label] in TOPICS[topic]
    assert len(pairs) == 2, label
    there, back = pairs
    assert there.base == pattern and back.edited == pattern and there.edited == back.base
    assert there.source == label and back.source == f"{label}, reversed"
    assert faults(there.edited) <= faults(pattern)
    check_pairs(pairs)


def test_real_patterns_are_recut(few_real_patterns):
    made = 0
    for k, pattern in enumerate(list(few_real_patterns.values())[::2]):
        pairs = geometric_pairs(pattern, k, count=2)
        for pair in pairs:
            assert not faults(pair.edited) - faults(pair.base)
        check_pairs(pairs)
        made += len(pairs)
    assert made >= len(few_real_patterns)


def test_pairs_from_garmentcodes_edits(garmentcode_edits):
    """A difference is seen in most; where one is, it is asked for both ways."""
    sample = list(garmentcode_edits(every=5))
    made = 0
    for seed, (base, edited) in enumerate(sample):
        pairs = pairs_of(base, edited, seed, source="design")
        check_pairs(pairs)
        assert len(pairs) <= 2
        made += len(pairs)
    assert made >= 1.4 * len(sample)


def test_the_same_seed_makes_the_same_pairs(drafts):
    one, other = (geometric_pairs(drafts["shirt-dress"], 9, count=3) for _ in range(2))
    assert [(p.instruction, p.source) for p in one] == [(p.instruction, p.source) for p in other]
    assert [p.edited for p in one] == [p.edited for p in other]
    assert len({p.source for p in one}) == len(one)


def test_equal_patterns_make_no_pair(drafts):
    for pattern in drafts.values():
        assert pairs_of(pattern, pattern) == []


def test_cutting_changes_only_what_it_is_about(drafts):
    """A shorter sleeve leaves every other panel as it was."""
    pattern = drafts["t-shirt"].canonical()
    topics = {"sleeve length": (WAYS["sleeves: longer or shorter"],)}
    pairs = geometric_pairs(pattern, 3, topics=topics)
    edited = pairs[0].edited
    changed = {p.name for p in edited.panels if p != pattern.panel(p.name)}
    assert changed == {p.name for p in pattern.panels if "sleeve" in p.name}

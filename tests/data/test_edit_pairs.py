"""Editing pairs: both directions, valid patterns, instructions that the facts of both bear out."""

from __future__ import annotations

import random

import pytest

from swifttailor.data.edits.pairs import geometric_pairs, pairs_of, recut
from swifttailor.describing import measure_facts
from swifttailor.pattern import Severity, check_pattern
from swifttailor.pattern.drafts import draft
from swifttailor.recutting.random_cuts import OPERATIONS
from swifttailor.recutting.table.checking import seams_kept
from swifttailor.recutting.table.cutter import Cutter

# A draft that each operation can be done to.
ON = {
    "hem length": "t-shirt",
    "leg length": "trousers",
    "sleeve length": "hoodie",
    "cuff length": "hoodie",
    "band height": "circle-skirt",
    "bodice length": "shirt-dress",
    "flare hem": "fitted-skirt",
    "flare legs": "trousers",
    "flare sleeves": ("t-shirt", {"sleeve_length": 55}),
    "gather skirt": "gathered-skirt",
    "remove sleeves": "t-shirt",
    "remove one sleeve": "t-shirt",
    "remove cuffs": "hoodie",
    "remove hood": "hoodie",
    "remove waistband": "trousers",
    "remove lower part": "fitted-dress",
    "remove upper part": "jumpsuit",
    "add cuffs": "t-shirt",
    "add leg cuffs": "trousers",
    "add hem band": "tank-top",
    "deepen neckline": "t-shirt",
    "reshape neckline": "t-shirt",
    "side slits": "fitted-skirt",
}
# Drafts have no collars, and trousers without a waistband or with cuffs are made by other operations first.
NOT_ON_DRAFTS = {"collar height", "remove collar", "remove leg cuffs", "add waistband"}


def faults(pattern):
    return {(f.code, f.panel) for f in check_pattern(pattern) if f.severity is not Severity.INFO}


def check_pairs(pairs):
    for pair in pairs:
        before, after = measure_facts(pair.base), measure_facts(pair.edited)
        assert pair.instruction.holds(before, after), pair.instruction
        assert not pair.instruction.holds(before, before), pair.instruction
        assert pair.instruction.text and pair.base != pair.edited


def test_every_operation_has_its_test():
    assert {o.name for o in OPERATIONS} == ON.keys() | NOT_ON_DRAFTS


@pytest.mark.parametrize("operation", [o for o in OPERATIONS if o.name in ON], ids=lambda o: o.name)
def test_operations_make_valid_pairs_both_ways(operation):
    on = ON[operation.name]
    name, options = on if isinstance(on, tuple) else (on, {})
    pattern = draft(name, **options)
    pairs = geometric_pairs(pattern, 4, operations=(operation,))
    assert len(pairs) == 2, operation.name
    there, back = pairs
    assert there.base == pattern and back.edited == pattern and there.edited == back.base
    assert back.source == f"{operation.name}, reversed"
    assert faults(there.edited) <= faults(pattern)
    check_pairs(pairs)


def test_the_rest_on_patterns_made_by_other_operations():
    by_name = {o.name: o for o in OPERATIONS}
    trousers = Cutter(draft("trousers"))
    for first, second in (("remove waistband", "add waistband"), ("add leg cuffs", "remove leg cuffs")):
        between = recut(trousers, by_name[first], random.Random(1))
        pairs = geometric_pairs(between.pattern, 1, operations=(by_name[second],))
        assert len(pairs) == 2
        check_pairs(pairs)


def test_collars_of_real_patterns(few_real_patterns, garmentcode_edits):
    by_name = {o.name: o for o in OPERATIONS}
    done = set()
    for pattern, _ in garmentcode_edits():
        if len(done) == 2:
            break
        if any("collar" in p.name for p in pattern.panels):
            for name in ("collar height", "remove collar"):
                pairs = geometric_pairs(pattern, 2, operations=(by_name[name],))
                check_pairs(pairs)
                done |= {name} if pairs else set()
    assert done == {"collar height", "remove collar"}


@pytest.mark.parametrize("name", ["hoodie", "jumpsuit", "fitted-skirt"])
def test_operations_never_harm(name):
    """Whatever the amount: no new finding, no seam that fits worse."""
    cutter = Cutter(draft(name))
    done = 0
    for operation in OPERATIONS:
        after = recut(cutter, operation, random.Random(7))
        if after is not None:
            assert not faults(after.pattern) - faults(cutter.pattern), operation.name
            assert operation.name == "gather skirt" or seams_kept(cutter, after)
            assert len(after.pattern.components()) == 1
            done += 1
    assert done >= 3


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
    operation = next(o for o in OPERATIONS if o.name == "sleeve length")
    pairs = geometric_pairs(pattern, 3, operations=(operation,))
    edited = pairs[0].edited
    changed = {p.name for p in edited.panels if p != pattern.panel(p.name)}
    assert changed == {p.name for p in pattern.panels if "sleeve" in p.name}

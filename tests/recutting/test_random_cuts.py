"""Random cuts: all levers are drawn, nothing is harmed, and the same seed cuts the same."""

from __future__ import annotations

import random

import pytest

from swifttailor.describing import CLAIM_TYPES
from swifttailor.describing.dimensions import DIMENSIONS
from swifttailor.pattern import Severity, check_pattern
from swifttailor.pattern.drafts import draft
from swifttailor.recutting.levers.all_levers import LEVERS, LEVERS_OF, NOT_CUT, TRICKS
from swifttailor.recutting.random_cuts import TOPICS, WAYS, can_be_drawn, recut, recut_variously, topic_of
from swifttailor.recutting.table.checking import seams_kept
from swifttailor.recutting.table.cutter import Cutter

TRIES = 6
# What drafts lack is made first.
FIRST = {
    "left sleeve taken off": "t-shirt",
    "stand collar sewn on": "t-shirt",
    "upper part taken off": "shirt-dress",
    "slit left: higher or lower": "shirt-dress",
    "slit right: higher or lower": "shirt-dress",
    "slit behind: higher or lower": "shirt-dress",
    "slit in front: higher or lower": "shirt-dress",
    "godets let in": "shirt-dress",
    "tiers: more or fewer": "shirt-dress",
    "waistband set in": "shirt-dress",
    "leg cuffs sewn on": "trousers",
}
# Drafts have no bodices that blouse or are gathered below, and only one count of godets fits theirs.
ON_REAL_PATTERNS = {
    "waist darts put into the bodice",
    "bodice, its blousing taken in: longer or shorter",
    "leg cuffs: wider or narrower",
    "godets: more or fewer",
    "godets, their width: more or less",
    "godets, their height: more or less",
}


def draws(cutter, labels):
    """Those of some ways that a pattern can be recut in."""
    rng = random.Random(1)
    possible = [WAYS[label] for label in sorted(labels) if can_be_drawn(WAYS[label], cutter)]
    return {way.label for way in possible if any(recut(cutter, way, rng) for _ in range(TRIES))}


def first_cut(label):
    rng, cutter = random.Random(1), Cutter(draft(FIRST[label]))
    return next(after for _ in range(TRIES) if (after := recut(cutter, WAYS[label], rng)))


def test_every_way_is_drawn():
    left = WAYS.keys() - ON_REAL_PATTERNS
    for name in ("t-shirt", "tank-top", "hoodie", "shirt-dress", "fitted-dress", "trousers", "circle-skirt"):
        left -= draws(Cutter(draft(name)), left)
    for label in FIRST:
        left -= draws(first_cut(label), left)
    assert left == set()


def test_the_rest_is_drawn_on_real_patterns(real_patterns):
    left = set(ON_REAL_PATTERNS)
    for pattern in real_patterns.values():
        left -= draws(Cutter(pattern), left) if left else set()
    assert left == set()


def test_all_levers_and_tricks_can_be_drawn():
    drawn = {way.label for way in (*LEVERS, *TRICKS) if topic_of(way) not in ("sides", "waistband width")}
    assert drawn == WAYS.keys()
    assert sorted(way.label for ways in TOPICS.values() for way in ways) == sorted(WAYS)
    assert TOPICS.keys() <= DIMENSIONS.keys() | CLAIM_TYPES.keys()


def test_every_dimension_is_cut_or_it_is_said_why_not():
    assert {name for name, levers in LEVERS_OF.items() if not levers} == NOT_CUT.keys()
    for lever in LEVERS:
        assert lever.serves and set(lever.serves) <= DIMENSIONS.keys() | CLAIM_TYPES.keys(), lever.label


@pytest.mark.parametrize("name", ["hoodie", "jumpsuit", "fitted-skirt"])
def test_random_cuts_never_harm(name):
    """Whatever the amount: no new finding, no seam that fits worse, no panel on its own."""
    cutter, rng = Cutter(draft(name)), random.Random(7)
    ways = [way for way in WAYS.values() if can_be_drawn(way, cutter)]
    done = 0
    for way in ways:
        after = recut(cutter, way, rng)
        if after is not None:
            found = {(f.code, f.panel) for f in check_pattern(after.pattern) if f.severity > Severity.INFO}
            assert not found - cutter.faults, way.label
            assert way.gathers or seams_kept(cutter, after), way.label
            assert len(after.pattern.components()) == 1
            done += 1
    assert done >= len(ways) / 2


def test_a_lever_moves_what_it_serves():
    """A measure that a lever is drawn for has changed as far as is seen."""
    cutter, rng = Cutter(draft("hoodie")), random.Random(3)
    for label in ("sleeves: longer or shorter", "hood: deeper or shallower", "band: higher or lower"):
        lever = WAYS[label]
        after = next(found for _ in range(TRIES) if (found := recut(cutter, lever, rng)))
        dimension = DIMENSIONS[lever.serves[0]]
        change = abs(dimension.of(after.facts) - dimension.of(cutter.facts))
        assert change > 0.95 * dimension.least, label


def test_each_topic_is_used_once_and_the_same_seed_cuts_the_same():
    cutter = Cutter(draft("shirt-dress"))
    one, other = (
        [(way.label, after.pattern) for way, after in recut_variously(cutter, random.Random(9), _both)]
        for _ in range(2)
    )
    assert one == other and len(one) >= 10
    topics = [next(t for t, ways in TOPICS.items() if WAYS[label] in ways) for label, _ in one]
    assert len(set(topics)) == len(topics)


def _both(way, after):
    return way, after

"""The table of dimensions: each is measured on some garment, and has words."""

from __future__ import annotations

import pytest

from swifttailor.describing import CLAIM_TYPES, measure_facts
from swifttailor.describing.dimensions import DIMENSIONS, QUANTITIES, STATED
from swifttailor.describing.facts_paths import imagine_at, measure_at
from swifttailor.pattern.drafts import draft
from swifttailor.wording.instructions.requests import step_words
from swifttailor.wording.wordings import all_wordings

# Drafts have none of what these are of.
NOT_ON_DRAFTS = {
    *("godets", "godet width", "godet height"),
    *("back slit", "left slit", "right slit"),
}


@pytest.fixture(scope="module")
def measured(drafts):
    return [measure_facts(pattern) for pattern in drafts.values()]


def test_every_dimension_is_measured_on_some_draft(measured):
    found = {name for name, d in DIMENSIONS.items() if any(d.of(facts) is not None for facts in measured)}
    assert DIMENSIONS.keys() - found == NOT_ON_DRAFTS


def test_every_dimension_is_asked_for_or_claimed_and_has_words():
    assert DIMENSIONS.keys() == QUANTITIES.keys() | {d.name for d in STATED.values()}
    assert {name for name, _ in step_words()} == QUANTITIES.keys()
    said = {name for wording in all_wordings() for name in wording.numbers}
    assert {name for name, kind in CLAIM_TYPES.items() if kind.measure} == STATED.keys() <= said


def test_what_is_imagined_is_measured():
    facts = measure_facts(draft("trousers"))
    wider = imagine_at("trousers.hem", "trousers.opening")(facts, 61.0)
    assert measure_at("trousers.hem")(wider) == measure_at("trousers.opening")(wider) == 61.0
    assert measure_at("trousers.inseam")(wider) == measure_at("trousers.inseam")(facts)
    assert measure_at("hood.depth")(facts) is None and imagine_at("hood.depth")(facts, 30.0) == facts


def test_a_stated_number_may_be_off_by_its_tolerance():
    facts = measure_facts(draft("trousers"))
    inseam = STATED["inseam_cm"]
    length = inseam.of(facts)
    assert inseam.is_stated_right(facts, length + 3.0) and not inseam.is_stated_right(facts, length * 1.1)

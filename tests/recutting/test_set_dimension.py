"""Moving one dimension to a value, as sliders do."""

from __future__ import annotations

import pytest

from swifttailor.describing import measure_facts
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.errors import InputError, PatternError
from swifttailor.pattern import Severity, check_pattern
from swifttailor.pattern.drafts import draft
from swifttailor.recutting.levers.all_levers import LEVERS_OF
from swifttailor.recutting.set_dimension import dimension_spans, set_dimension

GARMENTS = ("t-shirt", "shirt-dress", "hoodie", "trousers")
NEAR_CM = 0.15


@pytest.mark.parametrize("name", GARMENTS)
def test_spans_hold_what_is_and_only_what_levers_move(name):
    facts = measure_facts(draft(name))
    spans = dimension_spans(facts)
    assert len(spans) >= 3
    for dimension, span in spans.items():
        assert span.low <= span.value <= span.high and span.high - span.low >= span.step > 0
        assert span.value == pytest.approx(QUANTITIES[dimension].of(facts))
        assert LEVERS_OF[dimension]


@pytest.mark.parametrize("name", GARMENTS)
def test_a_slider_comes_to_its_value_or_says_why_not(name):
    """A tenth of the way to either end: most come there, and none breaks the pattern."""
    pattern = draft(name)
    before = {f.code for f in check_pattern(pattern) if f.severity is not Severity.INFO}
    reached, tried = 0, 0
    for dimension, span in dimension_spans(measure_facts(pattern)).items():
        if not QUANTITIES[dimension].in_cm:
            continue
        for value in (
            span.value + 0.1 * (span.high - span.value),
            span.value - 0.1 * (span.value - span.low),
        ):
            tried += 1
            try:
                moved, _ = set_dimension(pattern, dimension, value)
            except PatternError as error:
                assert dimension in str(error)
                continue
            after = {f.code for f in check_pattern(moved) if f.severity is not Severity.INFO}
            assert after <= before, f"{dimension}: {after - before}"
            now = QUANTITIES[dimension].of(measure_facts(moved))
            assert now is not None
            assert abs(now - value) <= abs(span.value - value) + NEAR_CM
            reached += abs(now - value) <= NEAR_CM
    assert reached >= 0.7 * tried, f"{reached} of {tried}"


def test_the_way_back_leads_to_where_it_was():
    pattern = draft("shirt-dress")
    length = QUANTITIES["length"].of(measure_facts(pattern))
    longer, said = set_dimension(pattern, "length", length + 8)
    back, _ = set_dimension(longer, "length", length)
    assert "length" in said and QUANTITIES["length"].of(measure_facts(longer)) == pytest.approx(
        length + 8, abs=NEAR_CM
    )
    assert QUANTITIES["length"].of(measure_facts(back)) == pytest.approx(length, abs=NEAR_CM)


def test_where_it_is_already_nothing_is_cut():
    pattern = draft("t-shirt").canonical()
    length = QUANTITIES["length"].of(measure_facts(pattern))
    assert set_dimension(pattern, "length", length) == (pattern, "")


@pytest.mark.parametrize(
    ("name", "value", "error"),
    [
        ("no such", 1.0, InputError),
        ("length", float("nan"), InputError),
        ("leg length", 50.0, PatternError),
        ("length", 1e6, PatternError),
    ],
)
def test_what_cannot_be(name, value, error):
    with pytest.raises(error, match=name):
        set_dimension(draft("t-shirt"), name, value)

"""Lengths that words state hold on the body that a pattern is refitted to."""

from __future__ import annotations

import pytest

from swifttailor.describing import measure_facts
from swifttailor.tailor import Order, Tailor
from swifttailor.tailor.lengths_kept import with_lengths_kept
from swifttailor.tailor.refitted import refitted
from swifttailor.tailor.wearing import body_wanted


@pytest.fixture(scope="module")
def tailor():
    return Tailor.load()


def test_stated_lengths_are_cut_again_after_refitting(tailor):
    (answer,) = tailor.write([Order("tunic 75 cm long, sleeves 60 cm, petite")])
    body = body_wanted(answer.wanted.order, None)
    small = refitted(answer, body)
    facts = measure_facts(small.pattern, body.measurements)
    assert facts.length < 73.0 and facts.left_sleeve.length < 57.5
    kept = with_lengths_kept(small, body)
    after = measure_facts(kept.pattern, body.measurements)
    assert after.length == pytest.approx(75.0, abs=3.0)
    assert after.left_sleeve.length == pytest.approx(60.0, abs=3.6)
    assert kept.verdict.open == answer.verdict.open and len(kept.cuts) > len(small.cuts)


def test_what_cannot_be_had_on_that_body_is_said(tailor):
    (answer,) = tailor.write([Order("a knee length dress 95 cm long for a girl of 8 years old")])
    body = body_wanted(answer.wanted.order, None)
    kept = with_lengths_kept(refitted(answer, body), body)
    assert {change.claim.name for change in kept.verdict.open} == {"length_cm"}


def test_where_lengths_hold_nothing_is_cut(tailor):
    (answer,) = tailor.write([Order("size 18 midi skirt with a waistband")])
    body = body_wanted(answer.wanted.order, None)
    fitted = refitted(answer, body)
    assert with_lengths_kept(fitted, body) is fitted


@pytest.mark.parametrize("who", ["I am 4'11", "for a woman 190 cm tall"])
def test_a_hem_that_is_said_from_the_knee_is_above_the_wearers_own(tailor, who):
    (answer,) = tailor.write([Order(f"{who}, a sundress, the hem two inches above the knee")])
    body = body_wanted(answer.wanted.order, None)
    kept = with_lengths_kept(refitted(answer, body), body)
    facts = measure_facts(kept.pattern, body.measurements)
    # Dresses hang a little lower than they are cut.
    assert facts.hem.level - facts.body.knee == pytest.approx(5.1 + 2.5, abs=3.0)
    assert kept.verdict.open == answer.verdict.open

"""What was drafted is drafted anew for large people."""

from __future__ import annotations

from swifttailor.body.wearer import Wearer
from swifttailor.describing.measuring import measure_facts
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.tailor import Order
from swifttailor.tailor.answer import Answer
from swifttailor.tailor.drafted import DraftCandidate
from swifttailor.tailor.large_drafts import drafted_for_large
from swifttailor.tailor.reading import Wanted


def answer_of(name):
    begun = DraftCandidate(NamedDraft(name), 0, plain=True)
    return Answer(begun.made_for(None), wanted=Wanted(Order("a top"), "a top"), drafted=begun)


def test_sleeves_stay_as_long_as_arms():
    large = Wearer(size="women 3XL").body()
    made = drafted_for_large(answer_of("hoodie"), large)
    assert made is not None
    facts = measure_facts(made, large.measurements)
    assert facts.left_sleeve is not None and facts.left_sleeve.length < 61.0
    assert facts.torso is not None and facts.torso.chest_ease > 15.0


def test_others_are_refitted():
    small, large = Wearer(size="women M").body(), Wearer(size="women 3XL").body()
    assert drafted_for_large(answer_of("hoodie"), small) is None
    assert drafted_for_large(answer_of("circle-skirt"), large) is None

"""Skirts of so many gores, tiers or godets, drafted where no known pattern has them."""

import pytest
from own_library import library_of

import swifttailor
from swifttailor.describing import Claim, measure_facts
from swifttailor.describing.differences import Gain
from swifttailor.pattern import check_pattern
from swifttailor.tailor.counted import CountedCandidate, counted_design, counted_pattern
from swifttailor.tailor.made_anew import anew_from_known
from swifttailor.tailor.order import Order
from swifttailor.tailor.reading import Wanted
from swifttailor.wishes.heard import HEARD_NOTHING
from swifttailor.wishes.reader import Wish

GORES, TIERS, GODETS = (
    lambda n, name=name: Gain(Claim(name, float(n))) for name in ("gores", "tiers", "godets")
)


@pytest.mark.parametrize("kind", ["skirt", "dress"])
@pytest.mark.parametrize(
    ("wish", "of", "count"),
    [
        (GORES(7), "gores", 7),
        (GORES(12), "gores", 12),
        (GODETS(10), "godets", 10),
        (TIERS(2), "tiers", 2),
        (TIERS(6), "tiers", 6),
        (Gain(Claim("skirt", "gored")), "gores", 6),
    ],
)
def test_there_are_as_many_as_are_asked_for(kind, wish, of, count):
    found = counted_pattern([wish], kind)
    assert found is not None
    pattern, _ = found
    facts = measure_facts(pattern)
    assert facts.kind == kind and getattr(facts.skirt, of) == count
    assert not [f for f in check_pattern(pattern) if f.kind == "error"]


@pytest.mark.parametrize(
    ("wishes", "kind"),
    [
        ([GORES(40)], "skirt"),
        ([GODETS(5)], "dress"),
        ([GORES(7)], "trousers"),
        ([Gain(Claim("skirt", "circle"))], "skirt"),
    ],
)
def test_there_is_no_design_of_what_cannot_be_counted_so(wishes, kind):
    assert counted_design(wishes, kind) is None and counted_pattern(wishes, kind) is None


def wanted(*wishes, **order):
    heard = HEARD_NOTHING
    return Wanted(Order("words", **order), "words", wishes=tuple(Wish(w, 1.0) for w in wishes), heard=heard)


def test_only_what_is_described_in_words_is_a_candidate():
    assert len(CountedCandidate(wanted(GORES(7)))) == 0  # of a garment of which no kind is known
    edit = swifttailor.draft("circle-skirt")
    assert len(CountedCandidate(wanted(GORES(7), edit=edit))) == 0


def test_the_skirt_of_a_dress_is_exchanged_for_one_of_seven_gores(tmp_path):
    edit = swifttailor.draft("shirt-dress")
    library = library_of({"plain": swifttailor.draft("fitted-skirt")}, tmp_path)
    answer = anew_from_known(wanted(GORES(7), edit=edit), lambda: library)
    assert answer is not None and answer.anew == "half" and answer.design is not None
    after = measure_facts(answer.pattern)
    assert after.skirt.gores == 7 and after.left_sleeve is not None
    kept = {p.name: p for p in edit.panels if "torso" in p.name}
    assert kept
    for name, panel in kept.items():
        # Only where the seam at the waist is sewn to more panels are there more corners on it.
        assert answer.pattern.panel(name).signed_area() == pytest.approx(panel.signed_area(), rel=1e-9)

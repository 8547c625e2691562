"""What goes without saying."""

from __future__ import annotations

import pytest

import swifttailor
from swifttailor.describing import Claim, measure_facts
from swifttailor.describing.differences import Gain
from swifttailor.pattern.drafts import list_drafts
from swifttailor.recutting import alter
from swifttailor.wishes.assumed.unsaid import leaves_hem_unsaid, unsaid_wishes


def wished(name: str, *said: Claim) -> set[tuple[str, object]]:
    facts = measure_facts(swifttailor.draft(name))
    wishes = unsaid_wishes([Gain(claim) for claim in said], facts)
    assert all(isinstance(wish, Gain) and not wish.claim.holds(facts) for wish in wishes)
    return {(wish.claim.name, wish.claim.value) for wish in wishes if isinstance(wish, Gain)}


UNUSUAL = {
    "hoodie": {("hood", "none")},
    "hooded-coat": {("hood", "none")},
    "waistcoat": {("top_hem", "hip")},
    "bandeau": {("top_hem", "hip")},
    "bustier": {("top_hem", "hip")},
    "off-shoulder-top": {("top_hem", "hip")},
    "bomber-jacket": {("top_hem", "hip")},
    "denim-jacket": {("top_hem", "hip")},
    "joggers": {("leg_cuffs", "none")},
    "fitted-top": {("top_hem", "hip")},
    "bodysuit": {("leg_hem", "full")},
    "briefs": {("leg_hem", "full")},
    "swimsuit": {("leg_hem", "full")},
    "wrap-skirt": {("slit", "none")},
    "sarong": {("slit", "none")},
    "wrap-dress": {("slit", "none")},
}


@pytest.mark.parametrize("name", [d.name for d in list_drafts()])
def test_other_drafts_are_as_usual(name):
    assert wished(name) == UNUSUAL.get(name, set())


def test_a_hood_that_was_asked_for_stays():
    assert wished("hoodie", Claim("hood", "hood")) == set()


def test_trousers_reach_the_feet_unless_they_are_asked_shorter():
    cut = alter(swifttailor.draft("trousers"), [Gain(Claim("leg_hem", "knee"))])
    assert cut.open == ()
    found = unsaid_wishes([], cut.facts)
    assert found == (Gain(Claim("leg_hem", "full")),)
    for said in (Claim("leg_hem", "knee"), Claim("inseam_cm", 40.0), Claim("kind", "shorts")):
        assert unsaid_wishes([Gain(said)], cut.facts) == ()


def test_a_skirt_covers_however_short_it_is_asked_for():
    whole = swifttailor.draft("circle-skirt")
    bare = alter(whole, [Gain(Claim("skirt_length_cm", 16.0))])
    assert bare.open == ()
    body = bare.facts.body
    assert bare.facts.hem is not None and bare.facts.hem.level > body.crotch
    assert unsaid_wishes([], bare.facts) == (Gain(Claim("skirt_hem", "above the knee")),)
    mini = Gain(Claim("skirt_hem", "mini"))
    (length,) = unsaid_wishes([mini], bare.facts)
    longer = alter(bare.pattern, [mini, length])
    assert longer.open == ()
    assert longer.facts.hem is not None
    assert body.crotch - 13.0 < longer.facts.hem.level < body.crotch - 5.0
    assert unsaid_wishes([Gain(Claim("skirt_length_cm", 16.0))], bare.facts) == ()


def test_a_hem_is_level_unless_something_is_said_of_it():
    assert leaves_hem_unsaid([Gain(Claim("kind", "skirt"))])
    assert not leaves_hem_unsaid([Gain(Claim("hem_shape", "high-low"))])
    assert not leaves_hem_unsaid([Gain(Claim("sides", "different"))])


def test_a_slit_behind_is_usual_alone():
    skirt = swifttailor.draft("fitted-skirt")
    behind = alter(skirt, [Gain(Claim("slit", "back"))])
    assert behind.open == () and unsaid_wishes([], behind.facts) == ()
    both = alter(behind.pattern, [Gain(Claim("slit", "left")), Gain(Claim("slit", "back"))])
    assert both.open == ()
    assert unsaid_wishes([], both.facts) == (Gain(Claim("slit", "none")),)
    assert unsaid_wishes([Gain(Claim("slit", "left"))], both.facts) == ()

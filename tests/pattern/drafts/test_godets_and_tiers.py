"""Godets let into hems, and tiers below a close part."""

from __future__ import annotations

import pytest
from draft_checks import assert_sound

from swifttailor.describing import Claim
from swifttailor.describing.measuring import measure_facts
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.drafts.godets_as_asked import godets_as_asked
from swifttailor.wishes.drafts.tiers_as_asked import tiers_as_asked

GODETS, TIERED, FULL = Claim("skirt", "godets"), Claim("skirt", "tiered"), Claim("skirt", "flared")
CLOSE = Claim("hips", "close")


@pytest.mark.parametrize("name", ["fitted-skirt", "fitted-dress"])
@pytest.mark.parametrize("count", [3, 6, 12])
def test_godets_add_their_width_to_the_hem_and_take_hardly_any(name, count):
    skirt = measure_facts(draft(name, godets=count, godet_width=30.0, godet_height=28.0)).skirt
    plain = measure_facts(draft(name)).skirt
    assert skirt is not None and plain is not None
    assert GODETS.holds(measure_facts(draft(name, godets=count)))
    assert skirt.godets == count
    assert skirt.godet_width == pytest.approx(30.0, abs=0.2)
    assert 23.0 < skirt.godet_height < 28.0  # at its sides; its hem is an arc
    assert skirt.hem == pytest.approx(plain.hem + 30.0 * count, abs=2.0 * count)


@pytest.mark.parametrize("name", ["fitted-skirt", "fitted-dress"])
def test_slits_end_beside_sides_that_bend_inward_above_them(name):
    length, flare = ("length", "flare") if name == "fitted-skirt" else ("skirt_length", "skirt_flare")
    assert_sound(draft(name, **{length: 36.0, flare: 18.0}, godets=12, hip_ease=0.5, stretch=10.0))


@pytest.mark.parametrize("length", [60.0, 98.0])
@pytest.mark.parametrize("tiers", [2, 4])
def test_tiers_below_a_close_part_leave_it_close_and_share_the_rest(tiers, length):
    facts = measure_facts(draft("tiered-skirt", close=40.0, tiers=tiers, length=length))
    assert facts.skirt is not None
    assert facts.skirt.tiers == tiers + 1
    assert facts.skirt.base_length == pytest.approx(36.0, abs=1.5)
    assert facts.skirt.tier_gather == pytest.approx(1.4, abs=0.02)
    assert Claim("hips", "close").holds(facts)


def test_a_dress_may_end_in_tiers_instead_of_a_flounce():
    facts = measure_facts(draft("mermaid-dress", tiers=3, skirt_length=98.0))
    assert facts.skirt is not None and facts.skirt.tiers == 4


@pytest.mark.parametrize(
    ("named", "claims", "begun"),
    [
        ("fitted-skirt", [], "fitted-skirt"),
        (
            "circle-skirt(length=60)",
            [GODETS, Claim("godets", 4.0)],
            "fitted-skirt(length=60;flare=2;godets=4;godet_width=38;godet_height=28.8)",
        ),
        (
            "skater-dress(sleeves=true)",
            [GODETS, Claim("skirt_hem", "maxi")],
            "fitted-dress(sleeves=true;skirt_length=96;skirt_flare=2;godets=6;godet_width=38;godet_height=45)",
        ),
        ("camisole", [GODETS], "camisole"),
    ],
)
def test_godets_are_let_in_where_they_are_asked_for(named, claims, begun):
    assert godets_as_asked(NamedDraft.parse(named), claims) == NamedDraft.parse(begun)


@pytest.mark.parametrize(
    ("named", "claims", "begun"),
    [
        ("tiered-skirt(length=62)", [TIERED], "tiered-skirt(length=62)"),
        (
            "tiered-skirt",
            [TIERED, CLOSE, Claim("skirt_hem", "floor"), Claim("tiers", 4.0)],
            "tiered-skirt(length=100;close=46;tiers=4)",
        ),
        ("mermaid-skirt", [TIERED], "tiered-skirt(length=62;close=30;tiers=3)"),
        ("mermaid-skirt", [], "mermaid-skirt"),
        ("circle-skirt(fraction=0.6)", [TIERED, FULL], "tiered-skirt(length=62;fullness=1.8)"),
        ("circle-skirt", [FULL], "circle-skirt"),
        ("tiered-skirt", [TIERED, FULL], "tiered-skirt(length=62;fullness=1.8)"),
        ("mermaid-dress(close=50)", [TIERED], "mermaid-dress(close=50;tiers=3)"),
    ],
)
def test_tiers_are_as_they_are_asked_for(named, claims, begun):
    assert tiers_as_asked(NamedDraft.parse(named), claims) == NamedDraft.parse(begun)

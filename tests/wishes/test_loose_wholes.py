"""Garments that are loose from the shoulders to the hem."""

from __future__ import annotations

from dataclasses import replace

import pytest

import swifttailor
from swifttailor.describing import Claim, measure_facts
from swifttailor.describing.differences import Gain
from swifttailor.describing.facts import Slit
from swifttailor.recutting import alter
from swifttailor.wishes.corrections.loose_wholes import UNLIKELY, is_loose_whole, loosened, of_loose_wholes
from swifttailor.wishes.reader import Wish

_LOOSE = Claim("fit", "loose")


@pytest.mark.parametrize(
    ("more", "kind", "whole"),
    [
        ((), "dress", True),
        ((Claim("skirt", "straight"),), "dress", True),
        ((Claim("hips", "loose"),), "tunic", True),
        ((), "trousers", False),
        ((), None, False),
        ((Claim("waist_seam", "empire"),), "dress", False),
        ((Claim("skirt", "pencil"),), "dress", False),
        ((Claim("hips", "close"),), "dress", False),
        ((Claim("bodice", "darted"),), "dress", False),
    ],
)
def test_loose_means_all_of_it_unless_a_shape_is_told(more, kind, whole):
    assert is_loose_whole([_LOOSE, *more], kind) is whole
    assert not is_loose_whole(more, kind)


def test_patterns_without_waist_seam_and_darts_are_sought_for_it():
    found = {w.change.claim: w.certainty for w in of_loose_wholes([Wish(Gain(_LOOSE), 0.97)], "dress")}
    for claim in (Claim("waist_seam", "natural"), Claim("bodice", "darted"), Claim("skirt", "pencil")):
        assert found[claim] == UNLIKELY
    assert of_loose_wholes([Wish(Gain(_LOOSE), 0.6)], "dress") == ()


def test_darts_and_slits_go_and_the_hips_are_let_out():
    pattern = swifttailor.draft("fitted-dress")
    facts = measure_facts(pattern)
    assert facts.torso.darts
    wishes = loosened([Gain(_LOOSE)], facts)
    assert Gain(Claim("bodice", "undarted")) in wishes
    assert loosened([Gain(_LOOSE), Gain(Claim("bodice", "darted"))], facts) == ()
    close = replace(
        facts, skirt=replace(facts.skirt, hips=facts.body.hip_girth, slits=(Slit("back", 20.0, 1.0),))
    )
    assert {("hips", "loose"), ("slit", "none")} <= {
        (w.claim.name, w.claim.value) for w in loosened([Gain(_LOOSE)], close)
    }
    after = alter(pattern, [_LOOSE, Claim("hips", "loose")])
    assert after.open == () and loosened([Gain(_LOOSE)], after.facts) == (Gain(Claim("bodice", "undarted")),)


def test_what_is_loose_already_stays():
    assert loosened([Gain(_LOOSE)], measure_facts(swifttailor.draft("kaftan"))) == ()

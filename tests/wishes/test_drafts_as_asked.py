"""Named drafts with the collar, the shoulders and the slits that a text asks for."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.describing.claims import CLAIM_TYPES, Claim
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.drafts.draft_names import BARE_SHOULDERED, DRAFT_NAMES, NamedDraft
from swifttailor.wishes.drafts_as_asked import draft_as_asked

BARE = Claim("shoulders", "strapless")
STAND = Claim("collar", "stand")
SLITS = [Claim("slit", "left"), Claim("slit", "right")]


@pytest.mark.parametrize(
    ("named", "claims", "begun"),
    [
        ("shirt", [], "shirt"),
        ("shirt", [STAND], "shirt(collar=standing)"),
        ("shirt", [Claim("neckline", "v")], None),
        ("shirt-dress(collar=folded;cuffs=false)", [STAND], "shirt-dress(cuffs=false;collar=standing)"),
        ("fitted-dress(collar=standing)", [Claim("neckline", "square")], None),
        ("fitted-dress(hip_ease=3;neck_depth=13)", [BARE], "strapless-dress(hip_ease=3;fitted=true)"),
        ("sweatshirt", [BARE], None),
        ("off-shoulder-top", [BARE], "off-shoulder-top"),
        ("strapless-dress", [Claim("sleeves", "long")], "skater-dress(skirt_length=98;skirt_fraction=0.5)"),
        ("strapless-dress", [Claim("sleeves", "none")], "strapless-dress"),
        ("t-shirt(length=38)", SLITS, "t-shirt(length=38;side_slits=14)"),
        ("t-shirt(length=38)", SLITS[:1], "t-shirt(length=38)"),
        ("skater-dress", SLITS[:1], "fitted-dress(skirt_length=72)"),
        ("tank-top(length=-3)", [Claim("straps", "narrow")], None),
        ("jumpsuit", [Claim("legs", "wide")], "jumpsuit(leg_ease=40;flare=8)"),
        ("trousers", [Claim("legs", "wide")], "trousers"),
        ("trousers(hip_ease=7)", [Claim("hips", "loose")], "trousers(hip_ease=12)"),
        ("t-shirt(length=38;neck_widening=1)", [STAND], "turtleneck(length=38;collar_height=4)"),
        ("tiered-skirt", [Claim("tiers", 4.0)], "tiered-skirt(tiers=4)"),
        ("tiered-skirt", [Claim("tiers", 9.0)], "tiered-skirt"),
    ],
)  # fmt: skip
def test_a_draft_is_begun_as_it_is_asked_for(named, claims, begun):
    found = draft_as_asked(NamedDraft.parse(named), claims)
    assert found == (None if begun is None else NamedDraft.parse(begun))


VALUES = [Claim(name, word) for name, kind in CLAIM_TYPES.items() for word in kind.words]


@given(st.sampled_from(DRAFT_NAMES), st.lists(st.sampled_from([BARE, STAND, *SLITS, *VALUES]), max_size=4))
def test_what_is_begun_can_be_drafted_and_has_the_shoulders_asked_for(name, claims):
    found = draft_as_asked(NamedDraft(name), claims)
    if found is None:
        return
    assert draft(found.name, **dict(found.options)).panels
    assert BARE not in claims or found.name in BARE_SHOULDERED

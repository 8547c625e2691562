"""What nobody expects who has not asked for it."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.describing import Claim
from swifttailor.describing.claims import CLAIM_TYPES
from swifttailor.describing.differences import Gain
from swifttailor.wishes.assumed.unsaid_looks import unexpected_looks
from swifttailor.wishes.reader import Wish
from swifttailor.wording.claim_kinds import fits_kind

KINDS = CLAIM_TYPES["kind"].words
WORDS = [Claim(kind.name, value) for kind in CLAIM_TYPES.values() for value in kind.words]


def wish(name, value, certainty=0.97):
    return Wish(Gain(Claim(name, value)), certainty)


def names(wishes, kind):
    return {f"{claim.name}={claim.value}" for claim in unexpected_looks(wishes, kind)}


@given(
    st.lists(st.tuples(st.sampled_from(WORDS), st.floats(0.5, 1.0)), max_size=6), st.sampled_from([*KINDS])
)
def test_only_what_a_kind_can_have_and_nobody_spoke_of_is_unexpected(said, kind):
    wishes = [Wish(Gain(claim), certainty) for claim, certainty in said]
    found = unexpected_looks(wishes, kind)
    assert len(set(found)) == len(found)
    sure = {claim.name for claim, certainty in said if certainty >= 0.85}
    for claim in found:
        assert claim.value in CLAIM_TYPES[claim.name].words
        assert fits_kind(claim.name, kind)
        further = claim == Claim("skirt", "fitted base") or Claim("shoulders", "both") in [c for c, _ in said]
        assert further or claim.name not in sure
        assert claim not in [one for one, _ in said]


def test_nothing_is_unexpected_of_a_garment_of_which_nothing_is_known():
    assert unexpected_looks([], None) == ()


@pytest.mark.parametrize(
    ("kind", "unexpected", "expected"),
    [
        ("top", {"sleeve_shape=puffed", "waistband=hem", "fit=loose"}, {"legs=flared"}),
        ("dress", {"shoulders=strapless", "skirt=godets", "waistband=hem"}, {"legs=flared"}),
        ("skirt", {"skirt=tiered"}, {"fit=loose", "sleeve_shape=puffed"}),
        ("trousers", {"legs=flared"}, {"skirt=tiered"}),
    ],
)
def test_each_kind_has_its_own(kind, unexpected, expected):
    found = names([], kind)
    assert unexpected <= found
    assert not expected & found


def test_what_is_said_may_be_meant():
    assert not [n for n in names([wish("sleeve_shape", "bell")], "dress") if n.startswith("sleeve_shape")]
    deep = names([wish("neck_depth", "low")], "dress")
    assert "neck_depth=plunging" not in deep and "back_depth=open" in deep
    assert "sleeve_shape=gathered end" not in names([wish("cuffs", "band")], "top")
    assert "sleeve_shape=balloon" in names([wish("cuffs", "band")], "top")


def test_what_may_be_meant_is_not_unexpected_but_what_goes_further_is():
    found = names([wish("fit", "loose", 0.6)], "top")
    assert "fit=loose" not in found
    assert "fit=oversized" in found


def test_rows_hang_from_the_waist_unless_the_hips_are_spoken_of():
    tiers = wish("skirt", "tiered")
    assert "skirt=fitted base" in names([tiers], "skirt")
    assert "skirt=fitted base" not in names([tiers, wish("hips", "close")], "skirt")
    assert "skirt=fitted base" not in names([wish("skirt", "fitted base")], "skirt")


def test_covered_shoulders_say_nothing_of_a_bare_back():
    assert "back_depth=low" in names([wish("shoulders", "both")], "top")
    assert "back_depth=low" not in names([wish("shoulders", "bare left")], "top")


def test_puffed_sleeves_are_not_frilled():
    assert "cuffs=flounce" in names([wish("sleeve_shape", "puffed")], "top")
    assert "cuffs=flounce" not in names([wish("cuffs", "flounce")], "top")

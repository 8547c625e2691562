"""Wishes said again in the words of captions."""

from __future__ import annotations

import pytest

from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.wishes.descriptions.own_words import in_own_words
from swifttailor.wishes.reader import WishReader
from swifttailor.wording.captions import write_claims
from swifttailor.wording.claim_kinds import implied_kind

DRESS = [
    Gain(Claim("kind", "dress")),
    Gain(Claim("sleeves", "none")),
    Gain(Claim("shoulders", "both")),
    Gain(Claim("neckline", "v")),
    Gain(Claim("skirt_hem", "knee")),
]


@pytest.mark.parametrize("seed", range(8))
def test_all_is_said_and_nothing_else(seed):
    claims = [wish.claim for wish in DRESS]
    caption = write_claims(claims, seed)
    assert set(caption.claims) == set(claims)
    assert caption.text == in_own_words(DRESS, seed)
    read = {w.change for w in WishReader.load().read(caption.text) if w.certainty > 0.9}
    assert set(DRESS) <= read


def test_other_seeds_have_other_words():
    assert len({in_own_words(DRESS, seed) for seed in range(8)}) > 3


def test_what_is_no_description_is_not_said():
    assert in_own_words([]) == ""
    assert in_own_words([Step("length", 1, 5.0)]) == ""


@pytest.mark.parametrize(
    ("claims", "kind"),
    [
        ([("legs", "wide")], "trousers"),
        ([("legs", "wide"), ("sleeves", "none")], "jumpsuit"),
        ([("skirt", "flared")], "skirt"),
        ([("skirt_hem", "mini"), ("neckline", "v")], "dress"),
        ([("hood", "hood"), ("sleeves", "long")], "top"),
    ],
)
def test_what_is_said_tells_the_kind(claims, kind):
    said = [Claim(name, value) for name, value in claims]
    assert implied_kind(said) == (kind,)
    assert implied_kind([Claim("rise", "high")]) == ()
    words = in_own_words([Gain(claim) for claim in said])
    assert Gain(Claim("kind", kind)) in {w.change for w in WishReader.load().read(words)}

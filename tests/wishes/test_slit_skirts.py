"""Skirts in which a slit is to be seen are close: a wide one falls over it."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.drafts.slit_skirts import slit_as_asked

LEFT, RIGHT = Claim("slit", "left"), Claim("slit", "right")


@pytest.mark.parametrize(
    ("draft", "claims", "found"),
    [
        ("strapless-dress(skirt_length=98;skirt_fraction=0.5)", (LEFT,), "strapless-dress"),
        ("slip-dress(length=74)", (RIGHT,), "strappy-dress"),
    ],
)
def test_it_becomes_close(draft, claims, found):
    asked = slit_as_asked(NamedDraft.parse(draft), claims)
    assert asked.name == found and dict(asked.options)["fitted"] is True
    assert "skirt_fraction" not in dict(asked.options)


@pytest.mark.parametrize(
    ("draft", "claims"),
    [
        ("strapless-dress(skirt_fraction=0.5)", ()),
        ("strapless-dress(skirt_fraction=0.5)", (LEFT, RIGHT)),
        ("strapless-dress(gathers=2.0)", (LEFT,)),
        ("strapless-dress(skirt_fraction=0.5)", (LEFT, Claim("skirt", "flared"))),
        ("slip-dress", (Claim("slit", "back"),)),
        ("fitted-dress", (LEFT,)),
    ],
)
def test_others_stay(draft, claims):
    assert slit_as_asked(NamedDraft.parse(draft), claims) == NamedDraft.parse(draft)

"""Dusters hang open, other coats are closed."""

from __future__ import annotations

import pytest

from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.drafts.heard_drafts import drafts_of
from swifttailor.wishes.reader import WishReader


@pytest.mark.parametrize(("text", "opening"), [("duster coat", 5.0), ("a dust coat", 5.0), ("a coat", 0.0)])
def test_how_far_a_coat_is_open(text, opening):
    (draft, *_) = drafts_of(hear_description(text, WishReader.load()))
    assert draft.name == "coat" and float(dict(draft.options).get("opening", 0.0)) == opening

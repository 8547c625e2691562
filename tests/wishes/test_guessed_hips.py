"""Close hips that a network alone hears: never of what is wide there."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.reader import WishReader

CLOSE = Claim("hips", "close")


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


@pytest.mark.parametrize(
    ("text", "close"),
    [
        ("cardigan dress", False),
        ("organza skirt in pale pink", False),
        ("faux wrap dress", False),
        ("tight cardigan dress", True),
        ("a-line skirt, close at the hips", True),
        ("bodycon dress", True),
    ],
)
def test_hips_are_close_where_a_word_says_so(text: str, close: bool, reader: WishReader) -> None:
    heard = hear_description(text, reader)
    claims = [w.change.claim for w in (*heard.sure, *heard.likely) if isinstance(w.change, Gain)]
    assert (CLOSE in claims) is close


def test_a_loose_knitted_dress_hangs_from_the_shoulders(reader: WishReader) -> None:
    draft = hear_description("cardigan dress", reader).drafts[0]
    assert draft.name == "shift-dress" and "stretch" not in dict(draft.options)

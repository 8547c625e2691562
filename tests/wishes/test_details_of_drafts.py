"""Words about details that tell an option of the draft that another word names."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes.drafts.heard_drafts import drafts_of
from swifttailor.wishes.heard import Heard
from swifttailor.wishes.reader import Wish
from swifttailor.wording.lexicon import read_words


@pytest.mark.parametrize(
    ("text", "kind", "draft", "option", "value"),
    [
        ("harem pants but not too droopy", "trousers", "joggers", "crotch_drop", 5.0),
        ("harem pants", "trousers", "joggers", "crotch_drop", 9.0),
        ("a trench coat with a swing back", "dress", "coat", "flare", 60.0),
    ],
)
def test_a_detail_tells_an_option_of_the_draft_that_is_named(text, kind, draft, option, value):
    words = read_words(text)
    sure = (Wish(Gain(Claim("kind", kind)), 1.0),)
    drafts = drafts_of(Heard(text, sure=sure, lacks=tuple(words.lacks), words=words))
    assert next(dict(each.options)[option] for each in drafts if each.name == draft) == value

"""That a collar which is named is there, whatever kind it is."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.wishes.corrections.named_collars import named_collars
from swifttailor.wording.lexicon import read_words


@pytest.mark.parametrize(
    ("text", "named"),
    [
        ("a shirt with a jaunty collar", True),
        ("a shirt, semi cutaway collar, single cuff", True),
        ("a dress with a demi collar", True),
        ("a shirt without a collar", False),
        ("a collarless shirt", False),
        ("a grandad shirt, no collar to speak of", False),
        ("a shirt", False),
    ],
)
def test_a_collar_that_is_named_is_not_none(text, named):
    assert (named_collars(read_words(text)) == (Claim("collar", "none"),)) is named

"""Satin shines, and what is only silk or crepe hardly does."""

from __future__ import annotations

import pytest

from swifttailor.wishes.looks.satin import is_satin
from swifttailor.wording import read_words


@pytest.mark.parametrize(
    "text", ["a satin blouse", "robe longue en satin", "a charmeuse skirt", "slip dress", "bias cut skirt"]
)
def test_satin_shines(text):
    assert is_satin(read_words(text))


@pytest.mark.parametrize("text", ["a crepe gown", "raw silk waistcoat", "silk blouse", "a dress, no satin"])
def test_other_silks_do_not(text):
    assert not is_satin(read_words(text))

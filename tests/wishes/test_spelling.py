"""Slips in words of cut."""

from __future__ import annotations

import pytest

from swifttailor.wishes.text.lexicon_spelling import lexicon_spelling
from swifttailor.wishes.text.spelling import _slips, common_slip, cut_words, neighbours, put_right
from swifttailor.wording.lexicon import all_entries
from swifttailor.wording.wordings import all_wordings


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("sleevless dres with v nekc", "sleeveless dress with v neck"),
        ("a lnog flaerd skrit", "a long flared skirt"),
        ("TROSERS, ankle lenght!", "trousers, ankle length!"),
        ("slevees, sleeeves", "sleeves, sleeves"),
    ],
)
def test_letters_left_out_doubled_or_exchanged_are_put_right(said, meant):
    assert put_right(said) == meant


@pytest.mark.parametrize(
    "text",
    [
        "black sports wear in linen for the beach",
        "a symmetric dress, form fitting, of shot silk",
        "wait for the pool, then come here and bring the tape",
        "no pockets, wider thighs, 60 cm",
        "una falda larga, eine weite Hose",
        "Ärmel",
        "",
    ],
)
def test_other_words_stay(text):
    assert put_right(text) == text


def test_all_that_captions_say_stays():
    said = [text for w in all_wordings() for texts in w.texts.values() for text in texts]
    assert len(said) > 500
    assert [text for text in said if put_right(text) != text] == []


def test_neighbours_are_one_slip_away():
    near = neighbours("neck")
    assert {"necks", "enck", "nceck", "nck"} & near == {"necks", "enck", "nceck"}
    assert "beck" not in near
    assert "neck" not in near
    assert "trousers" in cut_words()


@pytest.mark.parametrize(
    ("said", "meant"),
    [("nee", "knee"), ("Strait", "straight"), ("bak", "back"), ("wlak", "walk"), ("coler", "collar")],
)
def test_common_slips_lead_back_to_what_is_meant(said, meant):
    assert common_slip(said) == meant


def test_no_common_slip_is_a_word_of_any_table():
    known = {w.lower() for e in all_entries() for w in e.words}
    assert not known & set(_slips())


@pytest.mark.parametrize("word", ["played", "harness", "smoking", "supper", "locked"])
def test_words_of_everyday_are_no_slips(word):
    assert put_right(word) == word and lexicon_spelling(word) is None

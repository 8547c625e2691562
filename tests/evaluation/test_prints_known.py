"""How well prints are read is counted by what they are and by what was said."""

from __future__ import annotations

import pytest

from swifttailor.errors import InputError
from swifttailor.evaluation.pictures.prints import PrintScores, known_prints, word_of
from swifttailor.picture_reader.seen_print import DOWN, SeenPrint


def test_a_list_of_prints_is_read_and_other_words_are_refused(tmp_path):
    table = tmp_path / "prints.csv"
    table.write_text("image,part,prints\na,upper,across figures\nb,lower,plain\n")
    assert known_prints(table) == {("a", "upper"): ("across", "figures"), ("b", "lower"): ("plain",)}
    table.write_text("image,part,prints\na,upper,tartan\n")
    with pytest.raises(InputError, match="Line 2"):
        known_prints(table)
    with pytest.raises(InputError, match="cannot be read"):
        known_prints(tmp_path / "none.csv")


def test_what_is_said_and_what_is_there_are_counted():
    garments = [(("across", "figures"), "figures"), (("plain",), "dots"), (("checks",), "plain")]
    scores = PrintScores(garments)
    assert scores.said("figures") == (1, 1) and scores.said("dots") == (1, 0)
    assert scores.there("across") == (1, 1) and scores.there("checks") == (1, 0)
    assert scores.printed() == (2, 1, 2)
    stripes = SeenPrint("stripes", 1.0, ("#000000", "#ffffff"), (0.5, 0.5))
    assert word_of(None) == "plain" and word_of(stripes) == "across"
    assert word_of(SeenPrint("stripes", 1.0, stripes.colors, stripes.shares, DOWN)) == "down"

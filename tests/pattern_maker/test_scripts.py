from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.pattern_maker.asking.scripts import about_scripts, says_something
from swifttailor.pattern_maker.maker import PatternMaker


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("a knee-length dress, 95 cm long", ""),
        ("Ein Kleid über dem Knie, œuvre", ""),
        ("ａ ｌｏｎｇ ｄｒｅｓｓ", ""),  # full-width letters are read as ordinary ones
        ("<script>alert(1)</script>", ""),
        ("一条长裙", "has never seen"),
        ("فستان طويل", "has never seen"),
        ("a 长裙 dress", "1 of the text's 3 words"),
        ("👗👗", "holds no word"),
        ("95", "holds no word"),
    ],
)
def test_what_is_said_of_other_scripts(text, said):
    found = about_scripts(text)
    assert len(found) == bool(said) and all(said in line for line in found)


@pytest.mark.parametrize("text", ["", "  \n\t", "\0\0", "\u200b\u202e", "\ud800", "\x1b"])
def test_what_is_not_seen_says_nothing(text):
    assert not says_something(text)


@given(st.text(max_size=200))
def test_any_text_can_be_judged(text):
    assert says_something(text) or not text.strip() or not text.isprintable()
    assert len(about_scripts(text)) <= 1


def test_the_network_says_so():
    from pathlib import Path

    maker = PatternMaker.load(Path(__file__).with_name("tiny_maker.zip"))
    made = maker.generate("一条长裙", seed=3, temperature=1.0)
    assert "has never seen" in made.notes[0]

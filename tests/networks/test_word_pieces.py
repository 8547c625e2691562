"""Word pieces: what texts are made of, and files of them."""

from __future__ import annotations

import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.errors import InputError
from swifttailor.networks.word_pieces import LONGEST_WORD, SHIPPED, UNKNOWN, WordPieces

FEW = WordPieces((UNKNOWN, "neck", "neckline", "##line", "##l", "##s", "s", "!", "cafe", "-", "5", "##0"))


def pieces_of(text: str, known: WordPieces = FEW, limit: int = 100) -> list[str]:
    return [known.pieces[token] for token in known.encode(text, limit).tokens]


@pytest.mark.parametrize(
    ("text", "pieces"),
    [
        ("Neckline!", ["neckline", "!"]),
        ("necklines", ["neckline", "##s"]),
        ("neck-line", ["neck", "-", UNKNOWN]),
        ("Caf\u00e9s", ["cafe", "##s"]),
        ("50 5", ["5", "##0", "5"]),
        ("necky neck", [UNKNOWN, "neck"]),
        ("", []),
        (" \n\t ", []),
        ("s" * (LONGEST_WORD + 1), [UNKNOWN]),
        ("s" * LONGEST_WORD, ["s"] + ["##s"] * (LONGEST_WORD - 1)),
    ],
)
def test_a_word_is_the_longest_pieces_that_it_has(text, pieces):
    assert pieces_of(text) == pieces


def test_they_are_berts():
    """What the tokenizer of BERT gives for these, where all its pieces are among those of the package."""
    shipped = WordPieces.shipped()
    assert pieces_of("Take it in at the waistband, please: 2.5cm!", shipped) == [
        "take", "it", "in", "at", "the", "waistband", ",", "please", ":", "2", ".", "5", "##cm", "!"
    ]  # fmt: skip
    assert pieces_of("an empire-line d\u00e9collet\u00e9", shipped) == [
        "an", "empire", "-", "line", "deco", "##llet", "##e"
    ]  # fmt: skip


@given(st.text(max_size=60), st.integers(0, 40))
def test_any_text_has_at_most_so_many_tokens_and_they_are_its_beginning(text, limit):
    shipped = WordPieces.shipped()
    whole, some = shipped.encode(text, 10_000), shipped.encode(text, limit)
    assert some.tokens == whole.tokens[:limit] and all(0 <= t < shipped.size for t in whole.tokens)
    assert some.truncated == (len(whole.tokens) > limit)


def test_long_texts_take_bounded_time():
    started = time.process_time()
    for text in ("skirt " * 10**6, "s" * 10**6, "\u1e9b\u0323" * 10**6):
        assert len(WordPieces.shipped().encode(text, 100).tokens) <= 100
    assert time.process_time() - started < 1.0


def test_files_that_hold_none_are_named(tmp_path):
    assert WordPieces.load(SHIPPED) == WordPieces.shipped()
    for name, content in (("none", None), ("empty", b""), ("damaged", b"\xff\n"), ("other", b"a\nb\n"),
                          ("twice", b"[UNK]\na\na\n")):  # fmt: skip
        path = tmp_path / f"{name}.txt"
        if content is not None:
            path.write_bytes(content)
        with pytest.raises(InputError, match=rf"{name}\.txt"):
            WordPieces.load(path)

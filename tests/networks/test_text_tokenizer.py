"""Text as tokens: any text, any length, and back."""

from __future__ import annotations

import json

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.errors import InputError
from swifttailor.networks.text_tokenizer import (
    BYTES,
    LONGEST_TOKEN,
    TextTokenizer,
    merge,
    normalize,
    words_of,
)

SHIPPED = TextTokenizer.shipped()
RANKS = {pair: BYTES + k for k, pair in enumerate(SHIPPED.merges)}


def plain_merge(tokens: list[int]) -> list[int]:
    """Every merge in turn, over the whole word, from the left."""
    for k, pair in enumerate(SHIPPED.merges):
        place = 0
        while place < len(tokens) - 1:
            if (tokens[place], tokens[place + 1]) == pair:
                tokens[place : place + 2] = [BYTES + k]
            place += 1
    return tokens


@given(st.text(max_size=200))
@settings(deadline=None)
def test_any_text_comes_back_normalised(text):
    encoded = SHIPPED.encode(text, 10_000)
    assert not encoded.truncated
    assert SHIPPED.decode(encoded.tokens) == normalize(text).encode("utf-8", "replace").decode()
    assert all(0 <= t < SHIPPED.size for t in encoded.tokens)


@given(
    st.text(alphabet="abdelnrstvwx -", min_size=1, max_size=20) | st.sampled_from(["sleeveless", "necklines"])
)
@settings(deadline=None)
def test_merging_equals_the_plain_way(text):
    word = list((" " + text).encode())
    assert merge(list(word), RANKS) == plain_merge(list(word))


@pytest.mark.parametrize(
    "text",
    [
        "Ein knielanges Kleid",
        "ひざ丈のワンピース",
        "платье до колен",
        "فستان",
        "👗👖",
        "a dres wiht log slevees",
        "\x00\x01",
    ],
)
def test_every_script_has_tokens(text):
    encoded = SHIPPED.encode(text, 200)
    assert 0 < len(encoded.tokens) <= len(text.encode()) + 1
    assert SHIPPED.decode(encoded.tokens) == normalize(text)


def test_words_of_captions_are_short():
    caption = "A sleeveless knee-length dress with a V neck and a waist seam, 95 cm long."
    assert len(SHIPPED.encode(caption, 200).tokens) <= 24
    assert SHIPPED.size == 1024


def test_digits_stand_alone():
    assert words_of("120 cm") == [b" ", b"1", b"2", b"0", b" cm"]


@pytest.mark.parametrize(
    "text", ["dress " * 20_000, "x" * 100_000, "é" * 50_000, " " * 100_000 + "dress", "\n" * 9**6]
)
def test_long_texts_are_cut_without_being_read_to_the_end(text, monkeypatch):
    import swifttailor.networks.text_tokenizer as module

    seen = []
    monkeypatch.setattr(module, "normalize", lambda t: seen.append(len(t)) or normalize(t))
    encoded = SHIPPED.encode(text, 64)
    assert len(encoded.tokens) <= 64
    assert encoded.truncated
    assert seen[0] <= 4 * LONGEST_TOKEN * 65


def test_cutting_keeps_the_beginning():
    text = "a dress with a very long skirt and puffed sleeves"
    whole = SHIPPED.encode(text, 100)
    for limit in range(len(whole.tokens)):
        assert SHIPPED.encode(text, limit).tokens == whole.tokens[:limit]
        assert SHIPPED.encode(text, limit).truncated


def test_file_comes_back():
    assert TextTokenizer.from_json(SHIPPED.to_json(), "test") == SHIPPED


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        "{}",
        '{"format": "swifttailor text tokens 2", "merges": []}',
        json.dumps({"format": "swifttailor text tokens 1", "merges": [[256, 1]]}),
        json.dumps({"format": "swifttailor text tokens 1", "merges": [[1.5, 1]]}),
        json.dumps({"format": "swifttailor text tokens 1", "merges": [[1, 2, 3]]}),
        json.dumps({"format": "swifttailor text tokens 1", "merges": 7}),
        "[" * 100_000,
    ],
)
def test_other_files_are_refused(text):
    with pytest.raises(InputError, match=r"text tokenizer|Merge 0"):
        TextTokenizer.from_json(text, "test")

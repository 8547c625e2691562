"""A plain reading of token sequences, against the grammar."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.errors import SwiftTailorError
from swifttailor.evaluation.patterns.validity import Validity, validity
from swifttailor.pattern.drafts import draft
from swifttailor.pattern_maker.tokens.decode import decode
from swifttailor.pattern_maker.tokens.encode import encode
from swifttailor.pattern_maker.tokens.token_sequence import TokenSequence
from swifttailor.pattern_maker.tokens.vocabulary import (
    CLOSING_COMMANDS,
    COMMANDS,
    NOT_STITCHED,
    NUMBERS,
    SIZE,
    STITCH_TOKENS,
)

SKIRT = encode(draft("fitted-skirt")).tokens.tolist()
GOOD = Validity(True, True)


def sequence(tokens) -> TokenSequence:
    return TokenSequence(np.array(tokens), np.zeros((len(tokens), NUMBERS)))


def places(kind) -> list[int]:
    return [k for k, token in enumerate(SKIRT) if token in kind]


@pytest.mark.parametrize("name", ["fitted-skirt", "hoodie", "trousers"])
def test_patterns_are_valid(name):
    assert validity(encode(draft(name))) == GOOD


def test_nothing_is_no_pattern():
    assert validity(sequence([])) == Validity(False, True)
    assert validity(sequence([STITCH_TOKENS.start])) == Validity(False, False)
    assert validity(sequence([COMMANDS.start])) == Validity(False, False)


def test_a_stitch_with_one_or_three_edges_is_no_pair():
    for place in places(STITCH_TOKENS):
        other = list(SKIRT)
        other[place] = NOT_STITCHED
        assert validity(sequence(other)) == Validity(True, False)
    free = places([NOT_STITCHED])[0]
    other = list(SKIRT)
    other[free] = STITCH_TOKENS.start
    assert validity(sequence(other)) == Validity(True, False)


def test_an_edge_with_two_tags_is_no_pair():
    """Every tag is there twice, and still one edge has both ends of a stitch."""
    place = places(STITCH_TOKENS)[0]
    new = max(SKIRT[k] for k in places(STITCH_TOKENS)) + 1
    assert validity(sequence([*SKIRT[: place + 1], new, new, *SKIRT[place + 1 :]])) == Validity(True, False)


def test_panels_end_once_and_at_their_end():
    closing, command = places(CLOSING_COMMANDS)[0], places(COMMANDS)[0]
    open_panel, closed_twice = list(SKIRT), list(SKIRT)
    open_panel[closing] = COMMANDS.start
    closed_twice[command] = CLOSING_COMMANDS.start
    swapped = list(SKIRT)
    swapped[closing], swapped[command] = COMMANDS.start, CLOSING_COMMANDS.start
    for other in (open_panel, closed_twice, swapped):
        assert validity(sequence(other)) == Validity(False, True)


@settings(max_examples=60, deadline=None)
@given(place=st.integers(0, len(SKIRT) - 1), token=st.integers(0, SIZE - 1))
def test_what_the_grammar_accepts_is_valid(place, token):
    """The other way round it need not be: the grammar knows of names, labels and order, too."""
    other = list(SKIRT)
    other[place] = token
    try:
        decode(sequence(other))
    except SwiftTailorError:
        return
    assert validity(sequence(other)) == GOOD

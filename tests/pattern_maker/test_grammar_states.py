"""The grammar's states, against a plain account of what each token changes."""

from __future__ import annotations

import random

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.pattern_maker.tokens.grammar import Grammar, Limits, Stage, State, next_state
from swifttailor.pattern_maker.tokens.vocabulary import PANEL_TOKENS, PATTERN_START, STITCH_TOKENS, TOKENS

START = State()
CURVED = ("quadratic", "cubic", "arc")


def changed(state: dict, word: str) -> dict:
    """What a token, read as text, changes of a state."""
    kind, *_ = word.split(":")
    state = state | {"length": state["length"] + 1}
    after_edge = Stage.BETWEEN_PANELS if state["closing"] else Stage.IN_PANEL
    if kind == "pattern_start":
        return state | {"stage": Stage.BETWEEN_PANELS}
    if kind == "pattern_end":
        return state | {"stage": Stage.FINISHED}
    if kind == "panel":
        number = TOKENS.index(f"<{word}>") - PANEL_TOKENS.start
        return state | {"stage": Stage.NAME, "name": number, "edges": 0, "curved": False, "closing": False}
    if kind == "covers":
        return state | {"stage": Stage.PANEL_LABEL}
    if kind == "move":
        return state | {"stage": Stage.IN_PANEL}
    if kind == "edge":
        return state | {"stage": Stage.EDGE_LABEL}
    if kind == "right_wrong":
        return state | {"stage": Stage.RIGHT_WRONG}
    if kind == "not_stitched":
        return state | {"stage": after_edge}
    if kind == "stitch":
        tag = frozenset([TOKENS.index(f"<{word}>") - STITCH_TOKENS.start])
        return state | {"stage": after_edge, "open": state["open"] ^ tag, "used": state["used"] | tag}
    curved = state["curved"] or word.removeprefix("closing_") in CURVED
    closing = word.startswith("closing_")
    return state | {
        "stage": Stage.COMMAND,
        "edges": state["edges"] + 1,
        "curved": curved,
        "closing": closing,
    }


grammars = st.builds(
    Grammar, st.builds(Limits, st.integers(9, 120), st.integers(4, 12)), st.sampled_from(["ascending", "any"])
)


@given(grammars, st.integers(0, 2**32), st.floats(0, 1))
def test_every_token_changes_what_it_says(grammar, seed, opening):
    drawn, state, plain = random.Random(seed), START, START._asdict()
    while state.stage is not Stage.FINISHED:
        allowed = np.flatnonzero(grammar.allowed(state)).tolist()
        stitches = [t for t in allowed if t in STITCH_TOKENS]
        token = drawn.choice(stitches if stitches and drawn.random() < opening else allowed)
        before = state._asdict()
        plain = changed(plain, TOKENS[token][1:-1])
        state = grammar.advance(state, token)
        assert state._asdict() == plain
        assert next_state(State(**before), token) == state, "only the state decides"
    assert START == State(), "the beginning stays as it is"


def test_states_are_equal_by_value_and_cannot_be_changed():
    first, again = (next_state(State(), PATTERN_START) for _ in range(2))
    assert first == again and hash(first) == hash(again) and first != START
    with pytest.raises(AttributeError):
        first.length = 7
    assert len({first, again, START}) == 2


@given(grammars)
def test_a_mask_is_the_caller_s_own(grammar):
    mask = grammar.allowed(START)
    expected = mask.copy()
    mask[:] = True
    assert np.array_equal(grammar.allowed(START), expected)

"""What is foreseen, as a writer is told it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.pattern.drafts import draft
from swifttailor.pattern_maker.asking.counterpart import NONE, counterparts
from swifttailor.pattern_maker.asking.foresight import CORNERS, FORESEEN, foresight_of
from swifttailor.pattern_maker.asking.plan import PatternPlan
from swifttailor.pattern_maker.tokens.encode import encode
from swifttailor.pattern_maker.tokens.vocabulary import (
    CLOSING_COMMANDS,
    COMMANDS,
    END,
    MOVE,
    PANEL_TOKENS,
    PATTERN_END,
    PATTERN_START,
)


def perfect(sequence) -> PatternPlan:
    """The plan of a network that foresees everything."""
    truth = foresight_of(sequence)
    return PatternPlan.from_foresight(np.concatenate([20 * truth.present - 10, truth.numbers.ravel()]))


@pytest.mark.parametrize("name", ["t-shirt", "trousers", "shirt-dress", "circle-skirt"])
def test_who_foresees_everything_is_told_panels_placements_and_first_corners(name):
    sequence = encode(draft(name))
    told = counterparts(None, sequence, perfect(sequence))
    alone = counterparts(None, sequence)
    assert told[0].token == PATTERN_START and told[0].planned == NONE
    panel_edges = 0
    for token, numbers, own, bare in zip(
        sequence.tokens.tolist(), sequence.numbers, told, alone, strict=True
    ):
        if bare.token != NONE:  # what can be repeated is not planned
            assert own.token == bare.token and own.planned == NONE
        elif token in PANEL_TOKENS or token == PATTERN_END:
            assert own.planned == token
        elif token == MOVE:
            assert own.planned == MOVE and np.array_equal(own.planned_numbers, numbers)
        elif token in COMMANDS and panel_edges < CORNERS:
            assert own.planned == COMMANDS[0]
            assert np.array_equal(own.planned_numbers[END], numbers[END])
        elif token in COMMANDS:
            assert own.planned == NONE
        elif token in CLOSING_COMMANDS:
            assert own.planned == CLOSING_COMMANDS[0]
        else:
            assert own.planned == NONE
        if token in PANEL_TOKENS:
            panel_edges = 0
        panel_edges += token in COMMANDS
    assert sum(c.planned != NONE for c in told) > 2 * len(set(sequence.tokens) & set(PANEL_TOKENS))


def test_of_an_edit_the_changes_are_foreseen_and_told_beside_the_old_pattern():
    old, new = encode(draft("tank-top")), encode(draft("t-shirt"))
    changes = foresight_of(new, old)
    foreseen = np.concatenate([20 * changes.present - 10, changes.numbers.ravel()])
    told = counterparts(old, new, PatternPlan.from_foresight(foreseen, old))
    absolute = counterparts(old, new, perfect(new))
    for own, same, bare in zip(told, absolute, counterparts(old, new), strict=True):
        assert own.token == bare.token and np.array_equal(own.numbers, bare.numbers)
        assert own.planned == same.planned
        assert np.abs(own.planned_numbers - same.planned_numbers).max() < 1e-5
    assert not foresight_of(old, old).numbers.any() and foresight_of(old).numbers.any()
    panels = [t for t in new.tokens.tolist() if t in PANEL_TOKENS]
    assert [c.planned for c in told if c.planned in PANEL_TOKENS] == panels


def test_a_network_that_foresees_no_panel_is_told_the_likeliest():
    foreseen = np.full(FORESEEN, -3.0, np.float32)
    foreseen[PANEL_TOKENS[7]] = -1.0
    plan = PatternPlan.from_foresight(foreseen)
    assert plan.panels == (7,)
    assert plan.after(-1) == PANEL_TOKENS[7] and plan.after(7) == PATTERN_END


@given(st.lists(st.floats(-6, -1e-5) | st.floats(1e-5, 6), min_size=75, max_size=75))
@settings(max_examples=50, deadline=None)
def test_the_likeliest_next_panels_are_the_likeliest_panels_altogether(odds):
    plan = replace(perfect(encode(draft("t-shirt"))), odds=np.array(odds))
    name, taken = -1, []
    while True:
        logs = plan.next_panels(name)
        token = int(np.argmax(logs))
        assert logs[token] <= 1e-9 and np.isneginf(logs[: PANEL_TOKENS.start + name + 1][2:]).all()
        if token == PATTERN_END:
            break
        name = token - PANEL_TOKENS.start
        taken.append(name)
    assert taken == np.flatnonzero(np.array(odds) > 0).tolist()


def test_a_plan_weighs_more_than_the_writer_where_it_is_sure():
    shirt = encode(draft("t-shirt"))
    plan, tokens = perfect(shirt), np.array([PATTERN_END, *PANEL_TOKENS])
    unsure, other = np.full(len(tokens), -np.log(len(tokens))), np.full(len(tokens), -9.0)
    other[0] = np.log1p(-np.exp(-9.0) * 75)
    first = next(t for t in shirt.tokens.tolist() if t in PANEL_TOKENS)
    for logs in (unsure, other):
        weighed = plan.weighed(logs, -1, tokens)
        assert tokens[np.argmax(weighed)] == first
        assert np.exp(weighed).sum() == pytest.approx(1)

"""What is foreseen, as a writer is told it."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.pattern.drafts import draft
from swifttailor.pattern_maker.counterpart import NONE, counterparts
from swifttailor.pattern_maker.encode import encode
from swifttailor.pattern_maker.foresight import CORNERS, FORESEEN, foresight_of
from swifttailor.pattern_maker.plan import PatternPlan
from swifttailor.pattern_maker.vocabulary import (
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
    assert told[0].token == PATTERN_START and not told[0].planned
    panel_edges = 0
    for token, numbers, own, bare in zip(
        sequence.tokens.tolist(), sequence.numbers, told, alone, strict=True
    ):
        if bare.token != NONE:  # what can be repeated is not planned
            assert own.token == bare.token and not own.planned
        elif token in PANEL_TOKENS or token == PATTERN_END:
            assert own.token == token and own.planned
        elif token == MOVE:
            assert own.token == MOVE and np.array_equal(own.numbers, numbers)
        elif token in COMMANDS and panel_edges < CORNERS:
            assert own.token == COMMANDS[0] and np.array_equal(own.numbers[END], numbers[END])
        elif token in COMMANDS:
            assert own.token == NONE
        elif token in CLOSING_COMMANDS:
            assert own.token == CLOSING_COMMANDS[0]
        else:
            assert own.token == NONE
        if token in PANEL_TOKENS:
            panel_edges = 0
        panel_edges += token in COMMANDS
    assert sum(c.planned for c in told) > 2 * len(set(sequence.tokens) & set(PANEL_TOKENS))


def test_an_edit_goes_by_its_old_pattern_before_any_plan():
    old, new = encode(draft("tank-top")), encode(draft("t-shirt"))
    told = counterparts(old, new, perfect(new))
    for own, bare in zip(told, counterparts(old, new), strict=True):
        assert own.planned or (own.token == bare.token and np.array_equal(own.numbers, bare.numbers))


def test_a_network_that_foresees_no_panel_is_told_the_likeliest():
    foreseen = np.full(FORESEEN, -3.0, np.float32)
    foreseen[PANEL_TOKENS[7]] = -1.0
    plan = PatternPlan.from_foresight(foreseen)
    assert plan.panels == (7,)
    assert plan.after(-1) == PANEL_TOKENS[7] and plan.after(7) == PATTERN_END

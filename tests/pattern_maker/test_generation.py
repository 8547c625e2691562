"""Writing under the grammar, by networks that know nothing."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from token_reference import faults

from swifttailor.errors import InputError
from swifttailor.pattern import check_pattern
from swifttailor.pattern_maker.asking.generation import Asked, write_answers
from swifttailor.pattern_maker.asking.prompt import make_prompt
from swifttailor.pattern_maker.network.runtime import Cache
from swifttailor.pattern_maker.tokens.decode import decode
from swifttailor.pattern_maker.tokens.grammar import Grammar, Limits, Stage, State
from swifttailor.pattern_maker.tokens.vocabulary import (
    NOT_STITCHED,
    NUMBERS,
    PATTERN_END,
    SIZE,
    STITCH_TOKENS,
    number_slots,
)

TEXT_SIZE = 10
HIDDEN = 4


class Chance:
    """A network whose logits are chance, decided by the last token, the length and the prompt."""

    def __init__(self, spread: float = 3.0, size: float = 1.0) -> None:
        self.spread, self.size = spread, size
        self.fed: list[np.ndarray] = []

    copies = plans = False

    def look(self, pictures):
        return np.zeros((len(pictures), 1, HIDDEN), np.float32)

    def embed(self, tokens, numbers):
        self.fed.append(numbers)
        return np.repeat(tokens[..., None], HIDDEN, axis=-1).astype(np.float32)

    def decode(self, embedded, known, cache):
        lengths = cache.lengths + known.sum(axis=1).astype(np.int64)
        memory = cache.keys + (embedded[..., 0] * known).sum(axis=1)[None, :]
        logits = np.zeros((*embedded.shape[:2], SIZE), np.float32)
        for row in range(len(embedded)):
            chance = np.random.default_rng([int(memory[0, row]), int(lengths[row])])
            logits[row] = chance.normal(scale=self.spread, size=SIZE)
        return embedded, logits, Cache(memory, memory, cache.seen, lengths)

    def regress(self, states, tokens):
        return np.stack([self.size * np.sin(np.arange(NUMBERS) + t) for t in tokens]).astype(np.float32)

    def empty_cache(self, rows):
        nothing = np.zeros((1, rows))
        return Cache(nothing, nothing, np.zeros((rows, 0), np.float32), np.zeros(rows, np.int64))


def asked(text=(1, 2, 3), seeds=((0,),), temperature=1.0):
    return Asked(make_prompt(text, TEXT_SIZE), None, seeds, temperature)


@given(
    st.integers(0, 2**31),
    st.sampled_from([0.0, 0.5, 1.0, 10.0]),
    st.sampled_from(["ascending", "any"]),
    st.sampled_from([(40, 6), (200, 12), (1024, 64)]),
    st.sampled_from([0.01, 1.0, 1e6]),
)
@settings(deadline=None, max_examples=60)
def test_whatever_a_network_thinks_a_pattern_comes_out(seed, temperature, tags, limits, size):
    grammar = Grammar(Limits(*limits), tags)
    (answers,) = write_answers(
        Chance(size=size), [asked((seed % 10,), ((seed,), (seed, 1)), temperature)], grammar, TEXT_SIZE
    )
    for written in answers:
        assert faults(written.sequence.tokens.tolist(), *limits) == []
        pattern = decode(written.sequence)
        assert pattern.panels
        check_pattern(pattern)


def test_the_same_seed_writes_the_same_in_any_company():
    grammar, together = Grammar(), [asked((1,), ((5,), (6,))), asked((2, 3, 4), ((5,),))]
    first = write_answers(Chance(), together, grammar, TEXT_SIZE)
    again = write_answers(Chance(), together[::-1], grammar, TEXT_SIZE)[::-1]
    alone = write_answers(Chance(), [asked((1,), ((6,),))], grammar, TEXT_SIZE)
    assert [[w.sequence for w in ws] for ws in first] == [[w.sequence for w in ws] for ws in again]
    assert first[0][1].sequence == alone[0][0].sequence
    assert first[0][0].sequence != first[0][1].sequence


def test_temperature_zero_takes_the_likeliest_and_sums_up_how_likely():
    """Written step by step beside it, broken off where stitches are open and the end is likeliest."""
    grammar, broken = Grammar(Limits(200, 12)), 0
    for text in [(k,) for k in range(1, 9)]:
        ((first, second),) = write_answers(
            Chance(), [asked(text, seeds=((1,), (2,)), temperature=0.0)], grammar, TEXT_SIZE
        )
        assert first.sequence == second.sequence
        state, prompt = State(), make_prompt(text, TEXT_SIZE).tokens.tolist()
        tokens, total = [], 0.0
        while state.stage is not Stage.FINISHED:
            logits = np.random.default_rng([sum(prompt), len(prompt)]).normal(scale=3.0, size=SIZE)
            allowed = grammar.allowed(state)
            unfinished = state.stage is Stage.BETWEEN_PANELS and state.name >= 0
            allowed[PATTERN_END] |= unfinished
            scores = np.where(allowed, logits.astype(np.float32), -np.inf).astype(np.float64)
            token = int(scores.argmax())
            total += scores[token] - np.log(np.exp(scores).sum())
            if token == PATTERN_END and state.open:
                state, tokens = grammar.broken_off(state, tokens)
                broken += 1
            state = grammar.advance(state, token)
            tokens.append(token)
            prompt.append(token + TEXT_SIZE)
        assert first.sequence.tokens.tolist() == tokens
        assert first.log_likelihood == pytest.approx(total, rel=1e-6)
    assert broken


@given(st.integers(0, 2**31), st.sampled_from(["ascending", "any"]))
@settings(deadline=None, max_examples=60)
def test_a_pattern_that_ends_early_leaves_edges_unsewn_and_nothing_else(seed, tags):
    chance, grammar, state, tokens = np.random.default_rng(seed), Grammar(tags=tags), State(), []
    while not (grammar.may_break_off(state) and chance.random() < 0.5):
        allowed = grammar.allowed(state)
        allowed[PATTERN_END] = False
        if not allowed.any():
            return
        tokens.append(int(chance.choice(np.flatnonzero(allowed))))
        state = grammar.advance(state, tokens[-1])
    after, kept = grammar.broken_off(state, tokens)
    assert faults([*kept, PATTERN_END], 1024, 64) == []
    again = State()
    for token in [*kept, PATTERN_END]:
        again = grammar.advance(again, token)
    assert again == grammar.advance(after, PATTERN_END)
    pairs = [(old, new) for old, new in zip(tokens, kept, strict=True) if old != new]
    opened = {STITCH_TOKENS[tag] for tag in state.open}
    assert {old for old, new in pairs if new == NOT_STITCHED} == opened
    renamed = {old: new for old, new in pairs if new != NOT_STITCHED}
    assert len(set(renamed.values())) == len(renamed) and (tags == "ascending" or not renamed)


def test_draws_follow_the_probabilities():
    """The first free choice, the name of the first panel, over many seeds."""
    seeds = tuple((k,) for k in range(3000))
    grammar = Grammar(Limits(9, 4))
    (answers,) = write_answers(Chance(spread=1.0), [asked(seeds=seeds)], grammar, TEXT_SIZE)
    names = np.array([w.sequence.tokens[1] for w in answers])
    tokens = [*make_prompt((1, 2, 3), TEXT_SIZE).tokens.tolist(), TEXT_SIZE]
    logits = np.random.default_rng([sum(tokens), len(tokens)]).normal(scale=1.0, size=SIZE)
    allowed = grammar.allowed(grammar.advance(State(), 0))
    expected = np.where(allowed, np.exp(logits), 0)
    expected = 3000 * expected / expected.sum()
    found = np.bincount(names, minlength=SIZE)
    common = expected > 20
    assert common.sum() > 20
    assert (np.abs(found - expected)[common] < 5 * np.sqrt(expected[common])).all()
    assert found[~allowed].sum() == 0


def test_numbers_are_fed_back_as_they_were_written():
    runtime = Chance()
    ((written,),) = write_answers(runtime, [asked()], Grammar(), TEXT_SIZE)
    fed = np.concatenate([n[0] for n in runtime.fed[1:]])
    assert np.array_equal(fed, written.sequence.numbers[:-1])
    with_numbers = [k for k, t in enumerate(written.sequence.tokens.tolist()) if number_slots(t)]
    assert np.abs(written.sequence.numbers[with_numbers]).sum(axis=1).min() > 0


@pytest.mark.parametrize("method", ["decode", "regress"])
def test_damaged_weights_are_noticed(method):
    runtime = Chance()
    whole = getattr(runtime, method)

    def broken(*given):
        found = whole(*given)
        if method == "regress":
            return found * np.nan
        return found[0], found[1] * np.nan, found[2]

    setattr(runtime, method, broken)
    with pytest.raises(InputError, match="weights are damaged"):
        write_answers(runtime, [asked()], Grammar(), TEXT_SIZE)


def test_nothing_asked_nothing_written():
    assert write_answers(Chance(), [], Grammar(), TEXT_SIZE) == []

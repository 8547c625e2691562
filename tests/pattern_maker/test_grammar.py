"""Whatever is chosen among the allowed tokens, a pattern comes of it."""

from __future__ import annotations

import random

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from token_reference import faults

from swifttailor.errors import InputError, PatternError
from swifttailor.pattern import Severity, read_specification, to_specification
from swifttailor.pattern_maker.tokens.decode import decode
from swifttailor.pattern_maker.tokens.encode import encode
from swifttailor.pattern_maker.tokens.grammar import Grammar, Limits, Stage, State
from swifttailor.pattern_maker.tokens.token_sequence import LARGEST_NUMBER, TokenSequence
from swifttailor.pattern_maker.tokens.vocabulary import (
    CLOSING_COMMANDS,
    COMMANDS,
    NUMBERS,
    PATTERN_END,
    SIZE,
    STITCH_TOKENS,
    TOKENS,
)


def walk(grammar, choose):
    """Tokens of one walk to the end; `choose` picks among the allowed ones."""
    state, tokens = State(), []
    while state.stage is not Stage.FINISHED:
        allowed = np.flatnonzero(grammar.allowed(state))
        assert len(allowed), (state, tokens)
        tokens.append(int(choose(allowed)))
        state = grammar.advance(state, tokens[-1])
        assert len(tokens) <= grammar.limits.tokens
    assert not grammar.allowed(state).any()
    return tokens


def greedy_for(wanted):
    """Chooses a token of `wanted` whenever there is one, to drive a walk into a corner."""

    def choose(allowed):
        liked = [t for t in allowed if t in wanted]
        return liked[-1] if liked else allowed[0]

    return choose


grammars = st.builds(
    Grammar,
    st.builds(Limits, st.integers(9, 150), st.integers(4, 12)),
    st.sampled_from(["ascending", "any"]),
)
extremes = st.sampled_from([0.0, 1e-7, -1e-3, 1.0, LARGEST_NUMBER, -LARGEST_NUMBER])


@settings(deadline=None)
@given(grammars, st.integers(0, 2**32), st.floats(0, 1), st.lists(extremes, max_size=6))
def test_random_walks_are_patterns(grammar, seed, opening, some):
    """`opening` is how often a stitch is begun on purpose, so that many are open when room runs out."""
    drawn = random.Random(seed)

    def choose(allowed):
        if drawn.random() < opening:
            liked = [t for t in allowed if t in STITCH_TOKENS or t in COMMANDS]
            return drawn.choice(liked or list(allowed))
        return drawn.choice(list(allowed))

    tokens = walk(grammar, choose)
    assert faults(tokens, grammar.limits.tokens, grammar.limits.edges) == []
    numbers = np.random.default_rng(seed).normal(size=(len(tokens), NUMBERS)) * 3
    numbers.flat[: len(some)] = some
    pattern = decode(TokenSequence(np.array(tokens), numbers))
    assert pattern == pattern.canonical()
    used = [side for s in pattern.stitches for side in s.sides]
    assert len(used) == len(set(used)) and all(pattern.has_edge(side) for side in used)
    assert 2 * len(pattern.stitches) == sum(t in STITCH_TOKENS for t in tokens)
    assert sum(len(p.edges) for p in pattern.panels) == sum(
        t in COMMANDS or t in CLOSING_COMMANDS for t in tokens
    )
    reading = read_specification(to_specification(pattern), name="pattern")
    assert reading.pattern == pattern
    assert [f for f in reading.findings if f.severity is Severity.ERROR] == []


@pytest.mark.parametrize("tags", ["ascending", "any"])
@pytest.mark.parametrize("limits", [Limits(), Limits(tokens=300, edges=4), Limits(tokens=97), Limits(9, 4)])
@pytest.mark.parametrize(
    "wanted",
    [
        set(STITCH_TOKENS) | set(COMMANDS),  # as many open stitches as can be
        {t for t in range(SIZE) if TOKENS[t].startswith("<panel:")} | set(CLOSING_COMMANDS),
        {t for t in range(SIZE) if TOKENS[t].startswith(("<edge:", "<right", "<covers"))}
        | set(STITCH_TOKENS),
    ],
)
def test_walks_into_corners_get_out(tags, limits, wanted):
    tokens = walk(Grammar(limits, tags), greedy_for(wanted))
    assert faults(tokens, limits.tokens, limits.edges) == []


@pytest.mark.parametrize("limits", [(40, 6), (30, 4), (200, 12)])
def test_there_is_always_a_way_on(limits):
    """Uniform walks: seven open stitches take panels of five and two edges, not of six and one."""
    grammar = Grammar(Limits(*limits), "any")
    for seed in range(100):
        walk(grammar, random.Random(seed).choice)


def test_the_shortest_pattern_has_nine_tokens():
    """One panel of two edges, one of which is curved: start, name, move, two edges of two tokens, end."""
    tokens = walk(Grammar(Limits(tokens=9, edges=4)), lambda allowed: allowed[0])
    assert len(tokens) <= 9
    with pytest.raises(InputError, match="at least 9"):
        Limits(tokens=8)


@settings(deadline=None, max_examples=40)
@given(st.integers(0, 2**32), st.integers(0, 200))
def test_the_mask_is_what_advance_accepts(seed, stop):
    drawn = random.Random(seed)
    grammar, state = Grammar(Limits(tokens=60, edges=5), "any"), State()
    for _ in range(stop):
        allowed = np.flatnonzero(grammar.allowed(state))
        if not len(allowed):
            break
        state = grammar.advance(state, int(drawn.choice(list(allowed))))
    mask = grammar.allowed(state)
    for token in range(SIZE):
        try:
            grammar.advance(state, token)
            accepted = True
        except InputError:
            accepted = False
        assert accepted == mask[token], (TOKENS[token], state)


def test_what_the_reference_rejects_the_grammar_rejects(real_patterns):
    """Real sequences with one token changed: both readings agree whether it still is a pattern."""
    drawn, disagreements, broken = random.Random(4), [], 0
    for pattern in (*real_patterns("repository", every=2), *real_patterns("validation", every=15)):
        tokens = encode(pattern).tokens.tolist()
        for _ in range(10):
            changed = list(tokens)
            changed[drawn.randrange(len(tokens))] = drawn.randrange(SIZE)
            wrong = faults(changed, 10**6, 10**5)
            try:
                decode(TokenSequence(np.array(changed), np.ones((len(changed), NUMBERS))))
                accepted = True
            except (InputError, PatternError):
                accepted = False
            broken += not accepted
            if accepted != (not wrong):
                disagreements.append((changed, wrong))
    assert not disagreements
    assert broken > 50


def test_messages_say_where_and_what(real_patterns):
    tokens = encode(next(real_patterns("repository"))).tokens.copy()
    with pytest.raises(PatternError, match="stops after 40 tokens, before its pattern is finished"):
        decode(TokenSequence(tokens[:40], np.zeros((40, NUMBERS))))
    tokens[1] = PATTERN_END
    with pytest.raises(InputError, match="Token 1 is <pattern_end>, which may not come here"):
        decode(TokenSequence(tokens, np.zeros((len(tokens), NUMBERS))))


def test_sequences_hold_finite_numbers_and_known_tokens():
    with pytest.raises(InputError, match="numbers of a sequence are from"):
        TokenSequence(np.zeros(1), np.full((1, NUMBERS), np.nan))
    with pytest.raises(InputError, match=f"Tokens are from 0 to {SIZE - 1}"):
        TokenSequence(np.array([SIZE]), np.zeros((1, NUMBERS)))
    with pytest.raises(InputError, match="n tokens"):
        TokenSequence(np.zeros(2), np.zeros((1, NUMBERS)))

"""Without the grammar an answer is a pattern, or there is a reason why not; nothing else happens."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scripted_runtime import AtRandom, Scripted

from swifttailor.errors import PatternError
from swifttailor.networks.text_tokenizer import TextTokenizer
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.pattern_maker.asking.counterpart import Counterparts
from swifttailor.pattern_maker.asking.foresight import FORESEEN
from swifttailor.pattern_maker.asking.generation import Asked, write_answers
from swifttailor.pattern_maker.asking.plan import PatternPlan
from swifttailor.pattern_maker.asking.prompt import make_prompt
from swifttailor.pattern_maker.maker import SHIPPED, PatternMaker, Request, WrittenPattern
from swifttailor.pattern_maker.tokens.decode import decode
from swifttailor.pattern_maker.tokens.encode import encode
from swifttailor.pattern_maker.tokens.fidelity import compare
from swifttailor.pattern_maker.tokens.free_reading import FreeReader, settled
from swifttailor.pattern_maker.tokens.grammar import Grammar, Limits
from swifttailor.pattern_maker.tokens.name_text import PANEL_END, PANEL_START, NameText
from swifttailor.pattern_maker.tokens.vocabulary import (
    CLOSING_COMMANDS,
    COMMANDS,
    MOVE,
    NOT_STITCHED,
    NUMBERS,
    PANEL_TOKENS,
    PATTERN_END,
    PATTERN_START,
    SIZE,
    STITCH_TOKENS,
)

TEXT = TextTokenizer.shipped()
NAMES = NameText.of(TEXT)
TOP = encode(draft("tank-top"))
LINE, CLOSING_LINE = COMMANDS[0], CLOSING_COMMANDS[0]
FIRST, SECOND = PANEL_TOKENS[4], PANEL_TOKENS[5]
SQUARE = [MOVE, LINE, NOT_STITCHED, LINE, NOT_STITCHED, CLOSING_LINE, NOT_STITCHED]


def write(outputs, numbers=None, *, names: NameText | None = None, longest: int = 1024):
    """What comes of a network that likes these outputs best."""
    rows = np.zeros((max(len(outputs), longest) + 1, NUMBERS), np.float32)
    rows[: len(outputs)] = 0.1 if numbers is None else numbers
    runtime = Scripted(outputs, rows, SIZE if names is None else names.outputs)
    asked, limits = Asked(make_prompt((1,), TEXT.size)), Limits(longest)
    ((written,),) = write_answers(runtime, [asked], Grammar(limits, "any"), TEXT.size, names=names, free=True)
    return written


def spelled(*names: int, panel=SQUARE) -> list[int]:
    """Panels of those class ids, names as text."""
    parts = [[PANEL_START, *NAMES.names[name], *panel, PANEL_END] for name in names]
    return [PATTERN_START, *(output for part in parts for output in part), PATTERN_END]


@pytest.mark.parametrize("names", [None, NAMES])
def test_a_pattern_comes_back_as_it_was(names):
    outputs, numbers = TOP.tokens, TOP.numbers
    if names is not None:
        text = names.spell(TOP)
        outputs, numbers = text.outputs, text.numbers
    found = write(outputs.tolist(), numbers, names=names)
    assert (found.sequence, found.fault, found.dropped) == (TOP, "", 0)


@pytest.mark.parametrize(
    ("outputs", "names", "why"),
    [
        ([FIRST], None, r"Token 1: <panel:skirt_front> may not come at the beginning. Accepted: <pattern_st"),
        ([PATTERN_START, PATTERN_END], None, "Token 2: The pattern ends without a panel"),
        ([PATTERN_START, MOVE], None, "Token 2: <move> may not come between panels. Accepted: a panel or <p"),
        (
            [PATTERN_START, FIRST, LINE],
            None,
            "Token 3: <line> may not come in panel 'skirt_front'. Accepted: <move>",
        ),
        ([PATTERN_START, FIRST, MOVE, PATTERN_END], None, "<pattern_end> may not come in panel 'skirt_fr"),
        ([PATTERN_START, FIRST, MOVE, LINE, LINE], None, "Token 5: <line> may not come in panel 'skirt_fr"),
        ([PATTERN_START, FIRST, *SQUARE, FIRST], None, "There are two panels 'skirt_front'"),
        (
            [PATTERN_START, FIRST, MOVE, LINE, NOT_STITCHED, CLOSING_LINE],
            None,
            "Panel 'skirt_front' is closed by its edge 2: it encloses nothing",
        ),
        ([PATTERN_START, FIRST, MOVE, CLOSING_LINE], None, "is closed by its edge 1: it encloses nothing"),
        (spelled(4, 4), NAMES, "There are two panels 'skirt_front'"),
        ([PATTERN_START, FIRST], NAMES, "<panel:skirt_front> may not come between panels. Accepted: <pan"),
        ([PATTERN_START, *SQUARE], NAMES, "<move> may not come between panels. Accepted: a panel or <patt"),
        (
            [PATTERN_START, PANEL_START, *NAMES.names[4], *SQUARE, PATTERN_END],
            NAMES,
            "<pattern_end> may not come between panels. Accepted: <panel_end>",
        ),
        (
            [PATTERN_START, PANEL_START, *NAMES.names[4], MOVE, NAMES.names[4][0]],
            NAMES,
            "The text 'skirt' may not come in panel 'skirt_front'",
        ),
        ([PATTERN_START, SIZE], NAMES, "A mark of prompts may not come between panels"),
    ],
)  # fmt: skip
def test_what_is_no_pattern_is_said_and_where(outputs, names, why):
    found = write(outputs, names=names)
    assert found.fault.startswith("What was written is no pattern. Token ") and why in found.fault, (
        found.fault
    )
    assert len(found.sequence.tokens) == len(found.sequence.numbers) < len(outputs)


def test_an_answer_without_end_is_cut_and_said():
    endless = [PATTERN_START, FIRST, MOVE, *[LINE, NOT_STITCHED] * 30]
    found = write(endless, longest=20)
    assert "After 20 tokens the pattern is not finished. Panel 'skirt_front' is not closed." in found.fault
    exact = [PATTERN_START, FIRST, *SQUARE, PATTERN_END]
    assert not write(exact, longest=len(exact)).fault


def test_panels_in_another_order_are_the_same_pattern():
    starts = [*np.flatnonzero(np.isin(TOP.tokens, PANEL_TOKENS)), len(TOP) - 1]
    parts = [range(a, b) for a, b in pairwise(starts)]
    order = [0, *(k for part in parts[::-1] for k in part), len(TOP) - 1]
    assert len(parts) > 2 and order != sorted(order)
    found = write(TOP.tokens[order].tolist(), TOP.numbers[order])
    assert not found.fault and compare(decode(found.sequence), decode(TOP)).same_structure


def test_tags_on_one_edge_or_three_join_nothing_and_are_counted():
    one, two, three = STITCH_TOKENS[7], STITCH_TOKENS[0], STITCH_TOKENS[99]
    first = [MOVE, LINE, one, LINE, two, CLOSING_LINE, three]
    second = [MOVE, LINE, three, LINE, three, CLOSING_LINE, two]
    found = write([PATTERN_START, FIRST, *first, SECOND, *second, PATTERN_END])
    assert (found.fault, found.dropped) == ("", 2)
    (stitch,) = decode(found.sequence).stitches
    assert [(s.panel, s.edge) for s in stitch.sides] == [("skirt_front", 1), ("skirt_back", 2)]


@given(
    st.integers(0, 2**31),
    st.sampled_from(["left out", "another", "put in", "cut", "exchanged"]),
    st.integers(1, 3),
    st.booleans(),
)
@settings(deadline=None, max_examples=150)
def test_damaged_answers_are_patterns_or_have_a_reason(seed, damage, times, as_text):
    names = NAMES if as_text else None
    text = NAMES.spell(TOP)
    outputs = text.outputs.tolist() if as_text else TOP.tokens.tolist()
    numbers = [*(text.numbers if as_text else TOP.numbers)]
    chance = np.random.default_rng(seed)
    choices = NAMES.outputs if as_text else SIZE
    for _ in range(times):
        place, other = (int(k) for k in chance.integers(len(outputs), size=2))
        if damage == "left out":
            del outputs[place], numbers[place]
        elif damage == "another":
            outputs[place] = int(chance.integers(choices))
        elif damage == "put in":
            outputs.insert(place, int(chance.integers(choices)))
            numbers.insert(place, chance.normal(size=NUMBERS).astype(np.float32))
        elif damage == "cut":
            del outputs[max(place, 1) :], numbers[max(place, 1) :]
        else:
            outputs[place], outputs[other] = outputs[other], outputs[place]
    found = write(outputs, np.array(numbers), names=names, longest=400)
    if found.fault:
        assert found.fault.startswith("What was written is no pattern. ")
    else:
        assert 1 <= len(decode(found.sequence).panels) <= len(decode(TOP).panels)


@given(st.integers(0, 2**31), st.booleans())
@settings(deadline=None, max_examples=40)
def test_noise_is_no_pattern(seed, as_text):
    names = NAMES if as_text else None
    asked = Asked(make_prompt((1,), TEXT.size), None, ((seed,),), 1.0)
    runtime = AtRandom(seed, NAMES.outputs if as_text else SIZE)
    ((found,),) = write_answers(runtime, [asked], Grammar(), TEXT.size, names=names, free=True)
    assert found.fault.startswith("What was written is no pattern. ")


@given(st.integers(0, 2**31), st.booleans(), st.booleans())
@settings(deadline=None, max_examples=60)
def test_what_is_likely_is_told_whatever_was_written_before(seed, editing, planning):
    """Panels in any order, tags on any number of edges; half of the tokens are what is likely."""
    chance, reader = np.random.default_rng(seed), FreeReader()
    foreseen = chance.normal(size=FORESEEN).astype(np.float32)
    old = encode(draft("t-shirt")) if editing else None
    plan = PatternPlan.from_foresight(foreseen, old) if planning else None
    likely, tokens, numbers = Counterparts(old, plan), [], []
    while not reader.finished:
        own = likely.next()
        assert own.token < SIZE and own.planned < SIZE and own.panel < len(PANEL_NAMES)
        wanted = [t for t in (own.token, own.planned) if t >= 0 and chance.random() < 0.5]
        wanted += [PATTERN_END] if len(tokens) > 80 else []
        token = next(t for t in (*wanted, *chance.permutation(SIZE).tolist()) if _taken(reader, t))
        tokens.append(token)
        numbers.append(chance.normal(size=NUMBERS).astype(np.float32))
        likely.follow(token, numbers[-1])
    assert decode(settled(tokens, numbers).sequence).panels


def _taken(reader: FreeReader, token: int) -> bool:
    try:
        return reader.take(token) == [token]
    except PatternError:
        return False


def test_an_untrained_network_that_repeats_and_plans_says_why_there_is_no_pattern(tiny_maker):
    assert tiny_maker.model.decoding == "grammar"
    requests = [Request("a long dress"), Request("make it shorter", edit=draft("t-shirt"))]
    for one in tiny_maker.write_all(requests, temperature=1.0, decoding="free"):
        assert isinstance(one, PatternError) and "What was written is no pattern" in str(one)


@pytest.mark.skipif(not SHIPPED.is_file(), reason="the package has no weights of a PatternMaker")
def test_trained_weights_seldom_need_the_grammar():
    maker = PatternMaker.load()
    requests = [Request(text) for text in ("a t-shirt", "a short skirt", "trousers", "a long dress")]
    free = maker.write_all(requests, decoding="free")
    ruled = maker.write_all(requests, decoding="grammar")
    same = [
        isinstance(a, WrittenPattern) and compare(a.pattern, b.pattern).same_structure
        for a, b in zip(free, ruled, strict=True)
    ]
    assert sum(same) >= 2

"""Names of panels written as text: spelled, read back, and spelled under the grammar."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scripted_runtime import AtRandom, Scripted
from token_reference import faults

from swifttailor.errors import InputError, PatternError
from swifttailor.networks.text_tokenizer import TextTokenizer
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.pattern_maker.asking.generation import Asked, write_answers
from swifttailor.pattern_maker.asking.prompt import (
    EDIT,
    IMAGE,
    MAKE,
    OWN_TOKENS,
    OWN_TOKENS_WITH_NAME_TEXT,
    PAD,
    make_prompt,
    outlines_of,
    pattern_part,
)
from swifttailor.pattern_maker.network.network_config import NetworkConfig
from swifttailor.pattern_maker.tokens.decode import decode
from swifttailor.pattern_maker.tokens.encode import encode
from swifttailor.pattern_maker.tokens.free_reading import FreeReader, settled
from swifttailor.pattern_maker.tokens.grammar import Grammar, Limits, Stage, State
from swifttailor.pattern_maker.tokens.name_text import FIRST_PIECE, PANEL_END, PANEL_START, NameText
from swifttailor.pattern_maker.tokens.token_sequence import NUMBER_MASK, TokenSequence, padded_mask
from swifttailor.pattern_maker.tokens.vocabulary import (
    NUMBERS,
    PANEL_TOKENS,
    PATTERN_END,
    SIZE,
    STITCH_TAGS,
)

TEXT = TextTokenizer.shipped()
NAMES = NameText.of(TEXT)


def read_back(sequence: TokenSequence) -> TokenSequence:
    """Spelled, and read as what a network wrote."""
    spelled, reader = NAMES.spell(sequence), FreeReader(NAMES)
    tokens, numbers = [], []
    for output, row in zip(spelled.outputs.tolist(), spelled.numbers, strict=True):
        done = reader.take(output)
        tokens += done
        numbers += [np.zeros(NUMBERS, np.float32)] * (len(done) - 1) + [row] * bool(done)
    assert reader.finished
    found = settled(tokens, numbers)
    assert found.dropped == 0
    return found.sequence


def at_random(seed: int, limits: Limits) -> TokenSequence:
    """Any sequence that the grammar lets through, with any numbers."""
    chance, grammar, state, tokens = np.random.default_rng(seed), Grammar(limits, "any"), State(), []
    while state.stage is not Stage.FINISHED:
        tokens.append(int(chance.choice(np.flatnonzero(grammar.allowed(state)))))
        state = grammar.advance(state, tokens[-1])
    numbers = chance.normal(size=(len(tokens), NUMBERS)).astype(np.float32)
    return TokenSequence(np.array(tokens), numbers * NUMBER_MASK[tokens])


def test_every_name_comes_back_and_no_mark_is_two():
    assert [NAMES.text_of(outputs) for outputs in NAMES.names] == list(PANEL_NAMES)
    assert len(set(NAMES.names)) == len(PANEL_NAMES)
    marks = [IMAGE, EDIT, MAKE, PAD, PANEL_START, PANEL_END]
    assert sorted(marks) == list(range(SIZE, FIRST_PIECE)) and OWN_TOKENS_WITH_NAME_TEXT == FIRST_PIECE
    assert OWN_TOKENS == PAD + 1
    whole = NAMES.whole(TEXT.size)
    assert len(set(whole.tolist())) == NAMES.outputs == FIRST_PIECE + len(NAMES.pieces)
    assert TEXT.decode(whole[list(NAMES.names[0])].tolist()) == "left_btorso"
    assert not padded_mask(NAMES.outputs)[SIZE:].any()


def test_what_is_written():
    shirt = encode(draft("t-shirt"))
    spelled = NAMES.spell(shirt)
    begin = spelled.outputs.tolist().index(PANEL_START)
    assert (
        begin == 1
        and TEXT.decode(NAMES.whole(TEXT.size)[spelled.outputs[2 : 2 + len(NAMES.names[0])]].tolist())
        == PANEL_NAMES[int(shirt.tokens[1]) - PANEL_TOKENS.start]
    )
    panels = np.isin(shirt.tokens, PANEL_TOKENS)
    letters = sum(len(NAMES.names[t - PANEL_TOKENS.start]) for t in shirt.tokens[panels].tolist())
    assert len(spelled) == len(shirt) + letters + panels.sum()  # a mark for the token, one more at the end
    assert (spelled.outputs == PANEL_END).sum() == panels.sum()
    assert spelled.outputs[-2:].tolist() == [PANEL_END, PATTERN_END]
    kept = spelled.outputs < SIZE
    assert np.array_equal(spelled.outputs[kept], shirt.tokens[~panels])
    assert np.array_equal(spelled.numbers[kept], shirt.numbers[~panels]) and not spelled.numbers[~kept].any()


@given(st.integers(0, 2**31), st.sampled_from([(60, 6), (300, 12)]))
@settings(deadline=None, max_examples=60)
def test_whatever_the_grammar_lets_through_is_read_back_as_it_was(seed, limits):
    sequence = at_random(seed, Limits(*limits))
    assert read_back(sequence) == sequence


@pytest.mark.parametrize(("name", "every"), [("repository", 1), ("validation", 2), ("train-2", 200)])
def test_real_patterns_are_read_back_as_they_were(real_patterns, name, every):
    chance, count = np.random.default_rng(0), 0
    for pattern in real_patterns(name, every=every):
        sequence = encode(pattern, tags=chance.permutation(STITCH_TAGS).tolist())
        assert read_back(sequence) == sequence
        count += 1
    if not count:
        pytest.skip(f"{name}.jsonl.gz is not there")
    assert count >= 15


@pytest.mark.parametrize("name", ["t-shirt", "hoodie", "shirt-dress", "jumpsuit", "circle-skirt"])
@pytest.mark.parametrize("free", [True, False])
def test_a_network_that_knows_a_pattern_writes_it(name, free):
    sequence = encode(draft(name))
    spelled = NAMES.spell(sequence)
    runtime = Scripted(spelled.outputs, spelled.numbers, NAMES.outputs)
    asked = Asked(make_prompt((1,), TEXT.size, names=NAMES))
    ((written,),) = write_answers(runtime, [asked], Grammar(), TEXT.size, names=NAMES, free=free)
    assert written.sequence == sequence and not (written.fault or written.dropped or written.unsewn)
    assert runtime.fed == NAMES.whole(TEXT.size)[spelled.outputs[:-1]].tolist(), "names are fed back as text"
    assert written.log_likelihood == pytest.approx(0.0, abs=1e-3)


@given(st.integers(0, 2**31), st.sampled_from([0.0, 1.0]))
@settings(deadline=None, max_examples=30)
def test_under_the_grammar_every_name_is_one(seed, temperature):
    limits = (120, 8)
    asked = Asked(make_prompt((1,), TEXT.size), None, ((seed,),), temperature)
    runtime = AtRandom(seed, NAMES.outputs)
    ((written,),) = write_answers(runtime, [asked], Grammar(Limits(*limits), "any"), TEXT.size, names=NAMES)
    assert faults(written.sequence.tokens.tolist(), *limits) == []
    assert decode(written.sequence).panels and read_back(written.sequence) == written.sequence


def test_a_pattern_to_edit_is_told_with_its_names_as_text():
    top = encode(draft("tank-top"))
    for brief, told in ((False, top), (True, outlines_of(top))):
        prompt = make_prompt((5,), TEXT.size, edit=top, brief=brief, names=NAMES)
        spelled = NAMES.spell(told)
        expected = [5, TEXT.size + EDIT, *NAMES.whole(TEXT.size)[spelled.outputs].tolist(), TEXT.size + MAKE]
        assert prompt.tokens.tolist() == expected
        assert np.array_equal(prompt.numbers[2:-1], spelled.numbers)
        panels = np.isin(told.tokens, PANEL_TOKENS).sum()
        assert (spelled.outputs == PANEL_START).sum() == (spelled.outputs == PANEL_END).sum() == panels
    assert pattern_part(top, TEXT.size).tokens.tolist() == (top.tokens + TEXT.size).tolist()


@pytest.mark.parametrize("name", ["skirt_fro", "", "skirt_front_9", "backskirt_"])
def test_a_name_that_is_none_is_said(name):
    pieces = {NAMES.text_of([k]): k for k in range(FIRST_PIECE, NAMES.outputs)}
    spelled = [pieces[one] for one in _cut(name, pieces)]
    reader = FreeReader(NAMES)
    for output in (0, PANEL_START, *spelled):
        assert reader.take(output) == ([0] if output == 0 else [])
    with pytest.raises(PatternError, match=f"Panel 1 is called {name!r}; GarmentCode's 75 names"):
        reader.take(2)


def _cut(name: str, pieces) -> list[str]:
    """A name in pieces, the longest first."""
    found = []
    while name:
        found.append(max((p for p in pieces if p and name.startswith(p)), key=len))
        name = name[len(found[-1]) :]
    return found


def test_tokenizers_that_lose_names_and_networks_that_cannot_go_with_them_are_refused():
    with pytest.raises(InputError, match="of the panel name 'left_btorso'"):
        NameText(NAMES.spelled, lambda tokens: TEXT.decode(tokens).replace("_", " "))
    with pytest.raises(InputError, match=r"network.names is text, and network.copying true"):
        NetworkConfig(names="text")
    with pytest.raises(InputError, match=r"network.names is 'sounds'"):
        NetworkConfig(names="sounds")

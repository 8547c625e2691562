"""What is likely to be repeated: of a pattern to edit, and of the body's other side."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from swifttailor.pattern.drafts import draft, list_drafts
from swifttailor.pattern.names import PANEL_NAMES, TWINS
from swifttailor.pattern_maker.asking.counterpart import NONE, Counterparts, counterparts
from swifttailor.pattern_maker.tokens.decode import decode
from swifttailor.pattern_maker.tokens.encode import encode
from swifttailor.pattern_maker.tokens.panel_tokens import are_alike, mirrored, panels_of
from swifttailor.pattern_maker.tokens.token_sequence import NUMBER_MASK, TokenSequence
from swifttailor.pattern_maker.tokens.vocabulary import (
    CLOSING_COMMANDS,
    COMMANDS,
    NOT_STITCHED,
    PANEL_TOKENS,
    STITCH_TOKENS,
)

NAMES = [info.name for info in list_drafts() if {p.name for p in draft(info.name).panels} <= set(PANEL_NAMES)]
"""PatternMaker has no names for straps of halters, collars that are turned down, and strips of pleats."""


def shares(old, new):
    """Of the tokens of `new` those that equal their counterparts, and of these those with equal numbers."""
    found = counterparts(old, new)
    same = np.array([c.token for c in found]) == new.tokens
    equal = [np.allclose(c.numbers, n, atol=1e-6) for c, n in zip(found, new.numbers, strict=True)]
    return same.mean(), np.array(equal)[same].mean()


@pytest.mark.parametrize("name", NAMES)
def test_unchanged_every_token_is_its_counterpart(name):
    pattern = encode(draft(name))
    assert shares(pattern, pattern) == (1, 1)


def test_real_patterns_unchanged(real_patterns):
    for pattern in (*real_patterns("repository"), *real_patterns("validation", every=10)):
        sequence = encode(pattern)
        assert shares(sequence, sequence) == (1, 1)


@pytest.mark.parametrize(
    ("name", "values"), [("shirt-dress", {"skirt_length": 50.0}), ("t-shirt", {"sleeve_length": 30.0})]
)
def test_of_another_length_only_numbers_differ(name, values):
    tokens, numbers = shares(encode(draft(name)), encode(draft(name, **values)))
    assert tokens == 1
    assert 0.3 < numbers < 1


def without_panel(pattern, name):
    """A pattern without one of its panels and the stitches to it."""
    kept = [s for s in pattern.stitches if name not in (s.first.panel, s.second.panel)]
    return replace(pattern, panels=tuple(p for p in pattern.panels if p.name != name), stitches=tuple(kept))


def symmetric_panels(panels):
    """Class ids of those on the right that are the reflection of those on the left."""
    pairs = [(right, left) for right, left in TWINS.items() if right in panels and left in panels]
    return {right for right, left in pairs if are_alike(mirrored(panels[left], right), panels[right], 1e-3)}


def test_what_is_changed_on_one_side_is_offered_on_the_other(real_patterns):
    """Of patterns to edit that are symmetric: made longer on both sides."""
    tried = 0
    for pattern in (*real_patterns("repository"), *real_patterns("validation", every=10)):
        old = encode(pattern)
        right = symmetric_panels(panels_of(old))
        both = right | {TWINS[name] for name in right}
        edges = in_panels(old, both) & np.isin(old.tokens, [*COMMANDS, *CLOSING_COMMANDS])[:, None]
        longer = np.where(edges & (np.arange(8) % 2 == 1), old.numbers * 1.3, old.numbers)
        new = TokenSequence(old.tokens, longer)
        found = counterparts(old, new)
        for k in np.flatnonzero(in_panels(new, right)[:, 0] & NUMBER_MASK[new.tokens].any(axis=1)):
            assert found[k].token == new.tokens[k]
            assert np.allclose(found[k].numbers, new.numbers[k], atol=2e-3)
            tried += 1
    assert tried > 100


def in_panels(sequence, names):
    """(n, 1) which tokens belong to panels of these class ids."""
    panel, inside = NONE, []
    for token in sequence.tokens.tolist():
        panel = token - PANEL_TOKENS.start if token in PANEL_TOKENS else panel
        inside.append(panel in names)
    return np.array(inside)[:, None]


def test_the_other_side_of_a_symmetric_garment_is_told_from_the_first(real_patterns):
    """Without a pattern to edit. Numbers all, and most stitches."""
    told = right = 0
    for pattern in (*real_patterns("repository"), *real_patterns("validation", every=10)):
        sequence = encode(pattern)
        symmetric = symmetric_panels(panels_of(sequence))
        inside = in_panels(sequence, symmetric)[:, 0]
        for k, c in enumerate(counterparts(None, sequence)):
            token = int(sequence.tokens[k])
            if not inside[k] or token in PANEL_TOKENS:
                assert inside[k] or c.token in (NONE, 0) or panel_has_twin(sequence, k)
                continue
            if NUMBER_MASK[token].any():
                assert c.token == token
                assert np.allclose(c.numbers, sequence.numbers[k], atol=2e-3)
            told += 1
            right += c.token == token
    assert told > 500
    assert right > 0.9 * told


def panel_has_twin(sequence, place):
    names = [t for t in sequence.tokens[: place + 1].tolist() if t in PANEL_TOKENS]
    return bool(names) and names[-1] - PANEL_TOKENS.start in TWINS


@pytest.mark.parametrize("name", NAMES)
def test_a_reflection_s_reflection_is_the_panel(name):
    for panel in panels_of(encode(draft(name))).values():
        again = mirrored(mirrored(panel, panel.name), panel.name)
        assert are_alike(again, panel, 1e-5)
        assert [e.label for e in again.edges] == [e.label for e in panel.edges]
        if panel.edges[0].kind == 0 and abs(panel.placement[0]) > 0.5:
            assert not are_alike(mirrored(panel, panel.name), panel, 1e-2)


def test_twins_are_the_two_sides_and_the_first_is_written_before():
    named = {PANEL_NAMES[right]: PANEL_NAMES[left] for right, left in TWINS.items()}
    assert named["right_ftorso"] == "left_ftorso" and named["pant_b_r"] == "pant_b_l"
    assert named["sl_right_cuff_skirt_b"] == "sl_left_cuff_skirt_b"
    assert all(right > left for right, left in TWINS.items())
    assert len(set(TWINS.values())) == len(TWINS) and not set(TWINS) & set(TWINS.values())


def test_what_was_sewn_to_a_panel_that_is_gone_is_sewn_to_nothing():
    old = draft("t-shirt").canonical()
    gone = old.panels[1].name  # others stand before and after it
    new = encode(without_panel(old, gone))
    found = counterparts(encode(old), new)

    assert PANEL_TOKENS.start <= found[int(np.flatnonzero(np.isin(new.tokens, PANEL_TOKENS))[1])].token
    wrong = [(int(t), c.token) for t, c in zip(new.tokens, found, strict=True) if t != c.token]
    # The name that is left out, and stitches towards it that come before it: these are open as before.
    names = [pair for pair in wrong if pair[0] in PANEL_TOKENS]
    assert len(names) == 1
    assert all(t == NOT_STITCHED and c in STITCH_TOKENS for t, c in wrong if t not in PANEL_TOKENS)
    after = [k for k, t in enumerate(new.tokens) if t in PANEL_TOKENS][1]
    assert all(t == c.token for t, c in zip(new.tokens[after + 1 :], found[after + 1 :], strict=True))


def test_a_new_panel_has_none_and_those_after_it_have_theirs():
    new = draft("t-shirt").canonical()
    added = new.panels[1].name
    new_sequence = encode(new)
    found = counterparts(encode(without_panel(new, added)), new_sequence)

    starts = [k for k, t in enumerate(new_sequence.tokens) if t in PANEL_TOKENS]
    inside = range(starts[1] + 1, starts[2] - 1)
    assert {found[k].token for k in inside} == {NONE}
    after = range(starts[2], len(new_sequence))
    numbered = [k for k in after if NUMBER_MASK[new_sequence.tokens[k]].any()]
    assert all(found[k].token == new_sequence.tokens[k] for k in numbered)
    assert all(np.allclose(found[k].numbers, new_sequence.numbers[k], atol=1e-6) for k in numbered)


@pytest.mark.parametrize("insert", [True, False])
def test_behind_an_edge_more_or_less_the_edges_find_theirs(insert):
    """An edge halved, or two joined: what comes after it is found again."""
    long = encode(draft("fitted-skirt"))
    at = int(
        np.flatnonzero(np.isin(long.tokens, COMMANDS) & np.isin(np.roll(long.tokens, -1), [NOT_STITCHED]))[0]
    )
    tokens, numbers = long.tokens.tolist(), long.numbers.tolist()
    half = [x * 0.5 for x in numbers[at]]
    tokens[at:at], numbers[at:at] = [COMMANDS[0], NOT_STITCHED], [half, [0.0] * 8]
    longer = TokenSequence(np.array(tokens), np.array(numbers))
    decode(longer)  # is a pattern
    old, new = (long, longer) if insert else (longer, long)
    found = counterparts(old, new)
    behind = at + (4 if insert else 2)
    assert [c.token for c in found[behind:]] == new.tokens[behind:].tolist()
    assert all(np.allclose(c.numbers, n) for c, n in zip(found[behind:], new.numbers[behind:], strict=True))


def test_whatever_is_written_there_is_an_answer():
    """Any other pattern may be written for a pattern: each for every fifth, and every fifth for each."""
    sequences = [encode(draft(name)) for name in NAMES]
    for first, old in enumerate(sequences):
        for new in sequences[first % 5 :: 5]:
            walk = Counterparts(old)
            for token, numbers in zip(new.tokens.tolist(), new.numbers, strict=True):
                counterpart = walk.next()
                assert counterpart.token == NONE or 0 <= counterpart.token
                assert counterpart.numbers.shape == (8,)
                walk.follow(token, numbers)
            assert walk.next().token == NONE

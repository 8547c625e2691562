"""Patterns written as tokens and read again are what they were."""

from __future__ import annotations

import random
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.errors import InputError, PatternError
from swifttailor.pattern import Arc, Cubic, EdgeRef, Line, Pattern, Placement, Quadratic, Stitch
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.panel import Edge, Panel
from swifttailor.pattern_maker.tokens.decode import decode
from swifttailor.pattern_maker.tokens.encode import encode, follow
from swifttailor.pattern_maker.tokens.fidelity import compare
from swifttailor.pattern_maker.tokens.grammar import Grammar, Limits, Stage
from swifttailor.pattern_maker.tokens.vocabulary import STITCH_TAGS, TOKENS, usual_label

OUTLINE_CM, PLACEMENT_CM = 0.05, 0.1


def words(sequence):
    return [TOKENS[t][1:-1] for t in sequence.tokens]


def assert_comes_back(pattern, **options):
    sequence = encode(pattern, **options)
    again = decode(sequence, name=pattern.name)
    found = compare(pattern, again)
    assert found.same_structure, pattern.name
    assert found.outline_cm <= OUTLINE_CM, (pattern.name, found)
    assert found.placement_cm <= PLACEMENT_CM, (pattern.name, found)
    return sequence, again


@pytest.mark.parametrize(
    ("name", "every"),
    [("repository", 1), ("validation", 1), ("test", 4), ("train", 40), ("train-2", 40), ("edits", 20)],
)
def test_real_patterns_come_back_and_are_grammatical(real_patterns, name, every):
    grammar, count = Grammar(), 0
    for pattern in real_patterns(name, every=every):
        sequence, again = assert_comes_back(pattern)
        assert follow(sequence, grammar)[-1].stage is Stage.FINISHED
        # A second time there is nothing left to round but the last digit of 32-bit numbers.
        twice = encode(again)
        assert twice.tokens.tolist() == sequence.tokens.tolist()
        np.testing.assert_allclose(twice.numbers, sequence.numbers, atol=1e-4, rtol=1e-4)
        count += 1
    if not count:
        pytest.skip(f"{name}.jsonl.gz is not there")
    assert count >= 20


def test_usual_labels_are_those_of_garmentcode(real_patterns):
    for pattern in real_patterns("repository", "validation"):
        assert not any(word.startswith("covers:") for word in words(encode(pattern)))
        assert all(p.label == usual_label(p.name) for p in pattern.panels)


@pytest.mark.parametrize(
    "name",
    ["t-shirt", "tank-top", "hoodie", "fitted-dress", "shirt-dress", "jumpsuit", "trousers", "fitted-skirt",
     "circle-skirt", "gathered-skirt"],
)  # fmt: skip
def test_drafts_come_back(name):
    assert_comes_back(draft(name))


numbers = st.floats(-150, 150, allow_subnormal=False)
angles = st.floats(-180, 180, allow_subnormal=False)
bulges = st.tuples(st.floats(0.1, 0.9), st.floats(-0.5, 0.5))
curves = st.one_of(
    st.just(Line()),
    st.builds(Quadratic, bulges),
    st.builds(Cubic, bulges, bulges),
    st.tuples(st.floats(0.501, 30.0), st.booleans(), st.booleans()),
)


@st.composite
def panels(draw, name):
    """Round about, its origin and placement anywhere, its edges of any shape."""
    count = draw(st.integers(3, 6))
    turn = np.linspace(0, 2 * np.pi, count, endpoint=False)
    radii = np.array([draw(st.floats(5, 80)) for _ in range(count)])
    middle = draw(st.tuples(numbers, numbers))
    vertices = np.stack([radii * np.cos(turn), radii * np.sin(turn)], axis=1) + middle
    edges = []
    for k in range(count):
        curve, length = draw(curves), float(np.hypot(*(vertices[(k + 1) % count] - vertices[k])))
        if isinstance(curve, tuple):
            curve = Arc(length * curve[0], curve[1], curve[2])
        edges.append(Edge(curve, draw(st.sampled_from(["", "lower_interface", "left_collar"]))))
    placement = Placement(
        draw(st.tuples(numbers, numbers, numbers)),
        draw(st.tuples(angles, st.one_of(angles, st.sampled_from([90.0, -90.0])), angles)),
        draw(st.sampled_from(["intrinsic", "extrinsic"])),
    )
    return Panel(name, vertices, tuple(edges), placement, draw(st.sampled_from(["", "body", "arm", "leg"])))


@st.composite
def patterns(draw):
    names = draw(st.permutations(["skirt_panel_14", "wb_front", "left_btorso"]))[: draw(st.integers(1, 3))]
    made = tuple(draw(panels(name)) for name in names)
    edges = draw(st.permutations([EdgeRef(p.name, k) for p in made for k in range(len(p.edges))]))
    count = draw(st.integers(0, len(edges) // 2))
    stitches = [Stitch(edges[2 * k], edges[2 * k + 1], draw(st.booleans())) for k in range(count)]
    return Pattern(made, tuple(stitches), "drawn")


@settings(deadline=None, max_examples=60)
@given(patterns(), st.integers(0, 2**32))
def test_any_pattern_of_known_names_comes_back(pattern, seed):
    tags = random.Random(seed).sample(range(STITCH_TAGS), STITCH_TAGS)
    shuffled, again = assert_comes_back(pattern, tags=tags)
    plain, same = assert_comes_back(pattern)
    assert compare(again, same).same_structure
    assert follow(shuffled, Grammar(tags="any"))[-1].stage is Stage.FINISHED
    assert follow(plain, Grammar())[-1].stage is Stage.FINISHED
    shift = {f"stitch:{tag}": f"stitch:{k}" for k, tag in enumerate(tags)}
    assert [shift.get(w, w) for w in words(shuffled)] == words(plain)


def test_what_is_written(square_pattern):
    front, back = (replace(p, name=n, label="leg") for p, n in zip(square_pattern.panels, NAMES, strict=True))
    front = replace(front, label="", edges=(Edge(Line(), "lower_interface"), *front.edges[1:]))
    sides = (
        Stitch(EdgeRef(NAMES[0], 1), EdgeRef(NAMES[1], 1)),
        Stitch(EdgeRef(NAMES[1], 3), EdgeRef(NAMES[0], 3), right_wrong=True),
    )
    assert words(encode(Pattern((back, front), sides))) == [
        *("pattern_start", "panel:skirt_front", "covers:nothing", "move"),
        *("line", "edge:lower_interface", "not_stitched", "line", "stitch:0"),
        *("line", "not_stitched", "closing_line", "stitch:1"),
        *("panel:skirt_back", "move", "line", "not_stitched", "line", "stitch:0"),
        *("line", "not_stitched", "closing_line", "right_wrong", "stitch:1", "pattern_end"),
    ]


NAMES = ("skirt_front", "skirt_back")


def renamed(pattern: Pattern) -> Pattern:
    made = tuple(replace(p, name=n) for p, n in zip(pattern.panels, NAMES, strict=True))
    return Pattern(made, ())


@pytest.mark.parametrize(
    ("change", "complaint"),
    [
        (lambda p: replace(p, panels=(replace(p.panels[0], name="Skirt_front"),)), "'skirt_front' is near"),
        (lambda p: replace(p, panels=(replace(p.panels[0], label="head"),)), "body, arm, leg or none"),
        (
            lambda p: replace(p, panels=(replace(p.panels[0], edges=(Edge(Line(), "hem"),) * 4),)),
            "labelled 'hem'",
        ),
        (lambda p: replace(p, panels=()), "no panels"),
        (lambda p: replace(p, stitches=(stitch(0, 0), stitch(0, 1))), "in two stitches"),
        (lambda p: replace(p, stitches=(stitch(0, 7),)), "does not exist"),
        (lambda p: replace(p, stitches=(stitch(0, 0),) * (STITCH_TAGS + 1)), "at most 108"),
        (
            lambda p: replace(p, panels=(Panel(NAMES[0], [[0, 0], [1, 0]], (Edge(), Edge())),)),
            "one must be curved",
        ),
    ],
)
def test_what_does_not_fit_is_refused(square_pattern, change, complaint):
    with pytest.raises(PatternError, match=complaint):
        encode(change(renamed(square_pattern)))


def stitch(a, b):
    return Stitch(EdgeRef(NAMES[0], a), EdgeRef(NAMES[1], b))


def test_limits_and_tags_are_checked(square_pattern):
    pattern = renamed(square_pattern)
    count = len(encode(pattern))
    assert len(encode(pattern, limits=Limits(tokens=count))) == count
    with pytest.raises(PatternError, match=f"takes {count} tokens; at most {count - 1}"):
        encode(pattern, limits=Limits(tokens=count - 1))
    for tags in ([0, 0], [108]):
        with pytest.raises(InputError, match="different numbers from 0 to 107"):
            encode(pattern, tags=tags)

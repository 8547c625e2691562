"""The panel tensor of a pattern, and the pattern that a tensor says."""

from __future__ import annotations

import gzip
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.errors import PatternError
from swifttailor.latent_diffusion import tensor_layout as at
from swifttailor.latent_diffusion.panel_tensor import tensor_of
from swifttailor.latent_diffusion.stitch_tags import nearest_pairs
from swifttailor.latent_diffusion.tensor_pattern import edge_count, pattern_of
from swifttailor.pattern import (
    Arc,
    Cubic,
    Edge,
    EdgeRef,
    Line,
    Panel,
    Pattern,
    Placement,
    Quadratic,
    Stitch,
    read_specification,
)
from swifttailor.pattern.names import EDGE_LABELS, body_region

REAL = Path(__file__).parents[1] / "garmentcode_patterns" / "patterns.jsonl.gz"


def require_same(found: Pattern, wanted: Pattern, off: float = 1e-6) -> None:
    """Names, labels, edges, stitches, and where all of it lies in the world."""
    assert [p.name for p in found.panels] == [p.name for p in wanted.panels]
    assert found.stitches == wanted.stitches
    for own, other in zip(found.panels, wanted.panels, strict=True):
        assert own.label == other.label
        assert [(type(e.curve), e.label) for e in own.edges] == [
            (type(e.curve), e.label) for e in other.edges
        ]
        for k in range(len(own.edges)):
            np.testing.assert_allclose(
                own.to_world(own.sample_edge(k, 7)), other.to_world(other.sample_edge(k, 7)), atol=off
            )


@pytest.fixture(scope="module")
def real_patterns():
    with gzip.open(REAL, "rt", encoding="utf-8") as lines:
        found = [json.loads(line) for line in lines]
    return [read_specification(one["pattern"], name=one["id"]).pattern.canonical() for one in found]


def test_patterns_of_garmentcode_come_back_whole(real_patterns):
    assert len(real_patterns) >= 10
    for pattern in real_patterns:
        require_same(pattern_of(tensor_of(pattern)), pattern, off=1e-5)


def test_noise_of_a_network_moves_corners_and_keeps_seams(real_patterns):
    chance = np.random.default_rng(0)
    for pattern in real_patterns[:5]:
        tensor = tensor_of(pattern)
        there = tensor[..., at.THERE] > 0
        noisy = tensor.copy()
        noisy[..., at.STEP] += chance.normal(0, 0.05, noisy[..., at.STEP].shape)
        noisy[..., at.TAG] += chance.normal(0, 0.02, noisy[..., at.TAG].shape)
        noisy[..., at.BITS] = np.where(tensor[..., at.BITS] > 0.5, 0.8, 0.2)
        noisy[..., at.TURN][there] *= np.where(chance.random((int(there.sum()), 1)) < 0.5, -1.0, 1.0)
        require_same(pattern_of(noisy), pattern, off=1.5)


curves = st.one_of(
    st.just(Line()),
    st.builds(Quadratic, st.tuples(st.floats(0.1, 0.9), st.floats(-0.4, 0.4))),
    st.builds(
        Cubic,
        st.tuples(st.floats(0.1, 0.5), st.floats(-0.4, 0.4)),
        st.tuples(st.floats(0.5, 0.9), st.floats(-0.4, 0.4)),
    ),
    st.builds(Arc, st.floats(40.0, 900.0), st.booleans(), st.booleans()),
)


@st.composite
def panels(draw, name):
    count = draw(st.integers(3, at.EDGES))
    around = 2 * np.pi * np.arange(count) / count
    vertices = 30 * np.stack([np.cos(around), np.sin(around)], 1) + draw(st.floats(-50, 50))
    edges = [Edge(draw(curves), draw(st.sampled_from(("", *EDGE_LABELS)))) for _ in range(count)]
    place = Placement(
        tuple(draw(st.floats(-150, 150)) for _ in range(3)),
        tuple(draw(st.floats(-180, 180)) for _ in range(3)),
        draw(st.sampled_from(("intrinsic", "extrinsic"))),
    )
    return Panel(name, vertices, tuple(edges), place, body_region(name))


@st.composite
def any_patterns(draw):
    names = draw(st.lists(st.sampled_from(at.SLOTS), min_size=1, max_size=4, unique=True))
    found = [draw(panels(name)) for name in names]
    sides = [EdgeRef(p.name, k) for p in found for k in range(len(p.edges))]
    sides = draw(st.permutations(sides))[: 2 * draw(st.integers(0, len(sides) // 2))]
    pairs = zip(sides[::2], sides[1::2], strict=True)
    return Pattern(tuple(found), tuple(Stitch(*pair, draw(st.booleans())) for pair in pairs)).canonical()


@settings(max_examples=30, deadline=None)
@given(any_patterns())
def test_any_panels_come_back_and_so_do_stitches_whose_tags_are_their_own(pattern):
    tensor = tensor_of(pattern)
    found = pattern_of(tensor)
    sides = [side for stitch in pattern.stitches for side in stitch.sides]
    own = [tensor[at.SLOTS.index(side.panel), side.edge, at.TAG] for side in sides]
    near = [np.linalg.norm(one - own, axis=1) < 0.1 for one in own]
    if all(alike.sum() == 2 for alike in near):
        assert found.stitches == pattern.stitches
    require_same(replace(found, stitches=()), replace(pattern, stitches=()), off=1e-4)


def square(name: str = "wb_front", count: int = 4, **more) -> Panel:
    around = 2 * np.pi * np.arange(count) / count
    return Panel(name, 10 * np.stack([np.cos(around), np.sin(around)], 1), (Edge(),) * count, **more)


@pytest.mark.parametrize(
    ("pattern", "said"),
    [
        (Pattern((square("lapel"),)), "no slot for a panel 'lapel'"),
        (Pattern((square(count=38),)), "38 edges"),
        (Pattern((replace(square(), edges=(Edge(label="zip"), *[Edge()] * 3)),)), "labelled 'zip'"),
        (
            Pattern(
                (square(),), tuple(Stitch(EdgeRef("wb_front", 0), EdgeRef("wb_front", k)) for k in (1, 2))
            ),
            "is in 2 stitches",
        ),
        (Pattern((square(),), (Stitch(EdgeRef("wb_front", 0), EdgeRef("wb_back", 1)),)), "not there"),
    ],
)
def test_what_does_not_fit_is_refused_with_the_reason(pattern, said):
    with pytest.raises(PatternError, match=said):
        tensor_of(pattern)


def test_a_tensor_that_says_no_pattern_is_refused_with_the_reason():
    with pytest.raises(PatternError, match="holds no panel"):
        pattern_of(np.zeros(at.SHAPE))
    with pytest.raises(PatternError, match="of shape"):
        pattern_of(np.zeros((2, 3)))
    tensor = tensor_of(Pattern((square(),)))
    for numbers, value, said in (
        (at.TURN, 0.0, "no direction"),
        (at.STEP, np.nan, "not finite"),
    ):
        broken = tensor.copy()
        broken[..., numbers] = value
        with pytest.raises(PatternError, match=said):
            pattern_of(broken)
    tensor[:, 1:, at.THERE] = 0.0
    with pytest.raises(PatternError, match="has one edge"):
        pattern_of(tensor)


def test_outlines_are_closed_by_moving_every_edge_alike():
    tensor = tensor_of(Pattern((square(),)))
    tensor[at.SLOTS.index("wb_front"), :4, at.STEP] += [0.4, -0.2]
    require_same(pattern_of(tensor), Pattern((replace(square(), label="body"),)))


def test_as_many_edges_as_are_likeliest():
    assert edge_count(np.array([0.9, 0.9, 0.9, 0.1, 0.2])) == 3
    assert edge_count(np.array([0.9, 0.4, 0.9, 0.9, 0.1])) == 4, "a doubtful one between sure ones"
    assert edge_count(np.array([0.1, 0.6, 0.1])) == 0
    assert edge_count(np.ones(37)) == 37


def test_nearest_tags_are_paired_first_and_far_ones_not_at_all():
    at_x = {"a": 0.0, "b": 3.0, "c": 4.0, "d": 7.5, "e": 90.0}
    tags = {EdgeRef(name, 0): np.array([x, 0.0, 0.0]) for name, x in at_x.items()}
    pairs = nearest_pairs(tags, dict.fromkeys(tags, 1.0))
    assert [{one.panel for one in pair} for pair in pairs] == [{"b", "c"}, {"a", "d"}]
    alike = {EdgeRef("x", k): np.zeros(3) for k in range(4)}
    lengths = dict(zip(alike, (10.0, 4.0, 4.1, 9.0), strict=True))
    assert {frozenset(e.edge for e in pair) for pair in nearest_pairs(alike, lengths)} == {
        frozenset((0, 3)),
        frozenset((1, 2)),
    }

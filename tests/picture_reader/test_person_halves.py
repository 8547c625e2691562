"""What is looked at from nearer of somebody, and what it says."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.picture_reader.labels import PARTS, measure_labels, statement_labels
from swifttailor.picture_reader.person_halves import (
    LEGS_SHARE,
    LOWER,
    NECK_SHARE,
    UPPER,
    chest_of,
    legs_of,
    mean_of,
    with_legs,
    with_neck,
)

WHOLE, NEAR = (0, 0, 90), (20, 30, 40)
LABELS = statement_labels()


def said(rng, upper=None, lower=None):
    """Answers that see these kinds of garments, or nothing, on each part; the rest at random."""
    statements = rng.normal(-3, 0.5, (len(PARTS), len(LABELS)))
    for part, kind in ((UPPER, upper), (LOWER, lower)):
        if kind is not None:
            statements[part, LABELS.index(("kind", kind))] = 4.0
    return {
        "present": np.array([5.0 if kind else -5.0 for kind in (upper, lower)]),
        "statements": statements,
        "has": rng.normal(size=(len(PARTS), len(measure_labels()))),
        "masks": rng.normal(size=(len(PARTS), 4, 4)),
        "designs": rng.normal(size=(len(PARTS), 3, 2)),
    }


@pytest.mark.parametrize(
    ("upper", "lower", "nearer", "added"),
    [
        ("top", None, "trousers", True),
        ("top", None, "skirt", True),
        ("dress", None, "trousers", True),
        ("dress", None, "skirt", False),
        ("dress", None, "shorts", False),
        ("jumpsuit", None, "skirt", False),
        ("jumpsuit", None, "trousers", False),
        (None, None, "trousers", True),
        ("top", None, None, False),
    ],
)
def test_what_is_worn_below_is_seen_from_nearer(upper, lower, nearer, added):
    rng = np.random.default_rng(0)
    answers, legs = said(rng, upper, lower), said(rng, None, nearer)
    seen = with_legs((WHOLE, answers), (NEAR, legs))
    assert (LOWER in seen) == added and (UPPER in seen) == (upper is not None)
    if added:
        square, told = seen[LOWER]
        assert square == NEAR and told is legs
    if upper:
        square, told = seen[UPPER]
        assert square == WHOLE and told is answers


def test_legs_that_are_seen_twice_are_the_mean_of_both():
    rng = np.random.default_rng(1)
    answers, legs = said(rng, "top", "trousers"), said(rng, None, "shorts")
    square, told = with_legs((WHOLE, answers), (NEAR, legs))[LOWER]
    assert square == NEAR and told["masks"] is legs["masks"]
    for name in ("present", "statements", "has", "designs"):
        mean = (1 - LEGS_SHARE) * answers[name][LOWER] + LEGS_SHARE * legs[name][LOWER]
        assert np.allclose(told[name][LOWER], mean)
    assert with_legs((WHOLE, answers), None) == {UPPER: (WHOLE, answers), LOWER: (WHOLE, answers)}
    nothing = said(rng, "top")
    assert with_legs((WHOLE, answers), (NEAR, nothing))[LOWER] == (WHOLE, answers)


def test_of_the_chest_the_neckline_alone_counts():
    rng = np.random.default_rng(2)
    answers, chest = said(rng, "top"), said(rng, "dress")
    told = with_neck(answers, chest)
    assert told["has"] is answers["has"] and np.array_equal(
        told["statements"][LOWER], answers["statements"][LOWER]
    )
    changed = told["statements"][UPPER] != answers["statements"][UPPER]
    assert {claim for (claim, _), is_so in zip(LABELS, changed, strict=True) if is_so} == {
        "neckline",
        "left_neckline",
        "right_neckline",
    }
    both = np.stack([answers["statements"][UPPER], chest["statements"][UPPER]])
    mean = np.average(both, axis=0, weights=[1 - NECK_SHARE, NECK_SHARE])
    assert np.allclose(told["statements"][UPPER][changed], mean[changed])


@pytest.mark.parametrize(
    ("hips", "seen"), [((40.0, 60.0), True), ((40.0, 99.0), False), ((40.0, -5.0), True)]
)
def test_legs_are_looked_at_where_there_are_some(hips, seen):
    mask = np.zeros((100, 80), bool)
    mask[10:100, 30:50] = True
    pixels = np.random.default_rng(3).integers(0, 200, (100, 80, 3), np.uint8)
    views = legs_of(pixels, mask, hips, 40.0)
    assert bool(views) == seen
    if seen:
        (alone, square), (all_of_it, same) = views
        first = max(int(hips[1] - 0.35 * 40), 10)
        assert all_of_it is pixels and same == square
        assert (alone[:first] == 255).all() and np.array_equal(alone[first:], pixels[first:])
        left, top, side = square
        assert top <= first and top + side >= 100 and left + side / 2 == pytest.approx(40, abs=1)


def test_the_chest_is_looked_at_where_it_is_seen():
    mask = np.zeros((100, 80), bool)
    mask[10:100, 30:50] = True
    pixels = np.zeros((100, 80, 3), np.uint8)
    shown, (left, top, side) = chest_of(pixels, mask, (40.0, 60.0), 40.0)
    assert shown is pixels and top + side == 52 and top <= 10 and left + side / 2 == pytest.approx(40, abs=1)
    assert chest_of(pixels, mask, (40.0, 20.0), 40.0) is None


def test_the_mean_is_of_each_answer():
    looks = [{"a": np.array([1.0, 2.0]), "b": np.array(3.0)}, {"a": np.array([3.0, 4.0]), "b": np.array(5.0)}]
    found = mean_of(looks)
    assert found["a"].tolist() == [2.0, 3.0] and found["b"] == 4.0


@pytest.mark.parametrize("lower", [None, "trousers"])
@pytest.mark.parametrize("below", [-1.0, 2.0])
@pytest.mark.parametrize("looked", [True, False])
def test_more_than_looks_decides_whether_anything_is_worn_below(lower, below, looked):
    rng = np.random.default_rng(3)
    answers, near = said(rng, "dress", lower), said(rng, None, "skirt")
    seen = with_legs((WHOLE, answers), (NEAR, near) if looked else None, below)
    assert seen[UPPER] == (WHOLE, answers) and (LOWER in seen) == (below > 0)
    if below > 0:
        square, told = seen[LOWER]
        assert square == (NEAR if looked else WHOLE) and told["present"][LOWER] == below
        shown = near if looked else answers
        share = LEGS_SHARE if looked and lower else 1.0
        expected = (1 - share) * answers["statements"][LOWER] + share * shown["statements"][LOWER]
        assert told["statements"][LOWER] == pytest.approx(expected)

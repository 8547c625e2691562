"""A side of a garment that was not written is the reflection of the other."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import swifttailor
from swifttailor.pattern import Pattern, check_pattern
from swifttailor.pattern.tidying.from_one_side import are_unlike, from_one_side, sides_of
from swifttailor.pattern.tidying.symmetry import OTHER_SIDE


def seams(pattern: Pattern) -> set[frozenset]:
    return {frozenset(s.sides) for s in pattern.stitches}


def only(pattern: Pattern, names: frozenset[str]) -> Pattern:
    """Without what is on the other side, and its seams."""
    kept = {p.name for p in pattern.panels if p.name not in OTHER_SIDE} | names
    return replace(
        pattern,
        panels=tuple(p for p in pattern.panels if p.name in kept),
        stitches=tuple(s for s in pattern.stitches if all(side.panel in kept for side in s.sides)),
    )


@pytest.mark.parametrize("name", ["t-shirt", "fitted-dress", "shirt-dress", "jumpsuit", "trousers"])
@pytest.mark.parametrize("side", [0, 1])
def test_a_missing_side_comes_back_with_its_seams(name, side):
    whole = swifttailor.draft(name)
    half = only(whole, sides_of(whole)[side])
    assert len(half.panels) < len(whole.panels)
    made = from_one_side(half, sides_of(half)[side])
    assert made is not None
    assert [p.name for p in made.panels] == [p.name for p in whole.panels]
    for before, after in zip(whole.panels, made.panels, strict=True):
        assert np.allclose(before.outline(0.1).mean(axis=0), after.outline(0.1).mean(axis=0), atol=1e-6)
        assert before.to_world(before.vertices) == pytest.approx(after.to_world(after.vertices), abs=1e-6)
    assert seams(made) == seams(whole)
    assert check_pattern(made) == check_pattern(whole)


def test_the_whole_stays_the_same():
    whole = swifttailor.draft("t-shirt")
    assert not are_unlike(whole)
    made = from_one_side(whole, sides_of(whole)[0])
    assert made is not None
    assert seams(made) == seams(whole)


def test_what_is_sewn_to_a_panel_without_like_halves_cannot_be_reflected():
    dress = swifttailor.draft("fitted-dress")
    skirt = dress.panel("skirt_front")
    vertices = skirt.vertices.copy()
    vertices[0] += [0.0, 30.0]
    crooked = replace(
        dress, panels=tuple(replace(p, vertices=vertices) if p is skirt else p for p in dress.panels)
    )
    assert from_one_side(crooked, sides_of(crooked)[0]) is None

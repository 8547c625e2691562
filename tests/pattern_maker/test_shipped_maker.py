"""The weights that come with the package, at their work."""

from __future__ import annotations

import json
from collections import Counter

import numpy as np
import pytest

from swifttailor.pattern import check_pattern
from swifttailor.pattern.check.crossings import find_crossing
from swifttailor.pattern.check.outline import trace_outline
from swifttailor.pattern.drafts import draft
from swifttailor.pattern_maker.maker import SHIPPED, PatternMaker, Request

pytestmark = pytest.mark.skipif(not SHIPPED.is_file(), reason="the package has no weights of a PatternMaker")

PROMPTS = (
    "a knee-length sleeveless dress with a V neck",
    "trousers",
    "short skirt",
    "Langärmeliges Hemd",
    "x",
)


@pytest.fixture(scope="module")
def maker():
    return PatternMaker.load()


@pytest.fixture(scope="module")
def answers(maker):
    return maker.generate_all([Request(text) for text in PROMPTS], temperature=1.0, seed=5)


def test_card_beside_the_file_is_the_one_in_it(maker):
    card = json.loads(SHIPPED.with_suffix(".json").read_text())
    assert card == maker.model.card
    assert card["training"]["garments_seen"] > 0 and card["data"]["train"]["garments"] > 0
    assert "/work" not in json.dumps(card) and "/home" not in json.dumps(card)
    assert SHIPPED.stat().st_size < 45e6


def test_whatever_is_asked_panels_are_closed_and_stitches_paired(answers):
    for answer in answers:
        assert answer.pattern.panels
        assert max(Counter(p.name for p in answer.pattern.panels).values()) == 1
        for panel in answer.pattern.panels:
            assert len(panel.edges) >= 3 or any(type(e.curve).__name__ != "Line" for e in panel.edges)
            assert np.isfinite(panel.vertices).all()
        sides = Counter(ref for s in answer.pattern.stitches for ref in s.sides)
        assert all(answer.pattern.has_edge(ref) for ref in sides)
        assert not sides or max(sides.values()) == 1


def test_answers_are_the_same_every_time_and_alone_or_together(maker, answers):
    again = maker.generate(PROMPTS[0], temperature=1.0, seed=5)
    assert again.pattern == maker.generate(PROMPTS[0], temperature=1.0, seed=5).pattern
    for one, other in zip(again.pattern.panels, answers[0].pattern.panels, strict=True):
        assert one.name == other.name
        # Sums of floats differ in the last digits with how much is computed at once.
        assert np.allclose(one.vertices, other.vertices, atol=1e-3)


def test_what_is_said_is_written(maker):
    """The kinds of garment that are named, at the likeliest."""
    trousers, skirt, shirt = (
        maker.generate(text).pattern
        for text in ("long trousers", "a knee-length skirt", "a t-shirt with short sleeves")
    )
    names = [{p.name for p in pattern.panels} for pattern in (trousers, skirt, shirt)]
    assert any("pant" in name for name in names[0]) and not any("torso" in name for name in names[0])
    assert any("skirt" in name for name in names[1]) and not any("torso" in name for name in names[1])
    assert any("torso" in name for name in names[2]) and any("sleeve" in name for name in names[2])


def test_most_of_it_can_be_sewn(answers):
    sound = [not any(f.severity.value == "error" for f in check_pattern(a.pattern)) for a in answers[:3]]
    simple = [all(find_crossing(trace_outline(p)) is None for p in a.pattern.panels) for a in answers[:3]]
    assert sum(sound) >= 2 and sum(simple) >= 2


def test_an_edit_changes_the_pattern_it_is_given(maker):
    skirt = draft("fitted-skirt")
    assert maker.generate("make it 15 cm longer", edit=skirt).pattern != skirt


@pytest.mark.xfail(strict=True, reason="the weights seldom do sums: 15 cm longer is not learnt")
def test_an_edit_does_what_it_is_told(maker):
    skirt = draft("fitted-skirt")
    edited = maker.generate("make it 15 cm longer", edit=skirt).pattern
    heights = [max(np.ptp(p.vertices[:, 1]) for p in pattern.panels) for pattern in (skirt, edited)]
    assert heights[0] + 10 < heights[1] < heights[0] + 20

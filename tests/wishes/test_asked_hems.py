"""Hems that are curved like a shirt's, where words ask for them or a shirt usually has one."""

from __future__ import annotations

import numpy as np
import pytest

import swifttailor
from swifttailor.describing import Claim, measure_facts
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.drafts.asked_hems import RISE_CM, hem_as_asked
from swifttailor.wishes.reader import WishReader

CURVED = {"curved_hem"}


@pytest.fixture(scope="module")
def reader():
    return WishReader.load()


def rise(draft: NamedDraft) -> float:
    return float(dict(draft.options).get("hem_rise", 0.0))


@pytest.mark.parametrize("garment", ["shirt", "t-shirt", "tank-top", "shift-dress"])
def test_the_hem_rises_to_the_side_seams_and_is_level_in_the_middle(garment):
    straight, curved = swifttailor.draft(garment), swifttailor.draft(garment, hem_rise=6.0)
    for name in ("left_ftorso", "left_btorso"):
        before, after = straight.panel(name), curved.panel(name)
        assert after.vertices[:, 1].min() == pytest.approx(before.vertices[:, 1].min(), abs=0.1)
        hem = max(range(len(after.edges)), key=lambda k: np.ptp(after.chord(k)[:, 0]))
        points = after.sample_edge(hem, 65)
        points = points[np.argsort(abs(points[:, 0]))]
        assert points[-1, 1] - points[0, 1] >= 6.0 - 0.1
        slopes = np.diff(points[:, 1]) / np.maximum(np.diff(abs(points[:, 0])), 1e-9)
        assert abs(slopes[0]) < 0.15 and abs(slopes[-1]) < 0.15 and slopes.max() > 0.3


def test_sides_stay_long_enough_on_short_tops():
    short = swifttailor.draft("shirt", length=-12.0, hem_rise=9.0)
    facts = measure_facts(short)
    assert facts.kind == "top" and facts.hem is not None


def test_words_curve_the_hems_of_what_hangs_straight():
    for name in ("shirt", "t-shirt", "tank-top"):
        asked = hem_as_asked(NamedDraft(name), [], CURVED, ())
        assert rise(asked) == RISE_CM and "curved_hem" in asked.shows
    for name in ("circle-skirt", "blazer"):
        assert hem_as_asked(NamedDraft(name), [], CURVED, ()) == NamedDraft(name)


def test_a_shirt_dress_with_a_curved_hem_is_a_long_shirt_unless_it_has_a_waist():
    dress = NamedDraft("shirt-dress", (("collar", "standing"),))
    asked = hem_as_asked(dress, [], CURVED, ())
    assert asked.name == "shift-dress" and rise(asked) == RISE_CM
    assert dict(asked.options)["collar"] == "standing"
    waisted = hem_as_asked(dress, [Claim("waist_seam", "natural")], CURVED, ())
    assert waisted.name == "shirt-dress" and "curved_hem" not in waisted.shows


def test_a_straight_hem_takes_the_curve_off():
    shirt = NamedDraft("shirt", (("hem_rise", 6.0), ("length", 28.0)))
    assert hem_as_asked(shirt, [], (), ()) == shirt
    for claims, denied in (([Claim("hem_shape", "level")], ()), ([], CURVED)):
        straight = hem_as_asked(shirt, claims, (), denied)
        assert rise(straight) == 0.0 and "curved_hem" not in straight.shows
        assert dict(straight.options)["length"] == 28.0


@pytest.mark.parametrize(
    ("text", "curved"),
    [
        ("a shirt with a curved hem", True),
        ("white t-shirt with a shirt tail hem", True),
        ("men's dress shirt", True),
        ("dress shirt with a straight hem", False),
        ("dress shirt, no curved hem", False),
        ("a shirt", False),
        ("Hemd mit abgerundetem Saum", True),
        ("camisa con bajo curvo", True),
        ("overhemd met ronde zoom", True),
    ],
)
def test_which_texts_curve_a_hem(text, curved, reader):
    heard = hear_description(text, reader)
    assert (rise(heard.drafts[0]) > 0.0) == curved
    assert "a hem curved like a shirt's" not in heard.made_as(heard.drafts[0]).cannot


def test_what_cannot_be_curved_is_still_said(reader):
    heard = hear_description("a flared skirt with a curved hem", reader)
    assert "a hem curved like a shirt's" in heard.made_as(heard.drafts[0]).cannot


def test_guesses_at_the_shape_of_a_curved_hem_are_not_cut():
    curved = NamedDraft("shirt", (("hem_rise", 6.0),))
    assert ("hem_shape", "high-low") in curved.has_in_spirit
    assert ("hem_shape", "high-low") not in NamedDraft("shirt").has_in_spirit


@pytest.mark.parametrize("name", ["shirt", "t-shirt", "tank-top", "turtleneck"])
def test_tops_may_be_longer_behind(name):
    dipped = hem_as_asked(NamedDraft(name), [Claim("hem_shape", "high-low")], (), ())
    assert ("hem_shape", "high-low") in dipped.is_to_the_eye
    low = [
        min(panel.to_world(panel.outline(0.5))[:, 1].min() for panel in made.panels if "btorso" in panel.name)
        for made in (swifttailor.draft(name), swifttailor.draft(name, **dict(dipped.options)))
    ]
    assert low[0] - low[1] == pytest.approx(8.0, abs=1.5)

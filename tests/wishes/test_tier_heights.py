"""How high the uppermost tier is told to be."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.pattern.drafts import draft
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.text.tier_heights import tier_as_said
from swifttailor.wishes.text.unread import unread_numbers


@pytest.mark.parametrize(
    ("named", "text", "first"),
    [
        ("tiered-skirt(length=75)", "a tiered skirt, first tier 30 cm. Total 75", 30.0),
        ("tiered-skirt(length=75)", "the top tier should be 10 inches", 25.4),
        (
            "tiered-skirt(length=64;tiers=2)",
            "two tiers, the top tier twice as long as the bottom one",
            40.0,
        ),
        ("tiered-skirt(length=64;tiers=2)", "two tiers, the second tier 20 cm", 40.0),
        ("tiered-skirt(length=64;tiers=2)", "a two-tier skirt", 26.4),
        ("tiered-skirt(length=64)", "a tiered skirt", None),
        ("tiered-skirt(length=64)", "first tier 90 cm", 44.0),
        ("circle-skirt(length=64)", "first tier 20 cm", None),
    ],
)
def test_the_uppermost_tier_is_as_high_as_told(named, text, first):
    assert dict(tier_as_said(NamedDraft.parse(named), text).options).get("first") == first


def test_two_tiers_are_fuller_where_nothing_is_said():
    assert (
        dict(tier_as_said(NamedDraft.parse("tiered-skirt(tiers=2)"), "two tiers").options)["fullness"] > 1.5
    )


def test_what_it_is_told_by_is_read():
    assert unread_numbers("a tiered skirt, first tier 30 cm", ()) == ()
    assert unread_numbers("a tiered skirt, 30 cm", ()) == ("30 cm",)


def test_the_skirt_is_cut_so():
    pattern = draft("tiered-skirt", length=74.0, first=30.0)
    heights = [np.ptp(pattern.panel(f"skirt_front{n}").vertices[:, 1]) for n in ("", "_0", "_1")]
    assert heights == pytest.approx([30.0, 20.0, 20.0], abs=0.1)


@pytest.mark.parametrize(
    ("text", "length"),
    [
        ("three-tier skirt, 25 cm a tier", 79.0),
        ("a skirt in three tiers, each tier 20 cm", 64.0),
        ("three tiers of 10 inches", 80.2),
        ("tiers 30 cm deep each", 94.0),
        ("three tiers, 25 cm", None),
    ],
)
def test_tiers_of_a_told_height_make_the_length(text, length):
    tiered = tier_as_said(NamedDraft.parse("tiered-skirt(tiers=3)"), text)
    assert dict(tiered.options).get("length") == length
    assert (unread_numbers(text, ()) == ()) == (length is not None)

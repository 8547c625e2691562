"""Wrap skirts that are cut from a part of a circle."""

from __future__ import annotations

import pytest

from swifttailor import draft
from swifttailor.describing import Claim, measure_facts
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.pattern.overlaps import lap_of_skirt, overlapping_fronts
from swifttailor.wishes.drafts.wound_skirts import wound_as_asked


@pytest.mark.parametrize(
    ("skirt", "fraction"),
    [("half circle", 0.5), ("flared", 0.5), ("three-quarter circle", 0.75), ("circle", 0.75)],
)
def test_they_are_as_wide_as_asked(skirt, fraction):
    (made,) = wound_as_asked([NamedDraft("wrap-skirt")], [Claim("skirt", skirt)])
    pattern = draft(made.name, length=75.0, **dict(made.options))
    assert dict(made.options) == {"fraction": fraction} and overlapping_fronts(pattern)
    assert Claim("skirt", "flared").holds(measure_facts(pattern)) or fraction > 0.5
    assert measure_facts(pattern).skirt.circle == pytest.approx(fraction, abs=0.06)


@pytest.mark.parametrize("claims", [[], [Claim("skirt", "a-line")], [Claim("skirt", "pencil")]])
def test_others_stay_as_they_are(claims):
    drafts = [NamedDraft("wrap-skirt"), NamedDraft("circle-skirt")]
    assert wound_as_asked(drafts, claims) == drafts


def test_a_front_that_lies_on_another_does_not_make_a_skirt_wider():
    less, more = (draft("wrap-skirt", fraction=0.5, overlap_under=u) for u in (8.0, 30.0))
    assert lap_of_skirt(more) > lap_of_skirt(less) + 20.0 and lap_of_skirt(draft("circle-skirt")) == 0.0
    circles = [measure_facts(pattern).skirt.circle for pattern in (less, more)]
    assert circles[0] == pytest.approx(circles[1], abs=0.05)


def test_the_lower_front_is_hardly_shorter_than_the_upper_one():
    pattern = draft("wrap-skirt", fraction=0.5, length=75.0)
    fronts = [pattern.panel(name) for pair in overlapping_fronts(pattern) for name in pair]
    upper, lower = (panel.to_world(panel.outline(0.5))[:, 1].min() for panel in fronts)
    assert 0.0 < lower - upper < 5.0

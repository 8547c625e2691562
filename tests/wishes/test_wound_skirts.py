"""Wrap skirts that are cut from a part of a circle."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely import LineString, Polygon

from swifttailor import draft
from swifttailor.describing import Claim, measure_facts
from swifttailor.pattern.check import check_pattern, errors_of
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


@settings(max_examples=12, deadline=None)
@given(
    petals=st.floats(3, 12),
    length=st.floats(36, 100),
    flare=st.floats(-6, 6),
)
def test_petals_part_in_the_middle_and_curve_away_to_the_hem(petals, length, flare):
    pattern = draft("wrap-skirt", petals=petals, length=length, flare=flare, hip_ease=10.0)
    assert not errors_of(check_pattern(pattern))
    ((upper, lower),) = overlapping_fronts(pattern)
    fronts = [Polygon(p.to_world(p.outline(0.2))[:, :2]) for p in map(pattern.panel, (upper, lower))]
    middle = LineString([(0, -50), (0, 200)])
    bottoms = [front.intersection(middle).bounds[1] for front in fronts]
    hem = min(front.bounds[1] for front in fronts)
    assert all(0.3 < bottom - hem < 26.0 for bottom in bottoms), "both edges leave the middle free"


def test_a_skirt_of_petals_is_measured_like_others():
    facts = measure_facts(draft("wrap-skirt", petals=4.0, flare=-5.0, hip_ease=10.0, length=57.0))
    assert Claim("skirt", "narrowing").holds(facts) and facts.length == pytest.approx(57.0, abs=1.5)

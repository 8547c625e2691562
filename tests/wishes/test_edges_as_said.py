"""Edges and hems of drafts by words that no claim has: straight across, to the thigh, gores from the knee."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.describing import measure_facts
from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.drafts.gored_drafts import gored_as_said
from swifttailor.wishes.drafts.low_skirts import low_as_asked
from swifttailor.wishes.drafts.straight_edges import straight_as_said
from swifttailor.wishes.drafts.tops_to_the_legs import to_the_legs_as_said


@pytest.mark.parametrize(
    ("named", "text", "dip"),
    [
        ("strapless-dress(flounce=true)", "a mermaid gown with a straight neckline", 0.0),
        ("bustier", "cut straight across", 0.0),
        ("strapless-dress", "a straight skirt and a heart neckline", None),
        ("strapless-dress", "a heart, not a straight neckline", None),
        ("t-shirt", "a straight neckline", None),
    ],
)
def test_an_upper_edge_is_straight_where_told(named, text, dip):
    assert dict(straight_as_said(NamedDraft.parse(named), text).options).get("dip") == dip


@pytest.mark.parametrize(
    ("named", "text", "length"),
    [
        ("t-shirt(length=38)", "a tunic reaching to about mid-thigh", 46.0),
        ("shirt(length=38)", "a shirt to the middle of the thigh", 46.0),
        ("tank-top(length=38)", "a knee-length tunic", 60.0),
        ("t-shirt(length=38)", "a tunic with slits to mid thigh", 38.0),
        ("t-shirt(length=22)", "a top, mid-thigh", 22.0),
        ("skater-dress(skirt_length=50)", "mid-thigh", None),
    ],
)
def test_long_tops_end_where_told(named, text, length):
    assert dict(to_the_legs_as_said(NamedDraft.parse(named), text).options).get("length") == length


def test_gores_flare_from_the_knee_where_told():
    named = [NamedDraft("mermaid-skirt"), NamedDraft.parse("gored-skirt(length=60)")]
    (gored,) = gored_as_said(named, "an eight-gore skirt, flared from the knee")
    options = dict(gored.options)
    assert gored.name == "gored-skirt" and options["close"] == 50.0 and options["length"] == 72.0
    assert gored_as_said(named, "an eight-gore skirt") == named
    assert gored_as_said(named[:1], "flared from the knee") == named[:1]


def test_such_gores_are_close_over_the_hips():
    facts = measure_facts(draft("gored-skirt", length=78.0, gores=8, close=50.0, hip_ease=2.5))
    assert facts.skirt is not None and facts.skirt.hips < 1.05 * facts.body.hip_girth


def test_such_gores_are_close_down_to_there():
    straight, flared = (draft("gored-skirt", length=90.0, flare=120.0, close=close) for close in (0.0, 55.0))
    panels = [pattern.panel("skirt_panel_0").vertices for pattern in (straight, flared)]
    widths = [np.ptp(p[:, 0]) for p in panels]
    assert widths[0] > widths[1] > 0.8 * widths[0]
    below = panels[1][:, 1].max() - panels[1][:, 1]
    knee = panels[1][np.abs(below - 51.0) < 1.0]
    assert len(knee) == 2 and np.ptp(knee[:, 0]) < 0.8 * widths[1], (below, panels[1])


@pytest.mark.parametrize(
    ("named", "claim", "below"),
    [
        ("circle-skirt(length=40)", Claim("rise", "low"), 14.0),
        ("circle-skirt", Claim("rise", "mid"), 5.0),
        ("circle-skirt", Claim("rise", "high"), None),
        ("gathered-skirt", Claim("rise", "low"), None),
    ],
)
def test_skirts_sit_on_the_hips_where_asked(named, claim, below):
    assert dict(low_as_asked(NamedDraft.parse(named), [claim]).options).get("below_waist") == below


def test_a_low_skirt_ends_where_a_high_one_does():
    high, low = (draft("circle-skirt", length=60.0, fraction=0.3, below_waist=low) for low in (0.0, 8.0))
    skirts, bands = ([p.panel(name).vertices for p in (high, low)] for name in ("skirt_front", "wb_front"))
    assert np.ptp(bands[1][:, 0]) > np.ptp(bands[0][:, 0]) + 0.5  # around the hips
    assert min(np.ptp(v[:, 1]) for v in skirts) == np.ptp(skirts[1][:, 1])

"""Seams keep the ratio of their sides: the equations of all corners at once against those row by row."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import plain_even_lengths as plain
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pattern_strategies import patterns

from swifttailor import draft
from swifttailor.pattern import Arc, Cubic
from swifttailor.refitting.even_lengths import keep_seam_ratios, with_corners


def grown(pattern, rng):
    """Other sizes of the same panels, by up to a fifth at each corner."""
    panels = []
    for panel in pattern.panels:
        vertices = panel.vertices * rng.uniform(0.8, 1.25) + rng.normal(0.0, 1.0, panel.vertices.shape)
        panels.append(with_corners(panel, vertices))
    return replace(pattern, panels=tuple(panels))


@settings(max_examples=40, deadline=None)
@given(patterns(), st.integers(0, 2**32 - 1))
def test_the_same_corners_to_the_last_bit(pattern, seed):
    after = grown(pattern, np.random.default_rng(seed))
    one, other = keep_seam_ratios(pattern, after), plain.keep_seam_ratios(pattern, after)
    assert one == other
    for a, b in zip(one.panels, other.panels, strict=True):
        assert a.vertices.tobytes() == b.vertices.tobytes()


@pytest.mark.parametrize("name", ["shirt-dress", "hoodie", "trousers"])
def test_drafts_come_out_alike_and_their_seams_fit(name):
    pattern = draft(name)
    after = grown(pattern, np.random.default_rng(5))
    settled = keep_seam_ratios(pattern, after)
    assert settled == plain.keep_seam_ratios(pattern, after)
    assert settled != after
    for stitch in pattern.stitches:
        was, now = (p.edge_length(stitch.first) / p.edge_length(stitch.second) for p in (pattern, settled))
        assert now == pytest.approx(was, rel=1e-3)


def test_arcs_go_with_their_chords_and_other_curves_stay_as_they_are():
    panel = draft("circle-skirt").panels[0]
    assert any(isinstance(edge.curve, Arc) for edge in panel.edges)
    wider = with_corners(panel, panel.vertices * 2)
    for old, new in zip(panel.edges, wider.edges, strict=True):
        if isinstance(old.curve, Arc):
            assert new.curve.radius == pytest.approx(2 * old.curve.radius)
        else:
            assert not isinstance(old.curve, Cubic) or new is old

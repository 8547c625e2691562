"""What is to be foreseen of a pattern is what the pattern is."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.pattern.drafts import draft, list_drafts
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.pattern_maker.asking.foresight import BOX, EDGES, OUTLINE, PLACEMENT, foresight_of
from swifttailor.pattern_maker.tokens.encode import encode
from swifttailor.pattern_maker.tokens.normalization import points_in_cm
from swifttailor.pattern_maker.tokens.placement_numbers import placement_numbers
from swifttailor.pattern_maker.tokens.vocabulary import PANEL_TOKENS, TOKENS

NAMES = [info.name for info in list_drafts() if {p.name for p in draft(info.name).panels} <= set(PANEL_NAMES)]
"""PatternMaker has no names for straps of halters, collars that are turned down, and strips of pleats."""


@pytest.mark.parametrize("name", NAMES)
def test_panels_their_places_and_their_sizes(name):
    pattern = draft(name).canonical()
    sequence = encode(pattern)
    foresight = foresight_of(sequence)
    assert foresight.present.tolist() == [float(t in sequence.tokens) for t in range(len(TOKENS))]
    rows = {TOKENS[PANEL_TOKENS.start + k]: k for k in range(len(PANEL_TOKENS))}
    there = {rows[f"<panel:{panel.name}>"] for panel in pattern.panels}
    assert set(np.flatnonzero(foresight.known.any(axis=1)).tolist()) == there
    for panel in pattern.panels:
        numbers, known = (a[rows[f"<panel:{panel.name}>"]] for a in (foresight.numbers, foresight.known))
        corners = panel.vertices - panel.vertices[0]
        if np.abs(corners).max() < 200:
            box = np.concatenate([corners.min(axis=0), corners.max(axis=0)]).reshape(2, 2)
            assert np.allclose(points_in_cm(numbers[BOX].reshape(2, 2)), box, atol=1e-3)
            some = corners[1:9].ravel()
            outline = points_in_cm(numbers[OUTLINE].reshape(-1, 2)).ravel()
            assert np.allclose(outline[: len(some)], some, atol=1e-3)
            assert known[OUTLINE].sum() == len(some)
        assert (numbers[EDGES] * 8).sum() == len(panel.edges)
        row = placement_numbers(panel.placement, corners, panel.vertices[0])
        assert np.allclose(numbers[PLACEMENT], row[:7], atol=1e-4)
        assert known[PLACEMENT].all() and known[BOX].all()

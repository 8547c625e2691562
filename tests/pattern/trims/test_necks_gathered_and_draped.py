"""Gathers around a neck, cords that are tied there, and the folds of cowls."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.pattern.drafts import draft
from swifttailor.pattern.trims import place_trims


def _put(name: str, trim: str, **options):
    from dataclasses import replace

    return place_trims(replace(draft(name, **options), trims=(trim,)))


def test_a_neck_is_gathered_in_front_and_behind_and_up_to_the_shoulders():
    folds = _put("t-shirt", "neck gathers", neck_widening=3.0, neck_depth=13.0)
    counts = {panel: sum(fold.panel == panel for fold in folds) for panel in {fold.panel for fold in folds}}
    assert set(counts) == {"left_ftorso", "right_ftorso", "left_btorso", "right_btorso"}
    assert min(counts.values()) >= 8
    for fold in folds:
        widths = np.linalg.norm(fold.second - fold.first, axis=1)
        assert fold.swell > 0.2 and widths[0] == widths.max() > 4 * widths[-1]


@pytest.mark.parametrize(("name", "loops"), [("t-shirt", True), ("skater-dress", True), ("hoodie", False)])
def test_a_cord_is_tied_where_no_hood_is(name, loops):
    pieces = _put(name, "neck cord")
    assert len(pieces) == (6 if loops else 2)


@pytest.mark.parametrize("name", ["slip-dress", "camisole", "t-shirt", "fitted-dress"])
def test_a_cowl_hangs_in_folds_that_meet_in_the_middle(name):
    options = {} if name in ("slip-dress", "camisole") else {"neck_widening": 3.0, "neck_depth": 13.0}
    folds = _put(name, "cowl folds", **options)
    assert len(folds) in (4, 6)
    for fold in folds:
        deep = np.linalg.norm(fold.second - fold.first, axis=1)
        assert fold.swell >= 1.5 and deep[0] > 2.5 and deep[0] == pytest.approx(deep.max(), rel=0.05)

"""Slits in legs, waistbands that rise behind, and straps that cross."""

from __future__ import annotations

import pytest

from swifttailor.pattern.drafts import draft
from swifttailor.pattern.pattern import EdgeRef
from swifttailor.pattern.trims.front_view import FrontView


def free_edges(pattern, panel):
    sewn = {side for stitch in pattern.stitches for side in stitch.sides}
    refs = [EdgeRef(panel, k) for k in range(len(pattern.panel(panel).edges))]
    return [ref for ref in refs if ref not in sewn]


@pytest.mark.parametrize(
    ("name", "length"), [("pull-on-trousers", 40.0), ("jeans", 78.0), ("leggings", 98.0)]
)
def test_slits_are_as_long_in_front_as_behind(name, length):
    pattern = draft(name, length=length, side_slits=8.0)
    for panel in ("pant_f_l", "pant_b_l"):
        shortest = min(pattern.edge_length(ref) for ref in free_edges(pattern, panel))
        assert shortest == pytest.approx(8.0, abs=0.05)


def test_the_waistband_rises_in_the_middle_of_the_back():
    tops = []
    for rise in (0.0, 4.0):
        middle = FrontView(draft("trousers", back_rise=rise).panel("wb_back")).column(0.0)
        tops.append(0.0 if middle is None else middle[1])
    assert tops[1] - tops[0] == pytest.approx(4.0, abs=0.05)


def test_straps_that_cross_end_on_the_other_side():
    for crossed in (False, True):
        pattern = draft("dungarees", crossed=crossed)
        strap = pattern.panel("left_btorso")
        low = min(strap.to_world(strap.outline(0.5)).tolist(), key=lambda point: point[1])
        assert (low[0] < 0) is crossed

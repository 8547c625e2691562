"""Yokes of skirts follow the hips, and gathered skirts widen to the hem."""

from __future__ import annotations

import pytest

from swifttailor.pattern.drafts import draft
from swifttailor.pattern.drafts.band import lay_yoke_or_band
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.flared_skirt import lay_gathered_skirt
from swifttailor.pattern.drafts.measurements import DraftMeasurements

FIGURE = Figure.of(DraftMeasurements())


@pytest.mark.parametrize("height", [8.0, 12.0, 20.0])
def test_a_yoke_is_as_wide_as_the_body_where_it_ends(height):
    table = CuttingTable("skirt")
    lower, high = lay_yoke_or_band(table, FIGURE, height, 4.0, 0.0)
    body = FIGURE.girth_below_waist(height).girth
    assert high == height and body < lower.girth < body + 3.0
    assert table.length("wb_front.top") == pytest.approx(2 * FIGURE.waist.front, abs=0.1)
    assert table.length("wb_front.bottom") == pytest.approx(2 * lower.front, abs=0.1)


def test_what_is_low_is_a_waistband():
    assert lay_yoke_or_band(CuttingTable("skirt"), FIGURE, 5.0, 4.0, 0.0)[1] == 4.0
    assert draft("gathered-skirt", yoke=5).panels == draft("gathered-skirt").panels


def test_gathered_skirts_widen_to_the_hem():
    table = CuttingTable("skirt")
    lay_gathered_skirt(table, FIGURE.waist, 60.0, 100.0, 2.0, 30.0)
    wider = table.length("skirt_front.bottom") - table.length("skirt_front.waist")
    assert wider == pytest.approx(15.0, abs=0.5)

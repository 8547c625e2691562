"""What the finished garment measures is told of the flat panels, in cm and inches, for each size."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.making.finished_measures import (
    MeasuresColumn,
    finished_column,
    finished_measures,
    in_inches,
    measures_table,
)
from swifttailor.making.pieces import cutting_plan
from swifttailor.making.sewing_steps import steps_markdown
from swifttailor.pattern.drafted_for import DraftedFor
from swifttailor.pattern.drafts import DraftMeasurements, draft


@given(st.floats(0.5, 400.0))
def test_inches_are_told_to_the_nearest_eighth(cm):
    parts = in_inches(cm).split()
    assert abs(float(sum(map(Fraction, parts))) - cm / 2.54) <= 1 / 16 + 1e-9


@pytest.mark.parametrize(("length", "sleeve"), [(10, 22), (30, 60)])
def test_a_t_shirt_measures_what_its_options_and_the_body_say(length, sleeve):
    found = finished_measures(draft("t-shirt", length=length, sleeve_length=sleeve))
    assert found["sleeve length"] == pytest.approx(sleeve, abs=0.2)
    longer = finished_measures(draft("t-shirt", length=length + 5, sleeve_length=sleeve))
    assert longer["length"] - found["length"] == pytest.approx(5, abs=0.1)
    narrow, wide = (
        finished_measures(draft("t-shirt", measurements=DraftMeasurements(bust=bust)))["chest"]
        for bust in (95, 105)
    )
    assert wide - narrow == pytest.approx(10, abs=0.5)


def test_each_kind_of_garment_has_its_own_measures():
    names = {
        name: list(finished_measures(draft(name))) for name in ("trousers", "circle-skirt", "shirt-dress")
    }
    assert names["trousers"] == ["upper edge", "hips", "thigh", "leg hem", "inside leg", "length"]
    assert names["circle-skirt"] == ["upper edge", "hips", "hem", "length"]
    assert names["shirt-dress"][:5] == ["chest", "waist seam", "hips", "hem", "length"]
    assert {"sleeve length", "sleeve width", "sleeve opening"} < set(names["shirt-dress"])


def test_the_waist_of_a_skirt_is_drawn_up_and_its_hem_is_not():
    skirt = finished_measures(draft("gathered-skirt"))
    assert skirt["upper edge"] < 0.7 * skirt["hem"]


def test_the_steps_have_a_table():
    text = steps_markdown(cutting_plan(draft("circle-skirt")))
    assert "## Finished garment\n\n| | cm | in |\n|---|---|---|\n| upper edge | " in text


def test_a_table_has_a_column_a_size_and_a_dash_where_one_lacks_a_measure():
    columns = [MeasuresColumn("36", {"chest": 100.0, "waist": 80.0}), MeasuresColumn("38", {"chest": 104.04})]
    assert measures_table(columns, inches=False) == [["chest", "100.0", "104.0"], ["waist", "80.0", "-"]]
    assert measures_table(columns, inches=True)[0] == ["chest", "39 3/8", "41"]


def test_a_pattern_for_nobody_is_still_printed_without_them_and_says_why():
    nobody = DraftedFor("nobody", None, (("bust", 60.0), ("waist", 120.0)))
    shirt = replace(draft("t-shirt"), drafted_for=nobody)
    assert finished_column(shirt) is None
    plan = cutting_plan(shirt)
    [finding] = [finding for finding in plan.findings if finding.code == "no-such-wearer"]
    assert "bust=60" in finding.message and "waist=120" in finding.message
    text = steps_markdown(plan)
    assert "## Finished garment" not in text
    assert finding.message in text.split("## Look at")[1]


def test_a_wearer_whom_there_is_is_no_finding():
    somebody = DraftedFor("somebody", None, (("bust", 96.0), ("waist", 80.0)))
    plan = cutting_plan(replace(draft("t-shirt"), drafted_for=somebody))
    assert not [finding for finding in plan.findings if finding.code == "no-such-wearer"]
    assert "## Finished garment" in steps_markdown(plan)

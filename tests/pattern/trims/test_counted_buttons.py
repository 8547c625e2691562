"""Rows of as many buttons as a pattern states."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from trim_checks import assert_on_panels, seen

from swifttailor.errors import PatternError
from swifttailor.pattern import read_specification, to_specification
from swifttailor.pattern.trims import TRIMS, Belt, Button, place_trims
from swifttailor.pattern.trims.names import COUNTED, MOST_BUTTONS, trim_said


def row(pattern, name: str, count: int, *more: str):
    placed = place_trims(replace(pattern, trims=(name, *more), button_count=count))
    assert_on_panels(pattern, placed)
    return [trim for trim in placed if isinstance(trim, Button) and trim.trim == name]


@pytest.mark.parametrize("count", [1, 2, 3, 4, 5, 7, 12, MOST_BUTTONS])
@pytest.mark.parametrize("name", ["buttons", "button placket"])
@pytest.mark.parametrize(
    "garment", ["waistcoat", "blazer", "cardigan", "shirt", "denim-jacket", "shirt-dress"]
)
def test_a_stated_number_is_put_on_one_below_the_other(garment, name, count, drafts):
    pattern = drafts[garment]
    found = row(pattern, name, count)
    assert len(found) == count
    heights = np.sort(np.concatenate([seen(pattern, button) for button in found])[:, 1])
    assert (np.diff(heights) > 2 * found[0].radius).all()


def test_the_buttons_of_a_dress_are_shared_by_bodice_and_skirt(drafts):
    found = row(drafts["shirt-dress"], "button placket", 10)
    panels = [button.panel for button in found]
    assert panels.count("skirt_front") >= 3 and len(set(panels)) == 2


@pytest.mark.parametrize(("stated", "made"), [(2, 2), (4, 4), (6, 6), (8, 8), (5, 6)])
def test_two_rows_have_them_in_pairs(stated, made, drafts):
    assert len(row(drafts["coat"], "double-breasted buttons", stated)) == made


def test_no_pair_is_hidden_by_a_belt(drafts):
    pattern = drafts["coat"]
    placed = place_trims(replace(pattern, trims=("double-breasted buttons", "tie belt"), button_count=6))
    (belt,) = [trim for trim in placed if isinstance(trim, Belt)]
    buttons = [trim for trim in placed if isinstance(trim, Button)]
    heights = np.concatenate([seen(pattern, button) for button in buttons])[:, 1]
    assert len(buttons) == 6 and heights.min() > belt.height + belt.width / 2


def test_a_waistcoat_is_closed_far_enough_for_five(drafts):
    found = row(drafts["waistcoat"], "buttons", 5)
    heights = np.sort(np.concatenate([seen(drafts["waistcoat"], button) for button in found])[:, 1])
    lowest = min(panel.to_world(panel.vertices)[:, 1].min() for panel in drafts["waistcoat"].panels)
    assert 3.0 < heights[1] - heights[0] < 6.0
    assert heights[0] - lowest < 14.0


@pytest.mark.parametrize("count", [0, 1, 7, MOST_BUTTONS])
def test_files_say_the_number(count, drafts):
    pattern = replace(drafts["shirt"], trims=("buttons",), button_count=count)
    written = json.loads(json.dumps(to_specification(pattern)))
    assert ("button_count" in written["properties"]) == bool(count)
    assert read_specification(written).pattern.button_count == count


@pytest.mark.parametrize("raw", [None, True, 0, -1, 21, 2.0, "4", [4], {}, 10**400, float("nan")], ids=str)
def test_anything_else_is_refused(raw, drafts):
    written = to_specification(drafts["shirt"])
    written["properties"]["button_count"] = raw
    with pytest.raises(PatternError, match=r"properties\.button_count: a whole number from 1 to 20"):
        read_specification(written)


def test_people_are_told_the_number():
    assert trim_said("buttons", 4) == "4 buttons down the front"
    assert trim_said("button placket", 1) == "a front band with 1 button"
    assert trim_said("double-breasted buttons", 6) == "two rows of buttons, 6 in all"
    assert [trim_said(name, 4) for name in TRIMS if name not in COUNTED] == [
        TRIMS[name] for name in TRIMS if name not in COUNTED
    ]
    assert all(trim_said(name) == TRIMS[name] for name in TRIMS)

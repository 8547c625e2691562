from __future__ import annotations

import re
from types import SimpleNamespace

import numpy as np
import pytest
import shapely
from draft_checks import assert_sound

import swifttailor
from swifttailor.pattern import PANEL_NAMES, Panel, Severity, check_pattern, load_pattern
from swifttailor.pattern.drafts import DraftMeasurements, draft, list_drafts
from swifttailor.pattern.names import OF_DRAFTS

EVERY = pytest.mark.parametrize("name", [d.name for d in list_drafts()])


def inside_points(panel: Panel) -> np.ndarray:
    """World points all over a panel, about 3 cm apart."""
    outline = shapely.Polygon(panel.outline(0.05))
    low, high = panel.bounding_box()
    grid = np.stack(np.meshgrid(np.arange(low[0], high[0], 3.0), np.arange(low[1], high[1], 3.0)), -1)
    points = grid.reshape(-1, 2)
    kept = points[shapely.contains_xy(outline, points)]
    return panel.to_world(np.concatenate([kept, panel.outline(0.05)]))


def inside_body(points: np.ndarray) -> np.ndarray:
    """Whether points lie in a coarse hull of the default body: torso and legs, head, arms."""
    x, y, z = points.T
    trunk = ((x / 19.5) ** 4 + (z / 15.5) ** 4 < 1) & (y < 142)  # its corners are round
    head = np.linalg.norm((points - [0.0, 160.0, 2.5]) / [9.5, 13.5, 13.0], axis=1) < 1
    start, end = np.array([18.0, 137.0, -2.5]), np.array([60.0, 95.0, 4.0])
    mirrored = np.stack([np.abs(x), y, z], axis=1)
    t = np.clip((mirrored - start) @ (end - start) / ((end - start) @ (end - start)), 0, 1)
    arms = np.linalg.norm(mirrored - (start + t[:, None] * (end - start)), axis=1) < 7
    return trunk | head | arms


@EVERY
def test_defaults_are_sewable(name):
    assert_sound(draft(name))


@EVERY
def test_stands_clear_of_the_body(name):
    for panel in draft(name).panels:
        assert not inside_body(inside_points(panel)).any(), panel.name


@EVERY
def test_panels_face_outward_on_their_side(name):
    for panel in draft(name).panels:
        middle = panel.to_world(panel.outline(0.05)).mean(axis=0)
        normal = panel.normal()
        assert normal @ [middle[0], 0.0, middle[2]] > 5.0, panel.name


ONE_SIDED = {"wrap-dress", "wrap-jumpsuit", "wrap-top", "blazer", "coat", "hooded-coat", "robe", "cardigan"}
"""The right front of these lies over the left one, or runs on to the left side, where the back has a joint
that the other side lacks."""


@EVERY
def test_left_and_right_are_mirror_images(name):
    pattern = draft(name)
    uneven = {p.name for p in pattern.panels if "torso" in p.name and name in ONE_SIDED}
    pairs = 0
    for panel in pattern.panels:
        twin = (
            panel.name.replace("left_", "right_")
            if "left_" in panel.name
            else re.sub("_l$", "_r", panel.name)
        )
        if twin == panel.name or panel.name in uneven:
            continue
        pairs += 1
        mine, other = (p.to_world(p.outline(0.01)) for p in (panel, pattern.panel(twin)))
        reflected = shapely.Polygon((mine * [-1.0, 1.0, 1.0])[:, :2])
        assert reflected.symmetric_difference(shapely.Polygon(other[:, :2])).area < 1e-6 * max(
            reflected.area, 1
        )
        assert panel.perimeter() == pytest.approx(pattern.panel(twin).perimeter())
    assert pairs > 0 or name.endswith(("skirt", "sarong"))


@EVERY
def test_names_labels_and_origins_are_garmentcodes(name):
    pattern = draft(name)
    assert {p.name for p in pattern.panels if not OF_DRAFTS.fullmatch(p.name)} <= set(PANEL_NAMES)
    for panel in pattern.panels:
        assert panel.label in ("body", "arm", "leg")
        np.testing.assert_array_equal(panel.vertices[0], [0.0, 0.0])
    sides = {
        side: label for s in pattern.stitches for side in s.sides if (label := edge_label(pattern, side))
    }
    for stitch in pattern.stitches:
        assert sum(side in sides for side in stitch.sides) < 2, "a label sits on one side of a seam"


def edge_label(pattern, side) -> str:
    return pattern.panel(side.panel).edges[side.edge].label


@EVERY
def test_round_trip_through_a_file_is_exact(name, tmp_path):
    pattern = draft(name)
    again = load_pattern(pattern.save(tmp_path / "pattern.json"))
    assert again.panels == pattern.panels
    assert again.stitches == pattern.stitches


@EVERY
def test_the_linter_finds_no_error(name):
    findings = check_pattern(draft(name))
    assert [f for f in findings if f.severity is not Severity.INFO] == []


@EVERY
def test_same_input_same_pattern(name):
    assert draft(name) == draft(name)


@EVERY
def test_takes_any_object_with_the_measurements(name):
    default = DraftMeasurements()
    other = SimpleNamespace(**{k: getattr(default, k) for k in DraftMeasurements.__dataclass_fields__})
    assert draft(name, measurements=other) == draft(name)


def test_root_package_offers_draft():
    assert swifttailor.draft("t_shirt").name == "t-shirt"

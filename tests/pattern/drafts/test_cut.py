"""What a tailor would measure on the flat pieces."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.pattern import Pattern
from swifttailor.pattern.drafts import DraftMeasurements, draft

BODY = DraftMeasurements()
NECK_Y = BODY.height - BODY.head_l
WAIST_Y = NECK_Y - BODY.waist_line


def extent(pattern: Pattern, name: str) -> np.ndarray:
    """World box of a panel [[min], [max]], cm."""
    world = pattern.panel(name).to_world(pattern.panel(name).outline(0.01))
    return np.array([world.min(axis=0), world.max(axis=0)])


def seam_length(pattern: Pattern, first: str, second: str) -> tuple[float, float]:
    """Lengths of all edges of `first` sewn to `second`, and the other way round, cm."""
    lengths = [0.0, 0.0]
    for stitch in pattern.stitches:
        sides = sorted(stitch.sides, key=lambda s: s.panel != first)
        if [s.panel for s in sides] == [first, second]:
            lengths[0] += pattern.edge_length(sides[0])
            lengths[1] += pattern.edge_length(sides[1])
    return lengths[0], lengths[1]


def labelled_length(pattern: Pattern, label: str) -> float:
    """Length of all edges with a label, cm."""
    return sum(p.edge_length(k) for p in pattern.panels for k, e in enumerate(p.edges) if e.label == label)


@pytest.mark.parametrize("ease", [2.0, 10.0, 30.0])
def test_t_shirt_chest_is_bust_plus_ease(ease):
    pattern = draft("t-shirt", chest_ease=ease, length=-10)
    widths = [np.diff(extent(pattern, n)[:, 0])[0] for n in ("left_ftorso", "left_btorso")]
    assert 2 * sum(widths) == pytest.approx(BODY.bust + ease, rel=1e-3)


@pytest.mark.parametrize("name", ["trousers", "fitted-skirt", "circle-skirt", "gathered-skirt"])
def test_waistband_is_waist_plus_ease(name):
    for ease in (-1.0, 0.0, 3.0):
        pattern = draft(name, waist_ease=ease)
        assert labelled_length(pattern, "lower_interface") == pytest.approx(BODY.waist + ease)


@pytest.mark.parametrize("name", ["fitted-dress", "shirt-dress", "jumpsuit"])
def test_waist_seam_is_waist_plus_ease(name):
    pattern = draft(name, waist_ease=5.0)
    assert labelled_length(pattern, "lower_interface") == pytest.approx(BODY.waist + 5.0)


@pytest.mark.parametrize("name", ["fitted-dress", "fitted-skirt"])
@pytest.mark.parametrize("length", [40.0, 60.0, 90.0])
def test_hem_hangs_where_asked_along_the_middle(name, length):
    option = "skirt_length" if name == "fitted-dress" else "length"
    pattern = draft(name, **{option: length})
    for panel in ("skirt_front", "skirt_back"):
        assert extent(pattern, panel)[0, 1] == pytest.approx(WAIST_Y - length, abs=0.6)


def test_skirt_hem_is_level_from_the_hips():
    """From hip to hem the side is as long as the middle, so a flared hem does not dip at the sides."""
    pattern = draft("fitted-skirt", flare=14.0, length=70)
    panel = pattern.panel("skirt_front")
    side = panel.edge_length(0)
    hip_y = WAIST_Y - BODY.hips_line
    middle = hip_y - extent(pattern, "skirt_front")[0, 1]
    assert side == pytest.approx(middle, rel=1e-3)


def test_hips_fit():
    pattern = draft("fitted-skirt", hip_ease=4.0, flare=0)
    widths = [np.diff(extent(pattern, n)[:, 0])[0] for n in ("skirt_front", "skirt_back")]
    assert sum(widths) == pytest.approx(BODY.hips + 4.0, rel=2e-3)


@pytest.mark.parametrize("fraction", [0.3, 0.5, 1.0, 1.5])
def test_circle_skirt_hem_follows_from_the_circle(fraction):
    pattern = draft("circle-skirt", fraction=fraction, length=60, band_height=4)
    waist = sum(seam_length(pattern, f"skirt_{p}", f"wb_{p}")[0] for p in ("front", "back"))
    hem = sum(pattern.panel(f"skirt_{p}").perimeter() for p in ("front", "back")) - waist - 4 * 56.0
    assert hem == pytest.approx(waist + 2 * np.pi * fraction * 56.0, rel=1e-6)


@pytest.mark.parametrize("fullness", [1.25, 2.0, 3.0])
def test_gathered_skirt_is_as_full_as_asked(fullness):
    pattern = draft("gathered-skirt", fullness=fullness)
    skirt, band = seam_length(pattern, "skirt_front", "wb_front")
    assert skirt / band == pytest.approx(fullness)


@pytest.mark.parametrize("name", ["t-shirt", "shirt-dress", "hoodie", "jumpsuit"])
@pytest.mark.parametrize("side", ["f", "b"])
def test_sleeve_cap_fits_the_armhole(name, side):
    options = {"sleeves": True} if name == "jumpsuit" else {}
    for ease in (0.0, 3.0, 6.0):
        if name != "hoodie":
            options["cap_ease"] = ease
        cap, hole = seam_length(draft(name, **options), f"left_sleeve_{side}", f"left_{side}torso")
        assert cap / hole == pytest.approx(1 + (0.01 if name == "hoodie" else ease / 100), rel=1e-6)


def test_longer_sleeves_make_longer_panels():
    spans = [
        np.diff(draft("t-shirt", sleeve_length=s).panel("left_sleeve_f").bounding_box()[:, 0])[0,]
        for s in (14.0, 30.0, 45.0, 60.0)
    ]
    np.testing.assert_allclose(spans, [14.0, 30.0, 45.0, 60.0])


@pytest.mark.parametrize("length", [50.0, 80.0, 105.0])
def test_trouser_hem_is_where_asked(length):
    pattern = draft("trousers", length=length)
    for panel in ("pant_f_l", "pant_b_l"):
        assert extent(pattern, panel)[0, 1] == pytest.approx(WAIST_Y - length)


def test_wider_legs_are_wider():
    hems = []
    for ease in (3.0, 12.0, 30.0):
        pattern = draft("trousers", leg_ease=ease)
        hems.append(sum(pattern.edge_length(ref) for ref in trouser_hems(pattern)))
    assert hems[0] < hems[1] < hems[2]


def trouser_hems(pattern):
    """The unsewn edges of the left leg."""
    sewn = {side for s in pattern.stitches for side in s.sides}
    from swifttailor.pattern import EdgeRef

    refs = [EdgeRef(n, k) for n in ("pant_f_l", "pant_b_l") for k in range(len(pattern.panel(n).edges))]
    return [r for r in refs if r not in sewn]


def test_back_crotch_is_longer_than_front():
    pattern = draft("trousers")
    front = seam_length(pattern, "pant_f_l", "pant_f_r")[0]
    back = seam_length(pattern, "pant_b_l", "pant_b_r")[0]
    assert front + 4 < back < front + 14


@pytest.mark.parametrize("name", ["t-shirt", "tank-top", "hoodie", "fitted-dress", "shirt-dress", "jumpsuit"])
def test_front_neck_is_lower_and_front_armhole_deeper(name):
    pattern = draft(name)
    centre = {p: seam_length(pattern, f"left_{p}torso", f"right_{p}torso")[0] for p in "fb"}
    assert centre["f"] < centre["b"]
    assert hollow(pattern, "left_ftorso") > hollow(pattern, "left_btorso") + 0.1


def hollow(pattern: Pattern, name: str) -> float:
    """How deep the armhole is cut behind the straight line between its ends, cm."""
    panel = pattern.panel(name)
    edge = next(k for k, e in enumerate(panel.edges) if e.label == "left_armhole")
    (start, end), points = panel.chord(edge), panel.flatten_edge(edge)
    along = (end - start) / np.linalg.norm(end - start)
    return float(np.abs((points - start) @ [-along[1], along[0]]).max())


def test_shoulders_slope():
    pattern = draft("t-shirt")
    ends = [
        pattern.panel("left_ftorso").to_world(pattern.panel("left_ftorso").chord(side.edge))
        for s in pattern.stitches
        for side in s.sides
        if {x.panel for x in s.sides} == {"left_ftorso", "left_btorso"} and side.panel == "left_ftorso"
    ]
    shoulder = max(ends, key=lambda e: e[:, 1].mean())
    run, fall, _ = np.abs(shoulder[1] - shoulder[0])
    assert np.degrees(np.arctan2(fall, run)) == pytest.approx(BODY.shoulder_incl, abs=1)


@pytest.mark.parametrize("height", [4.0, 10.0, 18.0])
def test_hood_covers_a_head(height):
    pattern = draft("hoodie", hood_height=height)
    low, high = extent(pattern, "left_hood")
    assert high[1] - (NECK_Y + 1) >= BODY.head_l + height - 1
    assert high[2] - low[2] > 0.9 * BODY.head_l


def test_options_of_the_hoodie_add_and_remove_panels():
    full = {p.name for p in draft("hoodie").panels}
    bare = {p.name for p in draft("hoodie", cuffs=False, hem_band=False).panels}
    assert full - bare == {"wb_front", "wb_back"} | {
        f"sl_{s}_cuff_{p}" for s in ("left", "right") for p in "fb"
    }


def test_larger_bodies_get_larger_clothes():
    small, large = (
        draft("fitted-dress", measurements=DraftMeasurements(bust=b, waist=b - 16, hips=b + 4))
        for b in (90.0, 110.0)
    )
    assert sum(abs(p.signed_area()) for p in small.panels) < sum(abs(p.signed_area()) for p in large.panels)


@pytest.mark.parametrize("name", ["blazer", "cardigan", "turtleneck", "waistcoat"])
def test_short_jackets_are_taken_in_by_darts_at_the_waist(name):
    """Without them, they hang from the bust like a shelf."""
    short = {"length": 8.0, "waist_shaping": 3.0}
    assert count_darts(draft(name, **short)) == 6  # two in each front, one in each back
    assert count_darts(draft(name, **{**short, "waist_shaping": 0.0})) == 0


def test_what_ends_lower_has_no_darts_from_its_hem():
    assert count_darts(draft("blazer", length=24.0)) == 0


def count_darts(pattern: Pattern) -> int:
    return sum(stitch.first.panel == stitch.second.panel for stitch in pattern.stitches)

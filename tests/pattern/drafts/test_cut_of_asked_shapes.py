"""What a tailor would measure on the shapes that options give to drafts: collars, wide legs, slits."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from test_cut import WAIST_Y, seam_length

from swifttailor.describing import Claim
from swifttailor.describing.differences import Gain
from swifttailor.describing.measuring import measure_facts
from swifttailor.pattern import Pattern
from swifttailor.pattern.drafts import draft
from swifttailor.wishes.assumed.well_within import well_within


@pytest.mark.parametrize("name", ["shirt", "fitted-dress", "shirt-dress"])
@pytest.mark.parametrize("height", [2.0, 4.0, 10.0])
def test_standing_collars_are_as_high_as_asked_on_a_close_neck(name, height):
    pattern = draft(name, collar="standing", collar_height=height)
    facts = measure_facts(pattern)
    assert any(Claim("collar", value).holds(facts) for value in ("stand", "turtleneck"))
    assert facts.collar is not None and facts.collar.height == pytest.approx(height, abs=0.1)
    seams = [seam_length(pattern, f"left_{p[0]}torso", f"left_collar_{p}") for p in ("front", "back")]
    assert all(collar == pytest.approx(neck, rel=1e-3) for neck, collar in seams)
    assert 35.0 < 2 * sum(neck for neck, _ in seams) < 50.0


@pytest.mark.parametrize("name", ["fitted-dress", "shirt-dress"])
def test_dresses_have_no_collar_unless_asked(name):
    panels = {p.name for p in draft(name).panels}
    assert {p.name for p in draft(name, collar="folded").panels} - panels == {
        f"{side}_collar_{part}" for side in ("left", "right") for part in ("front", "back")
    }


@pytest.mark.parametrize("leg_ease", [34.0, 45.0, 60.0])
def test_legs_wider_than_the_thigh_widen_evenly(leg_ease):
    panel = draft("trousers", leg_ease=leg_ease, flare=12.0).panel("pant_f_l")
    outline = shapely.Polygon(panel.outline(0.01))
    low, high = outline.bounds[1], outline.bounds[3]
    levels = low + np.array([1.0, 20.0, 40.0])
    widths = [outline.intersection(shapely.box(-99, y, 99, y + 0.1)).area / 0.1 for y in levels]
    assert high - low > 90.0 and widths[0] >= widths[1] >= widths[2]
    assert widths[0] - widths[1] == pytest.approx(widths[1] - widths[2], abs=1.5)


@pytest.mark.parametrize("slit", [0.0, 14.0, 30.0])
@pytest.mark.parametrize("name", ["t-shirt", "turtleneck", "shift-dress"])
def test_side_slits_leave_the_lower_end_of_the_sides_open(name, slit):
    length = 55.0
    whole, open_ = (draft(name, length=length, side_slits=s) for s in (0.0, slit))
    seams = [seam_length(p, "left_ftorso", "left_btorso")[0] for p in (whole, open_)]
    assert seams[0] - seams[1] == pytest.approx(slit)


def test_an_empire_seam_runs_under_the_bust_and_skirts_hang_between_the_arms():
    for ease in (1.0, 6.0, 16.0):
        pattern = draft("empire-dress", bust_ease=ease, waist_ease=ease, fullness=1.6)
        assert Claim("waist_seam", "empire").holds(measure_facts(pattern))
        top = pattern.panel("skirt_front").vertices[:, 1].max()
        upper = [x for x, y in pattern.panel("skirt_front").vertices if y > top - 1.0]
        assert 20.0 < (max(upper) - min(upper)) / 2 < 40.0


@pytest.mark.parametrize("length", [40.0, 70.0, 100.0])
def test_shifts_and_coats_end_where_they_are_asked_to(length):
    for name in ("shift-dress", "coat"):
        hem = measure_facts(draft(name, length=length)).hem
        assert hem is not None and hem.level == pytest.approx(WAIST_Y - length, abs=4.0)


def test_a_strapless_dress_may_be_close_to_the_floor():
    facts = measure_facts(draft("strapless-dress", fitted=True, skirt_length=92.0))
    assert Claim("shoulders", "strapless").holds(facts) and Claim("hips", "close").holds(facts)


@pytest.mark.parametrize("tiers", [2, 3, 6])
def test_tiers_are_of_one_height_and_each_is_gathered_into_the_one_above(tiers):
    pattern = draft("tiered-skirt", tiers=tiers, length=80.0, fullness=1.5, band_height=4.0)
    facts = measure_facts(pattern)
    assert facts.skirt is not None and facts.skirt.tiers == tiers
    names = ["skirt_front", *[f"skirt_front_{k}" for k in range(tiers - 1)]]
    heights = [np.ptp(pattern.panel(name).vertices[:, 1]) for name in names]
    assert heights == pytest.approx([76.0 / tiers] * tiers)
    for above, below in zip(["wb_front", *names], names, strict=False):
        fixed, gathered = seam_length(pattern, above, below)
        assert gathered == pytest.approx(1.5 * fixed, rel=1e-3)


def test_minis_and_hems_above_the_knee_are_well_within_their_words():
    for word, below_crotch in (("mini", 17.0), ("above the knee", 25.0)):
        facts = measure_facts(draft("skater-dress", skirt_length=60.0, skirt_fraction=0.4))
        (wish,) = well_within([Gain(Claim("skirt_hem", word))], facts)
        assert isinstance(wish, Gain) and wish.claim.name == "skirt_length_cm"
        shorter = 60.0 - float(wish.claim.value)
        assert facts.hem is not None and facts.hem.level + shorter > facts.body.crotch - below_crotch


@pytest.mark.parametrize("name", ["fitted-dress", "skater-dress", "jumpsuit", "halter-dress"])
def test_a_bare_back_is_bare_to_the_waist_and_beside_the_blades(name):
    options = {"back_fall": 18.0} if name == "halter-dress" else {"back_neck_depth": 38.0}
    panel = draft(name, **options).panel("left_btorso")
    outline = shapely.Polygon(panel.to_world(panel.outline(0.01))[:, :2])
    low = outline.bounds[1]

    def bare(above: float) -> float:
        """How far from the middle the cloth begins so high above the waist, cm."""
        return outline.intersection(shapely.LineString([(-60, low + above), (60, low + above)])).bounds[0]

    assert bare(1.5) < 1.0 and bare(6.0) > 5.0 and bare(13.0) > 9.0
    assert Claim("back_depth", "open").holds(measure_facts(draft(name, **options))) or "halter" in name


def underarm_seam(pattern: Pattern) -> np.ndarray:
    """(n, 3) along the underarm seam of the left sleeve, cm."""
    stitches = [
        s for s in pattern.stitches if {r.panel for r in s.sides} == {"left_sleeve_f", "left_sleeve_b"}
    ]
    panel = pattern.panel("left_sleeve_f")
    edges = [next(r.edge for r in s.sides if r.panel == panel.name) for s in stitches]
    seams = [panel.to_world(panel.sample_edge(edge, 41)) for edge in edges]
    return min(seams, key=lambda seam: seam[:, 1].mean())


def test_legs_of_mutton_are_close_from_above_the_elbow():
    mutton, plain = (
        underarm_seam(draft("shirt", sleeve_shape=shape, sleeve_length=60.0, sleeve_end=21.0, cuffs=False))
        for shape in ("puffed", "plain")
    )

    def bend(seam: np.ndarray) -> float:
        """How far the seam is from the straight way between its ends, cm."""
        way = (seam[-1] - seam[0]) / np.linalg.norm(seam[-1] - seam[0])
        from_start = seam - seam[0]
        return float(np.linalg.norm(from_start - np.outer(from_start @ way, way), axis=1).max())

    assert bend(mutton) > 2.0 and bend(plain) < 0.1


def test_long_balloon_sleeves_widen_to_their_cuffs():
    long, short = (draft("shirt", sleeve_shape="balloon", sleeve_length=length) for length in (60.0, 24.0))
    for pattern, wider in ((long, True), (short, False)):
        sleeve = measure_facts(pattern).left_sleeve
        assert (sleeve.end_width > sleeve.upper_width + 8.0) == wider
    assert Claim("sleeve_shape", "balloon").holds(measure_facts(long))


def test_sleeves_of_sweatshirts_balloon_above_their_cuffs():
    for garment in ("sweatshirt", "hoodie"):
        plain, full = (draft(garment, sleeve_shape=shape) for shape in ("plain", "balloon"))
        widths = [measure_facts(pattern).left_sleeve.end_width for pattern in (plain, full)]
        assert widths[1] > widths[0] + 30.0
        assert {panel.name for panel in plain.panels} == {panel.name for panel in full.panels}


def test_short_bell_sleeves_flutter_from_the_shoulder_on():
    def lean(length: float) -> float:
        """By how much a half of a sleeve is wider above the middle of the arm than its cap is, cm."""
        pattern = draft("t-shirt", sleeve_shape="bell", sleeve_length=length)
        sleeve = next(panel for panel in pattern.panels if panel.name == "left_sleeve_f")
        return float(np.ptp(np.asarray(sleeve.vertices)[:, 1]))

    assert lean(22.0) > lean(30.0) + 8.0


def test_long_wide_sleeves_widen_less_than_bells():
    plain, wide, bell = (
        measure_facts(draft("t-shirt", sleeve_shape=shape, sleeve_length=60.0)).left_sleeve.end_width
        for shape in ("plain", "wide", "bell")
    )
    assert plain + 15.0 < wide < bell - 8.0


def test_flounced_sleeves_end_in_frills():
    for length in (12.0, 22.0, 60.0):
        facts = measure_facts(draft("t-shirt", sleeve_shape="flounced", sleeve_length=length))
        assert Claim("cuffs", "flounce").holds(facts), length
        assert facts.left_sleeve.length > length - 0.5

"""Pieces to cut: their sew lines are the pattern's, their allowances whole, their notches in pairs."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.errors import InputError, PatternError
from swifttailor.making import Allowances, cutting_plan
from swifttailor.making.allowances import EdgeKind
from swifttailor.making.cut_line import Run, cut_line
from swifttailor.making.notch_check import notch_faults
from swifttailor.making.overlaps import allowance_faults
from swifttailor.pattern import EdgeRef, Pattern, Stitch


def area(points) -> float:
    return shapely.Polygon(points).area


def test_rectangles_are_cut_on_the_fold_with_their_allowances(skirt):
    plan = cutting_plan(skirt, Allowances(seam=1.5, hem=4.0, edge=0.7))
    (piece,) = plan.pieces
    assert piece.name == "Skirt" and set(piece.panels) == {"skirt_front", "skirt_back"}
    assert piece.instruction == "Cut 2 on the fold" and not piece.mirrored
    np.testing.assert_allclose(np.ptp(piece.cut.outline, axis=0), [50 + 3, 45 + 4.7], atol=1e-3)
    np.testing.assert_allclose(np.ptp(piece.sew_line, axis=0), [50, 45], atol=1e-3)
    assert area(piece.cut.outline) == pytest.approx(53 * 49.7, abs=0.1)
    assert [r.kind for r in piece.runs] == [EdgeKind.HEM, EdgeKind.SEAM, EdgeKind.TOP, EdgeKind.SEAM]
    low, high = piece.grain
    assert low[0] == high[0] and high[1] - low[1] > 20


def test_long_seams_have_notches_at_equal_shares(skirt):
    plan = cutting_plan(skirt)
    sides = [n for n in plan.pieces[0].notches if abs(abs(n.point[0]) - 25) < 1e-6]
    heights = sorted({round(float(n.point[1] - plan.pieces[0].sew_line[:, 1].min()), 3) for n in sides})
    assert heights == [15.0, 30.0] and len(sides) == 4


def test_no_allowance_is_broken_and_no_notch_alone(plans):
    for name, plan in plans.items():
        for piece in plan.pieces:
            assert allowance_faults(piece.runs, piece.cut) == [], (name, piece.name)
        assert notch_faults(plan) == [], name


@pytest.mark.parametrize(
    "widths", [Allowances(0, 0, 0, 0), Allowances(5, 8, 8, 5), Allowances(0, 3, 1.5, 0.5)]
)
def test_odd_allowances_are_whole_too(few_real_patterns, widths):
    for pattern in list(few_real_patterns.values())[:8]:
        plan = cutting_plan(pattern, widths)
        for piece in plan.pieces:
            assert allowance_faults(piece.runs, piece.cut) == [], (pattern.name, piece.name)
        if widths.seam == widths.hem == 0:
            for piece in plan.pieces:
                assert area(piece.cut.outline) == pytest.approx(area(piece.sew_line), rel=1e-3)


def test_sew_lines_are_the_panels_closed_over_darts(plans):
    for plan in plans.values():
        for piece in plan.pieces:
            panel = plan.sewn.pattern.panel((*piece.panels, *piece.mirrored)[0])
            darts = [d for d in plan.sewn.darts if d.panel == panel.name]
            own = shapely.make_valid(shapely.Polygon(panel.outline(0.002))).area
            if not darts:
                assert area(piece.sew_line) == pytest.approx(own, rel=1e-6)
            else:
                legs = [panel.chord(d.leg_in) for d in darts]
                outs = [panel.chord(d.leg_out) for d in darts]
                wedges = [area([a[0], a[1], b[1]]) for a, b in zip(legs, outs, strict=True)]
                assert own + 0.9 * sum(wedges) < area(piece.sew_line) < own + 1.4 * sum(wedges) + 0.1


def test_every_panel_is_cut_once(plans):
    for plan in plans.values():
        cut = Counter(n for p in plan.pieces for n in (*p.panels, *p.mirrored))
        assert cut == Counter(p.name for p in plan.sewn.panels)
        names = [p.name for p in plan.pieces]
        assert len(set(names)) == len(names)


def test_panels_of_one_piece_lie_on_each_other(plans):
    """Whether a panel is as drawn or mirrored is measured anew, from the outlines alone."""
    for plan in plans.values():
        for piece in plan.pieces:
            drawn = centred(piece_outline(plan, piece.panels[0]))
            for name in piece.panels:
                assert difference(centred(piece_outline(plan, name)), drawn) < 0.01
            for name in piece.mirrored:
                assert difference(centred(piece_outline(plan, name) * (-1.0, 1.0)), drawn) < 0.01
            if piece.symmetric:
                assert difference(centred(piece_outline(plan, piece.panels[0]) * (-1.0, 1.0)), drawn) < 0.01


def piece_outline(plan, name: str) -> np.ndarray:
    return plan.sewn.panel(name).outline


def centred(points: np.ndarray) -> shapely.Polygon:
    return shapely.make_valid(shapely.Polygon(points - (points.min(axis=0) + points.max(axis=0)) / 2))


def difference(a, b) -> float:
    return shapely.symmetric_difference(a, b).area / max(a.area, 1e-9)


def test_left_and_right_are_cut_mirrored(draft_plans):
    trousers = draft_plans["trousers"]
    assert {p.instruction for p in trousers.pieces if p.name.startswith("Trousers")} == {"Cut 2, mirrored"}


def test_darts_are_not_cut_open(shipped_plans):
    plan = shipped_plans["gc_1000272"]
    skirt = next(p for p in plan.pieces if p.name == "Skirt back")
    cloth = shapely.Polygon(skirt.cut.outline)
    assert len(skirt.darts) == 4
    for dart in skirt.darts:
        for leg in dart.legs:
            np.testing.assert_allclose(leg[-1], dart.legs[0][-1], atol=1e-6)
            assert cloth.exterior.distance(shapely.Point(leg[-1])) > 5
        mouth = (dart.legs[0][0] + dart.legs[1][0]) / 2
        assert cloth.exterior.distance(shapely.Point(mouth)) == pytest.approx(1.0, abs=0.3)
    # Folded, a dart reaches over the seam beside it, so its mouth peaks.
    assert skirt.sew_line[:, 1].max() > max(leg[0, 1] for d in skirt.darts for leg in d.legs)


def test_twins_with_other_seams_are_pieces_of_their_own(skirt):
    """A seam on one side of the back alone: the panels are no longer sewn alike."""
    pattern = replace(skirt, stitches=skirt.stitches[:1])
    plan = cutting_plan(pattern)
    assert not any(p.symmetric for p in plan.pieces)


CORNERS = st.lists(st.tuples(st.integers(-400, 400), st.integers(-400, 400)), min_size=3, max_size=9)


@settings(max_examples=150)
@given(CORNERS, st.lists(st.sampled_from(list(EdgeKind)), min_size=9, max_size=9), st.integers(0, 2**16))
def test_any_polygon_gets_a_whole_allowance(corners, kinds, seed):
    """In tenths of a centimetre."""
    hull = shapely.Polygon(
        sorted(np.array(corners).tolist(), key=lambda p: np.arctan2(p[1] - 0.1, p[0] - 0.1))
    )
    if not hull.is_valid or hull.area < 100.0 or hull.length / np.sqrt(hull.area) > 40:
        return
    points = shapely.get_coordinates(shapely.orient_polygons(hull).exterior)[:-1] / 10.0
    hull = shapely.Polygon(points)
    if np.hypot(*(np.roll(points, -1, axis=0) - points).T).min() < 0.05:
        return
    widths = np.random.default_rng(seed).uniform(0.0, 4.0, len(points))
    runs = [
        Run(np.array([points[k], points[(k + 1) % len(points)]]), kinds[k % 9], float(widths[k]), k)
        for k in range(len(points))
    ]
    made = cut_line(runs)
    assert allowance_faults(runs, made) == []
    away = shapely.distance(hull, shapely.points(made.outline))
    assert away.max() <= 6.0 * widths.max() + 0.01


def test_what_cannot_be_sewn_is_refused(skirt):
    with pytest.raises(PatternError, match="no panels"):
        cutting_plan(Pattern(()))
    twice = replace(
        skirt, stitches=(*skirt.stitches, Stitch(EdgeRef("skirt_front", 1), EdgeRef("skirt_back", 0)))
    )
    with pytest.raises(PatternError, match=r"cannot be sewn.*remove all but one of these stitches"):
        cutting_plan(twice)
    bowtie = replace(skirt.panels[0], vertices=[[-20, 0], [20, 60], [30, 0], [-20, 30]])
    with pytest.raises(PatternError, match="self-crossing"):
        cutting_plan(Pattern((bowtie,)))


@pytest.mark.parametrize("width", [-1.0, 11.0, float("nan"), float("inf")])
def test_absurd_allowances_are_refused(width):
    with pytest.raises(InputError, match="allowance"):
        Allowances(seam=width)

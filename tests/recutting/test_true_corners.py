"""Hems rounded at the side seams of flared skirts."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from swifttailor.describing.measuring import measure_facts
from swifttailor.pattern import Line, Pattern, check_pattern
from swifttailor.pattern import curve as curves
from swifttailor.pattern.drafts import draft
from swifttailor.recutting.level_hems import DIP_CM, level_hem
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.true_corners import _reach, true_corners


def with_straight_hem(skirt: Pattern) -> Pattern:
    """The skirt of whoever draws its hem with a ruler: its corners hang low."""
    panels = []
    for panel in skirt.panels:
        edges = list(panel.edges)
        if panel.name.startswith("skirt"):
            k = min(range(len(edges)), key=lambda k: panel.chord(k)[:, 1].mean())
            edges[k] = replace(edges[k], curve=Line())
        panels.append(replace(panel, edges=tuple(edges)))
    return replace(skirt, panels=tuple(panels))


@pytest.fixture(scope="module")
def pointed():
    return with_straight_hem(draft("fitted-skirt", flare=16, length=44))


def corner_angles(pattern: Pattern) -> list[float]:
    """Between hem and side seams, degrees."""
    found = []
    for panel in pattern.panels:
        if not panel.name.startswith("skirt"):
            continue
        count = len(panel.edges)
        k = min(range(count), key=lambda k: panel.chord(k)[:, 1].mean())
        hem = curves.derivative(panel.edges[k].curve, panel.chord(k), [0.0, 1.0])
        before = curves.derivative(panel.edges[k - 1].curve, panel.chord(k - 1), [1.0])[0]
        after = curves.derivative(panel.edges[(k + 1) % count].curve, panel.chord((k + 1) % count), [0.0])[0]
        for one, other in ((-before, hem[0]), (-hem[1], after)):
            cosine = one @ other / np.linalg.norm(one) / np.linalg.norm(other)
            found.append(float(np.degrees(np.arccos(cosine))))
    return found


def test_corners_become_right_angles_and_seams_still_fit(pointed):
    cutter = Cutter(pointed)
    assert cutter.facts.hem is not None and max(corner_angles(pointed)) < 76.0
    trued = true_corners(cutter, cutter.facts.hem.dip)
    assert trued is not None
    assert corner_angles(trued) == pytest.approx([90.0] * 4, abs=0.5)
    assert not [f for f in check_pattern(trued) if f.severity.name == "ERROR"]
    for stitch in trued.stitches:
        first, second = (trued.edge_length(side) for side in stitch.sides)
        assert first == pytest.approx(second, rel=1e-3)


def test_hems_with_low_corners_are_rounded_and_said_to_be(pointed):
    before = measure_facts(pointed).hem
    levelled, words = level_hem(pointed)
    after = measure_facts(levelled).hem
    assert before is not None and after is not None and before.dip > DIP_CM
    assert abs(after.dip) < 0.7 * before.dip and words.startswith("hem ")
    assert level_hem(levelled) == (levelled, "")


def test_what_is_true_already_stays():
    skirt = draft("fitted-skirt", flare=16, length=44)
    assert level_hem(skirt) == (skirt, "")


@pytest.mark.parametrize("dip", [DIP_CM, -DIP_CM])
def test_beside_a_side_that_goes_on_as_the_hem_does_nothing_is_drawn(dip):
    """No curve leaves it at a right angle and reaches the hem: control points were not finite."""
    toward = np.array([30.0, 0.0])
    assert _reach(np.array([12.0, 0.0]), toward, dip) is None
    assert _reach(np.array([12.0, 0.3]), toward, dip) is None
    reach = _reach(np.array([-4.0, 12.0]), toward, dip)
    assert reach is not None and np.isfinite(reach).all() and reach @ toward > 0

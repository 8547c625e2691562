"""Necklines closer to the neck than its base, V's to the waist, and the leaves of flat collars."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.describing.measuring import measure_facts
from swifttailor.pattern.drafts import draft


@pytest.mark.parametrize("name", ["t-shirt", "sweatshirt"])
def test_what_is_worn_every_day_has_a_crew_neck(name):
    neck = measure_facts(draft(name)).front_neck
    assert neck.width < 9.8 and 9.0 < neck.depth < 10.5


@pytest.mark.parametrize(("shape", "deep"), [("v", 31.0), ("square", 23.0), ("round", 23.0)])
def test_only_a_v_reaches_the_waist(shape, deep):
    neck = measure_facts(draft("fitted-dress", neckline=shape, neck_widening=1.0, neck_depth=32.0)).front_neck
    assert deep - 2.0 < neck.depth < deep + 1.0


@pytest.mark.parametrize("width", [4.0, 6.0, 8.0])
def test_the_leaves_of_a_flat_collar_part_in_front_and_end_round(width):
    leaf = draft("shirt", collar="flat", collar_width=width).panel("left_collar_front")
    outline = leaf.to_world(leaf.outline(0.1))
    low = outline[outline[:, 1].argmin()]
    middle = outline[np.abs(outline[:, 0]) < 0.05][:, 1].min()
    assert low[0] > 0.6 * width and middle - low[1] > 0.9 * width
    corner = outline[np.abs(outline[:, 1] - low[1]) < 0.25 * width]
    assert np.ptp(corner[:, 0]) > 0.8 * width


@pytest.mark.parametrize("collar", ["flat", "folded", "sailor"])
def test_collars_that_lie_are_laid_below_their_neckline(collar):
    dress = draft("shirt-dress", collar=collar)
    for face in ("f", "b"):
        torso = dress.panel(f"left_{face}torso")
        lies = dress.panel("left_collar_front" if face == "f" else "left_collar_back")
        high = [panel.to_world(panel.vertices)[:, 1].max() for panel in (torso, lies)]
        assert high[0] - high[1] == pytest.approx(5.0)

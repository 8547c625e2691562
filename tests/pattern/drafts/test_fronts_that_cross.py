"""Coats and robes whose fronts cross, jackets with other collars than lapels, cuffs of shift dresses."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import swifttailor
from swifttailor.pattern.trims import place_trims
from swifttailor.pattern.trims.front_view import is_closed_to_the_neck


@pytest.mark.parametrize(
    ("name", "options"),
    [("coat", {"opening": -18.0, "closed_to": 2.0}), ("robe", {"opening": -20.0, "front_slit": 60.0})],
)
@pytest.mark.parametrize("crossing", [0.0, 7.0])
def test_the_seam_runs_to_where_the_fronts_meet(name, options, crossing):
    pattern = swifttailor.draft(name, crossing=crossing, **options)
    assert not swifttailor.check(pattern)
    stitch = next(
        s for s in pattern.stitches if {x.panel for x in s.sides} == {"left_ftorso", "right_ftorso"}
    )
    for side in stitch.sides:
        panel = pattern.panel(side.panel)
        ends = panel.to_world(panel.chord(side.edge))
        low = ends[np.argmin(ends[:, 1])]
        assert low[0] == pytest.approx(crossing, abs=0.01)


@pytest.mark.parametrize("collar", ["none", "flat", "shirt", "standing", "mandarin"])
def test_jackets_close_to_the_neck_with_any_collar_but_lapels(collar):
    pattern = swifttailor.draft("blazer", collar=collar)
    assert not swifttailor.check(pattern)
    assert is_closed_to_the_neck(pattern)
    assert not is_closed_to_the_neck(swifttailor.draft("blazer"))


def test_shift_dresses_may_have_cuffs():
    pattern = swifttailor.draft("shift-dress", sleeves=True, cuffs=True, sleeve_length=60.0, collar="shirt")
    assert not swifttailor.check(pattern)
    assert any("cuff" in panel.name for panel in pattern.panels)


def test_pockets_of_a_robe_lie_beside_the_upper_front():
    pattern = swifttailor.draft("coat", opening=-18.0, closed_to=2.0, crossing=7.0, chest_ease=20.0)
    marked = place_trims(replace(pattern, trims=("patch pockets",)))
    assert {piece.panel for piece in marked} == {"left_ftorso", "right_ftorso"}

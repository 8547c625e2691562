"""What is worn on legs has a place in a photograph, where the network points at none."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.describing import Claim
from swifttailor.picture_reader.body_joints import ANKLES, HIPS, KNEES, PLACES, BodyJoints
from swifttailor.picture_reader.cloth_on_legs import (
    before_ground,
    reach_of,
    with_legs_before_ground,
    with_legs_of_joints,
)
from swifttailor.picture_reader.reading import PartReading, Statement

NOWHERE = np.zeros((300, 120), np.float32)
SHOWN = np.zeros_like(NOWHERE)
SHOWN[20:290, 30:90] = 1


def part(**said):
    told = tuple(Statement(Claim(name, word), 0.9) for name, word in said.items())
    return PartReading("lower", 0.9, told, (), (), NOWHERE)


def joints(seen=0.9):
    places = np.zeros((PLACES, 2))
    for which, y in ((HIPS, 100), (KNEES, 180), (ANKLES, 260)):
        places[list(which)] = (70, y), (50, y)
    return BodyJoints(places, np.full(PLACES, seen))


def test_cloth_reaches_as_far_as_what_was_read():
    shorts, trousers = reach_of(part(kind="shorts")), reach_of(part(kind="trousers"))
    assert shorts < reach_of(part(kind="trousers", leg_hem="calf")) < trousers
    mini, maxi = (reach_of(part(kind="skirt", skirt_hem=hem)) for hem in ("mini", "maxi"))
    assert 0 < mini < maxi <= trousers


@pytest.mark.parametrize("reach", [0.15, 0.75])
def test_legs_are_followed_from_the_hips_as_far_as_cloth_reaches(reach):
    found = with_legs_of_joints(NOWHERE, SHOWN, joints(), reach)
    rows = np.flatnonzero((found > 0.5).any(axis=1))
    assert rows[0] == pytest.approx(100, abs=12) and rows[-1] == pytest.approx(100 + 160 * reach, abs=12)
    assert (found[SHOWN == 0] == 0).all()


def test_what_is_pointed_at_and_legs_that_are_not_seen_stay():
    pointed_at = np.where(np.arange(300)[:, None] > 90, SHOWN, np.float32(0))
    assert with_legs_of_joints(pointed_at, SHOWN, joints(), 0.5) is pointed_at
    assert with_legs_of_joints(NOWHERE, SHOWN, joints(seen=0.2), 0.5) is NOWHERE


def test_before_a_plain_ground_everything_else_is_shown():
    pixels = np.full((300, 120, 3), 255, np.uint8)
    pixels[10:290, 40:80] = 20, 90, 160
    pixels[100:110, 55:60] = 255  # a button
    shown = before_ground(pixels)
    assert shown[10:290, 40:80].all() and shown.sum() == 280 * 40
    found = with_legs_before_ground(NOWHERE, pixels, 0.5)
    assert found.any() and (found[:40] == 0).all() and (found[200:] == 0).all()
    assert with_legs_before_ground(NOWHERE, np.full_like(pixels, 255), 0.5) is NOWHERE

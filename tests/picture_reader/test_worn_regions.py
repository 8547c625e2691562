"""Garments in photographs lie where they are worn."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.picture_reader.body_joints import HIPS, PLACES, SHOULDERS, BodyJoints
from swifttailor.picture_reader.worn_regions import on_their_places

SHAPE = 400, 200
SHOWN = np.zeros(SHAPE, np.float32)
SHOWN[20:380, 60:140] = 1


def joints(seen=0.9, tilted=0.0):
    """Shoulders at row 100, hips at row 200."""
    places, surely = np.zeros((PLACES, 2)), np.full(PLACES, seen)
    places[list(SHOULDERS)] = (130, 100 + tilted), (70, 100 - tilted)
    places[list(HIPS)] = (115, 200), (85, 200)
    return BodyJoints(places, surely)


def band(top, bottom):
    mask = np.zeros(SHAPE, np.float32)
    mask[top:bottom, 60:140] = 0.9
    return mask


def rows(mask):
    there = np.flatnonzero((mask > 0.5).any(axis=1))
    return (int(there[0]), int(there[-1]) + 1) if len(there) else None


def test_a_top_begins_at_the_shoulders_and_trousers_at_the_waist():
    found = on_their_places({"upper": band(40, 220), "lower": band(110, 380)}, SHOWN, joints(), hood=False)
    assert rows(found["upper"]) == (88, 220) and rows(found["lower"]) == (170, 380)
    hooded = on_their_places({"upper": band(40, 220)}, SHOWN, joints(), hood=True)
    assert rows(hooded["upper"]) == (40, 220)


@pytest.mark.parametrize("pointed_at", [band(30, 80), np.zeros(SHAPE, np.float32)])
def test_where_a_face_is_taken_for_a_top_the_chest_is_one(pointed_at):
    found = on_their_places({"upper": pointed_at}, SHOWN, joints(), hood=False)["upper"]
    assert rows(found) == (108, 186)
    columns = np.flatnonzero((found > 0.5).any(axis=0))
    assert columns[0] >= 69 and columns[-1] <= 131
    assert (found[SHOWN == 0] == 0).all()


def test_bare_legs_are_no_trousers():
    found = on_their_places({"lower": band(30, 80)}, SHOWN, joints(), hood=False)
    assert rows(found["lower"]) is None


def test_shoulders_that_are_not_seen_say_nothing():
    masks = {"upper": band(30, 80), "lower": band(30, 80)}
    found = on_their_places(masks, SHOWN, joints(seen=0.2), hood=False)
    assert all(found[name] is mask for name, mask in masks.items())


def test_a_leaning_torso_is_followed():
    flat = on_their_places({"upper": band(40, 220)}, SHOWN, joints(), hood=False)["upper"]
    leaning = joints()
    leaning.places[list(HIPS)] = (165, 200), (135, 200)
    found = on_their_places({"upper": band(40, 220)}, SHOWN, leaning, hood=False)["upper"]
    left, right = (np.flatnonzero(found[:, x] > 0.5)[0] for x in (62, 138))
    assert left > right, "the side that the hips lean away from begins lower"
    assert np.flatnonzero(flat[:, 62] > 0.5)[0] == np.flatnonzero(flat[:, 138] > 0.5)[0]

"""Hems near the knees are told by where joints are."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from swifttailor.describing.claims import Claim
from swifttailor.picture_reader.body_joints import BodyJoints
from swifttailor.picture_reader.leg_joints import LegJoints, default_landmarks
from swifttailor.picture_reader.reading import PartReading, PictureReading, Statement
from swifttailor.picture_reader.seen_hems import lowest_row, with_hems_near_knees
from swifttailor.render import Camera

JOINTS = LegJoints(hips=100.0, knees=200.0, ankles=300.0)
SQUARE, SIZE = (-20, 40, 512), 256


def places(hips=60.0, knees=110.0, ankles=160.0, seen=5.0):
    """What the network says of all joints: at these rows of what it is shown, so surely."""
    said = np.zeros((39, 5), np.float32)
    said[23:25, 1], said[25:27, 1], said[27:29, 1] = hips, knees, ankles
    said[:, 3] = seen
    return said


def legs(said):
    return LegJoints.of(BodyJoints.of(said, SQUARE, SIZE))


def part(name, kind, hem, bottom):
    mask = np.zeros((340, 60), np.float32)
    mask[40:bottom, 10:50] = 1
    mask[bottom : bottom + 60, 25:30] = 1  # a piece of a leg
    said = (Statement(Claim("kind", kind), 0.8), Statement(Claim("skirt_hem", hem), 0.6))
    return PartReading(name, 0.9, (*said, Statement(Claim("sleeves", "long"), 0.5)), (), (), mask)


def read(*parts):
    return PictureReading(parts, Camera((0.0, 100.0, 0.0), 180.0), (0, 0, 340, 340))


def likeliest(found, claim):
    return next(str(one.claim.value) for one in found.statements if one.claim.name == claim)


def test_levels_are_those_of_the_default_body():
    body = default_landmarks()
    assert JOINTS.level(100.0) == pytest.approx(body.hips)
    assert JOINTS.level(200.0) == pytest.approx(body.knee)
    assert JOINTS.level(150.0) == pytest.approx((body.hips + body.knee) / 2)
    assert 5 < JOINTS.level(300.0) < 10
    levels = [JOINTS.level(float(row)) for row in range(60, 320)]
    assert (np.diff(levels) < 0).all()


def test_joints_are_told_in_pixels_of_the_picture():
    found = legs(places())
    assert (found.hips, found.knees, found.ankles) == (40 + 120.0, 40 + 220.0, 40 + 320.0)
    half_hidden = places()
    half_hidden[25, 1:4] = 170.0, 0.0, -9.0  # a knee behind a bag
    assert legs(half_hidden).knees == pytest.approx(260.0, abs=0.1)


@pytest.mark.parametrize(
    "unseen", [places(seen=-3.0), places(knees=75.0), places(knees=50.0), places(ankles=100.0)]
)
def test_nothing_is_told_of_who_sits_or_is_not_seen(unseen):
    assert legs(unseen) is None


@pytest.mark.parametrize(
    ("bottom", "hem"),
    [
        (120, "mini"),
        (155, "mini"),
        (180, "above the knee"),
        (202, "knee"),
        (222, "below the knee"),
        (250, "midi"),
    ],
)
@pytest.mark.parametrize(("name", "kind"), [("upper", "dress"), ("lower", "skirt")])
def test_what_is_taken_for_a_short_one_ends_where_its_mask_does(name, kind, bottom, hem):
    (found,) = with_hems_near_knees(read(part(name, kind, "mini", bottom)), JOINTS).parts
    assert likeliest(found, "skirt_hem") == hem and likeliest(found, "kind") == kind
    certain = [one.certainty for one in found.statements]
    assert certain == sorted(certain, reverse=True) and max(certain) <= 1


def test_other_hems_are_seen_better_than_joints_tell():
    for hem in ("above the knee", "knee", "maxi"):
        given = part("upper", "dress", hem, 230)
        (found,) = with_hems_near_knees(read(given), JOINTS).parts
        assert found.statements == given.statements


def test_a_top_that_ends_above_the_knees_is_a_coat_where_something_is_worn_below():
    below = part("lower", "trousers", "mini", 290)
    for kind in ("top", "tunic"):
        coat, _ = with_hems_near_knees(read(part("upper", kind, "mini", 185), below), JOINTS).parts
        assert likeliest(coat, "kind") == "dress" and likeliest(coat, "skirt_hem") == "above the knee"
    short, _ = with_hems_near_knees(read(part("upper", "top", "mini", 130), below), JOINTS).parts
    assert likeliest(short, "kind") == "top"
    (alone,) = with_hems_near_knees(read(part("upper", "top", "mini", 185)), JOINTS).parts
    assert likeliest(alone, "kind") == "top"


def test_without_joints_all_stays():
    given = read(part("upper", "dress", "mini", 220))
    assert with_hems_near_knees(given, None) is given


def test_what_is_cut_off_ends_nowhere():
    mask = np.zeros((100, 40), bool)
    assert lowest_row(mask) is None
    mask[20:98, 5:30] = True
    assert lowest_row(mask) is None
    mask[90:] = False
    assert lowest_row(mask) == 89
    mask[90:95, 5:9] = True  # a foot
    assert lowest_row(mask) == 89
    mask[93:97, 5:30] = True  # a piece of a boot
    mask[92] = False
    mask[90:92] = False
    assert lowest_row(mask) == 89


@pytest.mark.parametrize(
    ("bottom", "said", "is_pair", "told"),
    [
        (125, "hip", True, "long"),
        (100, "hip", True, "hip"),
        (125, "high hip", True, "high hip"),
        (125, "hip", False, "hip"),
    ],
)
def test_tops_over_the_seat_are_long(bottom, said, is_pair, told):
    top = part("upper", "top", "knee", bottom)
    top = replace(top, statements=(*top.statements, Statement(Claim("top_hem", said), 0.7)))
    parts = (top, part("lower", "trousers", "knee", 310)) if is_pair else (top,)
    found = with_hems_near_knees(read(*parts), JOINTS).parts[0]
    assert likeliest(found, "top_hem") == told
    assert likeliest(found, "kind") == "top" and likeliest(found, "sleeves") == "long"

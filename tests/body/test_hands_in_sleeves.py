import numpy as np
import pytest

from swifttailor.body import Body, BodyPart
from swifttailor.body.hands_in_sleeves import Arm, hands_in_sleeves
from swifttailor.body.mannequin import mannequin
from swifttailor.body.measuring import arm_axis


def arm():
    """The left arm, of whose vertices those are that lie far out."""
    body = Body.default()
    joint, axis = arm_axis(body.vertices, body.faces, body.vertex_part, BodyPart.LEFT_ARM)
    length = float(((body.vertices[body.vertex_part == BodyPart.LEFT_ARM] - joint) @ axis).max())
    return Arm(joint, axis, length, np.flatnonzero(mannequin(body)[0][:, 0] > 35))


def tube(radius, *, end=1.1, turn=2 * np.pi):
    """A sleeve about the left arm down to `end` of its length, with a vertex every 2 cm."""
    joint, axis, length = arm().joint, arm().axis, arm().length
    across = np.linalg.svd(axis[None])[2][1:]
    angles = np.arange(0.0, turn, 2.0 / radius)
    ring = radius * np.stack([np.cos(angles), np.sin(angles)], axis=1) @ across
    return np.concatenate([joint + s * axis + ring for s in np.arange(0.4 * length, end * length, 2.0)])


def hand_of(vertices):
    """Distances of vertices from the left arm's line, places along it, and which are the hand's."""
    joint, axis, length = arm().joint, arm().axis, arm().length
    along = (vertices - joint) @ axis
    away = np.linalg.norm(vertices - joint - along[:, None] * axis, axis=1)
    return away, along, (along > 0.8 * length) & (along < 1.04 * length) & (away < 12)


@pytest.mark.parametrize("radius", [3.0, 4.0, 5.0])
def test_the_thumb_stays_in_a_sleeve(radius):
    there = mannequin(Body.default())[0]
    away, along, hand = hand_of(there)
    assert away[hand].max() > 5.0, "the thumb would come through"
    moved = hands_in_sleeves(there, tube(radius), [arm()])
    assert hand_of(moved)[0][hand].max() < radius - 0.5
    np.testing.assert_allclose(hand_of(moved)[1], along, atol=1e-9)
    np.testing.assert_array_equal(moved[there[:, 0] < 0], there[there[:, 0] < 0])


def test_beyond_the_end_of_the_sleeve_a_hand_is_as_it_was():
    there = mannequin(Body.default())[0]
    moved = hands_in_sleeves(there, tube(3.0, end=0.85), [arm()])
    beyond = hand_of(there)[1] > 0.9 * arm().length
    assert (moved != there).any() and beyond.sum() > 50
    np.testing.assert_array_equal(moved[beyond], there[beyond])


@pytest.mark.parametrize("cloth", [tube(11.0), tube(3.0, turn=np.pi)], ids=["wide", "only half around"])
def test_what_does_not_hold_a_hand_leaves_it_alone(cloth):
    there = mannequin(Body.default())[0]
    assert hands_in_sleeves(there, cloth, [arm()]) is there


def test_previews_show_hands_within_sleeves():
    there, moved = mannequin(Body.default())[0], mannequin(Body.default(), tube(4.0), tube(4.0))[0]
    hand = hand_of(there)[2]
    assert hand_of(moved)[0][hand].max() < 3.5 < hand_of(there)[0][hand].max()


def test_what_is_beside_a_hanging_arm_stays():
    there = mannequin(Body.default())[0]
    middle = there[np.abs(there[:, 0]) < 5].mean(axis=0)
    joint, axis = middle + np.array([0.0, 60.0, 0.0]), np.array([0.0, -1.0, 0.0])
    hanging = Arm(joint, axis, 75.0, arm().vertices)  # down the middle of the trunk
    levels = np.arange(45.0, 80.0, 2.0)
    angles = np.arange(0.0, 2 * np.pi, 0.4)
    ring = 4.0 * np.stack([np.cos(angles), 0 * angles, np.sin(angles)], axis=1)
    sleeve = np.concatenate([joint + level * axis + ring for level in levels])
    moved = hands_in_sleeves(there, sleeve, [hanging])
    others = np.setdiff1d(np.arange(len(there)), hanging.vertices)
    np.testing.assert_array_equal(moved[others], there[others])

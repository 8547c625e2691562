"""Bodies of other shapes in other poses."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.body import Body, BodyPart, body_for
from swifttailor.body.standing import carried_to
from swifttailor.errors import InputError


def hand(body: Body) -> np.ndarray:
    arm = body.vertices[body.vertex_part == BodyPart.LEFT_ARM]
    return arm[arm[:, 0].argmax()] if np.ptp(arm[:, 1]) < 40 else arm[arm[:, 1].argmin()]


@pytest.mark.parametrize("size", ["women 46", "men 52", "children 128"])
def test_arms_are_level_or_hang_and_the_feet_stay_on_the_floor(size):
    body = body_for(size=size)
    shoulder = body.measurements.shoulder_level
    level, _ = carried_to("T", body)
    assert abs(hand(level)[1] - shoulder) < 0.08 * body.measurements.height
    assert hand(level)[0] > hand(body)[0]
    down, _ = carried_to("down", body)
    assert abs(hand(down)[0]) < abs(hand(body)[0]) and hand(down)[1] < hand(body)[1]
    for stood in (level, down):
        assert stood.vertices[:, 1].min() == pytest.approx(0.0, abs=0.05)
        trunk = (body.vertex_part == BodyPart.TORSO) & (np.abs(body.vertices[:, 0]) < 6)
        assert np.abs(stood.vertices - body.vertices)[trunk].max() < 1.5
        bones = np.linalg.norm(hand(stood) - [0, shoulder, 0])
        assert bones == pytest.approx(np.linalg.norm(hand(body) - [0, shoulder, 0]), rel=0.08)


def test_other_meshes_and_poses_are_refused():
    default = Body.default()
    with pytest.raises(InputError, match="There is no pose"):
        carried_to("Y", default)
    own = Body.from_mesh(default.vertices[:, :] * 1.0, default.faces[::-1], name="mine")
    with pytest.raises(InputError, match="mesh of its own"):
        carried_to("T", own)


def test_the_sides_of_a_top_stay_on_the_trunk_when_arms_are_level():
    """In an A-pose the side of a top hangs near the arm, and would be lifted with it."""
    from swifttailor.body.rig import Rig
    from swifttailor.body.worn import garment_weights

    rig = Rig.default()
    arms = [rig.index(f"left_{name}") for name in ("arm", "arm_twist", "forearm", "hand")]
    level = Body.default().measurements.armpit_level
    side = np.array([[17.0, level - 8.0, 0.0], [17.5, level - 8.0, 1.0], [17.0, level - 9.0, 0.0]])
    sleeve = np.array(
        [[x, level - y, z] for x, y in ((25.0, 6.0), (30.0, 12.0), (40.0, 25.0)) for z in (-1, 1)]
    )
    points, faces = np.concatenate([side, sleeve]), np.array([[0, 1, 2], [3, 4, 5], [6, 7, 8]])

    def on_arm(off_arm):
        weights = garment_weights(rig, points, faces, off_arm)
        return (weights.share * np.isin(weights.carrier, arms)).sum(axis=1)

    before = on_arm(None)
    after = on_arm(np.array([9.0, 9.0, 10.0, *[0.0] * 6]))
    assert after[:3].max() < 0.02 and (after[:3] <= before[:3]).all()
    np.testing.assert_allclose(after[3:], before[3:], atol=1e-6)

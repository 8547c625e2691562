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

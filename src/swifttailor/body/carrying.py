"""A standing body and what it wears, carried into a pose and a shape.

Linear blend skinning: each joint has one affine map, which holds its turn and the sizes around it, and a
point moves by the mean of the maps of its carriers. The joints that bend most have a second map half way
between theirs and their parent's, so that elbows and knees keep their girth; sizes may differ from joint to
joint, which dual quaternions would not allow. What hangs follows the legs by shears.
"""

from __future__ import annotations

import functools
from collections.abc import Sequence

import numpy as np

from swifttailor.arrays import Array
from swifttailor.body.body import Body
from swifttailor.body.body_shape import BodyShape
from swifttailor.body.pose import Pose
from swifttailor.body.rig import HANGING, Rig, Weights
from swifttailor.errors import GeometryError

SOLE_CM = 4.0
"""The floor is touched by what is below this while the body stands."""


def carry(
    points: Array,
    rig: Rig,
    pose: Pose,
    shape: BodyShape | None = None,
    weights: Weights | None = None,
    *,
    sole: float = 0.0,
) -> Array:
    """Carries points along with the body that they belong to; its feet end on the floor.

    Args:
        points: (P, 3) positions on or around the standing default body, cm.
        rig: Its rig.
        pose: How it shall stand.
        shape: What sizes it shall have; None leaves them.
        weights: What `rig.weights_at(points)` or `garment_weights` gave; None looks them up, which takes
            ten times as long as the rest.
        sole: How high the soles of its shoes are, cm.

    Returns:
        (P, 3) float64 positions, cm. What would lie under the floor, as a long hem, lies on it.
    """
    kept = rig.weights_at(points) if weights is None else weights
    return carry_all([(points, kept)], rig, pose, shape, sole=sole)[0]


def carry_all(
    things: Sequence[tuple[Array, Weights]],
    rig: Rig,
    pose: Pose,
    shape: BodyShape | None = None,
    *,
    sole: float = 0.0,
) -> list[Array]:
    """Carries a body and all it wears in one go; see `carry`.

    Args:
        things: Points (P, 3) cm of each, and their weights.
        rig: The body's.
        pose: How it shall stand.
        shape: What sizes it shall have; None leaves them.
        sole: How high the soles of its shoes are, cm.

    Returns:
        (P, 3) float64 positions of each, cm.
    """
    from swifttailor.body.carrying_kernels import carry_points

    maps = carrier_maps(rig, pose, shape)
    maps[:, 7] += _lift(maps) + sole
    carried = []
    for points, kept in things:
        if len(points) != len(kept):
            raise GeometryError(f"{len(points)} points need as many weights, received {len(kept)}.")
        start = np.ascontiguousarray(points, np.float64)
        result = np.zeros_like(start)
        if carry_points(start, kept.carrier, kept.share, maps, result) < 0.0:
            np.maximum(result[:, 1], 0.0, out=result[:, 1])
        carried.append(result)
    return carried


def carrier_maps(rig: Rig, pose: Pose, shape: BodyShape | None = None) -> Array:
    """Affine maps of all carriers: of the joints, the halves and what hangs.

    Args:
        rig: The joints.
        pose: How they turn.
        shape: What sizes they have; None leaves them.

    Returns:
        (J + S + 4, 12) float64, see `carrying_kernels.carry_points`.
    """
    turns = pose.rotations(rig)
    sizes = np.broadcast_to(np.eye(3), turns.shape) if shape is None else shape.sizes(rig)
    turned = np.zeros_like(turns)
    places = np.zeros((rig.joint_count, 3))
    for j, parent in enumerate(rig.parents):
        if parent < 0:
            turned[j], places[j] = turns[j], rig.joints[j]
            continue
        turned[j] = turned[parent] @ turns[j]
        from_parent = sizes[parent] @ (rig.joints[j] - rig.joints[parent])
        places[j] = places[parent] + turned[parent] @ from_parent
    half = rig.softened
    above = np.asarray(rig.parents)[half]
    half_turned = turned[above] @ pose.rotations(rig, half=True)[half]
    linear = np.concatenate([turned @ sizes, half_turned @ (0.5 * (sizes[half] + sizes[above]))])
    anchors = np.concatenate([rig.joints, rig.joints[half]])
    places_of = np.concatenate([places, places[half]])
    upright, at = _hanging(rig, turned[rig.index("pelvis")], sizes, places)
    linear, anchors = np.concatenate([linear, upright]), np.concatenate([anchors, rig.joints[at]])
    shift = np.concatenate([places_of, places[at]]) - np.einsum("cij,cj->ci", linear, anchors)
    return np.concatenate([linear, shift[:, :, None]], axis=2).reshape(-1, 12)


def _hanging(rig: Rig, pelvis: Array, sizes: Array, places: Array) -> tuple[Array, Array]:
    """Shears (4, 3, 3) that follow the bones of legs and keep a hem level, and their joints (4,)."""
    at = np.array([rig.index(name) for name in HANGING])
    ends = np.array([rig.index(name.replace("shin", "foot").replace("thigh", "shin")) for name in HANGING])
    turn = np.arctan2(pelvis[0, 2], pelvis[2, 2])
    yaw = np.array([[np.cos(turn), 0, np.sin(turn)], [0, 1, 0], [-np.sin(turn), 0, np.cos(turn)]])
    linear = np.zeros((len(at), 3, 3))
    for k, (joint, end) in enumerate(zip(at, ends, strict=True)):
        bone, posed = rig.joints[end] - rig.joints[joint], places[end] - places[joint]
        # A leg that slants is thicker where a level plane cuts it.
        thicker = np.linalg.norm(posed) / max(abs(posed[1]), 1e-6)
        linear[k] = yaw * (sizes[joint][0, 0], 1.0, sizes[joint][2, 2] * min(thicker, 1.2))
        linear[k, :, 1] = (posed - linear[k] @ (bone * (1, 0, 1))) / bone[1]
    return linear, at


def _lift(maps: Array) -> float:
    from swifttailor.body.carrying_kernels import carry_points

    soles, kept = _soles()
    return -float(carry_points(soles, kept.carrier, kept.share, maps, np.zeros_like(soles)))


@functools.cache
def _soles() -> tuple[Array, Weights]:
    """What of the default body can touch the floor, and who carries it."""
    vertices = Body.default().vertices
    soles = np.ascontiguousarray(vertices[vertices[:, 1] < SOLE_CM])
    return soles, Rig.default().weights_at(soles)

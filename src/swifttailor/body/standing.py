"""Bodies of any shape in other poses than the A-pose they are made in, and what they wear carried along."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from swifttailor.arrays import Array
from swifttailor.body.body import Body
from swifttailor.body.carrying import carry
from swifttailor.body.limbs import arm, other_side
from swifttailor.body.pose import Pose
from swifttailor.body.rig import Rig
from swifttailor.body.worn import garment_weights
from swifttailor.errors import InputError

POSES = ("A", "T", "down")
_NEAR_CM = 7.0
"""A joint goes with the vertices that lie within so much of its own slice, at the least."""


def carried_to(
    pose: str,
    body: Body,
    cloth: Array | None = None,
    faces: Array | None = None,
    off_arm: Array | None = None,
) -> tuple[Body, Array | None]:
    """A body in another pose, and the garment that it wears.

    Args:
        pose: One of `POSES`; in ``T`` the arms are level, ``down`` they hang.
        body: In its A-pose, with the default body's mesh.
        cloth: (v, 3) vertices of a garment on it, cm.
        faces: (f, 3) of the garment.
        off_arm: (v,) how far its vertices are from the armhole, where it has sleeves (`garment_weights`).

    Raises:
        InputError: There is no such pose, or the body has a mesh of its own.
    """
    if pose not in POSES:
        raise InputError(f"There is no pose '{pose}'; there are {', '.join(POSES)}.")
    if pose == "A":
        return body, cloth
    default = Body.default()
    if not np.array_equal(body.faces, default.faces):
        raise InputError(
            f"The body '{body.name}' has a mesh of its own, and poses need the default body's. Give the body "
            "by its size or measures, or pose the mesh before."
        )
    rig = rig_of(body)
    angle = {"T": 90.0, "down": 14.0}[pose]
    lifted = arm(rig, out=angle, bend=2.0 if pose == "T" else 10.0)
    turns = Pose(lifted | other_side(lifted))
    skin = Rig.default().weights_at(default.vertices)
    stood = replace(body, vertices=carry(body.vertices, rig, turns, weights=skin))
    if cloth is None or faces is None:
        return stood, None
    # The field of weights is the default body's: cloth is looked up where it would lie on that.
    from scipy.spatial import KDTree

    _, nearest = KDTree(body.vertices).query(cloth)
    there = cloth + default.vertices[nearest] - body.vertices[nearest]
    worn = garment_weights(Rig.default(), there, faces, off_arm)
    return stood, carry(cloth, rig, turns, weights=worn)


def rig_of(body: Body) -> Rig:
    """The default rig with its joints where they are in a body with the default body's mesh."""
    rig, default = Rig.default(), Body.default()
    moves = body.vertices - default.vertices
    joints = np.array(rig.joints)
    for k, joint in enumerate(rig.joints):
        away = np.linalg.norm(default.vertices - joint, axis=1)
        near = away < max(_NEAR_CM, 1.3 * float(np.sort(away)[40]))
        # All around the joint, so that what is behind it counts as much as what is before.
        weight = 1.0 / np.maximum(away[near], 1.0) ** 2
        joints[k] = joint + (moves[near] * weight[:, None]).sum(axis=0) / weight.sum()
    return replace(rig, joints=joints)

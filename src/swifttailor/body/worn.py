"""Who carries a garment: the space around the body does, but for what the body alone does not tell.

Each trouser leg goes with its own leg alone, though it may touch the other; a skirt hangs from both; and a
bodice without sleeves leaves the arms alone, though it may be wide enough to touch them.
"""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Array
from swifttailor.body.rig import HANGING, Rig, Weights, mirrored_name

BELOW_CROTCH_CM = 74.0
"""A garment that falls into left and right below this level has legs; else it is a skirt."""
LEGS_CM = 68.0, 77.0
"""A trouser leg goes with its own leg below the first level, wholly, and above the second as space does."""
HANGS_CM = 68.0, 90.0
"""A skirt hangs below the first level, wholly, and above the second not at all."""
OFF_ARM_CM = 4.0
"""Trunk cloth so far from the armhole leaves the arm by two thirds."""
ARMHOLE_CM = 127.0, 139.0
"""A bodice without a sleeve leaves the arm alone below the first level; above the second it lies on the
shoulder and goes with it."""
SLEEVE_CM = 7.0, 2.0
"""A sleeve covers the upper side of the arm: some of it lies further from the shoulder than the first, and
further above the bone than the second."""
ONE_SIDE = 0.75
"""A trouser leg has at least this share of its vertices on its own side; wide ones cross the middle."""


def garment_weights(rig: Rig, vertices: Array, faces: Array, off_arm: Array | None = None) -> Weights:
    """Who carries the vertices of a garment that was sewn or draped on the standing default body.

    Args:
        rig: The body's.
        vertices: (P, 3) cm.
        faces: (M, 3) vertex indices.
        off_arm: (P,) how far each vertex is from the armhole on the side of the trunk, cm; 0 on the armhole
            and in sleeves. Where arms are lifted far, the sides of tops then stay on the trunk.

    Returns:
        Their weights, to be kept: they hold for every pose and shape.
    """
    dense = rig.dense_weights_at(vertices)
    side, is_skirt = legs_and_skirt(vertices, faces)
    for sign, own in ((1, "left"), (-1, "right")):
        strength = (side == sign) * _fading(vertices[:, 1], LEGS_CM)
        for joint in ("thigh", "shin", "foot", "toes"):
            mine = rig.index(f"{own}_{joint}")
            other = rig.index(mirrored_name(f"{own}_{joint}"))
            moved = strength * dense[:, other]
            dense[:, mine] += moved
            dense[:, other] -= moved
    for sign, own in ((1, "left"), (-1, "right")):
        if not has_sleeve(rig, vertices, sign):
            arm = [rig.index(f"{own}_{joint}") for joint in ("arm", "arm_twist", "forearm", "hand")]
            _leave(dense, arm, _fading(vertices[:, 1], ARMHOLE_CM), rig.index("chest"))
    if off_arm is not None:
        arms = [
            rig.index(f"{own}_{joint}")
            for own in ("left", "right")
            for joint in ("arm", "arm_twist", "forearm", "hand")
        ]
        _leave(dense, arms, 1.0 - np.exp(-((off_arm / OFF_ARM_CM) ** 2)), rig.index("chest"))
    hanging = np.zeros((len(vertices), len(HANGING)), dense.dtype)
    strength = is_skirt * _fading(vertices[:, 1], HANGS_CM)
    for k, name in enumerate(HANGING):
        joints = (
            [name] if name.endswith("thigh") else [name, *(name.replace("shin", n) for n in ("foot", "toes"))]
        )
        for joint in (rig.index(n) for n in joints):
            moved = strength * dense[:, joint]
            hanging[:, k] += moved
            dense[:, joint] -= moved
    return rig.strongest(dense, hanging)


def legs_and_skirt(vertices: Array, faces: Array) -> tuple[Array, Array]:
    """Which vertices belong to a trouser leg, and which to a garment with a skirt.

    Args:
        vertices: (P, 3) cm.
        faces: (M, 3) vertex indices.

    Returns:
        (P,) int8, 1 on the left leg, -1 on the right, 0 elsewhere; and (P,) bool, True all over a connected
        garment whose part below the crotch goes around both legs.
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    def pieces(kept: Array) -> Array:
        edges = kept[:, [0, 1, 1, 2]].reshape(-1, 2)
        graph = coo_array((np.ones(len(edges), np.int8), edges.T), shape=(len(vertices), len(vertices)))
        return connected_components(graph, directed=False)[1]

    below = vertices[:, 1] < BELOW_CROTCH_CM
    piece = pieces(faces[below[faces].all(axis=1)])
    size = np.bincount(piece[below], minlength=piece.max() + 1)
    left = np.bincount(piece[below], vertices[below, 0] > 0.0, minlength=piece.max() + 1)
    share = (left / np.maximum(size, 1))[piece]
    side = np.zeros(len(vertices), np.int8)
    side[below & (share >= ONE_SIDE)] = 1
    side[below & (share <= 1.0 - ONE_SIDE)] = -1
    whole = pieces(faces)
    around = np.bincount(whole[below & (side == 0)], minlength=whole.max() + 1)
    legs = np.bincount(whole[side != 0], minlength=whole.max() + 1)
    return side, (around > legs)[whole]


def has_sleeve(rig: Rig, vertices: Array, sign: int) -> bool:
    """Whether a garment covers an upper arm.

    Args:
        rig: The body's.
        vertices: (P, 3) cm.
        sign: 1 for the left arm, -1 for the right.
    """
    shoulder, elbow = rig.joints[rig.index("left_arm")], rig.joints[rig.index("left_forearm")]
    bone = (elbow - shoulder) / np.linalg.norm(elbow - shoulder)
    above = np.array([-bone[1], bone[0], 0.0]) / np.hypot(bone[0], bone[1])
    seen = vertices * (sign, 1.0, 1.0) - shoulder
    return int(((seen @ bone > SLEEVE_CM[0]) & (seen @ above > SLEEVE_CM[1])).sum()) >= 4


def _leave(dense: Array, joints: list[int], strength: Array, rest: int) -> None:
    """Takes a share (P,) of the weights (P, J) of some joints, and gives it to the others and to `rest`."""
    taken = strength[:, None] * dense[:, joints]
    dense[:, joints] -= taken
    others = np.setdiff1d(np.arange(dense.shape[1]), joints)
    dense[:, rest] += 1e-3
    dense[:, others] *= 1.0 + ((taken.sum(axis=1) - 1e-3) / dense[:, others].sum(axis=1))[:, None]


def _fading(level: Array, ends: tuple[float, float]) -> Array:
    t = np.clip((ends[1] - level) / (ends[1] - ends[0]), 0.0, 1.0)
    return t * t * (3 - 2 * t)

"""What of a body a picture may colour: lips, hands, the legs that tights would cover, and so on."""

from __future__ import annotations

from enum import IntEnum

import numpy as np

from swifttailor.arrays import Array
from swifttailor.body.rig import Rig


class SkinRegion(IntEnum):
    """Label of a point on the standing default body or its mannequin."""

    TRUNK = 0
    NECK = 1
    FACE = 2
    SCALP = 3
    """Where hair grows."""
    EYES = 4
    BROWS = 5
    LIPS = 6
    ARMS = 7
    HANDS = 8
    THIGHS = 9
    SHINS = 10
    FEET = 11


def skin_regions(points: Array) -> Array:
    """Labels points on the standing default body or its mannequin.

    Args:
        points: (P, 3) cm, on the surface.

    Returns:
        (P,) uint8 `SkinRegion`.
    """
    rig = Rig.default()
    dense = rig.dense_weights_at(points)
    table = np.zeros((rig.joint_count, len(SkinRegion)))
    for k, name in enumerate(rig.names):
        table[k, _REGION_OF.get(name.split("_", 1)[-1], SkinRegion.TRUNK)] = 1.0
    region = (dense @ table).argmax(axis=1).astype(np.uint8)
    x, y, z = np.abs(points[:, 0]), points[:, 1], points[:, 2]
    face = region == SkinRegion.FACE
    front = face & (z > 6.0)
    region[front & (np.hypot((x - 3.0) / 1.5, (y - 161.3) / 0.7) < 1.0)] = SkinRegion.EYES
    region[front & (np.hypot((x - 3.1) / 2.0, (y - 163.0) / 0.45) < 1.0)] = SkinRegion.BROWS
    region[front & (np.hypot(x / 2.5, (y - 153.6) / 1.0) < 1.0)] = SkinRegion.LIPS
    region[face & (y > 157.0 + 0.95 * z)] = SkinRegion.SCALP
    return region


_REGION_OF = {
    "neck": SkinRegion.NECK,
    "head": SkinRegion.FACE,
    "arm": SkinRegion.ARMS,
    "arm_twist": SkinRegion.ARMS,
    "forearm": SkinRegion.ARMS,
    "hand": SkinRegion.HANDS,
    "thigh": SkinRegion.THIGHS,
    "shin": SkinRegion.SHINS,
    "foot": SkinRegion.FEET,
    "toes": SkinRegion.FEET,
}

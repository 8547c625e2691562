"""How likely somebody in a photograph has bare arms and shins, and whether their legs are in it at all.

`scripts/fit_bare_limbs.py` writes the numbers.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Array, Pixels
from swifttailor.picture_reader.bare_skin import FOREARM, HAND_END, SHIN, UPPER_ARM, BareSkin, LimbColours
from swifttailor.picture_reader.body_joints import HIPS, KNEES, BodyJoints

FOREARMS_BARE = (-2.306, 1.014, -2.435, 0.675, 9.702)
"""Of how far the middle of forearms is from face and cloth, then the same of their end, and a summand."""
UPPER_ARMS_BARE = (-2.843, 0.780, 6.165)
SHINS_BARE = (-0.838, 0.730, 0.152)
"""Of how far upper arms are from face and cloth, and a summand; of shins the same."""
_MOST = 4.0
"""Nothing is told more surely than that: light makes cloth of skin."""


@dataclass(frozen=True)
class BareLimbs:
    """Logarithms of how much likelier limbs are bare than those of people are in general."""

    forearms: float = 0.0
    """0 where none is seen, here and below."""
    upper_arms: float = 0.0
    shins: float = 0.0
    knees_seen: float = 0.0
    """How sure the surer knee is in the picture, 0 to 1."""
    hips_seen: float = 0.0

    @staticmethod
    def of(pixels: Pixels, mask: NDArray[np.bool_], joints: BodyJoints) -> BareLimbs:
        """Looks at somebody.

        Args:
            pixels: (h, w, 3) sRGB.
            mask: (h, w) which show them.
            joints: Of them, in the same pixels.
        """
        seen = {"knees_seen": joints.surest(KNEES), "hips_seen": joints.surest(HIPS)}
        skin = BareSkin.of(pixels, mask, joints)
        if skin is None:
            return BareLimbs(**seen)
        signs = limb_signs(skin)
        weights = {"forearms": FOREARMS_BARE, "upper_arms": UPPER_ARMS_BARE, "shins": SHINS_BARE}
        bare = {
            name: float(np.clip(sign @ weights[name][:-1] + weights[name][-1], -_MOST, _MOST))
            for name, sign in signs.items()
            if sign is not None
        }
        return BareLimbs(**bare, **seen)


def limb_signs(skin: BareSkin) -> dict[str, Array | None]:
    """What the numbers above are multiplied with, by name; None where that limb is not seen."""
    middle, end = _mean(skin.arms(FOREARM)), _mean(skin.arms(HAND_END))
    middle, end = (end if middle is None else middle), (middle if end is None else end)
    forearms = None if middle is None or end is None else np.concatenate([middle, end])
    return {
        "forearms": forearms,
        "upper_arms": _mean(skin.arms(UPPER_ARM)),
        "shins": _mean(skin.legs(SHIN)),
    }


def _mean(limbs: Sequence[LimbColours]) -> Array | None:
    if not limbs:
        return None
    return np.mean([(one.to_face, one.to_cloth) for one in limbs], axis=0)

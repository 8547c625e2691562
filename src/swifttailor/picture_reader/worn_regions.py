"""Where on somebody in a photograph a garment can be, by joints.

Networks that know what is worn may still point at a face or at hair, where nothing but a chest is left below.
What is pointed at gives the garment its colour.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Array
from swifttailor.picture_reader.body_joints import HIPS, LEAST_SEEN, SHOULDERS, BodyJoints

Mask = NDArray[np.float32]
_ABOVE_SHOULDERS, _ABOVE_HIPS = 0.12, 0.3
"""How far above these a garment of the part below may begin, in heights of the torso."""
_CHEST = 0.08, 0.85
"""From where to where along the torso something worn there is most surely seen; the hips are at 1."""
_LEAST_WIDE, _INNER = 0.4, 0.5
"""Shoulders of somebody seen from aside, in heights of the torso; how far from the middle the chest goes."""
_LEAST = 0.2
"""Of the chest: where less of it is pointed at, all of it is."""


def on_their_places(
    masks: Mapping[str, Mask], shown: Mask, joints: BodyJoints, *, hood: bool
) -> dict[str, Mask]:
    """Masks of garments without what lies where they cannot be.

    Args:
        masks: (h, w) of `PARTS`, 0 to 1.
        shown: (h, w) how surely each pixel shows somebody, 0 to 1.
        joints: Of them.
        hood: Whether the upper garment has one.
    """
    if joints.surest(SHOULDERS) < LEAST_SEEN:
        return dict(masks)
    down, across = _along_torso(shown.shape, joints)
    found = dict(masks)
    if "upper" in found:
        if not hood:
            found["upper"] = np.where(down >= -_ABOVE_SHOULDERS, found["upper"], np.float32(0))
        place = (down >= _CHEST[0]) & (down <= _CHEST[1]) & (across <= _INNER)
        found["upper"] = _or_all_of(found["upper"], shown, place)
    if "lower" in found:
        found["lower"] = np.where(down >= 1 - _ABOVE_HIPS, found["lower"], np.float32(0))  # legs may be bare
    return found


def _along_torso(shape: tuple[int, ...], joints: BodyJoints) -> tuple[Array, Array]:
    """Where pixels (h, w) are along the torso, 0 at the shoulders and 1 at the hips, and how far aside.

    That is in widths of the shoulders.
    """
    neck, seat = joints.middle(SHOULDERS), joints.middle(HIPS)
    left, right = (joints.places[k] for k in SHOULDERS)
    high = max(float(np.hypot(*(seat - neck))), 1.0)
    wide = max(float(np.hypot(*(left - right))), _LEAST_WIDE * high)
    axis = (seat - neck) / high
    y, x = np.mgrid[: shape[0], : shape[1]]
    away = np.stack([x - neck[0], y - neck[1]], axis=-1)
    return away @ axis / high, np.abs(away @ np.array([-axis[1], axis[0]])) / wide


def _or_all_of(mask: Mask, shown: Mask, place: NDArray[np.bool_]) -> Mask:
    """A mask, or where hardly any of its place is in it all that is shown there."""
    there = place & (shown > LEAST_SEEN)
    pointed_at = (mask > LEAST_SEEN) & there
    if pointed_at.sum() >= _LEAST * there.sum():
        return mask
    return np.where(there, shown, np.float32(0))

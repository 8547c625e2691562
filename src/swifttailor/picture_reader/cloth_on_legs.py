"""Where on legs in a photograph what is worn there must be, where the network points at hardly anything.

Networks know that somebody wears a skirt and still do not say where: of every second garment on the legs that
shops show hardly a pixel was pointed at. What is pointed at gives the garment its colour and its print.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Pixels
from swifttailor.picture_reader.body_joints import ANKLES, HIPS, KNEES, LEAST_SEEN, BodyJoints
from swifttailor.picture_reader.plain_pictures import colour_around
from swifttailor.picture_reader.reading import PartReading

Mask = NDArray[np.float32]
_FAR: Mapping[str, Mapping[str, float]] = MappingProxyType(
    {
        "leg_hem": {"very short": 0.1, "mid-thigh": 0.2, "thigh": 0.25, "knee": 0.35, "calf": 0.6},
        "skirt_hem": {
            "micro": 0.1,
            "mini": 0.15,
            "above the knee": 0.25,
            "knee": 0.35,
            "below the knee": 0.4,
            "midi": 0.5,
            "maxi": 0.7,
            "ankle": 0.75,
            "floor": 0.75,
        },
    }
)
_FAR_OF_KINDS: Mapping[str, float] = MappingProxyType({"trousers": 0.75, "shorts": 0.15, "skirt": 0.15})
"""How far from the hips to the ankles there is cloth for sure, by where it ends, or by what it is alone."""
_LEAST = 0.2
"""Of the place: where less of it is pointed at, all of it is."""
_WIDE, _STEPS = 0.13, 24
"""Of legs that are surely covered: half their width in the length of a thigh; and places down a leg."""
_WAIST, _DOWN = 0.15, 0.8
"""Where somebody who is shown from the waist down has hips, and how far down from there the ankles are."""
_MIDDLE = 0.3
"""Of the width of what is shown in a row: as much is looked at on either side of its middle."""
_APART, _WHITE = 24, 12
"""Of 255: what is so far from the ground is no part of it; before white what is nearer is none."""


def reach_of(part: PartReading) -> float:
    """How far down there is cloth for sure: 0 at the hips, 1 at the ankles."""
    likeliest: dict[str, str] = {}
    for one in part.statements:  # surest first
        likeliest.setdefault(one.claim.name, str(one.claim.value))
    kind = likeliest.get("kind", "")
    told = _FAR_OF_KINDS.get(kind, min(_FAR_OF_KINDS.values()))
    claim = "skirt_hem" if kind == "skirt" else "leg_hem"
    return _FAR[claim].get(likeliest.get(claim, ""), told)


def with_legs_of_joints(mask: Mask, shown: Mask, joints: BodyJoints, reach: float) -> Mask:
    """The mask of what is worn on legs; where hardly any of it lies along them, what is shown there.

    Args:
        mask: (h, w) 0 to 1.
        shown: (h, w) how surely each pixel shows somebody, and no garment above, 0 to 1.
        joints: Of them.
        reach: See `reach_of`.
    """
    place = np.zeros(mask.shape, np.bool_)
    for hip, knee, ankle in zip(HIPS, KNEES, ANKLES, strict=True):
        if joints.seen[[hip, knee]].min() < LEAST_SEEN:
            continue
        thigh, shin = (joints.places[b] - joints.places[a] for a, b in ((hip, knee), (knee, ankle)))
        wide = max(_WIDE * float(np.hypot(*thigh)), 1.0)
        for along in np.linspace(0, 2 * reach, _STEPS):
            middle = joints.places[hip] + min(along, 1) * thigh + max(along - 1, 0) * shin
            _mark_disc(place, middle, wide)
    return _or_all_of(mask, shown, place)


def with_legs_before_ground(mask: Mask, pixels: Pixels, reach: float) -> Mask:
    """The same where nobody is found before a plain ground: of a picture from the waist down.

    Args:
        mask: (h, w) 0 to 1.
        pixels: (h, w, 3) sRGB.
        reach: See `reach_of`.
    """
    shown = before_ground(pixels)
    rows = np.flatnonzero(shown.any(axis=1))
    if not len(rows):
        return mask
    high = rows[-1] + 1 - rows[0]
    first = rows[0] + _WAIST * high
    place = np.zeros(mask.shape, np.bool_)
    for y in rows[(rows >= first) & (rows <= first + reach * _DOWN * high)]:
        columns = np.flatnonzero(shown[y])
        middle, aside = (columns[0] + columns[-1]) / 2, _MIDDLE * (columns[-1] - columns[0])
        place[y, round(middle - aside) : round(middle + aside) + 1] = True
    return _or_all_of(mask, shown.astype(np.float32), place)


def before_ground(pixels: Pixels) -> NDArray[np.bool_]:
    """(h, w) what is not of the colour of the ground around it, and what that encloses."""
    from scipy import ndimage

    ground = colour_around(pixels)
    apart = np.abs(pixels.astype(np.int16) - ground).max(axis=2)
    shown = apart > (_WHITE if ground.min() > 255 - _WHITE else _APART)
    pieces, count = ndimage.label(shown)
    if not count:
        return shown
    largest = pieces == 1 + int(np.bincount(pieces.ravel())[1:].argmax())
    return np.asarray(ndimage.binary_fill_holes(largest))


def _or_all_of(mask: Mask, shown: Mask, place: NDArray[np.bool_]) -> Mask:
    there = place & (shown > LEAST_SEEN)
    if not there.any() or ((mask > LEAST_SEEN) & there).sum() >= _LEAST * there.sum():
        return mask
    return np.where(there, shown, np.float32(0))


def _mark_disc(place: NDArray[np.bool_], middle: NDArray[np.float64], radius: float) -> None:
    high, wide = place.shape
    left, top = (max(int(v - radius), 0) for v in middle)
    right, bottom = min(int(middle[0] + radius) + 1, wide), min(int(middle[1] + radius) + 1, high)
    if left < right and top < bottom:
        y, x = np.mgrid[top:bottom, left:right]
        place[top:bottom, left:right] |= np.hypot(x - middle[0], y - middle[1]) <= radius

"""Hems that end near the knees of somebody in a photograph, by where their joints are.

Networks see most hems better than joints tell, but they take coats to the knee for short ones, or for tops,
and long tops for those of the usual length.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr

from swifttailor.describing.claims import Claim
from swifttailor.describing.claims.hems import SKIRT_ZONES
from swifttailor.picture_reader.leg_joints import LegJoints, default_landmarks
from swifttailor.picture_reader.reading import PartReading, PictureReading, Statement

_SHORT = frozenset({"micro", "mini"})
_TOPS = frozenset({"top", "tunic"})
_OFF_CM = 5.0
"""How far levels that are told by joints and mask are off (standard deviation)."""
_ABOVE_KNEE_CM = 14.0
"""So far above the knee a hem is near it; no top ends as low."""
_LOWEST_CM = 15.0
"""What ends lower is hardly a coat that is taken for a short one: its mask runs over trousers and boots."""
_LEAST_WIDE, _USUAL = 0.4, 90.0
"""A garment goes down to where it is that wide, in the width that a tenth of its rows exceeds: below are
pieces of legs."""
_LEAST_PIECE = 0.15
"""Smaller pieces, in the size of the largest, are boots and bags."""
_AT_EDGE = 4
"""Rows from the edge of the picture: what ends there is cut off."""
_LONG_CM = (-24.0, -4.0)
"""Tops that end so far above (below, if negative) the hips are long ones, where networks see the usual."""
_LONG = [Statement(Claim("top_hem", "long"), 0.6), Statement(Claim("top_hem", "hip"), 0.3)]
_SURE, _LEAST = 0.75, 0.03
"""How sure it is that what ends at the knees is no top; what is less sure is not told."""


def with_hems_near_knees(read: PictureReading, joints: LegJoints | None) -> PictureReading:
    """What is read of somebody, with the length of coats, dresses and skirts that are taken for short ones.

    Args:
        read: Whose masks show what is worn.
        joints: Of who wears it; None where they are not seen.
    """
    if joints is None:
        return read
    is_pair = len(read.parts) == 2
    parts = tuple(_with_hem(part, joints, is_pair=is_pair) for part in read.parts)
    return replace(read, parts=parts)


def _with_hem(part: PartReading, joints: LegJoints, *, is_pair: bool) -> PartReading:
    said = {one.claim.name: str(one.claim.value) for one in reversed(part.statements)}  # the surest is last
    row = lowest_row(part.mask > 0.5)
    if row is None:
        return part
    level = joints.level(row)
    if is_pair and part.part == "upper" and said.get("top_hem") == "hip" and _is_long(level):
        return replace(part, statements=_surest_first(_without(part, "top_hem") + _LONG))
    above = level - default_landmarks().knee
    if level < _LOWEST_CM or above > _ABOVE_KNEE_CM:
        return part
    found = list(part.statements)
    if is_pair and part.part == "upper" and said.get("kind") in _TOPS and above > 0:
        found = _without(part, "kind")
        found.append(Statement(Claim("kind", "dress"), _SURE))
    if said.get("skirt_hem") in _SHORT:
        found = [one for one in found if one.claim.name != "skirt_hem"]
        found += _hems_at(level)
    return replace(part, statements=_surest_first(found))


def _is_long(level: float) -> bool:
    """Whether a top that ends at a level is worn over the seat, and no jacket of which the mask runs on."""
    low, high = _LONG_CM
    return low <= level - default_landmarks().hips <= high


def _without(part: PartReading, claim: str) -> list[Statement]:
    return [one for one in part.statements if one.claim.name != claim]


def _surest_first(found: list[Statement]) -> tuple[Statement, ...]:
    return tuple(sorted(found, key=lambda one: -one.certainty))


def lowest_row(mask: NDArray[np.bool_]) -> int | None:
    """The row in which a garment ends; None where it is cut off by the picture's edge, or not there.

    Args:
        mask: (h, w) where it is; pieces that are far smaller than the largest do not count.
    """
    from scipy import ndimage

    pieces, count = ndimage.label(mask)
    if count > 1:
        sizes = np.bincount(pieces.ravel())[1:]
        mask = np.isin(pieces, 1 + np.flatnonzero(sizes >= _LEAST_PIECE * sizes.max()))
    wide = mask.sum(axis=1)
    if not wide.any():
        return None
    usual = float(np.percentile(wide[wide > 0], _USUAL))
    row = int(np.flatnonzero(wide > _LEAST_WIDE * usual)[-1])
    return None if row >= len(mask) - _AT_EDGE else row


def _hems_at(level: float) -> list[Statement]:
    """How sure each word for a hem is of a level that is told so roughly."""
    found = []
    for word, zone in SKIRT_ZONES.items():
        low, high = zone(default_landmarks())
        sure = float(ndtr((high - level) / _OFF_CM) - ndtr((low - level) / _OFF_CM))
        if sure >= _LEAST:
            found.append(Statement(Claim("skirt_hem", word), sure))
    return found

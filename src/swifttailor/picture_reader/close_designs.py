"""Which design parameters each close-up tells."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from swifttailor.picture_reader.close_ups import CLEAR_COSINE, CLOSE_UPS, WHOLE

ASYMMETRIC = "left.enable_asym"
"""The parameter that says whether the left side of a garment has parameters of its own."""
_LEFT = "left."
_TOLD: dict[str, tuple[str, ...]] = {
    "neck": ("collar.", "shirt.strapless"),
    "waist": ("meta.wb", "waistband."),
    "sleeve": ("sleeve.cuff.", "sleeve.end_width"),
    "leg": ("pants.cuff.",),
    "skirt": ("meta.bottom", "skirt.", "flare-skirt.", "godet-skirt.", "pencil-skirt.", "levels-skirt."),
    "armhole": (
        "sleeve.sleeveless",
        "sleeve.armhole_shape",
        "sleeve.connecting_width",
        "sleeve.connect_ruffle",
        "sleeve.standing_shoulder",
        "sleeve.smoothing_coeff",
        "shirt.strapless",
    ),
}
"""Beginnings of the names of parameters, by `CloseUp.part`; those of the left side follow `_LEFT`."""
_NOT_TOLD = (".rise",)
_BEHIND = ("collar.b_", "collar.bc_", "pencil-skirt.back_")
_BEFORE = ("collar.f_", "collar.fc_", "pencil-skirt.front_")
"""What cannot be seen from the other side."""

Mask = NDArray[np.bool_]


def sees_designs(
    close_up: NDArray[np.int64], cosine: NDArray[np.floating], asymmetric: Mask, parameters: tuple[str, ...]
) -> Mask:
    """Which design parameters pictures tell.

    The left side of a garment that is the same on both sides tells what the right one does.

    Args:
        close_up: (n,) numbers of `CLOSE_UPS`, or `WHOLE`, of which all is asked from everywhere.
        cosine: (n,) of the azimuth from which each looks, 1 in front of the wearer.
        asymmetric: (n,) whether the left side has parameters of its own.
        parameters: D names.

    Returns:
        (n, D).
    """
    tables = _tables(parameters)
    seen = np.where(asymmetric[:, None], tables[1][close_up], tables[0][close_up])
    near = close_up != WHOLE
    before, behind = near & (cosine > CLEAR_COSINE), near & (cosine < -CLEAR_COSINE)
    for side, hidden in ((before, _BEHIND), (behind, _BEFORE)):
        seen[np.ix_(side, np.array([_begins(name, hidden) for name in parameters], bool))] = False
    return seen


@lru_cache(maxsize=8)
def _tables(parameters: tuple[str, ...]) -> tuple[Mask, Mask]:
    """(C + 1, D) of garments with two sides that are the same, and of others."""
    alike = np.ones((WHOLE + 1, len(parameters)), bool)
    for number, close_up in enumerate(CLOSE_UPS):
        told, hides = _TOLD[close_up.part], close_up.side < 0
        alike[number] = [_begins(name, told) and not (hides and _is_left(name)) for name in parameters]
    unlike = alike.copy()
    left = np.array([_is_left(name) for name in parameters], bool)
    for number, close_up in enumerate(CLOSE_UPS):
        if close_up.side > 0 and (alike[number] & left).any():
            unlike[number, ~left] = False
    return alike, unlike


def _begins(name: str, beginnings: Sequence[str]) -> bool:
    return name.removeprefix(_LEFT).startswith(tuple(beginnings)) and not name.endswith(_NOT_TOLD)


def _is_left(name: str) -> bool:
    return name.startswith(_LEFT)

"""What is looked at from near, a neckline, a waist, an armhole, and what each tells.

A neckline is some 20 pixels of a picture of a whole dress. Where these parts are follows from where on the
wearer, as he stands, and on which kind of panel a point lies; so drawn garments and pictures that are
read are cut alike.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Array
from swifttailor.describing.claims import CLAIM_TYPES
from swifttailor.describing.dimensions import DIMENSIONS
from swifttailor.picture_reader.labels import measure_labels, statement_labels
from swifttailor.picture_reader.panel_kinds import PANEL_KINDS, kinds_of_panels

Mask = NDArray[np.bool_]
LEAST_CM = 24.0
"""A close-up shows at least so much, from top to bottom."""


@dataclass(frozen=True)
class CloseUp:
    """A part of a garment and what can be told of it."""

    name: str
    kinds: tuple[str, ...]
    """Of the panels on which its points lie."""
    claims: tuple[str, ...]
    measures: tuple[str, ...]
    panels: tuple[str, ...]
    """Kinds of panels that it tells of."""
    side: int = 0
    """1 for the wearer's left half, -1 for the right one."""

    @property
    def part(self) -> str:
        """The same for the left and the right one: one of `ALL_PARTS`."""
        return self.name.split()[-1]

    def __post_init__(self) -> None:
        known = (set(PANEL_KINDS), set(CLAIM_TYPES), set(DIMENSIONS), set(PANEL_KINDS))
        for names, all_names in zip(
            (self.kinds, self.claims, self.measures, self.panels), known, strict=True
        ):
            assert set(names) <= all_names, set(names) - all_names

    def points(self, places: Array, kinds: Array) -> Mask:
        """Which points of one garment it shows.

        Args:
            places: (n, 3) where on the wearer they lie as he stands, cm; NaN for unknown ones.
            kinds: (n,) number of `PANEL_KINDS`.

        Returns:
            (n,); none where the garment has no such part.
        """
        mine = np.isin(kinds, [PANEL_KINDS.index(kind) for kind in self.kinds])
        with np.errstate(invalid="ignore"):
            mine &= np.isfinite(places[:, 1]) & (self.side * places[:, 0] >= 0)
        if np.count_nonzero(mine) < 2:
            return np.zeros(len(mine), bool)
        return mine & _REGIONS[self.part](places, mine)


def _neck(places: Array, mine: Mask) -> Mask:
    near = mine & (np.abs(places[:, 0]) < _HALF_NECK_CM)
    if not near.any():
        return near
    return near & (places[:, 1] > _high(places[near, 1]) - _DEEP_CM)


def _waist(places: Array, mine: Mask) -> Mask:
    """Around the waist, or at the top of what begins lower."""
    top = min(_high(places[mine, 1]), _ABOVE_WAIST_CM)
    level = (places[:, 1] <= top + 4.0) & (places[:, 1] > top - _WAIST_CM)
    return mine & level & (np.abs(places[:, 0]) < _HALF_WAIST_CM)


def _sleeve(places: Array, mine: Mask) -> Mask:
    out = np.abs(places[:, 0])
    return mine & (out > _high(out[mine]) - _END_CM)


def _leg(places: Array, mine: Mask) -> Mask:
    return mine & (places[:, 1] < np.percentile(places[mine, 1], 2) + _END_CM)


def _skirt(_: Array, mine: Mask) -> Mask:
    return mine


def _armhole(places: Array, mine: Mask) -> Mask:
    """Where a sleeve begins, or would; nothing of what is worn lower."""
    out = np.abs(places[:, 0])
    return mine & (out > _ARMHOLE_CM[0]) & (out < _ARMHOLE_CM[1]) & (places[:, 1] > _ARMPIT_CM)


def _high(levels: Array) -> float:
    return float(np.percentile(levels, 98))


_HALF_NECK_CM, _DEEP_CM = 22.0, 30.0
_ABOVE_WAIST_CM, _WAIST_CM, _HALF_WAIST_CM = 121.0, 34.0, 32.0
_END_CM = 17.0
_ARMHOLE_CM, _ARMPIT_CM = (6.0, 34.0), 112.0
_REGIONS = {
    "neck": _neck,
    "waist": _waist,
    "sleeve": _sleeve,
    "leg": _leg,
    "skirt": _skirt,
    "armhole": _armhole,
}
_BODICE = ("front bodice", "back bodice")
_SKIRT = ("skirt", "tier", "gore", "inset")
_LOWER = (*_SKIRT, "leg")


def _sleeve_end(side: int, name: str) -> CloseUp:
    return CloseUp(
        f"end of the {name} sleeve",
        ("sleeve", "cuff", "cuff flounce"),
        ("cuffs",),
        ("cuff length", "cuff opening", "sleeve end"),
        ("cuff", "cuff flounce"),
        side,
    )


def _leg_end(side: int, name: str) -> CloseUp:
    return CloseUp(
        f"end of the {name} leg",
        ("leg", "leg cuff", "leg cuff flounce"),
        ("leg_cuffs",),
        ("leg cuff length", "leg end"),
        ("leg cuff", "leg cuff flounce"),
        side,
    )


def _armhole_of(side: int, name: str) -> CloseUp:
    return CloseUp(
        f"{name} armhole",
        (*_BODICE, "sleeve"),
        ("armholes",),
        ("armholes",),
        ("sleeve",),
        side,
    )


CLOSE_UPS: tuple[CloseUp, ...] = (
    CloseUp(
        "neck",
        (*_BODICE, "collar"),
        (
            "shoulders",
            "straps",
            "neckline",
            "left_neckline",
            "right_neckline",
            "neck_depth",
            "back_neckline",
            "back_depth",
            "collar",
            "hood",
        ),
        ("collar height", "neck depth", "neck width", "back depth", "shoulders", "top width"),
        ("collar", "hood"),
    ),
    CloseUp(
        "waist",
        (*_BODICE, "waistband", *_LOWER),
        ("waistband", "waist_seam", "rise"),
        ("waistband height", "waistband width"),
        ("waistband",),
    ),
    _sleeve_end(1, "left"),
    _sleeve_end(-1, "right"),
    _leg_end(1, "left"),
    _leg_end(-1, "right"),
    CloseUp(
        "skirt",
        _SKIRT,
        ("skirt", "hem_shape", "slit", "slit_size"),
        (
            "tiers",
            "gores",
            "godets",
            "godet width",
            "godet height",
            "skirt gathers",
            "tier gathers",
            "skirt hem",
            "front slit",
            "back slit",
            "left slit",
            "right slit",
            "slits",
            "dip",
        ),
        _SKIRT,
    ),
    _armhole_of(1, "left"),
    _armhole_of(-1, "right"),
)


class Hidden(NamedTuple):
    """What of a neck cannot be seen from a side."""

    claims: tuple[str, ...]
    measures: tuple[str, ...]


HIDDEN: dict[str, Hidden] = {
    "front": Hidden(("back_neckline", "back_depth", "back_depth_cm"), ("back depth",)),
    "back": Hidden(
        ("neckline", "left_neckline", "right_neckline", "neck_depth", "neck_depth_cm"), ("neck depth",)
    ),
}
ALL_PARTS: tuple[str, ...] = tuple(dict.fromkeys(close_up.part for close_up in CLOSE_UPS))
WHOLE = len(CLOSE_UPS)
"""Number of a picture that is no close-up."""


class Told(NamedTuple):
    """What pictures tell of; a row for each of `CLOSE_UPS` and, last, one for whole garments."""

    statements: Mask
    """(C + 1, S)."""
    measures: Mask
    """(C + 1, M)."""
    panels: Mask
    """(C + 1, P)."""


@cache
def told_by() -> Told:
    """What each close-up tells of, and a picture of a whole garment: everything."""
    claims = [[claim in c.claims for claim, _ in statement_labels()] for c in CLOSE_UPS]
    measures = [[name in c.measures for name in measure_labels()] for c in CLOSE_UPS]
    panels = [[PANEL_KINDS[kind] in c.panels for kind in kinds_of_panels()] for c in CLOSE_UPS]
    return Told(*(np.array([*rows, [True] * len(rows[0])]) for rows in (claims, measures, panels)))


@cache
def hidden_from() -> Told:
    """What cannot be seen of a neck from the front, and from behind: a row for each."""
    sides = HIDDEN.values()
    statements = [[claim in hidden.claims for claim, _ in statement_labels()] for hidden in sides]
    measures = [[name in hidden.measures for name in measure_labels()] for hidden in sides]
    panels = [[False] * len(kinds_of_panels()) for _ in sides]
    return Told(*map(np.array, (statements, measures, panels)))


CLEAR_COSINE = 0.5
"""Of the azimuth: within 60 degrees of the front or the back."""


def sees(close_up: NDArray[np.int64], cosine: NDArray[Any]) -> Told:
    """What pictures tell of: `told_by`, less what is on the other side of a neck.

    Args:
        close_up: (n,) numbers of `CLOSE_UPS`, or `WHOLE`, of which all is asked from everywhere.
        cosine: (n,) of the azimuth from which each looks, 1 in front of the wearer.

    Returns:
        (n, ...).
    """
    near = close_up != WHOLE
    sides = near & (cosine > CLEAR_COSINE), near & (cosine < -CLEAR_COSINE)
    found = []
    for told, hidden in zip(told_by(), hidden_from(), strict=True):
        seen = told[close_up]
        for side, of_side in zip(sides, hidden, strict=True):
            seen[np.ix_(side, of_side)] = False
        found.append(seen)
    return Told(*found)

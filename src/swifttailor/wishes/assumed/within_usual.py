"""What is cut back where nobody speaks of it: necklines to the navel, cuffs from the knee, bare shoulders.

Known patterns are drawn from wide ranges, so that one which is all that was asked for may be odd in the rest.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import get_args

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain, Step
from swifttailor.describing.facts import GarmentFacts, Neckline, Place, Sleeve

_BARE = frozenset({"shoulders", "straps"})
_NECK = frozenset({"neck_depth", "neck_depth_cm", "left_neckline", "right_neckline", *_BARE})
_BACK = frozenset({"back_depth", "back_depth_cm", *_BARE})
_SAYS_NOTHING_MORE = frozenset([("shoulders", "both")])
FRONT, LOW_FRONT = (20.0, 14.0), (23.0, 18.0)
"""Depth of a neckline, cm: what is too much, and what it is cut to; and of shapes that are low by nature."""
BACK, SHAPED_BACK = (13.0, 6.0), (19.0, 12.0)
WIDTH, WIDE_SQUARE, AT_THE_NECK = (25.5, 20.0), (27.5, 22.0), (20.0, 17.0)
"""The same of its width: a half of 13 cm ends in the middle of a shoulder; and of a high neck."""
CUFF, LEG_CUFF = (12.0, 6.0), (15.0, 7.0)
"""The same of the length of a cuff of a sleeve, and of a leg."""
SLIT = (24.0, 18.0)
"""The same of the height of a slit behind."""
TAILS_CM = 16.0
"""So much lower than the middle of a panel its corners may hang, where nobody asks for a hem of points."""
STAND = (5.0, 4.0)
"""Height of a stand collar: higher ones buckle behind the neck."""
GATHERS = (1.25, 1.0)
"""Of a skirt at its seam, in lengths of the seam, where a straight one is asked for."""
OTHER_SLIT_CM = 6.0
"""Height of a slit that is not the one asked for."""
HEM = (560.0, 440.0)
"""Around a hem: more stands out to the sides, in folds that no network has seen."""
_LOW = frozenset({"v", "scoop", "s-curve", "pointed", "lapel"})


@dataclass(frozen=True)
class _Odd:
    """A measure beyond what is usual."""

    words: str
    change: Change


_Names = frozenset[str]
"""Of claims that are spoken of."""
_Words = frozenset[tuple[str, str | float]]
"""The same with their values."""


def within_usual(said: Sequence[Change], facts: GarmentFacts) -> tuple[Change, ...]:
    """What is to be cut of a garment although nobody asked for it.

    Args:
        said: What is asked for or likely meant: what of this is spoken of stays.
        facts: What the garment shows now.
    """
    return tuple([odd.change for odd in _all_odd(said, facts)])


def beyond_usual(said: Sequence[Change], facts: GarmentFacts) -> tuple[str, ...]:
    """The same in words: what nobody asked for, and a customer would send a garment back for."""
    return tuple([odd.words for odd in _all_odd(said, facts)])


def _other_slit(place: Place) -> Callable[[_Names, _Words, GarmentFacts], _Odd | None]:
    """Looks for a slit in one place, where one in another is asked for."""

    def look(names: _Names, words: _Words, facts: GarmentFacts) -> _Odd | None:
        asked = {value for name, value in words if name == "slit"} - {"none"}
        if facts.skirt is None or not asked or place in asked:
            return None
        height = max((slit.height for slit in facts.skirt.slits if slit.place == place), default=0.0)
        return _odd("it has another slit", height, OTHER_SLIT_CM, Step(f"{place} slit", -1, height))

    return look


_SLITS = tuple([_other_slit(place) for place in get_args(Place)])


def _all_odd(said: Sequence[Change], facts: GarmentFacts) -> list[_Odd]:
    claims = [wish.claim for wish in said if isinstance(wish, Gain)]
    words = frozenset([(c.name, c.value) for c in claims]) - _SAYS_NOTHING_MORE
    names = frozenset([name for name, _ in words])
    return [odd for look in _LOOKS if (odd := look(names, words, facts)) is not None]


def _whole(neck: Neckline | None) -> bool:
    """Whether it lies between two shoulders."""
    return neck is not None and neck.left is not None and neck.right is not None


def _front_depth(names: _Names, words: _Words, facts: GarmentFacts) -> _Odd | None:
    neck = facts.front_neck
    if neck is None or not _whole(neck) or names & _NECK or facts.hood is not None:
        return None
    low = any((name, shape) in words for name in ("neckline", "collar") for shape in _LOW)
    most, cut = LOW_FRONT if low else FRONT
    return _odd("its neckline is very deep", neck.depth, most, Gain(Claim("neck_depth_cm", cut)))


def _back_depth(names: _Names, words: _Words, facts: GarmentFacts) -> _Odd | None:
    neck = facts.back_neck
    if neck is None or not _whole(neck) or names & _BACK or facts.hood is not None:
        return None
    most, cut = SHAPED_BACK if "back_neckline" in names else BACK
    return _odd("its neckline is very deep behind", neck.depth, most, Gain(Claim("back_depth_cm", cut)))


def _neck_width(names: _Names, words: _Words, facts: GarmentFacts) -> _Odd | None:
    neck = facts.front_neck
    if neck is None or not _whole(neck) or names & _BARE or ("neckline", "boat") in words:
        return None
    most, cut = WIDE_SQUARE if ("neckline", "square") in words else WIDTH
    most, cut = AT_THE_NECK if ("neck_depth", "high") in words else (most, cut)
    width = 2.0 * neck.width
    return _odd("its neckline is very wide", width, most, Step("neck width", -1, round(width - cut, 1)))


def _cuffs(names: _Names, words: _Words, facts: GarmentFacts) -> _Odd | None:
    cuffs = [_cuff(one) for one in (facts.left_sleeve, facts.right_sleeve)]
    if "cuff_cm" in names or ("cuffs", "deep") in words:
        return None
    return _odd("its cuffs are very deep", max(cuffs), CUFF[0], Gain(Claim("cuff_cm", CUFF[1])))


def _cuff(sleeve: Sleeve | None) -> float:
    return 0.0 if sleeve is None or sleeve.cuff is None else sleeve.cuff.length


def _leg_cuffs(names: _Names, words: _Words, facts: GarmentFacts) -> _Odd | None:
    legs = facts.trousers
    # Where nobody speaks of them there are none: `unsaid_wishes`.
    spoken = "leg_cuffs" in names and "leg_cuff_cm" not in names and ("leg_cuffs", "deep") not in words
    if legs is None or legs.cuff is None or not spoken:
        return None
    most, cut = LEG_CUFF
    return _odd("its cuffs are very deep", legs.cuff.length, most, Gain(Claim("leg_cuff_cm", cut)))


def _back_slit(names: _Names, words: _Words, facts: GarmentFacts) -> _Odd | None:
    skirt = facts.skirt
    if skirt is None or names & {"slit", "slit_cm", "slit_size"}:
        return None
    high = max((slit.height for slit in skirt.slits if slit.place == "back"), default=0.0)
    return _odd("its slit is very high", high, SLIT[0], Gain(Claim("slit_cm", SLIT[1])))


def _tails(names: _Names, words: _Words, facts: GarmentFacts) -> _Odd | None:
    hem, skirt = facts.hem, facts.skirt
    if hem is None or skirt is None or skirt.godets or names & {"hem_shape", "godets"}:
        return None
    return _odd("its hem hangs in points", hem.dip, TAILS_CM, Gain(Claim("hem_shape", "level")))


def _hem(names: _Names, words: _Words, facts: GarmentFacts) -> _Odd | None:
    hem, skirt = facts.hem, facts.skirt
    plain = skirt is not None and skirt.tiers == 1 and not skirt.godets
    if hem is None or not plain or "hem_cm" in names or ("skirt", "circle") in words:
        return None
    return _odd("its skirt is very wide", hem.length, HEM[0], Gain(Claim("hem_cm", HEM[1])))


def _stand(names: _Names, words: _Words, facts: GarmentFacts) -> _Odd | None:
    collar = facts.collar
    spoken = ("collar", "stand") in words and ("collar", "turtleneck") not in words
    if collar is None or collar.kind != "stand" or "collar_cm" in names or not spoken:
        return None
    return _odd("its collar is very high", collar.height, STAND[0], Gain(Claim("collar_cm", STAND[1])))


def _gathers(names: _Names, words: _Words, facts: GarmentFacts) -> _Odd | None:
    skirt, shapes = facts.skirt, {value for name, value in words if name == "skirt"}
    if skirt is None or facts.kind != "dress" or not shapes or not shapes <= {"straight", "pencil"}:
        return None
    by = round(skirt.gather - GATHERS[1], 2)
    return _odd("its straight skirt is gathered", skirt.gather, GATHERS[0], Step("skirt gathers", -1, by))


def _odd(words: str, measure: float, most: float, change: Change) -> _Odd | None:
    return _Odd(words, change) if measure > most else None


_LOOKS = (
    *(_front_depth, _back_depth, _neck_width, _cuffs, _leg_cuffs, _back_slit),
    *(_tails, _hem, _stand, _gathers, *_SLITS),
)

"""Taking parts off and sewing new ones on: hoods, collars, sleeves, cuffs, bands, skirts."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from swifttailor.describing.facts import Band, Cuff, CuffKind, GarmentFacts, Sleeve
from swifttailor.describing.measuring.parts import Part
from swifttailor.pattern import Pattern
from swifttailor.recutting.amounts import cuts, sleeve_cuts
from swifttailor.recutting.levers.lengths import ArmSide, mean_of_sleeves, with_sleeves
from swifttailor.recutting.levers.lever import Lever, Trick, fixed, with_hem
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.sleeves import ARM_EASE_CM

_FLOUNCE_FLARE = 1.7
_THINNER_WRIST = 0.45
"""By how much the wrist is thinner than the upper arm, as a part of it."""
_BAND_SHARE = 0.7
"""Length of a new cuff over the sleeve end that is gathered into it."""


def _taken(
    name: str,
    part: Part,
    imagine: Callable[[GarmentFacts], GarmentFacts | None],
    only_for: tuple[str, ...],
    opens: tuple[str, ...],
) -> Trick:
    def cut(cutter: Cutter) -> Pattern | None:
        return cuts.remove_parts(cutter, part)

    return Trick(f"{name} taken off", 0, imagine, cut, only_for=only_for, opens=opens)


def _no_sleeves(facts: GarmentFacts) -> GarmentFacts | None:
    return (
        replace(facts, left_sleeve=None, right_sleeve=None)
        if facts.left_sleeve or facts.right_sleeve
        else None
    )


def _one_sleeve(side: str) -> Trick:
    def imagine(facts: GarmentFacts) -> GarmentFacts | None:
        if facts.left_sleeve is None or facts.right_sleeve is None:
            return None
        return replace(facts, left_sleeve=None) if side == "left" else replace(facts, right_sleeve=None)

    def cut(cutter: Cutter) -> Pattern | None:
        return cuts.remove_sleeve(cutter, "left" if side == "left" else "right")

    return Trick(f"{side} sleeve taken off", 0, imagine, cut, only_for=("sleeves",))


def _no_cuffs(facts: GarmentFacts) -> GarmentFacts | None:
    if not any(s and s.cuff for s in (facts.left_sleeve, facts.right_sleeve)):
        return None

    def bare(sleeve: Sleeve) -> Sleeve:
        gone = sleeve.cuff.length if sleeve.cuff else 0.0
        return replace(
            sleeve, cuff=None, end_gather=1.0, length=sleeve.length - gone, opening=sleeve.end_width
        )

    return with_sleeves(facts, ("left", "right"), bare)


def _no_leg_cuffs(facts: GarmentFacts) -> GarmentFacts | None:
    legs = facts.trousers
    if legs is None or legs.cuff is None:
        return None
    gone = legs.cuff.length
    legs = replace(legs, cuff=None, end_gather=1.0, inseam=legs.inseam - gone, opening=legs.hem)
    return replace(with_hem(facts, -gone), trousers=legs)


def _no_band(facts: GarmentFacts) -> GarmentFacts | None:
    band = facts.waistband
    if band is None:
        return None
    return replace(with_hem(facts, -band.height) if band.at_hem else facts, waistband=None)


def _no_lower(facts: GarmentFacts) -> GarmentFacts | None:
    if facts.torso is None or (facts.skirt is None and facts.trousers is None) or facts.hem is None:
        return None
    level = facts.torso.lower_level - (facts.waistband.height if facts.waistband else 0.0)
    facts = replace(facts, skirt=None, trousers=None, kind="top")
    return with_hem(facts, facts.hem.level - level) if facts.hem else None


def _no_upper(facts: GarmentFacts) -> GarmentFacts | None:
    if facts.torso is None or (facts.skirt is None and facts.trousers is None) or facts.hem is None:
        return None
    top = facts.waistband.level if facts.waistband else facts.torso.lower_level
    return replace(
        facts,
        torso=None,
        front_neck=None,
        back_neck=None,
        collar=None,
        hood=None,
        left_sleeve=None,
        right_sleeve=None,
        kind="skirt" if facts.skirt else "trousers",
        top_level=top,
        length=top - facts.hem.level,
    )


def _cuffs_added(kind: CuffKind, upper: Part, gathered: bool) -> Lever:
    share = _BAND_SHARE if gathered else 1.0
    flare = _FLOUNCE_FLARE if kind == "flounce" else 1.0

    def of(facts: GarmentFacts) -> float | None:
        if upper is Part.SLEEVE:
            found = [s.cuff for s in (facts.left_sleeve, facts.right_sleeve) if s]
        else:
            found = [facts.trousers.cuff] if facts.trousers else []
        return found[0].length if found and found[0] else None

    def cuff(length: float, width: float) -> Cuff:
        return Cuff(kind, length, width * share * flare, flare)

    def imagine(facts: GarmentFacts, length: float) -> GarmentFacts:
        if of(facts) is not None:
            return facts
        if upper is Part.SLEEVE:
            return with_sleeves(
                facts,
                ("left", "right"),
                lambda s: replace(
                    s, length=s.length + length, end_gather=1 / share, cuff=cuff(length, s.end_width)
                ),
            )
        legs = facts.trousers
        if legs is None:
            return facts
        own = cuff(length, legs.hem)
        legs = replace(legs, inseam=legs.inseam + length, cuff=own, end_gather=1 / share)
        return replace(with_hem(facts, length), trousers=legs)

    def cut(cutter: Cutter, amount: float) -> Pattern | None:
        return cuts.add_cuffs(cutter, amount, share, flare, upper=upper)

    only_for = ("cuffs", "cuff_cm", "sleeve_shape") if upper is Part.SLEEVE else ("leg_cuffs", "leg_cuff_cm")
    what = "flounces" if kind == "flounce" else "cuffs"
    name = f"{'sleeve' if upper is Part.SLEEVE else 'leg'} {what} sewn on"
    return Lever(
        name, 0, of, imagine, cut, fixed(4.0, 25.0), makes=True, moves=False, natural=6.0, only_for=only_for
    )


def _band_added(at_hem: bool) -> Lever:
    def imagine(facts: GarmentFacts, height: float) -> GarmentFacts:
        if facts.waistband is not None or (facts.trousers is not None and at_hem):
            return facts
        if at_hem and facts.kind == "top" and facts.torso and facts.skirt is None:
            width = facts.torso.lower_edge
            band = Band(height, width, width, True, facts.torso.lower_level)
            return replace(with_hem(facts, height), waistband=band)
        if not at_hem and facts.torso is None:
            width = facts.skirt.upper if facts.skirt else facts.body.waist_girth
            band = Band(height, width, width, False, facts.top_level)
            return replace(with_hem(facts, height), waistband=band)
        return facts

    def cut(cutter: Cutter, amount: float) -> Pattern | None:
        return cuts.add_hem_band(cutter, amount, 0.9) if at_hem else cuts.add_waistband(cutter, amount)

    name = "hem band sewn on" if at_hem else "waistband sewn on"
    return Lever(
        name,
        0,
        lambda f: f.waistband.height if f.waistband else None,
        imagine,
        cut,
        fixed(3.0, 15.0),
        step=0.5,
        makes=True,
        moves=False,
        natural=5.0,
        only_for=("waistband", "waistband_cm"),
    )


def _second_sleeve(facts: GarmentFacts) -> GarmentFacts | None:
    torso = facts.torso
    if torso is None or facts.one_shoulder or (facts.left_sleeve is None) == (facts.right_sleeve is None):
        return None
    sleeve = facts.left_sleeve or facts.right_sleeve
    torso = replace(torso, left_armhole=None, right_armhole=None)
    return replace(facts, left_sleeve=sleeve, right_sleeve=sleeve, torso=torso)


def _sleeves_added(sides: tuple[ArmSide, ...]) -> Lever:
    of = mean_of_sleeves(sides, lambda s: s.length)

    def imagine(facts: GarmentFacts, length: float) -> GarmentFacts:
        torso = facts.torso
        if torso is None:
            return facts
        arm = facts.body.upper_arm_girth
        width = arm + ARM_EASE_CM
        end = width - _THINNER_WRIST * arm * min(length / facts.body.arm_length, 1.0)
        new = Sleeve(length, width, end, end, 1.0, 1.0, None)
        left, right = facts.left_sleeve, facts.right_sleeve
        if "left" in sides and left is None:
            if torso.left_shoulder is None:
                return facts
            left, torso = new, replace(torso, left_armhole=None)
        if "right" in sides and right is None:
            if torso.right_shoulder is None:
                return facts
            right, torso = new, replace(torso, right_armhole=None)
        return replace(facts, left_sleeve=left, right_sleeve=right, torso=torso)

    def cut(cutter: Cutter, amount: float) -> Pattern | None:
        return sleeve_cuts.add_sleeves(cutter, amount, sides)

    return Lever(
        "sleeves sewn on" if len(sides) == 2 else f"{sides[0]} sleeve sewn on",
        0,
        of,
        imagine,
        cut,
        lambda f: (8.0, 1.19 * f.body.arm_length),
        makes=True,
        moves=False,
        natural=22.0,
        only_for=("sleeves", "sleeve_cm", "sleeve_shape")
        if len(sides) == 2
        else ("sleeves", f"{sides[0]}_sleeve"),
    )


_NECKLINES = ("neckline", "left_neckline", "right_neckline", "back_neckline")
_COLLARS = (*_NECKLINES, "collar", "hood", "shoulders: strapless")
_KINDS = ("kind",)
PART_TRICKS: tuple[Trick, ...] = (
    _taken(
        "hood", Part.HOOD, lambda f: replace(f, hood=None) if f.hood else None, ("hood", "collar"), _COLLARS
    ),
    _taken(
        "collar",
        Part.COLLAR,
        lambda f: replace(f, collar=None) if f.collar else None,
        ("collar",),
        _COLLARS,
    ),
    _taken("cuffs", Part.CUFF, _no_cuffs, ("cuffs",), ("cuffs", "sleeve_shape")),
    _taken("leg cuffs", Part.LEG_CUFF, _no_leg_cuffs, ("leg_cuffs",), ("leg_cuffs",)),
    Trick("band taken off", 0, _no_band, cuts.remove_band, only_for=("waistband",), opens=("waistband",)),
    Trick(
        "sleeves taken off",
        0,
        _no_sleeves,
        lambda c: cuts.remove_parts(c, Part.SLEEVE, Part.CUFF),
        only_for=("sleeves",),
        opens=("shoulders: strapless",),
    ),
    _one_sleeve("left"),
    _one_sleeve("right"),
    Trick(
        "second sleeve sewn on",
        0,
        _second_sleeve,
        sleeve_cuts.mirror_sleeve,
        only_for=("sleeves", "sleeve_cm", "left_sleeve", "right_sleeve", "sleeve_shape"),
    ),
    Trick("lower part taken off", 0, _no_lower, cuts.remove_lower, only_for=_KINDS),
    Trick("upper part taken off", 0, _no_upper, cuts.remove_upper, only_for=_KINDS),
)
ADDED_PARTS: tuple[Lever, ...] = (
    _sleeves_added(("left", "right")),
    _sleeves_added(("left",)),
    _sleeves_added(("right",)),
    _cuffs_added("band", Part.SLEEVE, gathered=False),
    _cuffs_added("band", Part.SLEEVE, gathered=True),
    _cuffs_added("flounce", Part.SLEEVE, gathered=False),
    _cuffs_added("band", Part.TROUSER, gathered=False),
    _cuffs_added("band", Part.TROUSER, gathered=True),
    _cuffs_added("flounce", Part.TROUSER, gathered=False),
    _band_added(at_hem=False),
    _band_added(at_hem=True),
)

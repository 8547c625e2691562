"""Taking parts off and sewing new ones on: hoods, collars, sleeves, cuffs, bands, skirts."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from swifttailor.describing.facts import Band, Cuff, CuffKind, GarmentFacts, Sleeve
from swifttailor.describing.facts_paths import mean_of_sleeves, measure_at, sleeves_of, with_sleeves
from swifttailor.describing.measuring.parts import Part
from swifttailor.pattern import Pattern
from swifttailor.recutting.amounts import cuts, sleeve_cuts
from swifttailor.recutting.levers.lengths import ArmSide
from swifttailor.recutting.levers.lever import Lever, Trick, fixed, of_dimension, of_sides, with_hem
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.sleeves import ARM_EASE_CM

_FLOUNCE_FLARE = 1.7
THINNER_WRIST = 0.45
"""By how much the wrist is thinner than the upper arm, as a part of it."""
_TO_THE_HANDS = 1.0
"""Length of sleeves, over that of the arm, from which a cuff takes the place of their ends."""
_UPPER = ("torso", "front_neck", "back_neck", "collar", "hood", "left_sleeve", "right_sleeve")
_BAND_SHARE = 0.7
"""Length of a new cuff over the sleeve end that is gathered into it."""


def _taken(
    name: str,
    *parts: Part,
    imagine: Callable[[GarmentFacts], GarmentFacts | None],
    only_for: tuple[str, ...],
    opens: tuple[str, ...] = (),
) -> Trick:
    return Trick(
        name=f"{name} taken off",
        stage=0,
        imagine=imagine,
        cut=lambda cutter: cuts.remove_parts(cutter, *parts),
        only_for=only_for,
        opens=opens,
    )


def _without(part: str) -> Callable[[GarmentFacts], GarmentFacts | None]:
    """The same garment without a part that changes nothing else."""
    return lambda facts: replace(facts, **{part: None}) if getattr(facts, part) else None


def _no_sleeves(facts: GarmentFacts) -> GarmentFacts | None:
    return replace(facts, left_sleeve=None, right_sleeve=None) if sleeves_of(facts) else None


def _one_sleeve(side: ArmSide) -> Trick:
    def imagine(facts: GarmentFacts) -> GarmentFacts | None:
        if len(sleeves_of(facts)) < 2:
            return None
        return replace(facts, left_sleeve=None) if side == "left" else replace(facts, right_sleeve=None)

    return Trick(
        name=f"{side} sleeve taken off",
        stage=0,
        imagine=imagine,
        cut=lambda cutter: cuts.remove_sleeve(cutter, side),
        only_for=("sleeves",),
    )


def _no_cuffs(facts: GarmentFacts) -> GarmentFacts | None:
    if not any(s.cuff for s in sleeves_of(facts)):
        return None

    def bare(sleeve: Sleeve) -> Sleeve:
        gone = sleeve.cuff.length if sleeve.cuff else 0.0
        return replace(
            sleeve, cuff=None, end_gather=1.0, length=sleeve.length - gone, opening=sleeve.end_width
        )

    return with_sleeves(facts, bare)


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


def _two_parts(facts: GarmentFacts) -> bool:
    return bool(facts.torso and (facts.skirt or facts.trousers) and facts.hem)


def _no_lower(facts: GarmentFacts) -> GarmentFacts | None:
    if facts.torso is None or facts.hem is None or not _two_parts(facts):
        return None
    level = facts.torso.lower_level - (facts.waistband.height if facts.waistband else 0.0)
    facts = replace(facts, skirt=None, trousers=None, kind="top")
    return with_hem(facts, facts.hem.level - level) if facts.hem else facts


def _no_upper(facts: GarmentFacts) -> GarmentFacts | None:
    if facts.torso is None or facts.hem is None or not _two_parts(facts):
        return None
    top = facts.waistband.level if facts.waistband else facts.torso.lower_level
    return replace(
        facts,
        **dict.fromkeys(_UPPER),
        kind="skirt" if facts.skirt else "trousers",
        top_level=top,
        length=top - facts.hem.level,
    )


def _first_cuff(facts: GarmentFacts) -> float | None:
    found = [sleeve.cuff for sleeve in sleeves_of(facts)]
    return found[0].length if found and found[0] else None


def _reaches_hands(facts: GarmentFacts) -> bool:
    """Whether sleeves are so long that a cuff takes the place of their ends."""
    return max((s.length for s in sleeves_of(facts)), default=0.0) > _TO_THE_HANDS * facts.body.arm_length


def _cuffs_added(kind: CuffKind, upper: Part, *, gathered: bool = False) -> Lever:
    share = _BAND_SHARE if gathered else 1.0
    flare = _FLOUNCE_FLARE if kind == "flounce" else 1.0
    of_sleeves = upper is Part.SLEEVE
    of = _first_cuff if of_sleeves else measure_at("trousers.cuff.length")

    def cuff(length: float, width: float) -> Cuff:
        return Cuff(kind, length, width * share * flare, flare)

    def cuffed(sleeve: Sleeve, length: float, longer: float) -> Sleeve:
        new = cuff(length, sleeve.end_width)
        return replace(sleeve, length=sleeve.length + longer, end_gather=1 / share, cuff=new)

    def imagine(facts: GarmentFacts, length: float) -> GarmentFacts:
        if of(facts) is not None:
            return facts
        if of_sleeves:
            longer = 0.0 if _reaches_hands(facts) else length
            return with_sleeves(facts, lambda s: cuffed(s, length, longer))
        legs = facts.trousers
        if legs is None:
            return facts
        own = cuff(length, legs.hem)
        legs = replace(legs, inseam=legs.inseam + length, cuff=own, end_gather=1 / share)
        return replace(with_hem(facts, length), trousers=legs)

    def cut(cutter: Cutter, amount: float) -> Pattern | None:
        shorter = (
            cuts.lengthen_sleeves(cutter, -amount) if of_sleeves and _reaches_hands(cutter.facts) else None
        )
        start = cutter if shorter is None else cutter.with_pattern(shorter)
        return cuts.add_cuffs(start, amount, share, flare, upper=upper)

    what = "flounces" if kind == "flounce" else "cuffs"
    return Lever(
        name=f"{'sleeve' if of_sleeves else 'leg'} {what} sewn on{', gathered' if gathered else ''}",
        serves=("cuff length",) if of_sleeves else ("leg cuff length",),
        stage=0,
        of=of,
        imagine=imagine,
        cut=cut,
        span=fixed(4.0, 25.0),
        moves=False,
        natural=6.0,
        only_for=("cuffs", "cuff_cm", "sleeve_shape") if of_sleeves else ("leg_cuffs", "leg_cuff_cm"),
        opens=("sleeve_shape: balloon", "sleeve_shape: gathered end") if of_sleeves and gathered else (),
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

    return Lever(
        name="hem band sewn on" if at_hem else "waistband sewn on",
        serves=("waistband height",),
        stage=0,
        of=of_dimension("waistband height"),
        imagine=imagine,
        cut=cut,
        span=fixed(3.0, 15.0),
        step=0.5,
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
    def imagine(facts: GarmentFacts, length: float) -> GarmentFacts:
        if facts.torso is None:
            return facts
        arm = facts.body.upper_arm_girth
        width = arm + ARM_EASE_CM
        end = width - THINNER_WRIST * arm * min(length / facts.body.arm_length, 1.0)
        new = Sleeve(
            length=length,
            upper_width=width,
            end_width=end,
            opening=end,
            head_gather=1.0,
            end_gather=1.0,
            cuff=None,
        )
        bare = [side for side in sides if not sleeves_of(facts, (side,))]
        if any(getattr(facts.torso, f"{side}_shoulder") is None for side in bare):
            return facts
        torso = replace(facts.torso, **{f"{side}_armhole": None for side in bare})
        return replace(facts, torso=torso, **{f"{side}_sleeve": new for side in bare})

    return Lever(
        name=f"{of_sides('sleeve', sides)} sewn on",
        serves=("sleeve length",),
        stage=0,
        of=mean_of_sleeves(lambda s: s.length, sides),
        imagine=imagine,
        cut=lambda cutter, amount: sleeve_cuts.add_sleeves(cutter, amount, sides),
        span=lambda f: (8.0, 1.19 * f.body.arm_length),
        moves=False,
        natural=22.0,
        only_for=("sleeves", "sleeve_cm", "sleeve_shape")
        if len(sides) == 2
        else ("sleeves", f"{sides[0]}_sleeve"),
        opens=("sleeve_shape",) if len(sides) == 2 else (),
    )


_NECKLINES = ("neckline", "left_neckline", "right_neckline", "back_neckline")
_COLLARS = (*_NECKLINES, "collar", "hood", "shoulders: strapless")
PART_TRICKS: tuple[Trick, ...] = (
    _taken("hood", Part.HOOD, imagine=_without("hood"), only_for=("hood", "collar"), opens=_COLLARS),
    _taken("collar", Part.COLLAR, imagine=_without("collar"), only_for=("collar",), opens=_COLLARS),
    _taken("cuffs", Part.CUFF, imagine=_no_cuffs, only_for=("cuffs",), opens=("cuffs", "sleeve_shape")),
    _taken("leg cuffs", Part.LEG_CUFF, imagine=_no_leg_cuffs, only_for=("leg_cuffs",), opens=("leg_cuffs",)),
    Trick(
        name="band taken off",
        stage=0,
        imagine=_no_band,
        cut=cuts.remove_band,
        only_for=("waistband",),
        opens=("waistband", "skirt: peplum", "kind: jumpsuit", "kind: playsuit"),
    ),
    _taken(
        "sleeves",
        Part.SLEEVE,
        Part.CUFF,
        imagine=_no_sleeves,
        only_for=("sleeves",),
        opens=("shoulders: strapless",),
    ),
    _one_sleeve("left"),
    _one_sleeve("right"),
    Trick(
        name="second sleeve sewn on",
        stage=0,
        imagine=_second_sleeve,
        cut=sleeve_cuts.mirror_sleeve,
        only_for=("sleeves", "sleeve_cm", "left_sleeve", "right_sleeve", "sleeve_shape"),
    ),
    Trick(name="lower part taken off", stage=0, imagine=_no_lower, cut=cuts.remove_lower, only_for=("kind",)),
    Trick(name="upper part taken off", stage=0, imagine=_no_upper, cut=cuts.remove_upper, only_for=("kind",)),
)
ADDED_PARTS: tuple[Lever, ...] = (
    _sleeves_added(("left", "right")),
    _sleeves_added(("left",)),
    _sleeves_added(("right",)),
    _cuffs_added("band", Part.SLEEVE),
    _cuffs_added("band", Part.SLEEVE, gathered=True),
    _cuffs_added("flounce", Part.SLEEVE),
    _cuffs_added("band", Part.TROUSER),
    _cuffs_added("band", Part.TROUSER, gathered=True),
    _cuffs_added("flounce", Part.TROUSER),
    _band_added(at_hem=False),
    _band_added(at_hem=True),
)

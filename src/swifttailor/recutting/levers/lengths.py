"""Levers that make garments, legs, sleeves, cuffs, bands and collars longer or shorter."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Literal

from swifttailor.describing.facts import Cuff, GarmentFacts, Sleeve
from swifttailor.describing.measuring.parts import Part, Side
from swifttailor.pattern import Pattern
from swifttailor.recutting.amounts import cuts
from swifttailor.recutting.levers.lever import LOWEST_CM, Lever, fixed, with_hem
from swifttailor.recutting.levers.tiers import lengthen_tiered
from swifttailor.recutting.table.cutter import Cutter

_SEEN_BLOUSON_CM = 1.0
ArmSide = Literal["left", "right"]


def hem_falls(facts: GarmentFacts, fall: float) -> GarmentFacts:
    """The same garment cut longer at its hem."""
    facts = with_hem(facts, fall)
    if facts.skirt is not None:
        skirt = facts.skirt
        base = {"base_length": skirt.base_length + fall} if skirt.tiers == 1 else {}
        return replace(facts, skirt=replace(skirt, length=skirt.length + fall, **base))
    if facts.torso is not None:
        return replace(facts, torso=replace(facts.torso, lower_level=facts.torso.lower_level - fall))
    return facts


def _hem_level(facts: GarmentFacts) -> float | None:
    return facts.hem.level if facts.hem and facts.trousers is None else None


def _hem_span(facts: GarmentFacts) -> tuple[float, float]:
    return LOWEST_CM + 1.0, facts.body.bust - 2.0


def _set_hem(facts: GarmentFacts, level: float) -> GarmentFacts:
    return hem_falls(facts, facts.hem.level - level) if facts.hem else facts


def _set_inseam(facts: GarmentFacts, inseam: float) -> GarmentFacts:
    legs = facts.trousers
    if legs is None:
        return facts
    return replace(with_hem(facts, inseam - legs.inseam), trousers=replace(legs, inseam=inseam))


def _inseam_span(facts: GarmentFacts) -> tuple[float, float]:
    if facts.trousers is None or facts.hem is None:
        return 0.0, 0.0
    return 2.0, facts.trousers.inseam + facts.hem.level - LOWEST_CM - 1.0


def _sleeves(facts: GarmentFacts, sides: Sequence[Side]) -> list[Sleeve]:
    """Of some sides; empty where one is missing."""
    found = [facts.left_sleeve if s == "left" else facts.right_sleeve for s in sides]
    return [s for s in found if s] if all(found) else []


def mean_of_sleeves(
    sides: Sequence[Side], of: Callable[[Sleeve], float | None]
) -> Callable[[GarmentFacts], float | None]:
    """A measure of the sleeves of some sides; of None where one is missing."""

    def measure(facts: GarmentFacts) -> float | None:
        values = [of(s) for s in _sleeves(facts, sides)]
        known = [v for v in values if v is not None]
        return sum(known) / len(known) if known and len(known) == len(values) else None

    return measure


def with_sleeves(
    facts: GarmentFacts, sides: Sequence[Side], change: Callable[[Sleeve], Sleeve]
) -> GarmentFacts:
    """The same garment with other sleeves."""
    left, right = facts.left_sleeve, facts.right_sleeve
    if left and "left" in sides:
        left = change(left)
    if right and "right" in sides:
        right = change(right)
    return replace(facts, left_sleeve=left, right_sleeve=right)


def sleeve_lever(sides: tuple[ArmSide, ...]) -> Lever:
    """Moves the ends of one or both sleeves."""
    of = mean_of_sleeves(sides, lambda s: s.length)

    def imagine(facts: GarmentFacts, length: float) -> GarmentFacts:
        by = length - (of(facts) or 0.0)
        return with_sleeves(facts, sides, lambda s: replace(s, length=s.length + by))

    def cut(cutter: Cutter, amount: float) -> Pattern | None:
        return cuts.lengthen_sleeves(cutter, amount, sides)

    name = "sleeves" if len(sides) == 2 else f"{sides[0]} sleeve"
    return Lever(name, 3, of, imagine, cut, lambda f: (6.0, 1.19 * f.body.arm_length))


def _cuff_of(part: Part) -> Callable[[GarmentFacts], float | None]:
    if part is Part.LEG_CUFF:
        return lambda f: f.trousers.cuff.length if f.trousers and f.trousers.cuff else None
    return lambda f: mean_of_sleeves(_arms(f), lambda s: s.cuff.length if s.cuff else None)(f)


def _arms(facts: GarmentFacts) -> tuple[Side, ...]:
    return tuple(s for s, own in (("left", facts.left_sleeve), ("right", facts.right_sleeve)) if own)


def with_cuffs(
    facts: GarmentFacts, part: Part, change: Callable[[Cuff], Cuff], longer: float
) -> GarmentFacts:
    """The same garment with other cuffs, sleeves or legs being `longer` by cm."""
    if part is Part.LEG_CUFF:
        legs = facts.trousers
        if legs is None or legs.cuff is None:
            return facts
        legs = replace(legs, cuff=change(legs.cuff), inseam=legs.inseam + longer)
        return replace(with_hem(facts, longer), trousers=legs)

    def changed(sleeve: Sleeve) -> Sleeve:
        cuff = change(sleeve.cuff) if sleeve.cuff else None
        return replace(sleeve, length=sleeve.length + longer, cuff=cuff)

    return with_sleeves(facts, ("left", "right"), changed)


def _cuff_lever(part: Part) -> Lever:
    of = _cuff_of(part)

    def imagine(facts: GarmentFacts, length: float) -> GarmentFacts:
        by = length - (of(facts) or 0.0)
        return with_cuffs(facts, part, lambda c: replace(c, length=c.length + by), by)

    def cut(cutter: Cutter, amount: float) -> Pattern | None:
        return cuts.lengthen_cuffs(cutter, amount, part)

    name = "cuffs" if part is Part.CUFF else "leg cuffs"
    only_for = ("cuffs", "cuff_cm", "cuff length", "leg_cuffs", "leg_cuff_cm", "leg cuff length")
    return Lever(name, 2, of, imagine, cut, fixed(2.0, 60.0), step=0.5, only_for=only_for)


def _set_band(facts: GarmentFacts, height: float) -> GarmentFacts:
    band = facts.waistband
    if band is None:
        return facts
    by = height - band.height
    facts = replace(with_hem(facts, by), waistband=replace(band, height=height))
    return facts


def _bodice_level(facts: GarmentFacts) -> float | None:
    if facts.torso is None or not (facts.skirt or facts.trousers or facts.waistband):
        return None
    return facts.torso.lower_level


def _set_bodice(facts: GarmentFacts, level: float) -> GarmentFacts:
    torso = facts.torso
    if torso is None:
        return facts
    fall = torso.lower_level - level
    band = facts.waistband and replace(facts.waistband, level=facts.waistband.level - fall)
    return replace(with_hem(facts, fall), torso=replace(torso, lower_level=level), waistband=band)


def _set_collar(facts: GarmentFacts, height: float) -> GarmentFacts:
    return replace(facts, collar=replace(facts.collar, height=height)) if facts.collar else facts


def _shorten_bloused(cutter: Cutter, distance: float) -> Pattern | None:
    """What blouses over the seam goes first: only what is cut off beyond it raises the seam."""
    torso = cutter.facts.torso
    if torso is None or torso.blouson < _SEEN_BLOUSON_CM or distance >= 0:
        return None
    return cuts.lengthen_bodice(cutter, distance - torso.blouson)


def _banded_top(facts: GarmentFacts) -> float | None:
    plain = facts.torso and facts.waistband and not facts.skirt and not facts.trousers
    return _bodice_level(facts) if plain else None


HEM = Lever(
    "hem",
    5,
    _hem_level,
    _set_hem,
    lengthen_tiered,
    _hem_span,
    rate=-1.0,
    words=("longer", "shorter"),
    sign=-1.0,
)
LENGTH_LEVERS: tuple[Lever, ...] = (
    HEM,
    replace(HEM, name="hem, flared over the hips,", cut=cuts.lengthen_over_hips),
    Lever(
        "legs",
        5,
        lambda f: f.trousers.inseam if f.trousers else None,
        _set_inseam,
        cuts.lengthen_legs,
        _inseam_span,
    ),
    sleeve_lever(("left", "right")),
    sleeve_lever(("left",)),
    sleeve_lever(("right",)),
    _cuff_lever(Part.CUFF),
    _cuff_lever(Part.LEG_CUFF),
    Lever(
        "band",
        2,
        lambda f: f.waistband.height if f.waistband else None,
        _set_band,
        cuts.raise_band,
        fixed(2.0, 25.0),
        step=0.5,
        words=("higher", "lower"),
        only_for=("waistband", "waistband_cm", "waistband height"),
    ),
    Lever(
        "collar",
        2,
        lambda f: f.collar.height if f.collar else None,
        _set_collar,
        cuts.raise_collar,
        fixed(1.5, 20.0),
        step=0.5,
        words=("higher", "lower"),
    ),
    Lever(
        "bodice",
        1,
        _bodice_level,
        _set_bodice,
        cuts.lengthen_bodice,
        lambda f: (f.body.hips - 10.0, f.body.bust - 4.0),
        rate=-1.0,
        sign=-1.0,
        only_for=("bodice length", "waist_seam", "length", "length_cm", "top_hem"),
    ),
    Lever(
        "bodice, its blousing taken in,",
        1,
        _bodice_level,
        _set_bodice,
        _shorten_bloused,
        lambda f: (f.body.hips - 10.0, f.body.bust - 4.0),
        rate=-1.0,
        sign=-1.0,
        only_for=("bodice length", "waist_seam", "length", "length_cm", "top_hem"),
    ),
    Lever(
        "bodice, its band let out,",
        1,
        _banded_top,
        _set_bodice,
        cuts.lengthen_with_band,
        lambda f: (f.body.hips - 20.0, f.body.bust - 4.0),
        rate=-1.0,
        sign=-1.0,
        only_for=("bodice length", "length", "length_cm", "top_hem"),
        gathers=True,
    ),
)

"""Levers that make garments, legs, sleeves, cuffs, bands and collars longer or shorter."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Literal

from swifttailor.describing.facts import Cuff, GarmentFacts, Sleeve
from swifttailor.describing.facts_paths import (
    imagine_at,
    mean_of_sleeves,
    shift_sleeves,
    with_sleeves,
)
from swifttailor.describing.measuring.parts import Part
from swifttailor.pattern import Pattern
from swifttailor.recutting.amounts import cuts, neck_cuts
from swifttailor.recutting.levers.lever import LOWEST_CM, Lever, fixed, of_dimension, of_sides, with_hem
from swifttailor.recutting.levers.tiers import lengthen_tiered
from swifttailor.recutting.table.cutter import Cutter

_SEEN_BLOUSON_CM = 1.0
_HIGHER = ("higher", "lower")
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


def sleeve_lever(sides: tuple[ArmSide, ...]) -> Lever:
    """Moves the ends of one or both sleeves."""
    of = mean_of_sleeves(lambda s: s.length, sides)
    return Lever(
        name=of_sides("sleeve", sides),
        serves=("sleeve length",),
        stage=3,
        of=of,
        imagine=shift_sleeves(of, "length", sides=sides),
        cut=lambda cutter, amount: cuts.lengthen_sleeves(cutter, amount, sides),
        span=lambda f: (6.0, 1.19 * f.body.arm_length),
    )


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

    return with_sleeves(facts, changed)


def _cuff_lever(name: str, part: Part) -> Lever:
    of = of_dimension(f"{name} length")

    def imagine(facts: GarmentFacts, length: float) -> GarmentFacts:
        by = length - (of(facts) or 0.0)
        return with_cuffs(facts, part, lambda c: replace(c, length=c.length + by), by)

    return Lever(
        name=f"{name}s",
        serves=(f"{name} length",),
        stage=2,
        of=of,
        imagine=imagine,
        cut=lambda cutter, amount: cuts.lengthen_cuffs(cutter, amount, part),
        span=fixed(2.0, 60.0),
        step=0.5,
        only_for=("cuffs", "cuff_cm", "cuff length", "leg_cuffs", "leg_cuff_cm", "leg cuff length"),
    )


def _set_band(facts: GarmentFacts, height: float) -> GarmentFacts:
    band = facts.waistband
    if band is None:
        return facts
    return replace(with_hem(facts, height - band.height), waistband=replace(band, height=height))


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
    name="hem",
    serves=("length", "skirt length"),
    stage=5,
    of=lambda f: f.hem.level if f.hem and f.trousers is None else None,
    imagine=_set_hem,
    cut=lengthen_tiered,
    span=lambda f: (LOWEST_CM + 1.0, f.body.bust - 2.0),
    rate=-1.0,
    sign=-1.0,
)
_BODICE = Lever(
    name="bodice",
    serves=("bodice length",),
    stage=1,
    of=_bodice_level,
    imagine=_set_bodice,
    cut=cuts.lengthen_bodice,
    span=lambda f: (f.body.hips - 10.0, f.body.bust - 4.0),
    rate=-1.0,
    sign=-1.0,
    only_for=("bodice length", "waist_seam", "length", "length_cm", "top_hem"),
)
LENGTH_LEVERS: tuple[Lever, ...] = (
    HEM,
    replace(HEM, name="hem, flared over the hips,", cut=cuts.lengthen_over_hips),
    Lever(
        name="legs",
        serves=("leg length",),
        stage=5,
        of=of_dimension("leg length"),
        imagine=_set_inseam,
        cut=cuts.lengthen_legs,
        span=_inseam_span,
    ),
    sleeve_lever(("left", "right")),
    sleeve_lever(("left",)),
    sleeve_lever(("right",)),
    _cuff_lever("cuff", Part.CUFF),
    _cuff_lever("leg cuff", Part.LEG_CUFF),
    Lever(
        name="band",
        serves=("waistband height",),
        stage=2,
        of=of_dimension("waistband height"),
        imagine=_set_band,
        cut=cuts.raise_band,
        span=fixed(2.0, 25.0),
        step=0.5,
        words=_HIGHER,
        only_for=("waistband", "waistband_cm", "waistband height"),
    ),
    Lever(
        name="collar",
        serves=("collar height",),
        stage=2,
        of=of_dimension("collar height"),
        imagine=imagine_at("collar.height"),
        cut=neck_cuts.raise_collar,
        span=fixed(1.5, 20.0),
        step=0.5,
        words=_HIGHER,
    ),
    _BODICE,
    replace(_BODICE, name="bodice, its blousing taken in,", cut=_shorten_bloused),
    replace(
        _BODICE,
        name="bodice, its band let out,",
        of=_banded_top,
        cut=cuts.lengthen_with_band,
        span=lambda f: (f.body.hips - 20.0, f.body.bust - 4.0),
        only_for=("bodice length", "length", "length_cm", "top_hem"),
        gathers=True,
    ),
)

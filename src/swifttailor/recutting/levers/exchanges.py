"""Halves of a garment exchanged for newly drafted ones, and waistbands set in and taken out between them."""

from __future__ import annotations

import math
from dataclasses import replace

from swifttailor.describing.facts import Band, GarmentFacts, HemFacts, Skirt, Torso, Trousers
from swifttailor.describing.facts_paths import Imagine
from swifttailor.describing.measuring.skirts import CURVED_CIRCLE
from swifttailor.pattern import Pattern
from swifttailor.recutting.amounts import part_swaps
from swifttailor.recutting.amounts.part_swaps import FlaredCut, LegsCut, StraightCut
from swifttailor.recutting.levers.lever import WIDER, Lever, Trick, fixed, kind_of, of_dimension, with_hem
from swifttailor.recutting.levers.slits import recut_closed
from swifttailor.recutting.table.cutter import Cutter

_LEAST_FRACTION, _MOST_FRACTION = 0.1, 1.8
"""Of a circle: what flares less is cut straight, what flares more does not lie flat."""
_GATHERED = 1.1
_HIP_EASE_CM = 2.0
_HIPS_BELOW_CM = 5.0
"""A skirt that begins less far above the hips is as wide there as above."""
_FLAT_CM = 4.0
"""A hem whose front and back, or left and right, differ by more is bent on purpose."""


def _top_of_lower(facts: GarmentFacts) -> float | None:
    """Height of the upper edge of skirt or trousers, cm."""
    if facts.hem is None:
        return None
    if not facts.torso and not facts.waistband:
        return facts.top_level
    if facts.skirt is not None:
        return facts.hem.level + facts.skirt.length
    if facts.waistband is not None:
        return facts.waistband.level - facts.waistband.height
    return facts.torso.lower_level if facts.torso else None


def _level_hem(level: float, length: float) -> HemFacts:
    return HemFacts(level=level, front=level, back=level, left=level, right=level, length=length, dip=0.0)


def _new_skirt(facts: GarmentFacts, length: float, hem: float, *, straight: bool) -> GarmentFacts | None:
    top = _top_of_lower(facts)
    if top is None:
        return None
    own = facts.torso.lower_edge if facts.torso else facts.body.waist_girth
    upper = facts.waistband.lower if facts.waistband else own
    upper = facts.skirt.upper if facts.skirt else upper
    circle = (hem - upper) / (2 * math.pi * length)
    drop = max(top - facts.body.hips, 0.0)
    hips = facts.body.hip_girth + 5.0 if straight else upper + min(drop / length, 1.0) * (hem - upper)
    skirt = Skirt(
        length=length,
        upper=upper,
        gather=1.0,
        hips=hips,
        hem=hem,
        circle=circle,
        gores=2,
        tiers=1,
        tier_gather=1.0,
        base_length=length,
        base_hem=hem,
        godets=0,
        godet_width=0.0,
        godet_height=0.0,
        darts=4 if straight else 0,
        slits=facts.skirt.slits if facts.skirt else (),
    )
    level = top - length
    kind = "dress" if facts.torso else "skirt"
    facts = replace(facts, trousers=None, skirt=skirt, kind=kind, hem=_level_hem(level, hem))
    facts = replace(facts, length=facts.top_level - level)
    return replace(facts, kind=kind_of(facts, level))


def _flat_skirt(facts: GarmentFacts) -> Skirt | None:
    """A skirt of one row with nothing but its flare and slits, its hem level."""
    skirt, hem = facts.skirt, facts.hem
    if skirt is None or hem is None or _top_of_lower(facts) is None:
        return None
    if skirt.tiers > 1 or skirt.godets or skirt.gores > 2 or skirt.length < 10.0:
        return None
    return skirt if max(abs(hem.front - hem.back), abs(hem.left - hem.right)) < _FLAT_CM else None


def _hem(facts: GarmentFacts) -> float | None:
    skirt = _flat_skirt(facts)
    return skirt.hem if skirt else None


def _curved_hem(facts: GarmentFacts) -> float | None:
    skirt = _flat_skirt(facts)
    return skirt.hem if skirt and skirt.circle > CURVED_CIRCLE and skirt.gather < _GATHERED else None


def _anew(*, straight: bool) -> Imagine:
    def imagine(facts: GarmentFacts, hem: float) -> GarmentFacts:
        skirt = _flat_skirt(facts)
        new = _new_skirt(facts, skirt.length, hem, straight=straight) if skirt else None
        return new or facts

    return imagine


def _least_fraction(facts: GarmentFacts) -> float:
    """Of a circle that a skirt must be to pass the hips."""
    top, skirt = _top_of_lower(facts), facts.skirt
    drop = 0.0 if top is None else top - facts.body.hips
    if skirt is None or drop < _HIPS_BELOW_CM or skirt.length < drop:
        return _LEAST_FRACTION
    passing = (facts.body.hip_girth + _HIP_EASE_CM - skirt.upper) / (2 * math.pi * drop)
    return max(_LEAST_FRACTION, passing)


def _flared_span(facts: GarmentFacts) -> tuple[float, float]:
    skirt = _flat_skirt(facts)
    if skirt is None:
        return 0.0, 0.0
    around = 2 * math.pi * skirt.length
    return skirt.upper + _least_fraction(facts) * around, skirt.upper + _MOST_FRACTION * around


def cut_flared(cutter: Cutter, amount: float) -> Pattern | None:
    """A skirt of one row cut anew from a circle, its hem wider by cm; above it fits what holds it."""
    skirt = _flat_skirt(cutter.facts)
    if skirt is None:
        return None
    fraction = (skirt.hem + amount - skirt.upper) / (2 * math.pi * skirt.length)
    if not 0.9 * _least_fraction(cutter.facts) <= fraction <= 1.05 * _MOST_FRACTION:
        return None
    return _exchange_closed(cutter, FlaredCut(fraction, skirt.length))


def _straight_span(facts: GarmentFacts) -> tuple[float, float]:
    skirt, hem = _flat_skirt(facts), facts.hem
    if skirt is None or hem is None or hem.level > facts.body.hips - 15.0:
        return 0.0, 0.0
    return 0.85 * facts.body.hip_girth, facts.body.hip_girth + 0.5 * (facts.body.hips - hem.level)


def _cut_straight(cutter: Cutter, amount: float) -> Pattern | None:
    skirt, hem, body = _flat_skirt(cutter.facts), cutter.facts.hem, cutter.facts.body
    if skirt is None or hem is None:
        return None
    spread = (skirt.hem + amount - body.hip_girth - 5.0) / 4.0
    below = body.hips - hem.level
    if below < 10.0 or abs(spread) > 0.5 * below:
        return None
    return _exchange_closed(cutter, StraightCut(skirt.length, math.degrees(math.asin(spread / below))))


def _exchange_closed(cutter: Cutter, cut: FlaredCut | StraightCut) -> Pattern | None:
    """With slits closed, which are opened again."""
    return recut_closed(cutter, lambda shut: part_swaps.exchange_lower(shut, cut), first=False)


def _for_skirt(straight: bool) -> Trick:
    """Trousers exchanged for a skirt that reaches the knees."""

    def length(facts: GarmentFacts) -> float | None:
        top = _top_of_lower(facts)
        return None if top is None else top - facts.body.knee

    def imagine(facts: GarmentFacts) -> GarmentFacts | None:
        own = length(facts)
        if facts.trousers is None or own is None or own < 20.0:
            return None
        hem = facts.body.hip_girth + 5.0 if straight else facts.body.waist_girth + math.pi * own
        return _new_skirt(facts, own, hem, straight=straight)

    def cut(cutter: Cutter) -> Pattern | None:
        own = length(cutter.facts)
        if own is None:
            return None
        return part_swaps.exchange_lower(cutter, StraightCut(own, 0.0) if straight else FlaredCut(0.5, own))

    shape = "straight" if straight else "flared"
    return Trick(
        name=f"trousers exchanged for a {shape} skirt", stage=0, imagine=imagine, cut=cut, only_for=("kind",)
    )


def _for_trousers(short: bool) -> Trick:
    """A skirt exchanged for trousers to the ankles, or for shorts."""

    def ends(facts: GarmentFacts) -> float:
        return facts.body.crotch - 14.0 if short else 7.0

    def imagine(facts: GarmentFacts) -> GarmentFacts | None:
        top = _top_of_lower(facts)
        if facts.skirt is None or top is None or top < facts.body.crotch + 15.0:
            return None
        body, level = facts.body, ends(facts)
        hem = body.thigh_girth + 10.0 if short else 0.6 * body.thigh_girth + 12.0
        legs = Trousers(
            inseam=body.crotch - level,
            thigh=body.thigh_girth + 6.0,
            hem=hem,
            opening=hem,
            end_gather=1.0,
            gather=1.0,
            hips=body.hip_girth + 5.0,
            cuff=None,
            darts=4,
        )
        kind = "jumpsuit" if facts.torso else "trousers"
        facts = replace(facts, skirt=None, trousers=legs, kind=kind, hem=_level_hem(level, 2 * hem))
        return replace(facts, length=facts.top_level - level)

    def cut(cutter: Cutter) -> Pattern | None:
        top = _top_of_lower(cutter.facts)
        if top is None:
            return None
        return part_swaps.exchange_lower(cutter, LegsCut(top - ends(cutter.facts), 4.0))

    name = "skirt exchanged for shorts" if short else "skirt exchanged for trousers"
    return Trick(name=name, stage=0, imagine=imagine, cut=cut, only_for=("kind",))


def _with_bodice(facts: GarmentFacts) -> GarmentFacts | None:
    if facts.torso is not None or facts.hem is None:
        return None
    body = facts.body
    bust = body.waist_girth + 20.0
    torso = Torso(
        left_shoulder=8.0,
        right_shoulder=8.0,
        chest=bust,
        chest_ease=4.0,
        waist=body.waist_girth,
        lower_edge=body.waist_girth,
        lower_level=body.waist,
        gather=1.0,
        darts=6,
        blouson=0.0,
        left_armhole=None,
        right_armhole=None,
    )
    kind = "jumpsuit" if facts.trousers else "dress"
    top = body.neck
    rise = body.waist - facts.top_level
    facts = with_hem(facts, -rise)
    assert facts.hem is not None
    facts = replace(facts, torso=torso, top_level=top, length=top - facts.hem.level, kind=kind)
    return replace(facts, kind=kind_of(facts, facts.hem.level)) if facts.hem else facts


def _band_out(facts: GarmentFacts) -> GarmentFacts | None:
    band = facts.waistband
    if band is None or facts.torso is None or not (facts.skirt or facts.trousers):
        return None
    return replace(with_hem(facts, -band.height), waistband=None)


def _band_in(facts: GarmentFacts, height: float) -> GarmentFacts:
    torso = facts.torso
    if torso is None or facts.waistband is not None or not (facts.skirt or facts.trousers):
        return facts
    width = facts.skirt.upper if facts.skirt else torso.lower_edge / max(torso.gather, 0.1)
    return replace(with_hem(facts, height), waistband=Band(height, width, width, False, torso.lower_level))


_ANEW = Lever(
    name="skirt cut anew from a circle, its hem",
    serves=("skirt hem",),
    stage=4,
    of=_hem,
    imagine=_anew(straight=False),
    cut=cut_flared,
    span=_flared_span,
    step=5.0,
    words=WIDER,
    only_for=("skirt", "skirt hem", "skirt gathers", "hem_cm", "hips"),
)
CURVED_LEVERS: tuple[Lever, ...] = (replace(_ANEW, of=_curved_hem),)
"""Before seams are turned or cloth is gathered in, which bends the hem of what is cut from a circle."""
EXCHANGE_LEVERS: tuple[Lever, ...] = (
    _ANEW,
    replace(
        _ANEW,
        name="skirt cut anew with darts, its hem",
        imagine=_anew(straight=True),
        cut=_cut_straight,
        span=_straight_span,
        step=2.0,
    ),
    Lever(
        name="waistband set in",
        serves=("waistband height",),
        stage=0,
        of=of_dimension("waistband height"),
        imagine=_band_in,
        cut=part_swaps.put_band_in,
        span=fixed(3.0, 12.0),
        step=0.5,
        moves=False,
        natural=5.0,
        only_for=("waistband", "waistband_cm"),
        gathers=True,
    ),
)

EXCHANGE_TRICKS: tuple[Trick, ...] = (
    _for_skirt(straight=True),
    _for_skirt(straight=False),
    _for_trousers(short=False),
    _for_trousers(short=True),
    Trick(
        name="bodice sewn on",
        stage=0,
        imagine=_with_bodice,
        cut=part_swaps.sew_bodice,
        only_for=("kind",),
        gathers=True,
    ),
    Trick(
        name="waistband taken out",
        stage=0,
        imagine=_band_out,
        cut=part_swaps.take_band_out,
        only_for=("waistband",),
        gathers=True,
    ),
)

"""Levers that make hems, legs, sleeves and cuffs wider or narrower, and gather more or less of a skirt."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

from swifttailor.describing.facts import Cuff, GarmentFacts
from swifttailor.describing.measuring.parts import Part
from swifttailor.describing.measuring.sleeves import FLOUNCE_FLARE
from swifttailor.pattern import Pattern
from swifttailor.recutting.amounts import cuts
from swifttailor.recutting.levers.lengths import with_cuffs, with_sleeves
from swifttailor.recutting.levers.lever import Lever, Trick, fixed
from swifttailor.recutting.levers.slits import recut_closed
from swifttailor.recutting.table.cutter import Cutter

SIDE_EDGES = 4.0
"""Ends of side seams around a hem: so much wider does it get for 1 cm at each."""
DART_CM = 2.5
"""What a dart of a skirt takes in, about."""
_WIDER = ("wider", "narrower")


def _hem(facts: GarmentFacts) -> float | None:
    if facts.skirt is not None:
        return facts.skirt.hem
    plain = facts.torso and not facts.trousers and not facts.waistband
    return facts.torso.lower_edge if plain and facts.torso else None


def _set_hem(facts: GarmentFacts, width: float) -> GarmentFacts:
    skirt, torso = facts.skirt, facts.torso
    if skirt is not None:
        upper = skirt.hem - 2 * math.pi * skirt.length * skirt.circle
        circle = (width - upper) / (2 * math.pi * skirt.length) if skirt.length > 1.0 else 0.0
        low = facts.hem.level if facts.hem else 0.0
        waist = facts.body.waist
        share = min(max((waist - facts.body.hips) / max(waist - low, 1.0), 0.0), 1.0)
        hips = skirt.hips + share * (width - skirt.hem)
        return replace(facts, skirt=replace(skirt, hem=width, circle=circle, base_hem=width, hips=hips))
    return replace(facts, torso=replace(torso, lower_edge=width)) if torso else facts


def _hem_span(facts: GarmentFacts) -> tuple[float, float]:
    return 60.0, max(260.0, 2.0 * (_hem(facts) or 0.0))


def _flare_hem(cutter: Cutter, amount: float) -> Pattern | None:
    return recut_closed(cutter, lambda shut: _flare(shut, amount))


def _flare(cutter: Cutter, amount: float) -> Pattern | None:
    if not cuts.is_gored(cutter):
        return cuts.flare_hem(cutter, amount / SIDE_EDGES)
    return cuts.flare_hem(cutter, amount / (2.0 * len(cutter.names(Part.SKIRT))))


def _sleeve_end(facts: GarmentFacts) -> float | None:
    ends = [s.end_width for s in (facts.left_sleeve, facts.right_sleeve) if s and s.cuff is None]
    return sum(ends) / len(ends) if ends else None


def _set_sleeve_end(facts: GarmentFacts, width: float) -> GarmentFacts:
    by = width - (_sleeve_end(facts) or 0.0)
    return with_sleeves(
        facts, ("left", "right"), lambda s: replace(s, end_width=s.end_width + by, opening=s.opening + by)
    )


def _leg_end(facts: GarmentFacts) -> float | None:
    return facts.trousers.hem if facts.trousers and facts.trousers.cuff is None else None


def _set_leg_end(facts: GarmentFacts, width: float) -> GarmentFacts:
    return (
        replace(facts, trousers=replace(facts.trousers, hem=width, opening=width))
        if facts.trousers
        else facts
    )


def _opening(part: Part) -> Callable[[GarmentFacts], float | None]:
    def of(facts: GarmentFacts) -> float | None:
        if part is Part.LEG_CUFF:
            return facts.trousers.cuff.opening if facts.trousers and facts.trousers.cuff else None
        found = [s.cuff.opening for s in (facts.left_sleeve, facts.right_sleeve) if s and s.cuff]
        return sum(found) / len(found) if found else None

    return of


def _cuff_width(part: Part) -> Lever:
    of = _opening(part)

    def imagine(facts: GarmentFacts, width: float) -> GarmentFacts:
        share = width / max(of(facts) or 1.0, 1.0)

        def widened(cuff: Cuff) -> Cuff:
            flare = cuff.flare * share
            kind = "flounce" if flare > FLOUNCE_FLARE else cuff.kind
            return replace(cuff, opening=cuff.opening * share, flare=flare, kind=kind)

        return with_cuffs(facts, part, widened, 0.0)

    def cut(cutter: Cutter, amount: float) -> Pattern | None:
        return cuts.widen_cuffs(cutter, amount, part)

    name = "cuffs" if part is Part.CUFF else "leg cuffs"
    return Lever(name, 4, of, imagine, cut, fixed(14.0, 110.0), rate=SIDE_EDGES, words=_WIDER)


def _gather(facts: GarmentFacts) -> float | None:
    skirt = facts.skirt
    return skirt.gather if skirt and not skirt.darts and not skirt.godets and facts.panels > 2 else None


def _set_gather(facts: GarmentFacts, gather: float) -> GarmentFacts:
    skirt = facts.skirt
    if skirt is None:
        return facts
    f = gather / max(skirt.gather, 0.1)
    skirt = replace(
        skirt,
        gather=gather,
        hips=skirt.hips * f,
        hem=skirt.hem * f,
        circle=skirt.circle * f,
        base_hem=skirt.base_hem * f,
    )
    return replace(facts, skirt=skirt)


def _cut_gather(cutter: Cutter, amount: float) -> Pattern | None:
    gather = cuts.skirt_gather(cutter)
    return cuts.gather_skirt(cutter, (gather + amount) / gather, bend_arcs=True) if gather else None


WIDTH_LEVERS: tuple[Lever, ...] = (
    Lever("hem", 6, _hem, _set_hem, _flare_hem, _hem_span, step=3.0, words=_WIDER),
    Lever(
        "leg ends",
        6,
        _leg_end,
        _set_leg_end,
        cuts.flare_legs,
        fixed(18.0, 110.0),
        rate=SIDE_EDGES,
        words=_WIDER,
    ),
    Lever(
        "sleeve ends",
        4,
        _sleeve_end,
        _set_sleeve_end,
        cuts.flare_sleeves,
        fixed(16.0, 110.0),
        rate=SIDE_EDGES,
        words=_WIDER,
    ),
    _cuff_width(Part.CUFF),
    _cuff_width(Part.LEG_CUFF),
    Lever(
        "skirt at its seam",
        4,
        _gather,
        _set_gather,
        _cut_gather,
        fixed(1.0, 2.7),
        step=0.04,
        words=("times more gathered", "times less gathered"),
        unit="",
        gathers=True,
    ),
)


def _without_darts(facts: GarmentFacts) -> GarmentFacts | None:
    skirt = facts.skirt
    if skirt is None or not skirt.darts or not (facts.torso or facts.waistband):
        return None
    gather = skirt.gather * (1.0 + DART_CM * skirt.darts / max(skirt.upper, 1.0))
    return replace(facts, skirt=replace(skirt, darts=0, gather=gather))


WIDTH_TRICKS: tuple[Trick, ...] = (
    Trick(
        "skirt darts let out",
        4,
        _without_darts,
        cuts.let_out_skirt,
        gathers=True,
        only_for=("skirt gathers", "skirt: gathered"),
        opens=("skirt gathers", "skirt: gathered"),
    ),
)

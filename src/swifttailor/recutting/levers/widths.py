"""Levers that make hems, legs, sleeves and cuffs wider or narrower, and gather more or less of a skirt."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

from swifttailor.describing.facts import Cuff, GarmentFacts
from swifttailor.describing.facts_paths import (
    Measure,
    imagine_at,
    mean,
    measure_at,
    shift_sleeves,
    sleeves_of,
)
from swifttailor.describing.measuring.parts import Part
from swifttailor.describing.measuring.sleeves import FLOUNCE_FLARE
from swifttailor.pattern import Pattern
from swifttailor.recutting.amounts import cuts
from swifttailor.recutting.levers.lengths import with_cuffs
from swifttailor.recutting.levers.lever import MORE_GATHERED, WIDER, Lever, Trick, fixed
from swifttailor.recutting.levers.slits import recut_closed
from swifttailor.recutting.table.cutter import Cutter

SIDE_EDGES = 4.0
"""Ends of side seams around a hem: so much wider does it get for 1 cm at each."""
DART_CM = 2.5
"""What a dart of a skirt takes in, about."""
_LEAST_GATHER, _MOST_GATHER = 1.0, 2.7
_HIP_EASE_CM = 3.0
_GATHERED = ("skirt gathers", "skirt: gathered")


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


def _flare_hem(cutter: Cutter, amount: float) -> Pattern | None:
    def flare(cutter: Cutter) -> Pattern | None:
        edges = 2.0 * len(cutter.names(Part.SKIRT)) if cuts.is_gored(cutter) else SIDE_EDGES
        return cuts.flare_hem(cutter, amount / edges)

    return recut_closed(cutter, flare)


def _sleeve_end(facts: GarmentFacts) -> float | None:
    return mean([s.end_width for s in sleeves_of(facts) if s.cuff is None])


def _cuff_opening(facts: GarmentFacts) -> float | None:
    return mean([s.cuff.opening for s in sleeves_of(facts) if s.cuff])


def _end_lever(
    name: str,
    serves: tuple[str, ...],
    of: Measure,
    imagine: Callable[[GarmentFacts, float], GarmentFacts],
    cut: Callable[[Cutter, float], Pattern | None],
    *,
    least: float,
    stage: int = 4,
) -> Lever:
    """Turns the seams that end at a free end."""
    return Lever(
        name=name,
        serves=serves,
        stage=stage,
        of=of,
        imagine=imagine,
        cut=cut,
        span=fixed(least, 110.0),
        rate=SIDE_EDGES,
        words=WIDER,
    )


def _cuff_width(name: str, serves: str, part: Part, of: Measure) -> Lever:
    def imagine(facts: GarmentFacts, width: float) -> GarmentFacts:
        share = width / max(of(facts) or 1.0, 1.0)

        def widened(cuff: Cuff) -> Cuff:
            flare = cuff.flare * share
            kind = "flounce" if flare > FLOUNCE_FLARE else cuff.kind
            return replace(cuff, opening=cuff.opening * share, flare=flare, kind=kind)

        return with_cuffs(facts, part, widened, 0.0)

    def cut(cutter: Cutter, amount: float) -> Pattern | None:
        return cuts.widen_cuffs(cutter, amount, part)

    return _end_lever(name, (serves,), of, imagine, cut, least=14.0)


def _gather(facts: GarmentFacts) -> float | None:
    skirt = facts.skirt
    return skirt.gather if skirt and not skirt.darts and not skirt.godets and facts.panels > 2 else None


def _set_gather(facts: GarmentFacts, gather: float) -> GarmentFacts:
    skirt = facts.skirt
    if skirt is None:
        return facts
    factor = gather / max(skirt.gather, 0.1)
    wider = {name: getattr(skirt, name) * factor for name in ("hips", "hem", "circle", "base_hem")}
    return replace(facts, skirt=replace(skirt, gather=gather, **wider))


def _gather_span(facts: GarmentFacts) -> tuple[float, float]:
    """Down to what the hips pass."""
    skirt, hem = facts.skirt, facts.hem
    if skirt is None or hem is None or hem.level > facts.body.hips:
        return _LEAST_GATHER, _MOST_GATHER
    passing = skirt.gather * (facts.body.hip_girth + _HIP_EASE_CM) / max(skirt.hips, 1.0)
    return min(max(_LEAST_GATHER, passing), max(skirt.gather, _LEAST_GATHER)), _MOST_GATHER


def _cut_gather(cutter: Cutter, amount: float) -> Pattern | None:
    gather = cuts.skirt_gather(cutter)
    return cuts.gather_skirt(cutter, (gather + amount) / gather) if gather else None


WIDTH_LEVERS: tuple[Lever, ...] = (
    Lever(
        name="hem",
        serves=("skirt hem", "top width", "base width"),
        stage=6,
        of=_hem,
        imagine=_set_hem,
        cut=_flare_hem,
        span=lambda f: (60.0, max(260.0, 2.0 * (_hem(f) or 0.0))),
        step=3.0,
        words=WIDER,
    ),
    _end_lever(
        "leg ends",
        ("leg end",),
        lambda f: f.trousers.hem if f.trousers and f.trousers.cuff is None else None,
        imagine_at("trousers.hem", "trousers.opening"),
        cuts.flare_legs,
        least=18.0,
        stage=6,
    ),
    _end_lever(
        "sleeve ends",
        ("sleeve end",),
        _sleeve_end,
        shift_sleeves(_sleeve_end, "end_width", "opening"),
        cuts.flare_sleeves,
        least=16.0,
    ),
    _cuff_width("cuffs", "cuff opening", Part.CUFF, _cuff_opening),
    _cuff_width("leg cuffs", "leg_cuffs", Part.LEG_CUFF, measure_at("trousers.cuff.opening")),
    Lever(
        name="skirt at its seam",
        serves=("skirt gathers",),
        stage=4,
        of=_gather,
        imagine=_set_gather,
        cut=_cut_gather,
        span=_gather_span,
        step=0.04,
        words=MORE_GATHERED,
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
        name="skirt darts let out",
        stage=4,
        imagine=_without_darts,
        cut=cuts.let_out_skirt,
        gathers=True,
        only_for=_GATHERED,
        opens=_GATHERED,
    ),
)

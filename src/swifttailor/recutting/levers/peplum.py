"""A peplum sewn to a top."""

from __future__ import annotations

import math
from dataclasses import replace

from swifttailor.describing.facts import GarmentFacts, HemFacts, Skirt
from swifttailor.recutting.amounts.peplum import PEPLUM_CM, PEPLUM_FRACTION, SHORT_CM, sew_peplum
from swifttailor.recutting.levers.lever import Trick


def _with_peplum(facts: GarmentFacts) -> GarmentFacts | None:
    torso, hem = facts.torso, facts.hem
    if torso is None or hem is None or facts.skirt or facts.trousers or facts.waistband:
        return None
    waist = facts.body.waist
    if hem.level > waist + SHORT_CM:
        return None
    around = hem.length + 2 * math.pi * PEPLUM_FRACTION * PEPLUM_CM
    skirt = Skirt(
        length=PEPLUM_CM,
        upper=hem.length,
        gather=1.0,
        hips=around,
        hem=around,
        circle=PEPLUM_FRACTION,
        gores=2,
        tiers=1,
        tier_gather=1.0,
        base_length=PEPLUM_CM,
        base_hem=around,
        godets=0,
        godet_width=0.0,
        godet_height=0.0,
        darts=0,
        slits=(),
    )
    seam = waist if waist - hem.level > SHORT_CM else hem.level
    level = seam - PEPLUM_CM
    below = HemFacts(level=level, front=level, back=level, left=level, right=level, length=around, dip=0.0)
    torso = replace(torso, lower_level=seam)
    return replace(facts, kind="top", torso=torso, skirt=skirt, hem=below, length=facts.top_level - level)


PEPLUM_TRICKS: tuple[Trick, ...] = (
    Trick(
        name="peplum sewn on",
        stage=0,
        imagine=_with_peplum,
        cut=sew_peplum,
        only_for=("skirt: peplum",),
        opens=("kind: jumpsuit", "kind: playsuit"),
    ),
)

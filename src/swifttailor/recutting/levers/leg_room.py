"""The lever of the room in trousers: legs spread from waist to hem, the cloth gathered at the waist."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.measuring.parts import LEG_PARTS
from swifttailor.pattern import Pattern
from swifttailor.recutting.levers.lever import WIDER, Lever
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.fullness import let_out_darts
from swifttailor.recutting.ways.grading import Spread, spread_panels

_PANELS_OF_A_LEG = 2.0
_PANELS = 4.0
_INNER, _OUTER = 0.35, 0.8
"""Where a leg is spread, parts of the reach of its panel from the middle of the body: beside the crease."""
_MOST_GATHER, _MOST_WIDER = 1.8, 1.9


def _thigh(facts: GarmentFacts) -> float | None:
    return facts.trousers.thigh if facts.trousers else None


def _set_thigh(facts: GarmentFacts, thigh: float) -> GarmentFacts:
    legs = facts.trousers
    if legs is None:
        return facts
    by = (thigh - legs.thigh) / _PANELS_OF_A_LEG
    upper = facts.waistband.lower if facts.waistband else facts.body.waist_girth
    hem = legs.hem + _PANELS_OF_A_LEG * by
    wider = replace(
        legs,
        thigh=thigh,
        hips=legs.hips + _PANELS * by,
        hem=hem,
        opening=hem if legs.cuff is None else legs.opening,
        end_gather=legs.end_gather if legs.cuff is None else legs.end_gather * hem / max(legs.hem, 1.0),
        gather=legs.gather + _PANELS * by / max(upper, 1.0),
        darts=0,
    )
    return replace(facts, trousers=wider)


def _span(facts: GarmentFacts) -> tuple[float, float]:
    legs = facts.trousers
    if legs is None:
        return 0.0, 0.0
    upper = facts.waistband.lower if facts.waistband else facts.body.waist_girth
    room = max(_MOST_GATHER - legs.gather, 0.0) * upper / _PANELS * _PANELS_OF_A_LEG
    return legs.thigh, min(_MOST_WIDER * legs.thigh, legs.thigh + room)


def _spread_legs(cutter: Cutter, amount: float) -> Pattern | None:
    """Everything beside the crease moves outward, all of the side seam alike; darts are let out first."""
    names = [p.name for p in cutter.anatomy.panels(LEG_PARTS) if p.name.startswith("pant")]
    if not names or amount <= 0:
        return None
    darted = [
        s for s in cutter.pattern.stitches if s.first.panel == s.second.panel and s.first.panel in names
    ]
    pattern = let_out_darts(cutter.pattern, names) if darted else cutter.pattern
    if pattern is None:
        return None
    spreads = {}
    for name in names:
        panel = pattern.panel(name)
        reach = float(np.abs(panel.to_world(panel.vertices)[:, 0]).max())
        spreads[name] = Spread(_INNER * reach, _OUTER * reach)
    return spread_panels(pattern, spreads, amount / _PANELS_OF_A_LEG)


LEG_ROOM_LEVERS: tuple[Lever, ...] = (
    Lever(
        name="legs from waist to hem, gathered at the waist,",
        serves=("thigh",),
        stage=3,
        of=_thigh,
        imagine=_set_thigh,
        cut=_spread_legs,
        span=_span,
        words=WIDER,
        only_for=("thigh", "hips", "hips: loose", "legs: wide", "leg end"),
        gathers=True,
    ),
)

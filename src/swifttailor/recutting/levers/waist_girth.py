"""The lever of the waist of skirts and trousers: the band let out or taken in, with what hangs from it."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.measuring.parts import LEG_PARTS, Part
from swifttailor.describing.measuring.skirts import upper_edges
from swifttailor.pattern import Pattern
from swifttailor.recutting.levers.exchanges import cut_flared
from swifttailor.recutting.levers.lever import WIDER, Lever
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.fullness import widen_panels

_MOST, _LEAST = 1.35, 0.88
"""Of the girth that the band has."""
_AT_HIPS = 0.5
"""How much of it is left at the hips, about: the ends of skirt and legs stay as they are."""


def _band(facts: GarmentFacts) -> float | None:
    band = facts.waistband
    if band is None or band.at_hem or facts.torso is not None or not (facts.skirt or facts.trousers):
        return None
    return band.upper


def _set_band(facts: GarmentFacts, girth: float) -> GarmentFacts:
    band, skirt, legs = facts.waistband, facts.skirt, facts.trousers
    if band is None or _band(facts) is None:
        return facts
    by = girth - band.upper
    band = replace(band, upper=girth, lower=band.lower * girth / max(band.upper, 1.0))
    if skirt is not None:
        skirt = replace(skirt, upper=skirt.upper + by, hips=skirt.hips + _AT_HIPS * by)
    if legs is not None:
        legs = replace(legs, hips=legs.hips + _AT_HIPS * by)
    return replace(facts, waistband=band, skirt=skirt, trousers=legs)


def _span(facts: GarmentFacts) -> tuple[float, float]:
    now = _band(facts) or 0.0
    return _LEAST * now, _MOST * now


def _cut(cutter: Cutter, amount: float) -> Pattern | None:
    """Band and upper edges are cut wider by the same part of their length, less so further down."""
    anatomy = cutter.anatomy
    band = cutter.facts.waistband
    if band is None:
        return None
    factor = (band.upper + amount) / band.upper
    part = Part.TROUSER if any(anatomy.has(p) for p in LEG_PARTS) else Part.SKIRT
    below = {ref.panel for ref in upper_edges(anatomy, part)[1].own}
    wider = widen_panels(cutter.pattern, cutter.names(Part.WAISTBAND), factor)
    if wider is None or not below:
        return None
    whole = widen_panels(wider, sorted(below), factor, keep_lower=True)
    # What is cut from a circle cannot be stretched: it is cut anew to fit the band.
    return cut_flared(cutter.with_pattern(wider), 0.0) if whole is None else whole


WAIST_GIRTH_LEVERS: tuple[Lever, ...] = (
    Lever(
        name="waist, with its band,",
        serves=("waistband width",),
        stage=2,
        of=_band,
        imagine=_set_band,
        cut=_cut,
        span=_span,
        step=0.5,
        words=WIDER,
        only_for=("waistband width",),
    ),
)

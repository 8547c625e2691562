"""The lever of the chest: the bodice wider or narrower, with what hangs from it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.measuring.parts import ARM_PARTS, LEG_PARTS, LOWER_PARTS, Part
from swifttailor.describing.measuring.skirts import upper_edges
from swifttailor.pattern import Pattern
from swifttailor.recutting.levers.lever import MORE_GATHERED, WIDER, Lever, fixed, of_dimension
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.ends import swing_sides
from swifttailor.recutting.ways.fullness import widen_panels
from swifttailor.recutting.ways.grading import Spread, spread_panels

_PANELS = 4.0
"""Side edges of front and back, left and right."""
_LEAST_SPREAD_CM = 3.0
_AT_HIPS = 0.35
"""How much of what a jumpsuit is let out at its waist is left at the hips, about."""
_LEAST_GATHER, _MOST_GATHER = 0.99, 1.9
"""Of the lower edge of a bodice over what holds it."""
_STEEPEST_SIDE = 0.6
_STRAPLESS = (0.35, 0.85)
"""Where a panel without shoulder is spread, parts of its reach from the middle."""


def _set_chest(facts: GarmentFacts, chest: float) -> GarmentFacts:
    torso = facts.torso
    if torso is None:
        return facts
    by = chest - torso.chest
    factor = 1.0 + by / max(torso.lower_edge, 1.0)
    left, right = (s if s is None else s + by / _PANELS for s in (torso.left_shoulder, torso.right_shoulder))
    wider = replace(
        torso,
        chest=chest,
        chest_ease=torso.chest_ease + by,
        waist=None if torso.waist is None else torso.waist + by,
        lower_edge=torso.lower_edge + by,
        left_shoulder=left,
        right_shoulder=right,
    )
    skirt, band, legs = facts.skirt, facts.waistband, facts.trousers
    if skirt is not None:
        skirt = replace(skirt, upper=skirt.upper * factor, hips=skirt.hips * factor, hem=skirt.hem * factor)
    if legs is not None:
        legs = replace(legs, hips=legs.hips + _AT_HIPS * by)
    if band is not None:
        band = replace(band, upper=band.upper * factor, lower=band.lower * factor)
    return replace(facts, torso=wider, skirt=skirt, trousers=legs, waistband=band)


def _span(facts: GarmentFacts) -> tuple[float, float]:
    if facts.torso is None:
        return 0.0, 0.0
    bust = facts.torso.chest - facts.torso.chest_ease
    return 0.95 * bust, 1.6 * bust


def _cut(cutter: Cutter, amount: float) -> Pattern | None:
    """What hangs from the bodice gets wider with it; legs down to the crotch."""
    anatomy, torso = cutter.anatomy, cutter.facts.torso
    length = anatomy.seam(Part.TORSO, {Part.WAISTBAND} | LOWER_PARTS).length
    factor = (length + amount) / length if length > 1.0 else 1.0
    wider = _cut_wider(cutter, amount, cutter.names(Part.WAISTBAND, Part.SKIRT, Part.GODET), factor)
    if wider is None or torso is None or not any(anatomy.has(p) for p in LEG_PARTS):
        return wider
    held = {ref.panel for ref in upper_edges(anatomy, Part.TROUSER)[1].own}
    band = cutter.facts.waistband
    top = torso.lower_level - (band.height if band else 0.0)
    return widen_panels(wider, sorted(held), factor, keep_lower=True, over=top - cutter.facts.body.crotch)


def _cut_wider(
    cutter: Cutter, amount: float, below: Sequence[str] = (), factor: float = 1.0
) -> Pattern | None:
    """Spreads the bodice, and what is below by a factor."""
    distance = amount / _PANELS
    spreads = {p.name: _spread(cutter, p.name, distance) for p in cutter.anatomy.panels(Part.TORSO)}
    beside = cutter.names(*ARM_PARTS)
    return spread_panels(cutter.pattern, spreads, distance, beside=beside, below=below, factor=factor)


def _spread(cutter: Cutter, name: str, distance: float) -> Spread:
    """Along the shoulder seam of a panel; by its reach where it has none."""
    cloth = cutter.anatomy.cloth
    for seam in cutter.worn.shoulders:
        refs = [ref for pair in seam.pairs for ref in pair] if seam else []
        if any(ref.panel == name for ref in refs):
            x = np.abs(np.concatenate([cloth.world[cloth.samples[ref]][:, 0] for ref in refs]))
            inner, outer = float(x.min()), float(x.max())
            return Spread(inner, max(outer, inner + _LEAST_SPREAD_CM - 2.0 * min(distance, 0.0)))
    panel = cutter.pattern.panel(name)
    reach = float(np.abs(panel.to_world(panel.vertices)[:, 0]).max())
    return Spread(_STRAPLESS[0] * reach, _STRAPLESS[1] * reach)


def _holding(facts: GarmentFacts) -> float | None:
    """Length of what holds the lower edge of a bodice without darts, cm; None where that is free."""
    torso = facts.torso
    if torso is None or torso.darts or not (facts.waistband or facts.skirt or facts.trousers):
        return None
    return torso.lower_edge / max(torso.gather, 0.1)


def _set_gathered_chest(facts: GarmentFacts, chest: float) -> GarmentFacts:
    held, torso = _holding(facts), facts.torso
    if held is None or torso is None:
        return facts
    wider = _set_chest(facts, chest).torso
    assert wider is not None
    return replace(facts, torso=replace(wider, gather=wider.lower_edge / held))


def _gathered_span(facts: GarmentFacts) -> tuple[float, float]:
    held, torso = _holding(facts), facts.torso
    if held is None or torso is None:
        return 0.0, 0.0
    bust = torso.chest - torso.chest_ease
    least = torso.chest + min(_LEAST_GATHER, torso.gather) * held - torso.lower_edge
    most = torso.chest + _MOST_GATHER * held - torso.lower_edge
    return max(0.95 * bust, least), min(1.6 * bust, most)


def _set_gather(facts: GarmentFacts, gather: float) -> GarmentFacts:
    torso = facts.torso
    if torso is None:
        return facts
    lower = torso.lower_edge * gather / max(torso.gather, 0.1)
    return replace(facts, torso=replace(torso, gather=gather, lower_edge=lower))


def _cut_lower_edge(cutter: Cutter, amount: float) -> Pattern | None:
    """Turns the side seams of the bodice: its chest stays, more or less of it is gathered below."""
    held = _holding(cutter.facts)
    seam = cutter.anatomy.seam(Part.TORSO, {Part.WAISTBAND} | LOWER_PARTS).own
    if held is None or not seam:
        return None
    return swing_sides(cutter.pattern, seam, amount * held / _PANELS, steepest=_STEEPEST_SIDE)


_CHEST = Lever(
    name="chest",
    serves=("chest", "waistband width"),
    stage=1,
    of=of_dimension("chest"),
    imagine=_set_chest,
    cut=_cut,
    span=_span,
    words=WIDER,
)
FIT_LEVERS: tuple[Lever, ...] = (
    Lever(
        name="bodice, its lower edge",
        serves=("bodice gathers",),
        stage=2,
        of=lambda f: f.torso.gather if _holding(f) is not None and f.torso else None,
        imagine=_set_gather,
        cut=_cut_lower_edge,
        span=fixed(1.0, 2.4),
        step=0.03,
        words=MORE_GATHERED,
        unit="",
        only_for=("bodice gathers", "bodice: gathered", "bodice"),
        gathers=True,
    ),
    _CHEST,
    replace(
        _CHEST,
        name="chest, gathered into what holds it,",
        imagine=_set_gathered_chest,
        cut=_cut_wider,
        span=_gathered_span,
        only_for=("chest", "chest_cm", "fit"),
        gathers=True,
    ),
)

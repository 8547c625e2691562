"""Darts in bodices that have none: what is gathered below, or is let out for it, is taken in by them."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.measuring.parts import LOWER_PARTS, Part
from swifttailor.pattern import Pattern
from swifttailor.recutting.levers.lever import Trick
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.ends import swing_sides
from swifttailor.recutting.ways.waist_darts import add_waist_darts

_PANELS = 4
_WIDTH_CM = 2.5
_WIDEST_CM = 4.5
"""Of a dart."""
_DEPTH_CM = 13.0
_AROUND_WAIST_CM = 12.0
"""How far from the waist the lower edge of a bodice with waist darts may lie."""
_STEEPEST = 0.4


def _gathered_cm(facts: GarmentFacts) -> float:
    """What is gathered in below, cm of each panel."""
    torso = facts.torso
    if torso is None or torso.gather <= 1.0:
        return 0.0
    return (torso.lower_edge - torso.lower_edge / torso.gather) / _PANELS


def _can_be_darted(facts: GarmentFacts) -> bool:
    torso = facts.torso
    return (
        torso is not None
        and not torso.darts
        and abs(torso.lower_level - facts.body.waist) < _AROUND_WAIST_CM
        and bool(facts.waistband or facts.skirt or facts.trousers)
    )


def _width(facts: GarmentFacts) -> float:
    return min(max(_gathered_cm(facts), _WIDTH_CM), _WIDEST_CM)


def _imagine(facts: GarmentFacts) -> GarmentFacts | None:
    torso = facts.torso
    if torso is None or not _can_be_darted(facts):
        return None
    taken = _PANELS * min(_width(facts), _gathered_cm(facts))
    lower = torso.lower_edge - taken
    gather = torso.gather * lower / max(torso.lower_edge, 1.0)
    return replace(facts, torso=replace(torso, darts=_PANELS, gather=gather, lower_edge=lower))


def _cut(cutter: Cutter) -> Pattern | None:
    if not _can_be_darted(cutter.facts):
        return None
    width = _width(cutter.facts)
    missing = width - _gathered_cm(cutter.facts)
    now: Cutter | None = cutter
    if missing > 0.05:
        # Let out at the side seams first, so that the lower edge stays as long when the darts are sewn.
        seam = cutter.anatomy.seam(Part.TORSO, {Part.WAISTBAND} | LOWER_PARTS).own
        wider = swing_sides(cutter.pattern, seam, missing, steepest=_STEEPEST) if seam else None
        now = None if wider is None else cutter.with_pattern(wider)
    if now is None:
        return None
    edges = now.anatomy.seam(Part.TORSO, {Part.WAISTBAND} | LOWER_PARTS).own
    if len(edges) != _PANELS:
        return None
    return add_waist_darts(now.pattern, edges, width, _DEPTH_CM, now.anatomy.figure.bust_x)


BODICE_DART_TRICKS: tuple[Trick, ...] = (
    Trick(
        name="waist darts put into the bodice",
        stage=3,
        imagine=_imagine,
        cut=_cut,
        only_for=("bodice: darted",),
        gathers=True,
    ),
)

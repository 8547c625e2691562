"""Hems of tiered skirts: where more is cut off than the lowest tier is long, the tier is taken off."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.alterations.lever import Trick, with_hem
from swifttailor.alterations.slits import slit_sides
from swifttailor.data.captions.facts import GarmentFacts
from swifttailor.data.captions.measure.skirts import skirt_rows
from swifttailor.data.edits import cuts
from swifttailor.data.edits.cutter import Cutter
from swifttailor.data.edits.recutting.removal import remove_panels
from swifttailor.data.edits.recutting.slits import close_slits
from swifttailor.pattern import Pattern

_LEAST_LEFT_CM = 4.0
"""A tier that would be shorter than this is taken off."""


def lengthen_tiered(cutter: Cutter, distance: float) -> Pattern | None:
    """Moves the hem down, cm; where it moves up past low slits or tiers, they go with what is cut off."""
    whole = cuts.lengthen_hem(cutter, distance)
    if whole is not None or distance >= 0:
        return whole
    cutter = _without_low_slits(cutter, -distance)
    while (tier := _lowest_tier(cutter)) and (shorter := remove_panels(cutter.pattern, tier)) is not None:
        after = Cutter(shorter, cutter.anatomy.body)
        if cutter.facts.hem is None or after.facts.hem is None:
            return None
        length = after.facts.hem.level - cutter.facts.hem.level
        if length > _LEAST_LEFT_CM - distance:
            break
        cutter, distance = after, distance + length
        if abs(distance) < 0.05:
            return cutter.pattern
    return cuts.lengthen_hem(cutter, distance)


def _without_low_slits(cutter: Cutter, cut_off: float) -> Cutter:
    low = [pair for pair in slit_sides(cutter) if cutter.anatomy.edge_length(pair[0]) < cut_off + 2.0]
    return Cutter(close_slits(cutter.pattern, low), cutter.anatomy.body) if low else cutter


def _lowest_tier(cutter: Cutter) -> list[str]:
    rows = skirt_rows(cutter.anatomy)
    last = max(rows.values(), default=0)
    return [name for name, row in rows.items() if row == last] if last else []


def _fewer(facts: GarmentFacts) -> GarmentFacts | None:
    skirt = facts.skirt
    if skirt is None or skirt.tiers < 2:
        return None
    length = (skirt.length - skirt.base_length) / (skirt.tiers - 1)
    skirt = replace(skirt, tiers=skirt.tiers - 1, length=skirt.length - length)
    return replace(with_hem(facts, -length), skirt=skirt)


def _cut(cutter: Cutter) -> Pattern | None:
    tier = _lowest_tier(cutter)
    return remove_panels(cutter.pattern, tier) if tier else None


TIER_TRICKS: tuple[Trick, ...] = (Trick("lowest tier taken off", 1, _fewer, _cut, only_for=("tiers",)),)

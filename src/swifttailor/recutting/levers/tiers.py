"""Hems of tiered skirts: where more is cut off than the lowest tier is long, the tier is taken off."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.measuring.parts import Part
from swifttailor.describing.measuring.skirts import skirt_rows
from swifttailor.pattern import Pattern
from swifttailor.recutting.amounts import cuts
from swifttailor.recutting.levers.lever import Lever, Trick, with_hem
from swifttailor.recutting.levers.slits import recut_closed, slit_sides
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.bands import BandPlan, add_band
from swifttailor.recutting.ways.removal import remove_panels
from swifttailor.recutting.ways.slits import close_slits

_LEAST_LEFT_CM = 4.0
"""A tier that would be shorter than this is taken off."""
_LEAST_TIER_CM = 6.0
"""Of a new one."""
_GATHERED = 1.35
"""Length of a new tier over that of what it hangs from."""
_MOST_GORES = 2
_MOST_TIERS = 6.0


def lengthen_tiered(cutter: Cutter, distance: float) -> Pattern | None:
    """Moves the hem down, cm; where it moves up past low slits or tiers, they go with what is cut off."""
    whole = cuts.lengthen_hem(cutter, distance)
    if whole is None and distance >= 0:
        return recut_closed(cutter, lambda shut: cuts.lengthen_hem(shut, distance))
    if whole is not None:
        return whole
    cutter = _without_low_slits(cutter, -distance)
    while (tier := _lowest_tier(cutter)) and (shorter := remove_panels(cutter.pattern, tier)) is not None:
        after = cutter.with_pattern(shorter)
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


def _tiers(facts: GarmentFacts) -> float | None:
    skirt = facts.skirt
    return float(skirt.tiers) if skirt and not skirt.godets and skirt.gores <= _MOST_GORES else None


def _more(facts: GarmentFacts, tiers: float) -> GarmentFacts:
    """The lowest row cut into rows of the same length, each gathered to the one above."""
    skirt, new = facts.skirt, round(tiers) - (facts.skirt.tiers if facts.skirt else 0)
    if skirt is None or new < 1:
        return facts
    hem = skirt.hem * _GATHERED**new
    base = skirt.base_length if skirt.tiers > 1 else skirt.length / (new + 1)
    skirt = replace(
        skirt, tiers=skirt.tiers + new, tier_gather=_GATHERED, hem=hem, base_length=base, slits=()
    )
    return replace(facts, skirt=replace(skirt, base_hem=skirt.base_hem if facts.skirt else hem))


def _sew_on(cutter: Cutter, amount: float) -> Pattern | None:
    """Cuts the lowest row shorter and sews as many rows to it as are to be new."""
    new, skirt = round(amount), cutter.facts.skirt
    if new < 1 or skirt is None or skirt.slits:
        return None
    last = skirt.length
    if skirt.tiers > 1:
        last = (skirt.length - skirt.base_length) / (skirt.tiers - 1)
    height = last / (new + 1)
    if height < _LEAST_TIER_CM:
        return None
    pattern = cuts.lengthen_hem(cutter, -new * height)
    for _ in range(new):
        if pattern is None:
            return None
        now = cutter.with_pattern(pattern)
        pattern = _with_row(now, height)
    return pattern


def _with_row(cutter: Cutter, height: float) -> Pattern | None:
    hem = cutter.hem_of(Part.SKIRT)
    taken = {p.name for p in cutter.pattern.panels}
    plans = []
    for face in ("front", "back"):
        edges = tuple(r for r in hem if cutter.anatomy.parts[r.panel].face == face)
        if not edges:
            return None
        name = next(n for k in range(len(taken) + 1) if (n := f"skirt_{face}_{k}") not in taken)
        plans.append(BandPlan(name, edges))
    return add_band(cutter.pattern, plans, height, share=_GATHERED)


def _cut(cutter: Cutter) -> Pattern | None:
    tier = _lowest_tier(cutter)
    return remove_panels(cutter.pattern, tier) if tier else None


TIER_TRICKS: tuple[Trick, ...] = (
    Trick(name="lowest tier taken off", stage=1, imagine=_fewer, cut=_cut, only_for=("tiers",)),
)
TIER_LEVERS: tuple[Lever, ...] = (
    Lever(
        name="tiers",
        serves=("tiers",),
        stage=5,
        of=_tiers,
        imagine=_more,
        cut=_sew_on,
        span=lambda f: (_tiers(f) or 1.0, _MOST_TIERS),
        words=("more", "fewer"),
        unit="",
        only_for=("tiers", "skirt: tiered", "tiers_count"),
    ),
)

"""Claims about waist, skirt and legs."""

from __future__ import annotations

import math
from collections.abc import Callable

from swifttailor.describing.claims.judgement import Judgement, Predicate
from swifttailor.describing.facts import CuffKind, GarmentFacts, Skirt, Trousers

SkirtTest = Callable[[Skirt, GarmentFacts, Judgement], bool]
LegTest = Callable[[Trousers, GarmentFacts, Judgement], bool]


def _skirt(test: SkirtTest) -> Predicate:
    return lambda facts, by: facts.skirt is not None and test(facts.skirt, facts, by)


def _legs(test: LegTest) -> Predicate:
    return lambda facts, by: facts.trousers is not None and test(facts.trousers, facts, by)


def _simple(skirt: Skirt) -> bool:
    """One row of two panels, no godets: a skirt whose shape is that of its sides."""
    return skirt.tiers == 1 and not skirt.godets and skirt.gores <= 3


def _long_enough(skirt: Skirt, facts: GarmentFacts) -> bool:
    """Whether the skirt reaches far enough below the hips to have a shape there."""
    return facts.hem is not None and facts.hem.level < facts.body.hips - 8.0


def _pencil(skirt: Skirt, facts: GarmentFacts, by: Judgement) -> bool:
    return (
        _simple(skirt)
        and _long_enough(skirt, facts)
        and by.below(skirt.gather, 1.12, 0.04)
        and by.below(skirt.hips, 1.06 * facts.body.hip_girth, 2.0)
        and by.below(skirt.hem - skirt.hips, 3.0, 3.0)
    )


def _narrowing(skirt: Skirt, facts: GarmentFacts, by: Judgement) -> bool:
    return _simple(skirt) and _long_enough(skirt, facts) and by.below(skirt.hem - skirt.hips, -8.0, 3.0)


def _straight(skirt: Skirt, facts: GarmentFacts, by: Judgement) -> bool:
    return (
        _simple(skirt)
        and _long_enough(skirt, facts)
        and by.between(skirt.hem - skirt.hips, -9.0, 9.0, 3.0)
        and by.below(abs(skirt.circle), 0.1, 0.02)
    )


def _a_line(skirt: Skirt, facts: GarmentFacts, by: Judgement) -> bool:
    return (
        _simple(skirt)
        and by.below(skirt.gather, 1.15, 0.05)
        and by.above(skirt.hem - skirt.hips, 6.0, 3.0)
        and by.between(skirt.circle, 0.06, 0.32, 0.02)
    )


def _flared(skirt: Skirt, facts: GarmentFacts, by: Judgement) -> bool:
    return skirt.tiers == 1 and not skirt.godets and by.above(skirt.circle, 0.26, 0.03)


def _circle(low: float, high: float) -> SkirtTest:
    return lambda s, f, by: s.tiers == 1 and not s.godets and by.between(s.circle, low, high, 0.03)


def _gathered(skirt: Skirt, facts: GarmentFacts, by: Judgement) -> bool:
    return by.above(skirt.gather, 1.18, 0.05)


def _fitted_base(skirt: Skirt, facts: GarmentFacts, by: Judgement) -> bool:
    """Lies close over the hips and spreads only below."""
    spreads = skirt.tiers > 1 or skirt.godets > 0
    return (
        spreads
        and by.below(skirt.hips, 1.06 * facts.body.hip_girth, 2.0)
        and by.above(skirt.base_length, 22.0, 2.0)
        and by.above(skirt.hem, 1.25 * skirt.hips, 0.05 * skirt.hips)
    )


def _peplum(facts: GarmentFacts, by: Judgement) -> bool:
    """A short flared or gathered piece at the waist of a top."""
    skirt = facts.skirt
    return (
        facts.kind == "top"
        and skirt is not None
        and by.below(skirt.length, 34.0, 3.0)
        and (by.above(skirt.circle, 0.3, 0.05) or by.above(skirt.gather, 1.2, 0.05))
    )


def _hips_loose(facts: GarmentFacts, by: Judgement) -> bool:
    hips = _hip_girth(facts)
    return hips is not None and by.above(hips, 1.13 * facts.body.hip_girth, 2.5)


def _hips_close(facts: GarmentFacts, by: Judgement) -> bool:
    hips = _hip_girth(facts)
    return hips is not None and by.below(hips, 1.05 * facts.body.hip_girth, 1.5)


def _hip_girth(facts: GarmentFacts) -> float | None:
    """Girth at the hips of what reaches them, cm."""
    if facts.hem is None or facts.hem.level > facts.body.hips - 4.0:
        return None
    part = facts.trousers or facts.skirt
    return part.hips if part else None


def _seam_level(facts: GarmentFacts) -> float | None:
    """Height of the seam between bodice and what hangs from it, cm."""
    if facts.torso is None or (facts.skirt is None and facts.trousers is None):
        return None
    return facts.torso.lower_level


def _empire(facts: GarmentFacts, by: Judgement) -> bool:
    level = _seam_level(facts)
    return level is not None and by.above(level, facts.body.waist + 6.5, 1.5)


def _natural(facts: GarmentFacts, by: Judgement) -> bool:
    level = _seam_level(facts)
    return level is not None and by.between(level, facts.body.waist - 7.5, facts.body.waist + 5.5, 1.5)


def _dropped(facts: GarmentFacts, by: Judgement) -> bool:
    level = _seam_level(facts)
    return level is not None and by.below(level, facts.body.waist - 9.5, 1.5)


def _rise(low: float, high: float) -> Predicate:
    """Upper border of a skirt or trousers, cm above the waist."""

    def test(facts: GarmentFacts, by: Judgement) -> bool:
        if facts.kind not in ("skirt", "trousers"):
            return False
        return by.between(facts.top_level - facts.body.waist, low, high, 1.2)

    return test


def _band(at_hem: bool) -> Predicate:
    return lambda f, by: f.waistband is not None and f.waistband.at_hem == at_hem


def _narrow_band(facts: GarmentFacts, by: Judgement) -> bool:
    return facts.waistband is not None and by.below(facts.waistband.height, 6.5, 0.8)


def _wide_band(facts: GarmentFacts, by: Judgement) -> bool:
    return facts.waistband is not None and by.above(facts.waistband.height, 10.0, 1.2)


def _shaped_band(facts: GarmentFacts, by: Judgement) -> bool:
    band = facts.waistband
    return band is not None and by.above(band.lower - band.upper, 2.5, 1.0)


def _straight_band(facts: GarmentFacts, by: Judgement) -> bool:
    band = facts.waistband
    return band is not None and by.below(band.lower - band.upper, 2.0, 1.0)


def _loose_band(facts: GarmentFacts, by: Judgement) -> bool:
    return facts.waistband is not None and by.above(facts.waistband.upper, 1.16 * facts.body.waist_girth, 3.0)


def _opening(legs: Trousers) -> float:
    """Hem over thigh; no number, of which nothing holds, where the legs end above the thigh."""
    return legs.hem / legs.thigh if legs.thigh > 0 else math.nan


def _wide_leg(legs: Trousers, facts: GarmentFacts, by: Judgement) -> bool:
    return by.above(legs.hem, 1.0 * facts.body.thigh_girth, 2.0) and by.above(_opening(legs), 0.9, 0.03)


def _tapered_leg(legs: Trousers, facts: GarmentFacts, by: Judgement) -> bool:
    return by.below(_opening(legs), 0.8, 0.03)


def _straight_leg(legs: Trousers, facts: GarmentFacts, by: Judgement) -> bool:
    return by.between(_opening(legs), 0.82, 1.03, 0.02)


def _flared_leg(legs: Trousers, facts: GarmentFacts, by: Judgement) -> bool:
    return by.above(_opening(legs), 1.04, 0.02)


def _slim_leg(legs: Trousers, facts: GarmentFacts, by: Judgement) -> bool:
    return by.below(legs.thigh, 1.06 * facts.body.thigh_girth, 1.0) and by.below(_opening(legs), 0.85, 0.03)


def _leg_cuff(kind: CuffKind) -> Predicate:
    return _legs(lambda legs, f, by: legs.cuff is not None and legs.cuff.kind == kind)


LOWER_CLAIMS: dict[str, tuple[str, dict[str, Predicate]]] = {
    "skirt": (
        "what the skirt of a skirt or dress is like",
        {
            "pencil": _skirt(_pencil),
            "narrowing": _skirt(_narrowing),
            "straight": _skirt(_straight),
            "a-line": _skirt(_a_line),
            "flared": _skirt(_flared),
            "half circle": _skirt(_circle(0.38, 0.62)),
            "three-quarter circle": _skirt(_circle(0.62, 0.88)),
            "circle": _skirt(_circle(0.84, 1.3)),
            "more than a circle": _skirt(_circle(1.22, 9.0)),
            "gathered": _skirt(_gathered),
            "tiered": _skirt(lambda s, f, by: s.tiers > 1),
            "gored": _skirt(lambda s, f, by: s.gores >= 4),
            "godets": _skirt(lambda s, f, by: s.godets > 0),
            "fitted base": _skirt(_fitted_base),
            "gathered tiers": _skirt(lambda s, f, by: s.tiers > 1 and by.above(s.tier_gather, 1.15, 0.05)),
            "peplum": _peplum,
        },
    ),
    "hips": ("room at the hips", {"close": _hips_close, "loose": _hips_loose}),
    "waist_seam": (
        "height of the seam below the bodice",
        {"empire": _empire, "natural": _natural, "dropped": _dropped},
    ),
    "rise": (
        "where skirts and trousers sit",
        {"high": _rise(-2.5, 99.0), "mid": _rise(-9.0, -2.0), "low": _rise(-99.0, -8.0)},
    ),
    "waistband": (
        "bands",
        {
            "none": lambda f, by: f.waistband is None and f.kind != "other",
            "waist": _band(at_hem=False),
            "hem": _band(at_hem=True),
            "narrow": _narrow_band,
            "wide": _wide_band,
            "shaped": _shaped_band,
            "straight": _straight_band,
            "loose": _loose_band,
        },
    ),
    "legs": (
        "shape of the legs",
        {
            "wide": _legs(_wide_leg),
            "straight": _legs(_straight_leg),
            "tapered": _legs(_tapered_leg),
            "slim": _legs(_slim_leg),
            "flared": _legs(_flared_leg),
        },
    ),
    "leg_cuffs": (
        "what ends the legs",
        {
            "none": _legs(lambda legs, f, by: legs.cuff is None),
            "band": _leg_cuff("band"),
            "flounce": _leg_cuff("flounce"),
            "band and flounce": _leg_cuff("band and flounce"),
            "gathered": _legs(
                lambda legs, f, by: legs.cuff is not None and by.above(legs.end_gather, 1.2, 0.05)
            ),
            "deep": _legs(
                lambda legs, f, by: legs.cuff is not None and by.above(legs.cuff.length, 15.0, 2.0)
            ),
        },
    ),
}
"""About, and the values with their tests."""

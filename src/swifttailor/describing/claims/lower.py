"""Claims about waist, skirt and legs."""

from __future__ import annotations

import math
from typing import get_args

from swifttailor.describing.claims.judgement import (
    Judgement,
    Predicate,
    above,
    all_of,
    any_of,
    below,
    between,
    is_one_of,
    missing,
    there,
    where,
)
from swifttailor.describing.facts import CuffKind, GarmentFacts
from swifttailor.describing.facts_paths import measure_of

_ONE_ROW = where("skirt", lambda skirt: skirt.tiers == 1 and not skirt.godets)
_SIMPLE = all_of(_ONE_ROW, where("skirt.gores", lambda gores: gores <= 3))
"""One row of two panels, no godets: a skirt whose shape is that of its sides."""


def _past_hips(facts: GarmentFacts, by: Judgement) -> bool:
    """Whether the hem is far enough below the hips for a shape there."""
    return facts.hem is not None and facts.hem.level < facts.body.hips - 8.0


_SPREAD = measure_of("skirt", lambda skirt: skirt.hem - skirt.hips)
"""By how much the hem is wider than the hips, cm."""
_CLOSE_OVER_HIPS = below("skirt.hips", lambda f: 1.06 * f.body.hip_girth, 2.0)


def _circle(low: float, high: float) -> Predicate:
    return all_of(_ONE_ROW, between("skirt.circle", low, high, 0.03))


def _spreads_below(facts: GarmentFacts, by: Judgement) -> bool:
    """Tiers or godets that make the hem a quarter wider than the hips."""
    skirt = facts.skirt
    if skirt is None or not (skirt.tiers > 1 or skirt.godets > 0):
        return False
    return by.above(skirt.hem, 1.25 * skirt.hips, 0.05 * skirt.hips)


def _hips(facts: GarmentFacts) -> float | None:
    """Girth at the hips of what reaches them, cm."""
    if facts.hem is None or facts.hem.level > facts.body.hips - 4.0:
        return None
    part = facts.trousers or facts.skirt
    if part is None and facts.kind == "dress" and facts.torso is not None:
        return facts.torso.hips
    return part.hips if part else None


def _falls_in_one(facts: GarmentFacts) -> bool:
    """Whether it is a dress without a seam between bodice and skirt that reaches past the hips."""
    torso = facts.torso
    return facts.kind == "dress" and facts.skirt is None and torso is not None and torso.hips is not None


def _spread_in_one(facts: GarmentFacts) -> float | None:
    """By how much the hem of a dress without a waist seam is wider than its hips, cm."""
    if not _falls_in_one(facts) or facts.hem is None or facts.torso is None:
        return None
    return facts.hem.length - (facts.torso.hips or 0.0)


def _circle_in_one(facts: GarmentFacts) -> float | None:
    """Part of a full circle that such a dress flares like below the hips."""
    spread = _spread_in_one(facts)
    if spread is None or facts.hem is None:
        return None
    fall = facts.body.hips - facts.hem.level
    return spread / (2.0 * math.pi * fall) if fall > _LEAST_FALL_CM else None


_LEAST_FALL_CM = 8.0
_IN_ONE_CLOSE = below(lambda f: f.torso.hips if f.torso else None, lambda f: 1.06 * f.body.hip_girth, 2.0)
_IN_ONE: dict[str, Predicate] = {
    "pencil": all_of(_past_hips, _IN_ONE_CLOSE, below(_spread_in_one, 3.0, 3.0)),
    "narrowing": all_of(_past_hips, below(_spread_in_one, -8.0, 3.0)),
    "straight": all_of(
        _past_hips, between(_spread_in_one, -9.0, 9.0, 3.0), between(_circle_in_one, -0.1, 0.1, 0.02)
    ),
    "a-line": all_of(above(_spread_in_one, 6.0, 3.0), between(_circle_in_one, 0.06, 0.32, 0.02)),
    "flared": above(_circle_in_one, 0.26, 0.03),
}
"""The same words of dresses without a waist seam, whose skirt begins at the hips."""


def _seam(facts: GarmentFacts) -> float | None:
    """Height of the seam between bodice and what hangs from it, cm."""
    if facts.torso is None or (facts.skirt is None and facts.trousers is None):
        return None
    return facts.torso.lower_level


def _rise(facts: GarmentFacts) -> float | None:
    """Upper border of a skirt or trousers, cm above the waist."""
    return facts.top_level - facts.body.waist if facts.kind in ("skirt", "trousers") else None


_SHAPING = measure_of("waistband", lambda band: band.lower - band.upper)
_OPENING = measure_of("trousers", lambda legs: legs.hem / legs.thigh if legs.thigh > 0 else None)
"""Hem over thigh; none where the legs end above the thigh."""

LOWER_CLAIMS: dict[str, tuple[str, dict[str, Predicate]]] = {
    "skirt": (
        "what the skirt of a skirt or dress is like",
        {
            "pencil": any_of(
                all_of(
                    _SIMPLE,
                    _past_hips,
                    below("skirt.gather", 1.12, 0.04),
                    _CLOSE_OVER_HIPS,
                    below(_SPREAD, 3.0, 3.0),
                ),
                _IN_ONE["pencil"],
            ),
            "narrowing": any_of(all_of(_SIMPLE, _past_hips, below(_SPREAD, -8.0, 3.0)), _IN_ONE["narrowing"]),
            "straight": any_of(
                all_of(
                    _SIMPLE,
                    _past_hips,
                    between(_SPREAD, -9.0, 9.0, 3.0),
                    between("skirt.circle", -0.1, 0.1, 0.02),
                ),
                _IN_ONE["straight"],
            ),
            "a-line": any_of(
                all_of(
                    _SIMPLE,
                    below("skirt.gather", 1.15, 0.05),
                    above(_SPREAD, 6.0, 3.0),
                    between("skirt.circle", 0.06, 0.32, 0.02),
                ),
                _IN_ONE["a-line"],
            ),
            "flared": any_of(all_of(_ONE_ROW, above("skirt.circle", 0.26, 0.03)), _IN_ONE["flared"]),
            "half circle": _circle(0.38, 0.62),
            "three-quarter circle": _circle(0.62, 0.88),
            "circle": _circle(0.84, 1.3),
            "more than a circle": _circle(1.22, 9.0),
            "gathered": above("skirt.gather", 1.18, 0.05),
            "tiered": where("skirt.tiers", lambda tiers: tiers > 1),
            "gored": where("skirt.gores", lambda gores: gores >= 4),
            "godets": where("skirt.godets", lambda godets: godets > 0),
            "fitted base": all_of(_spreads_below, _CLOSE_OVER_HIPS, above("skirt.base_length", 22.0, 2.0)),
            "gathered tiers": all_of(
                where("skirt.tiers", lambda tiers: tiers > 1), above("skirt.tier_gather", 1.15, 0.05)
            ),
            # A short flared or gathered piece at the waist of a top.
            "peplum": all_of(
                is_one_of("kind", "top"),
                below("skirt.length", 34.0, 3.0),
                any_of(above("skirt.circle", 0.3, 0.05), above("skirt.gather", 1.2, 0.05)),
            ),
        },
    ),
    "hips": (
        "room at the hips",
        {
            "close": below(_hips, lambda f: 1.05 * f.body.hip_girth, 1.5),
            "loose": above(_hips, lambda f: 1.13 * f.body.hip_girth, 2.5),
        },
    ),
    "waist_seam": (
        "height of the seam below the bodice",
        {
            "empire": above(_seam, lambda f: f.body.waist + 6.5, 1.5),
            "natural": between(_seam, lambda f: f.body.waist - 7.5, lambda f: f.body.waist + 5.5, 1.5),
            # The strip between the legs of a swimsuit is sewn on lower still.
            "dropped": between(_seam, lambda f: f.body.crotch + 3.0, lambda f: f.body.waist - 9.5, 1.5),
        },
    ),
    "rise": (
        "where skirts and trousers sit",
        {
            "high": between(_rise, -2.5, 99.0, 1.2),
            "mid": between(_rise, -9.0, -2.0, 1.2),
            "low": between(_rise, -99.0, -8.0, 1.2),
        },
    ),
    "waistband": (
        "bands",
        {
            "none": lambda f, by: f.waistband is None and f.kind != "other",
            "waist": where("waistband", lambda band: not band.at_hem),
            "hem": where("waistband", lambda band: band.at_hem),
            "narrow": below("waistband.height", 6.5, 0.8),
            "wide": above("waistband.height", 10.0, 1.2),
            "shaped": above(_SHAPING, 2.5, 1.0),
            "straight": below(_SHAPING, 2.0, 1.0),
            "loose": above("waistband.upper", lambda f: 1.16 * f.body.waist_girth, 3.0),
        },
    ),
    "legs": (
        "shape of the legs",
        {
            "wide": all_of(
                above("trousers.hem", lambda f: f.body.thigh_girth, 2.0), above(_OPENING, 0.9, 0.03)
            ),
            "straight": between(_OPENING, 0.65, 1.03, 0.02),
            "tapered": below(_OPENING, 0.7, 0.03),
            "slim": all_of(
                below("trousers.thigh", lambda f: 1.06 * f.body.thigh_girth, 1.0), below(_OPENING, 0.85, 0.03)
            ),
            "flared": above(_OPENING, 1.04, 0.02),
        },
    ),
    "leg_cuffs": (
        "what ends the legs",
        {
            "none": all_of(there("trousers"), missing("trousers.cuff")),
            **{kind: is_one_of("trousers.cuff.kind", kind) for kind in get_args(CuffKind)},
            "gathered": all_of(there("trousers.cuff"), above("trousers.end_gather", 1.2, 0.05)),
            "deep": above("trousers.cuff.length", 15.0, 2.0),
        },
    ),
}
"""About, and the values with their tests."""

"""Claims about the hem: how long a garment is, and what its lower border looks like."""

from __future__ import annotations

import math
from collections.abc import Callable

from swifttailor.describing.claims.judgement import Judgement, Predicate
from swifttailor.describing.facts import GarmentFacts, LandmarkFacts, Place, Slit

HEM_TOLERANCE_CM = 2.5
"""Levels measured on patterns differ from those of drapes by about this much (docs/captions.md)."""


def _skirt_like(facts: GarmentFacts) -> bool:
    return facts.kind in ("dress", "skirt")


def _top_like(facts: GarmentFacts) -> bool:
    return facts.kind == "top"


def _legged(facts: GarmentFacts) -> bool:
    return facts.trousers is not None


Zone = Callable[[LandmarkFacts], tuple[float, float]]
"""Heights of the hem from and to, cm, on a body."""

_SKIRT_ZONES: dict[str, Zone] = {
    "micro": lambda b: (b.crotch - 10.0, math.inf),
    "mini": lambda b: (b.knee + 10.0, math.inf),
    "above the knee": lambda b: (b.knee + 2.5, b.knee + 13.5),
    "knee": lambda b: (b.knee - 5.5, b.knee + 5.5),
    "below the knee": lambda b: (b.knee - 14.0, b.knee - 2.5),
    "midi": lambda b: (0.42 * b.knee, b.knee - 7.0),
    "maxi": lambda b: (-math.inf, 0.45 * b.knee),
    "ankle": lambda b: (0.06 * b.knee, 0.42 * b.knee),
    "floor": lambda b: (-math.inf, 0.14 * b.knee),
}
_TOP_ZONES: dict[str, Zone] = {
    "bra": lambda b: (b.waist + 9.0, math.inf),
    "cropped": lambda b: (b.waist - 2.5, math.inf),
    "waist": lambda b: (b.waist - 7.5, b.waist + 4.5),
    "high hip": lambda b: (b.hips + 5.0, b.waist - 3.0),
    "hip": lambda b: (b.hips - 8.0, b.hips + 8.0),
    "long": lambda b: (-math.inf, b.hips - 3.0),
}
_LEG_ZONES: dict[str, Zone] = {
    "very short": lambda b: (b.crotch - 15.0, math.inf),
    "mid-thigh": lambda b: (b.knee + 8.0, b.crotch - 7.0),
    "thigh": lambda b: (b.knee + 4.0, math.inf),
    "knee": lambda b: (b.knee - 6.0, b.knee + 7.0),
    "calf": lambda b: (0.45 * b.knee, b.knee - 4.0),
    "ankle": lambda b: (0.2 * b.knee, 0.5 * b.knee),
    "full": lambda b: (-math.inf, 0.32 * b.knee),
}


def _in_zone(facts: GarmentFacts, by: Judgement, zone: tuple[float, float]) -> bool:
    return facts.hem is not None and by.between(facts.hem.level, *zone, HEM_TOLERANCE_CM)


def _uneven(facts: GarmentFacts) -> float:
    """Largest difference between the four sides of the hem, cm."""
    if facts.hem is None:
        return 0.0
    sides = (facts.hem.front, facts.hem.back, facts.hem.left, facts.hem.right)
    return max(sides) - min(sides)


def _level(facts: GarmentFacts, by: Judgement) -> bool:
    return (
        facts.hem is not None
        and by.below(_uneven(facts), 8.0, 2.0)
        and by.below(abs(facts.hem.dip), 7.0, 2.0)
    )


def _high_low(facts: GarmentFacts, by: Judgement) -> bool:
    return facts.hem is not None and by.above(facts.hem.front - facts.hem.back, 9.0, 2.5)


def _slanted(facts: GarmentFacts, by: Judgement, lower: str) -> bool:
    if facts.hem is None or facts.trousers is not None:
        return False
    fall = facts.hem.right - facts.hem.left if lower == "left" else facts.hem.left - facts.hem.right
    return by.above(fall, 7.0, 2.0)


def _pointed(facts: GarmentFacts, by: Judgement) -> bool:
    """Corners between the panels hang down, as in a handkerchief hem."""
    return facts.skirt is not None and facts.hem is not None and by.above(facts.hem.dip, 9.0, 2.0)


def _scalloped(facts: GarmentFacts, by: Judgement) -> bool:
    return (
        facts.skirt is not None
        and facts.skirt.gores > 3
        and facts.hem is not None
        and by.below(facts.hem.dip, -6.0, 1.5)
    )


def _slits(facts: GarmentFacts) -> tuple[Slit, ...]:
    return facts.skirt.slits if facts.skirt else ()


WEDGE_CM = 7.0
"""Above this width a slit is a wedge cut out of the hem."""


def _has_slit(facts: GarmentFacts, by: Judgement, place: Place) -> bool:
    return any(s.place == place and by.above(s.height, 5.0, 2.0) for s in _slits(facts))


def _high_slit(facts: GarmentFacts, by: Judgement) -> bool:
    skirt = facts.skirt
    return skirt is not None and any(
        by.above(s.height, max(0.45 * skirt.length, 18.0), 2.5) for s in skirt.slits
    )


def _wedge(facts: GarmentFacts, by: Judgement) -> bool:
    return any(by.above(s.width, WEDGE_CM + 2.0, 2.0) and by.above(s.height, 8.0, 2.0) for s in _slits(facts))


def _no_slit(facts: GarmentFacts, by: Judgement) -> bool:
    return facts.skirt is not None and all(by.below(s.height, 5.0, 3.0) for s in facts.skirt.slits)


def _zone_tests(zones: dict[str, Zone], applies: Callable[[GarmentFacts], bool]) -> dict[str, Predicate]:
    def test(zone: Zone) -> Predicate:
        return lambda f, by: applies(f) and _in_zone(f, by, zone(f.body))

    return {word: test(zone) for word, zone in zones.items()}


HEM_CLAIMS: dict[str, tuple[str, dict[str, Predicate]]] = {
    "skirt_hem": (
        "where the hem of a dress or skirt ends",
        _zone_tests(_SKIRT_ZONES, _skirt_like),
    ),
    "top_hem": ("where a top ends", _zone_tests(_TOP_ZONES, _top_like)),
    "leg_hem": ("where the legs end", _zone_tests(_LEG_ZONES, _legged)),
    "hem_shape": (
        "what the hem looks like",
        {
            "level": _level,
            "high-low": _high_low,
            "lower left": lambda f, by: _slanted(f, by, "left"),
            "lower right": lambda f, by: _slanted(f, by, "right"),
            "pointed": _pointed,
            "scalloped": _scalloped,
        },
    ),
    "slit": (
        "open slits in the hem of a skirt",
        {
            "none": _no_slit,
            "front": lambda f, by: _has_slit(f, by, "front"),
            "back": lambda f, by: _has_slit(f, by, "back"),
            "left": lambda f, by: _has_slit(f, by, "left"),
            "right": lambda f, by: _has_slit(f, by, "right"),
        },
    ),
    "slit_size": ("how large the slits are", {"high": _high_slit, "wedge": _wedge}),
}
"""About, and the values with their tests."""

"""Claims about the hem: how long a garment is, and what its lower border looks like."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from types import MappingProxyType
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
from swifttailor.describing.dimensions import slit_height
from swifttailor.describing.facts import GarmentFacts, HemFacts, LandmarkFacts, Place
from swifttailor.describing.facts_paths import measure_of

HEM_TOLERANCE_CM = 2.5
"""Levels measured on patterns differ from those of drapes by about this much (docs/captions.md)."""
WEDGE_CM = 7.0
"""Above this width a slit is a wedge cut out of the hem."""

Zone = Callable[[LandmarkFacts], tuple[float, float]]
"""Heights of the hem from and to, cm, on a body."""

SKIRT_ZONES: Mapping[str, Zone] = MappingProxyType(
    {
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
)
"""Of words for where a dress or skirt ends."""
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


def _ends_in(zones: Mapping[str, Zone], applies: Predicate) -> dict[str, Predicate]:
    def test(zone: Zone) -> Predicate:
        low, high = (lambda f: zone(f.body)[0]), (lambda f: zone(f.body)[1])
        return all_of(applies, between("hem.level", low, high, HEM_TOLERANCE_CM))

    return {word: test(zone) for word, zone in zones.items()}


def _unevenness(hem: HemFacts) -> float:
    """Largest difference between its four sides, cm."""
    sides = (hem.front, hem.back, hem.left, hem.right)
    return max(sides) - min(sides)


def _high_slit(facts: GarmentFacts, by: Judgement) -> bool:
    skirt = facts.skirt
    return skirt is not None and any(
        by.above(s.height, max(0.45 * skirt.length, 18.0), 2.5) for s in skirt.slits
    )


def _wedge(facts: GarmentFacts, by: Judgement) -> bool:
    slits = facts.skirt.slits if facts.skirt else ()
    return any(by.above(s.width, WEDGE_CM + 2.0, 2.0) and by.above(s.height, 8.0, 2.0) for s in slits)


HEM_CLAIMS: dict[str, tuple[str, dict[str, Predicate]]] = {
    "skirt_hem": (
        "where the hem of a dress or skirt ends",
        _ends_in(SKIRT_ZONES, is_one_of("kind", "dress", "skirt")),
    ),
    "top_hem": ("where a top ends", _ends_in(_TOP_ZONES, is_one_of("kind", "top"))),
    "leg_hem": ("where the legs end", _ends_in(_LEG_ZONES, there("trousers"))),
    "hem_shape": (
        "what the hem looks like",
        {
            "level": all_of(
                below(measure_of("hem", _unevenness), 8.0, 2.0),
                below(measure_of("hem", lambda hem: abs(hem.dip)), 7.0, 2.0),
                where("hem.arcs", lambda arcs: arcs == 0),
            ),
            "high-low": above(measure_of("hem", lambda hem: hem.front - hem.back), 9.0, 2.5),
            "lower left": all_of(
                missing("trousers"), above(measure_of("hem", lambda hem: hem.right - hem.left), 7.0, 2.0)
            ),
            "lower right": all_of(
                missing("trousers"), above(measure_of("hem", lambda hem: hem.left - hem.right), 7.0, 2.0)
            ),
            # Corners between the panels hang down, as in a handkerchief hem.
            "pointed": all_of(there("skirt"), above("hem.dip", 9.0, 2.0)),
            "scalloped": any_of(
                all_of(where("skirt.gores", lambda gores: gores > 3), below("hem.dip", -6.0, 1.5)),
                where("hem.arcs", lambda arcs: arcs > 0),
            ),
        },
    ),
    "slit": (
        "open slits in the hem of a skirt",
        {
            "none": below(
                measure_of("skirt", lambda skirt: max((s.height for s in skirt.slits), default=0.0)), 5.0, 3.0
            ),
            **{place: above(slit_height(place), 5.0, 2.0) for place in get_args(Place)},
        },
    ),
    "slit_size": ("how large the slits are", {"high": _high_slit, "wedge": _wedge}),
}
"""About, and the values with their tests."""

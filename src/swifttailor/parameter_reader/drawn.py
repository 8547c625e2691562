"""Designs drawn by lot: as many patterns with known parameters as one likes."""

from __future__ import annotations

import random
from collections.abc import Iterator
from typing import Any

from swifttailor.pattern import Pattern, Severity, check_pattern
from swifttailor.programs import DESIGN_PARAMETERS, DesignError, DesignParameter, make_pattern

USUAL = 0.4
"""Share of values that are the default."""
_ORNAMENT = "pencil-skirt.style_side_cut"


def drawn_designs(seed: int) -> Iterator[tuple[dict[str, Any], Pattern]]:
    """Designs that the programs accept and in whose patterns no check finds an error, endlessly.

    Args:
        seed: The same designs come of the same seed.
    """
    chance = random.Random(seed)
    while True:
        design = {name: _value(one, chance) for name, one in DESIGN_PARAMETERS.items()}
        design[_ORNAMENT] = None
        try:
            pattern = make_pattern(design).canonical()
        except DesignError:
            continue
        if not any(finding.severity == Severity.ERROR for finding in check_pattern(pattern)):
            yield design, pattern


def _value(parameter: DesignParameter, chance: random.Random) -> Any:
    if chance.random() < USUAL:
        return parameter.default
    if parameter.choices:
        return chance.choice(parameter.choices)
    low, high = parameter.range
    return chance.randint(int(low), int(high)) if parameter.kind == "int" else chance.uniform(low, high)

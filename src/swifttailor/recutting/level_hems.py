"""Hems that nobody asked to be uneven are made level."""

from __future__ import annotations

from swifttailor.describing.facts import HemFacts
from swifttailor.describing.measuring.parts import Face
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Pattern
from swifttailor.recutting.amounts import cuts
from swifttailor.recutting.round_hems import round_hem
from swifttailor.recutting.table.checking import accepted
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.hem_line import bend_hem

LEVEL_CM = 4.0
"""A hem that rises and falls by less is level."""
DIP_CM = 2.0
"""Corners that hang lower than that below the middles between them are seen, however level the rest is."""
FLARED = 0.26
"""Part of a full circle from which a skirt counts as flared."""
SMOOTHER = 0.7
"""What is kept has at most this share of the unevenness left."""


def level_hem(pattern: Pattern) -> tuple[Pattern, str]:
    """Brings the hem to the height that it has at the sides, in front and behind.

    Returns:
        The pattern and what was done, in words; the same pattern and no words where the hem is level, or has
        a band, or cannot be bent.
    """
    if not pattern.panels:
        return pattern, ""
    try:
        before = Cutter(pattern)
        hem, facts = cuts.free_hem(before), before.facts.hem
        if not hem or facts is None or before.facts.trousers is not None or _is_level(facts):
            return pattern, ""
        sides = (facts.left + facts.right) / 2
        by: dict[Face, float] = {"front": facts.front - sides, "back": facts.back - sides}
        # A flared skirt hangs in points wherever its sides are not as long as its middle.
        drawn = round_hem(before) if _is_flared(before) else None
        tried = (accepted(before, one, as_before=True) for one in (drawn, bend_hem(pattern, hem, by)))
        made = [one for one in tried if one is not None and one.facts.hem is not None]
        after = min(made, key=lambda one: unevenness(one.facts.hem or facts), default=None)
    except SwiftTailorError:
        return pattern, ""
    if after is None or after.facts.hem is None:
        return pattern, ""
    if unevenness(after.facts.hem) > SMOOTHER * unevenness(facts):
        return pattern, ""
    return after.pattern, f"hem made level (uneven by {unevenness(facts):.1f} cm before)"


def _is_level(hem: HemFacts) -> bool:
    return unevenness(hem) <= LEVEL_CM and hem.dip <= DIP_CM


def _is_flared(cutter: Cutter) -> bool:
    return cutter.facts.skirt is not None and cutter.facts.skirt.circle > FLARED


def unevenness(hem: HemFacts) -> float:
    """How far apart front, back and sides of a hem end, or corners from middles, cm."""
    sides = (hem.left + hem.right) / 2
    apart = max(hem.front, hem.back, sides) - min(hem.front, hem.back, sides)
    return max(apart, abs(hem.dip))

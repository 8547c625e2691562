"""Hems that nobody asked to be uneven are made level."""

from __future__ import annotations

from swifttailor.describing.facts import HemFacts
from swifttailor.describing.measuring.parts import Face
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Pattern
from swifttailor.recutting.amounts import cuts
from swifttailor.recutting.hems_below_waists import hem_below_waist
from swifttailor.recutting.round_hems import round_hem
from swifttailor.recutting.table.checking import accepted
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.true_corners import true_corners
from swifttailor.recutting.ways.hem_line import bend_hem

LEVEL_CM = 4.0
"""A hem that rises and falls by less is level."""
DIP_CM = 2.0
"""Corners that hang lower than that below the middles between them are seen, however level the rest is."""
BOWS_CM = 4.0
"""So much lower than its corners may the hem of a gore be in its middle."""
TRUED = (0.5, 0.75, 1.0)
"""Parts of a dip by which corners are raised; the best is kept."""
FLARED = 0.26
"""Part of a full circle from which a skirt counts as flared."""
SMOOTHER = 0.7
"""What is kept has at most this share of the unevenness left."""


def level_hem(pattern: Pattern, *, below_waist: bool = False) -> tuple[Pattern, str]:
    """Brings the hem to the height that it has at the sides, in front and behind.

    Args:
        pattern: Any pattern.
        below_waist: Whether a skirt's hem is level where it is everywhere as far from the skirt's upper
            edge. Otherwise it is where it is worn as high by the measures of the whole garment, of which
            the way over the bust is not taken off in front alone.

    Returns:
        The pattern and what was done, in words; the same pattern and no words where the hem is level, or has
        a band, or cannot be bent.
    """
    if not pattern.panels:
        return pattern, ""
    try:
        before = Cutter(pattern)
        hem, facts = cuts.free_hem(before), _hem_of(before, below_waist)
        if not hem or facts is None or before.facts.trousers is not None or _is_level(facts):
            return pattern, ""
        sides = (facts.left + facts.right) / 2
        by: dict[Face, float] = {"front": facts.front - sides, "back": facts.back - sides}
        # A flared skirt hangs in points wherever its sides are not as long as its middle.
        drawn = round_hem(before) if _is_flared(before) else None
        bent = facts.dip > DIP_CM or (below_waist and facts.dip < -BOWS_CM)
        dips = [share * facts.dip for share in TRUED] if bent else []
        trued = _measured(before, below_waist, *(true_corners(before, dip) for dip in dips))
        made = [*_measured(before, below_waist, drawn, bend_hem(pattern, hem, by)), *trued]
    except SwiftTailorError:
        return pattern, ""
    best = min(made, key=lambda one: unevenness(one[1]), default=None)
    if best is not None and unevenness(best[1]) <= SMOOTHER * unevenness(facts):
        return best[0], f"hem made level (uneven by {unevenness(facts):.1f} cm before)"
    best = min(trued, key=lambda one: abs(one[1].dip), default=None)
    if best is not None and abs(best[1].dip) <= SMOOTHER * facts.dip:
        return best[0], f"hem rounded at the side seams (its corners hung {facts.dip:.1f} cm lower before)"
    return pattern, ""


def has_level_hem(pattern: Pattern) -> bool:
    """Whether a pattern has a skirt whose hem is everywhere as far from its upper edge."""
    cutter = Cutter(pattern)
    facts = hem_below_waist(cutter) if cutter.facts.skirt is not None else None
    return facts is not None and _is_level(facts)


def _hem_of(cutter: Cutter, below_waist: bool) -> HemFacts | None:
    found = hem_below_waist(cutter) if below_waist else None
    return cutter.facts.hem if found is None else found


def _measured(before: Cutter, below_waist: bool, *made: Pattern | None) -> list[tuple[Pattern, HemFacts]]:
    """Those that can be made, with their hems."""
    found = [one for one in (accepted(before, one, as_before=True) for one in made) if one is not None]
    hems = [(one.pattern, _hem_of(one, below_waist)) for one in found]
    return [(pattern, hem) for pattern, hem in hems if hem is not None]


def _is_level(hem: HemFacts) -> bool:
    return unevenness(hem) <= LEVEL_CM and hem.dip <= DIP_CM


def _is_flared(cutter: Cutter) -> bool:
    return cutter.facts.skirt is not None and cutter.facts.skirt.circle > FLARED


def unevenness(hem: HemFacts) -> float:
    """How far apart front, back and sides of a hem end, or corners from middles, cm."""
    sides = (hem.left + hem.right) / 2
    apart = max(hem.front, hem.back, sides) - min(hem.front, hem.back, sides)
    return max(apart, abs(hem.dip))

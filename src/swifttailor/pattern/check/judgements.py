"""What is judged of a whole pattern, remembered: checks and every step of a repair ask for the same."""

from __future__ import annotations

from functools import lru_cache

from swifttailor.pattern.check.body_levels import BodyLevels
from swifttailor.pattern.check.outline import Outline, trace_outline
from swifttailor.pattern.check.seam_direction import Directions, judge_directions
from swifttailor.pattern.check.stitch_checks import single_stitches, usable_stitches
from swifttailor.pattern.check.worn_place import WornPlace, judge_worn_place
from swifttailor.pattern.pattern import Pattern

_REMEMBERED = 16
"""Patterns; a repair looks at a few."""


def outlines_of(pattern: Pattern) -> dict[str, Outline]:
    """Outline of each panel by name."""
    return {panel.name: trace_outline(panel) for panel in pattern.panels}


@lru_cache(maxsize=_REMEMBERED)
def directions_of(pattern: Pattern) -> Directions:
    """Everything found about the directions of seams and panels."""
    single = single_stitches(pattern, usable_stitches(pattern))
    return judge_directions(pattern, outlines_of(pattern), single)


@lru_cache(maxsize=_REMEMBERED)
def place_of(pattern: Pattern, levels: BodyLevels) -> WornPlace:
    """Everything found about where the panels stand.

    Args:
        pattern: Any pattern.
        levels: Of the body that it is placed around.
    """
    single = single_stitches(pattern, usable_stitches(pattern))
    return judge_worn_place(pattern, outlines_of(pattern), single, levels)

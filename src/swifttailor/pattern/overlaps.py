"""Fronts that lie over each other: of wound skirts, and of coats below where they are buttoned."""

from __future__ import annotations

from swifttailor.pattern.names import UNDER_FRONT
from swifttailor.pattern.panel import Panel
from swifttailor.pattern.pattern import Pattern

_MAY_OVERLAP = (("skirt_front", UNDER_FRONT), ("right_ftorso", "left_ftorso"))
"""The upper one first; it comes from the wearer's right."""
_LEAST_CM = 1.0
"""What reaches less far over the other one does not overlap."""


def overlapping_fronts(pattern: Pattern) -> tuple[tuple[str, str], ...]:
    """Names of panels that overlap, the upper one of each two first."""
    panels = {panel.name: panel for panel in pattern.panels}
    return tuple(
        names
        for names in _MAY_OVERLAP
        if all(name in panels for name in names) and _reach(*(panels[name] for name in names)) > _LEAST_CM
    )


def _reach(upper: Panel, lower: Panel) -> float:
    """How far the first goes over the second, from the wearer's right to the left, cm."""
    (_, right), (left, _) = (
        (x.min(), x.max()) for x in (p.placement.apply(p.vertices)[:, 0] for p in (upper, lower))
    )
    return float(right - left)


def lap_of_skirt(pattern: Pattern) -> float:
    """How far the upper front of a wound skirt goes over the lower one at most, cm; 0 of others."""
    pairs = [names for names in overlapping_fronts(pattern) if UNDER_FRONT in names]
    return max([_reach(*(pattern.panel(name) for name in names)) for names in pairs], default=0.0)

"""Making the sides of a pattern alike where they nearly are."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.pattern import Pattern
from swifttailor.pattern.check.repair import Change
from swifttailor.pattern.overlaps import overlapping_fronts
from swifttailor.pattern.panel import Panel
from swifttailor.pattern.tidying.symmetry import (
    OTHER_SIDE,
    between,
    distance,
    reflected,
    self_reflection,
)

NEARLY_CM = 6.0
"""Sides that differ by less are meant to be alike. In GarmentCode's 150 validation patterns 383 of 408 pairs
of panels are alike to 0.05 cm and 16 differ by more than this; of 146 skirt panels in the middle it is 102
and 44."""
SEEN_CM = 0.05
_ANY_SHAPE = ("skirt_panel_", "skirt_pleat_", "skirt_under_")
"""Panels of skirts of many gores, and strips of pleats, stand all around the body: theirs need not be
symmetric."""


def even_sides(pattern: Pattern, nearly: float = NEARLY_CM) -> tuple[Pattern, tuple[Change, ...]]:
    """Gives panels of both sides that are nearly alike their mean, and so panels in the middle.

    Edges and stitches stay as they are, and so do fronts that lie over each other.

    Args:
        pattern: To mend.
        nearly: Panels that are farther from their reflection at any place are left alone, cm.
    """
    panels = {p.name: p for p in pattern.panels}
    overlapping = {name for names in overlapping_fronts(pattern) for name in names}
    changes: list[Change] = []
    for panel in pattern.panels:
        other = OTHER_SIDE.get(panel.name)
        if other is None:
            after, moved = _even_middle(panel, nearly)
            new = [after]
        elif other in panels and panel.name < other and panel.name not in overlapping:
            one, two, moved = _even_pair(panel, panels[other], nearly)
            new = [one, two]
        else:
            continue
        if moved <= SEEN_CM:
            continue
        panels |= {p.name: p for p in new}
        both = "this panel and its counterpart" if other else "both halves of this panel"
        changes.append(
            Change("uneven-sides", f"made {both} alike; they differed by {moved:.2g} cm", panel.name)
        )
    if not changes:
        return pattern, ()
    return replace(pattern, panels=tuple(panels[p.name] for p in pattern.panels)), tuple(changes)


def _even_pair(one: Panel, two: Panel, nearly: float) -> tuple[Panel, Panel, float]:
    """Two panels of both sides, and how far they were from alike; 0 where they are left alone."""
    other = reflected(two, one.name)
    apart = distance(one, other)
    if apart is None or not SEEN_CM < apart <= nearly:
        return one, two, 0.0
    mean = between(one, other)
    x, y, z = (
        (a + b) / 2 for a, b in zip(one.placement.translation, other.placement.translation, strict=True)
    )
    mean = replace(mean, placement=replace(one.placement, translation=(x, y, z)))
    return mean, replace(reflected(mean, two.name), label=two.label), apart


def _even_middle(panel: Panel, nearly: float) -> tuple[Panel, float]:
    """A panel and how far its halves were from alike; 0 where it is left alone."""
    own = None if panel.name.startswith(_ANY_SHAPE) else self_reflection(panel)
    if own is None or not SEEN_CM < own.deviation <= nearly:
        return panel, 0.0
    return between(panel, own.image(panel)), own.deviation

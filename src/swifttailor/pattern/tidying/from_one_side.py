"""A symmetric pattern made of one side of another: what is missing or wrong on the other side comes anew."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from swifttailor.pattern import EdgeRef, Panel, Pattern, Stitch
from swifttailor.pattern.tidying.symmetry import (
    OTHER_SIDE,
    Reflection,
    distance,
    reflected,
    self_reflection,
)

ALIKE_CM = 6.0
"""A panel in the middle may be this far from its reflection to have two like halves."""
MIDDLE_CM = 3.0
"""An edge that is nowhere farther from the middle of the body runs down it."""
LEAST_SEAM_CM = 5.0
CROTCH_CM, CROTCH_STEEPNESS = 20.0, 0.8
"""A leg's edge that goes more down than so many times across and stays so near the middle is its crotch."""


def from_one_side(pattern: Pattern, panels: frozenset[str]) -> Pattern | None:
    """Reflects panels to the body's other side, with their seams, in place of what was there.

    Args:
        pattern: Any.
        panels: Names of those to keep; their counterparts are made anew. Neither of a pair may be left over.

    Returns:
        The pattern; None where it cannot be symmetric: a panel of the middle has no like halves, or an edge
        would be sewn to two others.
    """
    middle = [p for p in pattern.panels if p.name not in OTHER_SIDE]
    counts = {p.name: len(p.edges) for p in pattern.panels}
    own: dict[str, Reflection] = {}
    for panel in middle:
        reflection = self_reflection(panel)
        if reflection is not None and reflection.deviation <= ALIKE_CM:
            own[panel.name] = reflection
    counts |= {OTHER_SIDE[name]: counts[name] for name in panels}

    def opposite(ref: EdgeRef) -> EdgeRef | None:
        if ref.panel in OTHER_SIDE:
            return EdgeRef(OTHER_SIDE[ref.panel], counts[ref.panel] - 1 - ref.edge)
        found = own.get(ref.panel)
        return None if found is None else EdgeRef(ref.panel, found.edge(ref.edge, counts[ref.panel]))

    taken: dict[EdgeRef, Stitch] = {}
    for stitch in pattern.stitches:
        names = {side.panel for side in stitch.sides}
        ours = names & panels
        if not ours:
            if all(name not in OTHER_SIDE for name in names):
                _add(taken, stitch)
            continue
        if any(name in OTHER_SIDE and name not in panels for name in names):
            # Across the middle: kept where it is its own reflection, as a seam in the middle is.
            first, second = stitch.sides
            if opposite(first) == second and not _add(taken, stitch):
                return None
            continue
        other = [opposite(side) for side in stitch.sides]
        first, second = other
        if first is None or second is None:
            return None
        if not _add(taken, stitch) or not _add(taken, replace(stitch, first=first, second=second)):
            return None
    kept = {p.name: p for p in pattern.panels if p.name in panels}
    new = [reflected(panel, OTHER_SIDE[name]) for name, panel in kept.items()]
    for name, panel in kept.items():
        for number in range(len(panel.edges)):
            ref = EdgeRef(name, number)
            across = opposite(ref)
            if ref not in taken and across is not None and _is_in_the_middle(panel, number):
                _add(taken, Stitch(ref, across))
    stitches = tuple(dict.fromkeys(taken.values()))
    return replace(pattern, panels=(*middle, *kept.values(), *new), stitches=stitches).canonical()


def _is_in_the_middle(panel: Panel, edge: int) -> bool:
    """Whether an edge runs down the middle of the body, where both sides are sewn together.

    On legs the curve of the crotch does so too, although it swings out between them.
    """
    x, y, _ = np.abs(np.diff(panel.to_world(panel.sample_edge(edge, 5))[[0, -1]], axis=0))[0]
    farthest = float(np.abs(panel.to_world(panel.sample_edge(edge, 5))[:, 0]).max())
    is_crotch = panel.label == "leg" and farthest <= CROTCH_CM and y > CROTCH_STEEPNESS * x
    return panel.edge_length(edge) >= LEAST_SEAM_CM and (farthest <= MIDDLE_CM or is_crotch)


def sides_of(pattern: Pattern) -> tuple[frozenset[str], frozenset[str]]:
    """The panels of each side, those included that only the other side has."""
    names = {p.name for p in pattern.panels}
    pairs = {tuple(sorted((name, OTHER_SIDE[name]))) for name in names if name in OTHER_SIDE}
    one, two = (frozenset(pair[k] if pair[k] in names else pair[1 - k] for pair in pairs) for k in (0, 1))
    return one, two


def are_unlike(pattern: Pattern) -> bool:
    """Whether panels of both sides that go by the same name are cut differently."""
    panels = {p.name: p for p in pattern.panels}
    for name, panel in panels.items():
        other = panels.get(OTHER_SIDE.get(name, ""))
        if other is not None and name < other.name:
            apart = distance(panel, reflected(other, name))
            if apart is None or apart > ALIKE_CM:
                return True
    return False


def _add(taken: dict[EdgeRef, Stitch], stitch: Stitch) -> bool:
    """Notes a stitch unless one of its edges is sewn already to another edge."""
    if any(taken.get(side, stitch) != stitch for side in stitch.sides):
        there = taken.get(stitch.first)
        return there is not None and set(there.sides) == set(stitch.sides)
    taken |= dict.fromkeys(stitch.sides, stitch)
    return True

"""A pattern as a cutter reads it: what each panel is, how its grain runs, what each edge is for."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.body import Body
from swifttailor.describing.measuring.anatomy import Anatomy, Border
from swifttailor.describing.measuring.parts import ARM_PARTS, PlacedPart
from swifttailor.errors import PatternError
from swifttailor.making.allowances import EdgeKind
from swifttailor.making.darts import Dart, find_darts
from swifttailor.making.upright import turn_upright
from swifttailor.pattern import EdgeRef, Pattern, check_pattern
from swifttailor.pattern.check import require_no_errors

MOST_PANELS, MOST_EDGES = 300, 4000
_FLAT_CM = 0.002
"""Polylines stay this close to the curves."""
_STEEP = 0.8
_SHORTEST_SLIT_CM = 2.0
_CURVED = 0.035
"""A hem is curved where 3 cm further out it is longer by more than this share."""
_OUT_CM = 3.0
NECK_FROM_CM = 8.0
"""The upper border is a neckline where its middle lies higher than this above the waist."""


@dataclass(frozen=True, eq=False)
class FlatPanel:
    """A panel seen from the right side of the cloth, its grain upright, travelled anticlockwise."""

    index: int
    """Position in the pattern."""
    name: str
    placed: PlacedPart
    edges: tuple[Floats, ...]
    """Polylines (n, 2), cm, one an edge, both ends included; edge k keeps its number."""
    lengths: tuple[float, ...]
    """Arc lengths of the edges, cm."""
    kinds: tuple[EdgeKind, ...]
    turn: Floats
    """(2, 2): panel-local points times its transpose are points of the piece."""

    @property
    def corners(self) -> Floats:
        """(n, 2) where the edges begin."""
        return np.array([e[0] for e in self.edges])

    @cached_property
    def outline(self) -> Floats:
        """Closed polyline (n, 2); the first point is not repeated."""
        return np.concatenate([e[:-1] for e in self.edges])


@dataclass(frozen=True, eq=False)
class SewnPattern:
    """What all files to sew from are made of."""

    pattern: Pattern
    """In canonical order."""
    panels: tuple[FlatPanel, ...]
    partner: Mapping[EdgeRef, EdgeRef]
    """What every stitched edge is sewn to."""
    darts: tuple[Dart, ...]

    def panel(self, name: str) -> FlatPanel:
        """The panel of that name."""
        return self.panels[self.pattern.panel_index(name)]

    def length(self, ref: EdgeRef) -> float:
        """Arc length of an edge, cm."""
        return self.panel(ref.panel).lengths[ref.edge]


def read_pattern(pattern: Pattern) -> SewnPattern:
    """Looks at a pattern as somebody who is about to cut it.

    Args:
        pattern: A pattern placed around a body.

    Raises:
        PatternError: It cannot be cut or sewn; the message names the first fault.
    """
    require_sewable(pattern)  # by the numbers that its file has
    pattern = pattern.canonical()
    anatomy = Anatomy.of(pattern, Body.default().measurements)
    darts = find_darts(pattern, anatomy.cloth.partner)
    kinds = _edge_kinds(anatomy, darts)
    panels = []
    for k, panel in enumerate(pattern.panels):
        refs = [EdgeRef(panel.name, e) for e in range(len(panel.edges))]
        placed = anatomy.parts[panel.name]
        turn = turn_upright(panel, on_arm=placed.part in ARM_PARTS)
        edges = tuple(panel.flatten_edge(r.edge, _FLAT_CM) @ turn.T for r in refs)
        lengths = tuple(panel.edge_length(r.edge) for r in refs)
        panels.append(FlatPanel(k, panel.name, placed, edges, lengths, tuple(kinds[r] for r in refs), turn))
    return SewnPattern(pattern, tuple(panels), anatomy.cloth.partner, darts)


def require_sewable(pattern: Pattern) -> None:
    """Refuses patterns that cannot be cut or sewn.

    Raises:
        PatternError: It has no panels, or `swifttailor check` finds an error in it.
    """
    if not pattern.panels:
        raise PatternError("The pattern has no panels, so there is nothing to cut. Give one with panels.")
    edges = sum(len(panel.edges) for panel in pattern.panels)
    if len(pattern.panels) > MOST_PANELS or edges > MOST_EDGES:
        raise PatternError(
            f"The pattern has {len(pattern.panels)} panels and {edges} edges; at most {MOST_PANELS} panels "
            f"and {MOST_EDGES} edges are made into files to sew from. Divide it into garments."
        )
    require_no_errors(check_pattern(pattern), f"The pattern '{pattern.name}'")


def _edge_kinds(anatomy: Anatomy, darts: tuple[Dart, ...]) -> dict[EdgeRef, EdgeKind]:
    pattern = anatomy.pattern
    kinds = dict.fromkeys(anatomy.cloth.samples, EdgeKind.SEAM)
    for dart in darts:
        for ref in dart.legs:
            kinds[ref] = EdgeKind.DART
    for loop, border in anatomy.borders:
        neck = loop.center[1] > anatomy.figure.waist_y + NECK_FROM_CM
        on_arms = {anatomy.part_of(r) for r in loop.edges} <= ARM_PARTS
        hems = []
        for ref in loop.edges:
            if border is Border.ARM:
                kind = EdgeKind.HEM if on_arms else EdgeKind.ARMHOLE
            elif border is Border.TOP:
                kind = EdgeKind.NECKLINE if neck else EdgeKind.TOP
            elif border is Border.OTHER:
                kind = EdgeKind.OPENING
            else:
                kind = EdgeKind.SLIT if _is_steep(anatomy, ref) else EdgeKind.HEM
            kinds[ref] = kind
            if kind is EdgeKind.HEM:
                hems.append(ref)
        # One width all around, or the folded hem would have steps in it.
        if any(_is_curved(pattern, ref) for ref in hems):
            kinds.update(dict.fromkeys(hems, EdgeKind.CURVED_HEM))
    return kinds


def _is_steep(anatomy: Anatomy, ref: EdgeRef) -> bool:
    """Whether a free edge of a hem is the side of a slit."""
    heights = anatomy.cloth.world[anatomy.cloth.samples[ref], 1]
    length = anatomy.edge_length(ref)
    return length > _SHORTEST_SLIT_CM and abs(float(heights[-1] - heights[0])) > _STEEP * length


def _is_curved(pattern: Pattern, ref: EdgeRef) -> bool:
    points = pattern.panel(ref.panel).flatten_edge(ref.edge, 0.05)
    along = np.diff(points, axis=0)
    angle = np.unwrap(np.arctan2(along[:, 1], along[:, 0]))
    return abs(float(angle[-1] - angle[0])) * _OUT_CM > _CURVED * pattern.edge_length(ref)

"""A pattern seen as a garment: its panels' parts, the seams between parts, and what each border is for."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property, lru_cache
from types import MappingProxyType

from swifttailor.body import BodyMeasurements
from swifttailor.describing.measuring.cloth import Cloth, FreeLoop
from swifttailor.describing.measuring.parts import (
    ARM_PARTS,
    LEG_PARTS,
    WELL_ABOVE_WAIST_CM,
    Face,
    Openings,
    Part,
    PlacedPart,
    Side,
    find_parts,
    named_part,
)
from swifttailor.pattern import EdgeRef, Panel, Pattern
from swifttailor.pattern.drafts.figure import Figure

_LEG_APART_CM = 3.0
_ARMHOLE_APART_CM = 10.0


class Border(StrEnum):
    """What a free border of a garment is for."""

    TOP = "top"
    """Neckline, top of a strapless garment, top of a skirt or trousers."""
    HEM = "hem"
    LEG = "leg"
    """End of a trouser leg."""
    ARM = "arm"
    """Armhole, or end of a sleeve."""
    OTHER = "other"


@dataclass(frozen=True)
class Seam:
    """All stitches between two kinds of panels, seen from one of them."""

    pairs: tuple[tuple[EdgeRef, EdgeRef], ...]
    """(own edge, edge of the other part)."""
    length: float
    """Of the own edges, cm."""
    other_length: float
    """Of the other part's edges, cm."""

    @property
    def gather(self) -> float:
        """How much longer the own edges are than what they are sewn to (1 where there is no seam)."""
        return self.length / self.other_length if self.other_length > 1e-6 else 1.0

    @property
    def own(self) -> tuple[EdgeRef, ...]:
        """The own edges."""
        return tuple(a for a, _ in self.pairs)


@dataclass(frozen=True, eq=False)
class Anatomy:
    """A pattern with everything that its measures are taken from."""

    pattern: Pattern
    body: BodyMeasurements
    figure: Figure
    cloth: Cloth
    parts: Mapping[str, PlacedPart]
    """By panel name."""
    borders: tuple[tuple[FreeLoop, Border], ...]

    @staticmethod
    def of(pattern: Pattern, body: BodyMeasurements) -> Anatomy:
        """Looks at a pattern placed around a body."""
        return _look_at(pattern, pattern.name, body)

    def panels(
        self, parts: Part | Collection[Part], side: Side | None = None, face: Face | None = None
    ) -> tuple[Panel, ...]:
        """Panels of some parts, of one side or face if asked, in pattern order."""
        wanted = {parts} if isinstance(parts, Part) else set(parts)
        return tuple(
            p.panel
            for p in self.parts.values()
            if p.part in wanted and side in (None, p.side) and face in (None, p.face)
        )

    def has(self, part: Part) -> bool:
        """Whether there is a panel of that part."""
        return any(p.part is part for p in self.parts.values())

    def edge_length(self, ref: EdgeRef) -> float:
        """Arc length of an edge, cm."""
        return self.cloth.lengths[ref]

    def part_of(self, ref: EdgeRef) -> Part:
        """The part that an edge belongs to."""
        return self.parts[ref.panel].part

    def seam(
        self,
        own: Part | Collection[Part],
        other: Part | Collection[Part],
        side: Side | None = None,
        face: Face | None = None,
    ) -> Seam:
        """All that is sewn between panels of `own` and panels of `other` (not darts).

        Args:
            own: Part or parts whose edges come first.
            other: Part or parts on the other side of the seam.
            side: Only own panels on this side.
            face: Only own panels of this face.
        """
        mine = {p.name for p in self.panels(own, side, face)}
        theirs = {p.name for p in self.panels(other)}
        pairs = tuple(
            (a, b)
            for s in self.cloth.stitches
            for a, b in dict.fromkeys((s.sides, s.sides[::-1]))
            if a.panel in mine and b.panel in theirs and a.panel != b.panel
        )
        lengths = [sum(map(self.edge_length, refs)) for refs in zip(*pairs, strict=True)] or [
            0.0,
            0.0,
        ]
        return Seam(pairs, lengths[0], lengths[1])

    def darts(self, parts: Part | Collection[Part]) -> int:
        """How many darts the panels of some parts have."""
        names = {p.name for p in self.panels(parts)}
        return sum(s.first.panel == s.second.panel and s.first.panel in names for s in self.cloth.stitches)

    def loops(self, border: Border) -> tuple[FreeLoop, ...]:
        """The borders of one kind."""
        return tuple(loop for loop, kind in self.borders if kind is border)

    @cached_property
    def top(self) -> FreeLoop | None:
        """Neckline or upper border; None for a closed garment."""
        found = self.loops(Border.TOP)
        return found[0] if found else None

    @cached_property
    def hem(self) -> FreeLoop | None:
        """Lower border; None where the garment ends in legs."""
        found = self.loops(Border.HEM)
        return found[0] if found else None

    def free_edges(self, parts: Part | Collection[Part]) -> tuple[EdgeRef, ...]:
        """Edges of some parts that are sewn to nothing."""
        names = {p.name for p in self.panels(parts)}
        return tuple(r for r in self.cloth.samples if r.panel in names and r not in self.cloth.partner)


@lru_cache(maxsize=32)
def _look_at(pattern: Pattern, name: str, body: BodyMeasurements) -> Anatomy:
    """Remembers the latest: who judges, alters or describes a pattern looks at it anew.

    Patterns are equal whatever they are called, so the name is told apart as well.
    """
    figure = Figure.of(body)
    cloth = Cloth.of(pattern)
    parts = MappingProxyType(find_parts(pattern, figure, _openings(cloth, figure)))
    return Anatomy(pattern, body, figure, cloth, parts, _borders(cloth, parts, figure))


def _openings(cloth: Cloth, figure: Figure) -> Openings:
    """Reads the borders before anything is known of the panels but their names."""
    low = [
        loop.center[0]
        for loop in cloth.loops
        if loop.center[1] < figure.hip_y and all(named_part(r.panel) not in ARM_PARTS for r in loop.edges)
    ]
    two_legs = any(x > _LEG_APART_CM for x in low) and any(x < -_LEG_APART_CM for x in low)
    high = [loop for loop in cloth.loops if loop.center[1] > figure.hip_y]
    arms = [loop for loop in high if abs(loop.center[0]) > _ARMHOLE_APART_CM]
    top = max(high, key=lambda loop: loop.center[1], default=None)
    upper = bool(arms) or (top is not None and top.center[1] > figure.waist_y + WELL_ABOVE_WAIST_CM)
    around = {r.panel for loop in (*arms, *([top] if top else [])) for r in loop.edges}
    return Openings(two_legs, upper, frozenset(around))


_AROUND_LEGS = LEG_PARTS | {Part.TORSO}
"""What openings of legs lie in: those of a swimsuit in the body and the strip between the legs."""


def _borders(
    cloth: Cloth, parts: Mapping[str, PlacedPart], figure: Figure
) -> tuple[tuple[FreeLoop, Border], ...]:
    kinds: dict[int, Border] = {}
    middle: list[int] = []
    for k, loop in enumerate(cloth.loops):
        own = {parts[r.panel].part for r in loop.edges}
        x, y, _ = loop.center
        if own <= ARM_PARTS or (abs(x) > _ARMHOLE_APART_CM and y > figure.hip_y and not own & LEG_PARTS):
            kinds[k] = Border.ARM
        elif own & LEG_PARTS and own <= _AROUND_LEGS and abs(x) > _LEG_APART_CM and y < figure.waist_y:
            kinds[k] = Border.LEG
        else:
            middle.append(k)
    middle.sort(key=lambda k: -cloth.loops[k].center[1])
    has_legs = Border.LEG in kinds.values()
    for position, k in enumerate(middle):
        if position == 0 and (len(middle) > 1 or has_legs or cloth.loops[k].center[1] > figure.hip_y):
            kinds[k] = Border.TOP
        elif position == len(middle) - 1 and not has_legs:
            kinds[k] = Border.HEM
        else:
            kinds[k] = Border.OTHER
    return tuple((loop, kinds[k]) for k, loop in enumerate(cloth.loops))

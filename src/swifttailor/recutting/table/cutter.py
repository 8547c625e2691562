"""A pattern on the cutting table: what it shows, what is wrong with it, and where its borders are."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from swifttailor.body import Body, BodyMeasurements
from swifttailor.body.probe import body_levels
from swifttailor.body.wearer import body_of
from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.measuring.anatomy import Anatomy, Border
from swifttailor.describing.measuring.hems import find_hem
from swifttailor.describing.measuring.parts import Face, Part
from swifttailor.describing.measuring.wear import Worn, wear
from swifttailor.describing.measuring.whole_pattern import measure_anatomy
from swifttailor.pattern import EdgeRef, Pattern, Severity, check_pattern
from swifttailor.pattern.check import BodyProbe


def _heights_of(body: BodyMeasurements) -> BodyProbe | None:
    """Where garments are worn on a body, and nothing else of it; None for the default body's own checks."""
    if body == Body.default().measurements:
        return None
    return BodyProbe(lambda points: np.full(len(points), np.inf), 0.0, body.height, body_levels(body))


class Cutter:
    """A pattern that is about to be recut, and what is known of it."""

    def __init__(self, pattern: Pattern, body: BodyMeasurements | None = None) -> None:
        self.pattern = pattern.canonical()
        worn_by = body_of(pattern.drafted_for).measurements if body is None else body
        self.anatomy = Anatomy.of(self.pattern, worn_by)

    def with_pattern(self, pattern: Pattern) -> Cutter:
        """Another pattern for the same body."""
        return Cutter(pattern, self.anatomy.body)

    @cached_property
    def facts(self) -> GarmentFacts:
        """What the pattern shows."""
        return measure_anatomy(self.anatomy)

    @cached_property
    def faults(self) -> frozenset[tuple[str, str]]:
        """Codes of errors and warnings, and the panels they are about."""
        found = check_pattern(self.pattern, body=_heights_of(self.anatomy.body))
        return frozenset((f.code, f.panel) for f in found if f.severity is not Severity.INFO)

    @cached_property
    def seam_ratios(self) -> dict[tuple[str, str], float]:
        """For every two panels sewn together, the length of one's edges over that of the other's."""
        sums: dict[tuple[str, str], list[float]] = {}
        for s in self.pattern.stitches:
            first, second = sorted(s.sides)
            lengths = sums.setdefault((first.panel, second.panel), [0.0, 0.0])
            lengths[0] += self.anatomy.edge_length(first)
            lengths[1] += self.anatomy.edge_length(second)
        return {pair: a / b for pair, (a, b) in sums.items() if b > 0.5}

    @cached_property
    def worn(self) -> Worn:
        """How it hangs."""
        return wear(self.anatomy)

    @cached_property
    def hem(self) -> tuple[EdgeRef, ...]:
        """The hem, slits left out; of both legs."""
        return find_hem(self.anatomy, self.worn).edges

    def names(self, *parts: Part) -> list[str]:
        """Panels of some parts."""
        return [p.name for p in self.anatomy.panels(parts)]

    def hem_of(self, *parts: Part) -> tuple[EdgeRef, ...]:
        """The hem, if all of it belongs to some parts; else nothing."""
        return self.hem if self.hem and all(self.anatomy.part_of(r) in parts for r in self.hem) else ()

    def ends_of(self, part: Part, border: Border) -> tuple[EdgeRef, ...]:
        """Free edges of a part on one kind of border."""
        free = {r for loop in self.anatomy.loops(border) for r in loop.edges}
        return tuple(r for r in self.anatomy.free_edges(part) if r in free)

    def neckline(self, face: Face) -> tuple[EdgeRef, ...]:
        """Free edges of the neckline of a face; none where a shoulder is bare or something is sewn to it."""
        if not all(self.worn.shoulders) or self.anatomy.has(Part.COLLAR) or self.anatomy.has(Part.HOOD):
            return ()
        top = self.anatomy.top.edges if self.anatomy.top else ()
        return tuple(
            r
            for r in top
            if self.anatomy.part_of(r) is Part.TORSO and self.anatomy.parts[r.panel].face == face
        )

"""Predicted patterns against true ones without conditions: panels paired by name, missing ones a failure."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.evaluation.patterns.panel_geometry import (
    rotation_distance,
    translation_distance,
    vertex_distance,
    vertex_extent,
)
from swifttailor.pattern import EdgeRef, Pattern


@dataclass(frozen=True)
class Found:
    """How well a set of things was predicted."""

    hits: int
    predicted: int
    true: int

    @property
    def precision(self) -> float:
        """Share of the predicted that are true; 1 where both are nothing."""
        return self.hits / self.predicted if self.predicted else float(not self.true)

    @property
    def recall(self) -> float:
        """Share of the true that were predicted; 1 where both are nothing."""
        return self.hits / self.true if self.true else float(not self.predicted)

    @property
    def f1(self) -> float:
        """Harmonic mean of both."""
        return 2 * self.hits / (self.predicted + self.true) if self.predicted + self.true else 1.0


@dataclass(frozen=True)
class NameScore:
    """One predicted pattern against the true one; the order of panels and stitches means nothing."""

    panels: Found
    """Names of panels."""
    edges: float
    """Share of the panels, of either pattern, that both have with equally many edges."""
    kinds: float
    """The same, each edge of the same kind of curve as well."""
    vertex_cm: float
    """Mean of `vertex_distance` over the panels of either pattern; one that the other lacks costs its
    `vertex_extent`."""
    translation_cm: float | None
    """Mean over the panels that both have; None where there are none."""
    rotation: float | None
    stitches: Found
    """Pairs of edges, by name of the panel and number of the edge."""
    sides: float | None
    """Of the stitches found: share whose `right_wrong` is right; None where there are none."""

    @property
    def structure_right(self) -> bool:
        """Whether names, edges, kinds of edges and stitches are all as they should be."""
        return self.kinds == 1.0 and self.stitches.f1 == 1.0 and self.sides in (1.0, None)


def name_score(predicted: Pattern | None, truth: Pattern) -> NameScore:
    """Compares two patterns; None, where nothing was decoded, counts as a pattern without panels."""
    predicted = Pattern(()) if predicted is None else predicted
    ours, theirs = ({p.name: p for p in pattern.panels} for pattern in (predicted, truth))
    shared = [(ours[n], theirs[n]) for n in sorted(ours.keys() & theirs.keys())]
    missed = [p for one, other in ((ours, theirs), (theirs, ours)) for n, p in one.items() if n not in other]
    either = max(len(shared) + len(missed), 1)
    same_edges = [len(p.edges) == len(t.edges) for p, t in shared]
    same_kinds = [[type(e.curve) for e in p.edges] == [type(e.curve) for e in t.edges] for p, t in shared]
    costs = [vertex_distance(p, t) for p, t in shared] + [vertex_extent(p) for p in missed]
    found, wanted = _stitches(predicted), _stitches(truth)
    hits = found.keys() & wanted.keys()
    both = len(shared)
    empty = not ours and not theirs
    return NameScore(
        panels=Found(both, len(ours), len(theirs)),
        edges=1.0 if empty else sum(same_edges) / either,
        kinds=1.0 if empty else sum(same_kinds) / either,
        vertex_cm=sum(costs) / either,
        translation_cm=sum(translation_distance(p, t) for p, t in shared) / both if both else None,
        rotation=sum(rotation_distance(p, t) for p, t in shared) / both if both else None,
        stitches=Found(len(hits), len(found), len(wanted)),
        sides=sum(found[pair] == wanted[pair] for pair in hits) / len(hits) if hits else None,
    )


def _stitches(pattern: Pattern) -> dict[frozenset[EdgeRef], bool]:
    """Whether each is `right_wrong`, by its two edges."""
    return {frozenset(s.sides): s.right_wrong for s in pattern.stitches}

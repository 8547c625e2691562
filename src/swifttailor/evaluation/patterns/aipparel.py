"""The metrics of patterns as AIpparel's code computes them (Nakayama et al. 2025), and hence the paper.

Panels are paired by their place in the list, and shape, placement and stitches are judged only where the
number of panels is right. `by_name` has what this leaves out.
"""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.evaluation.patterns.panel_geometry import (
    rotation_distance,
    translation_distance,
    vertex_distance,
)
from swifttailor.pattern import EdgeRef, Pattern, Stitch


@dataclass(frozen=True)
class AipparelScore:
    """One predicted pattern against the true one; None where AIpparel leaves the pattern out."""

    panels_right: bool
    """Whether their number is; names do not count."""
    edges_by_name: float | None = None
    """Share of the predicted panels that have as many edges as the true one of that name."""
    edges_in_order: float | None = None
    """Share of the panels that have as many edges as the true one in the same place."""
    vertex_cm: float | None = None
    """Mean over the panels of `vertex_distance`."""
    translation_cm: float | None = None
    rotation: float | None = None
    stitches: float | None = None
    """Share of the true stitches that are among the predicted ones; those in excess do not count."""


def aipparel_score(predicted: Pattern | None, truth: Pattern) -> AipparelScore:
    """Compares two patterns.

    Args:
        predicted: Its panels in the order in which they were generated; None where nothing was decoded.
        truth: Any order; it is put in the canonical one.
    """
    truth = truth.canonical()
    if predicted is None or not predicted.panels:
        return AipparelScore(panels_right=False)
    known = {p.name: p for p in truth.panels}
    by_name = [p.name in known and len(p.edges) == len(known[p.name].edges) for p in predicted.panels]
    count = len(predicted.panels)
    if count != len(truth.panels):
        return AipparelScore(panels_right=False, edges_by_name=sum(by_name) / count)
    pairs = list(zip(predicted.panels, truth.panels, strict=True))
    return AipparelScore(
        panels_right=True,
        edges_by_name=sum(by_name) / count,
        edges_in_order=sum(len(p.edges) == len(t.edges) for p, t in pairs) / count,
        vertex_cm=sum(vertex_distance(p, t) for p, t in pairs) / count,
        translation_cm=sum(translation_distance(p, t) for p, t in pairs) / count,
        rotation=sum(rotation_distance(p, t) for p, t in pairs) / count,
        stitches=_stitches_found(predicted.stitches, truth.stitches),
    )


def _stitches_found(predicted: tuple[Stitch, ...], truth: tuple[Stitch, ...]) -> float:
    """An edge in several predicted stitches has the last of them; a pattern without stitches counts 0."""
    partner: dict[EdgeRef, EdgeRef] = {}
    for s in predicted:
        partner[s.first], partner[s.second] = s.second, s.first
    return sum(partner.get(s.first) == s.second for s in truth) / max(len(truth), 1)

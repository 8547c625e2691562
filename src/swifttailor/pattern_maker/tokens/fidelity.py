"""How far a pattern that was written as tokens and read again is from what it was."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from swifttailor.pattern.curve import Arc, evaluate
from swifttailor.pattern.panel import Panel
from swifttailor.pattern.pattern import Pattern


@dataclass(frozen=True)
class Fidelity:
    """Differences between two patterns."""

    same_structure: bool
    """Panels, labels, edges, their kinds and labels, and stitches with their flags are equal."""
    outline_cm: float
    """Largest distance between corresponding points of the outlines, from the first vertex of each."""
    placement_cm: float
    """Largest distance between corresponding vertices where the panels are placed."""


def compare(first: Pattern, second: Pattern) -> Fidelity:
    """Compares two patterns, whatever the order of their panels and the origins of these.

    Distances are infinite where the structure differs.
    """
    first, second = first.canonical(), second.canonical()
    same = first.stitches == second.stitches and [_structure(p) for p in first.panels] == [
        _structure(p) for p in second.panels
    ]
    if not same:
        return Fidelity(False, np.inf, np.inf)
    pairs = list(zip(first.panels, second.panels, strict=True))
    return Fidelity(
        True,
        max((_outline_difference(a, b) for a, b in pairs), default=0.0),
        max((_distance(a.to_world(a.vertices), b.to_world(b.vertices)) for a, b in pairs), default=0.0),
    )


def _structure(panel: Panel) -> tuple[object, ...]:
    return (
        panel.name,
        panel.label,
        *((type(e.curve), e.label, _side(panel, k)) for k, e in enumerate(panel.edges)),
    )


def _side(panel: Panel, edge: int) -> bool | None:
    """To which side an arc bulges. The other flag means nothing for half circles; the points tell."""
    curve = panel.edges[edge].curve
    return curve.right if isinstance(curve, Arc) else None


def _outline_difference(a: Panel, b: Panel) -> float:
    parameters = np.linspace(0.0, 1.0, 9)
    return max(
        _distance(
            evaluate(a.edges[k].curve, a.chord(k), parameters) - a.vertices[0],
            evaluate(b.edges[k].curve, b.chord(k), parameters) - b.vertices[0],
        )
        for k in range(len(a.edges))
    )


def _distance(a: np.ndarray, b: np.ndarray) -> float:
    return float(np.linalg.norm(a - b, axis=-1).max())

"""Long straight side seams become curves where another body asks for it, at waist and hips for instance."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from swifttailor.pattern import Panel, Pattern
from swifttailor.pattern.check import panel_regions
from swifttailor.pattern.curve import Cubic, Line
from swifttailor.refitting.alike import Likeness

STRAIGHT = Cubic((1 / 3, 0.0), (2 / 3, 0.0))
_LONG_CM = 12.0
_STRAIGHT_CM = 0.25
"""Curves that leave their chord by less are lines again."""


def shaped_seams(pattern: Pattern, likeness: Likeness) -> frozenset[tuple[int, int]]:
    """Edges that may become curves: both sides of long straight seams down the trunk or down a leg.

    Seams in the middle, between a panel and its own mirror image, stay straight, so that they can be cut on
    the fold. Darts, sleeves, waistbands and hems stay as they are.

    Args:
        pattern: Before it is refitted.
        likeness: Of it.

    Returns:
        Numbers of panel and edge.
    """
    region = panel_regions(pattern)
    mirrored = {frozenset(pair) for pair in likeness.pairs}
    found: set[tuple[int, int]] = set()
    for stitch in pattern.stitches:
        sides = [(pattern.panel_index(ref.panel), ref.edge) for ref in stitch.sides]
        numbers = frozenset(number for number, _ in sides)
        if len(numbers) == 1 or numbers in mirrored:
            continue
        edges = [pattern.panels[number].edges[k] for number, k in sides]
        if any(region[pattern.panels[number].name] == "arm" for number in numbers):
            continue
        if all(isinstance(edge.curve, Line) for edge in edges) and all(
            pattern.edge_length(ref) >= _LONG_CM for ref in stitch.sides
        ):
            found |= set(sides)
    return frozenset(_upright(pattern, found))


def _upright(pattern: Pattern, found: set[tuple[int, int]]) -> set[tuple[int, int]]:
    """Those that run more down the panel than across it."""
    kept = set()
    for number, k in found:
        a, b = pattern.panels[number].chord(k)
        if abs(b[1] - a[1]) > abs(b[0] - a[0]):
            kept.add((number, k))
    return kept


def curved(panel: Panel, edges: frozenset[int]) -> Panel:
    """A panel whose edges of these numbers are curves, straight as they may be."""
    return replace(
        panel,
        edges=tuple(
            replace(edge, curve=STRAIGHT) if k in edges and isinstance(edge.curve, Line) else edge
            for k, edge in enumerate(panel.edges)
        ),
    )


def straightened(pattern: Pattern, seams: frozenset[tuple[int, int]]) -> Pattern:
    """The pattern with those of the edges as lines that are next to straight."""
    panels = list(pattern.panels)
    for number, k in seams:
        panel = panels[number]
        curve = panel.edges[k].curve
        chord = panel.chord(k)
        if isinstance(curve, Cubic):
            rise = max(abs(curve.control_1[1]), abs(curve.control_2[1]))
            if rise * float(np.linalg.norm(chord[1] - chord[0])) < _STRAIGHT_CM:
                edges = list(panel.edges)
                edges[k] = replace(edges[k], curve=Line())
                panels[number] = replace(panel, edges=tuple(edges))
    return replace(pattern, panels=tuple(panels))

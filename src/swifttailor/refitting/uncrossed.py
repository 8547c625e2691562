"""Panels whose curves ran over another edge on the way to another body are drawn a little flatter there."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from swifttailor.pattern import Panel, Pattern
from swifttailor.pattern.check.crossings import find_crossing
from swifttailor.pattern.check.outline import trace_outline
from swifttailor.pattern.curve import Arc, Cubic, Curve, Line, Quadratic
from swifttailor.refitting.alike import Likeness, made_alike
from swifttailor.refitting.even_lengths import keep_seam_ratios

_STEP = 0.95
"""What a curve's rise over its chord is multiplied by in each round."""
_ROUNDS = 16
_DEEPEST_CM = 100.0
_LEAST_KEPT = 0.4
"""Of a panel's width; the smallest children's are 0.6 of an adult's."""


def uncrossed(before: Pattern, after: Pattern, likeness: Likeness) -> Pattern:
    """Flattens curves that cross another edge until they do not, where they did not before.

    Args:
        before: The pattern that was refitted.
        after: The same panels and edges for another body.
        likeness: Of the pattern before.

    Returns:
        The pattern for the other body; as it was given where flatter curves do not help.
    """
    own = [_depth(panel) for panel in before.panels]
    pattern = after
    for _ in range(_ROUNDS):
        panels = list(pattern.panels)
        crossed = False
        for k, panel in enumerate(panels):
            found = find_crossing(trace_outline(panel))
            if found is None or _depth(panel) <= own[k]:
                continue
            crossed = True
            panels[k] = _flatter(panel, set(found.edges))
        if not crossed:
            return pattern
        pattern = replace(pattern, panels=tuple(panels))
        pattern = made_alike(keep_seam_ratios(before, pattern), likeness)
    still = sum(_depth(panel) for panel in pattern.panels)
    return pattern if still < sum(_depth(panel) for panel in after.panels) else after


def damaged(before: Pattern, after: Pattern) -> bool:
    """Whether a panel crosses itself, or does so more deeply, that did not before, or has collapsed."""
    pairs = list(zip(before.panels, after.panels, strict=True))
    return any(_collapsed(a, b) or _depth(b) > _depth(a) for a, b in pairs)


def _collapsed(before: Panel, after: Panel) -> bool:
    """Whether hardly any cloth is left, or the loop has turned over, as of flounces a centimetre high."""
    old, new = trace_outline(before), trace_outline(after)
    kept = np.sign(old.area * new.area) * new.mean_width
    return bool(old.mean_width > 0 and kept < _LEAST_KEPT * old.mean_width)


def _depth(panel: Panel) -> float:
    """How deeply an outline crosses itself, cm; -1 where it does not even touch itself."""
    found = find_crossing(trace_outline(panel))
    return -1.0 if found is None else min(found.depth, _DEEPEST_CM)


def _flatter(panel: Panel, numbers: set[int]) -> Panel:
    """The panel with some of its curved edges nearer to their chords."""
    edges = list(panel.edges)
    for k in numbers:
        length = float(np.linalg.norm(panel.chord(k)[1] - panel.chord(k)[0]))
        edges[k] = replace(edges[k], curve=_flatter_curve(edges[k].curve, length))
    return replace(panel, edges=tuple(edges))


def _flatter_curve(curve: Curve, length: float) -> Curve:
    if isinstance(curve, Line):
        return curve
    if isinstance(curve, Arc):
        reach = np.sqrt(max(curve.radius**2 - length**2 / 4, 0.0))
        rise = _STEP * float(curve.radius + (reach if curve.large else -reach))
        radius = (length**2 / 4 + rise**2) / (2 * rise)
        return replace(curve, radius=radius, large=rise > length / 2)
    if isinstance(curve, Quadratic):
        x, y = curve.control
        return Quadratic((x, _STEP * y))
    (a, b), (c, d) = curve.control_1, curve.control_2
    return Cubic((a, _STEP * b), (c, _STEP * d))

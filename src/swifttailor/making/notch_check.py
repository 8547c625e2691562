"""Whether the notches that are printed match, found anew from the printed pieces and the seams."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.making.notches import EVERY_CM
from swifttailor.making.piece import Piece
from swifttailor.making.pieces import CuttingPlan
from swifttailor.making.sewn_pattern import FlatPanel
from swifttailor.making.twins import along
from swifttailor.pattern import EdgeRef

_HERE_CM = 0.06
"""A notch this close to an edge lies on it."""
_SAME_CM = 0.15
_END_CM = 0.5
"""Marks closer to the end of an edge are those of its end."""


def notch_faults(plan: CuttingPlan) -> list[str]:
    """Everything about the printed notches that would mislead; nothing when all match.

    For every seam, the notches on one edge must lie at the same shares of its length, with as many teeth, as
    those on the other edge, seen the way in which the edges are sewn together. A mark at the end of an
    edge may face a corner, which needs no mark. Long seams must not be without notches.
    """
    faults = []
    printed = {p.name: _on_panel(plan.piece_of(p.name), p, plan) for p in plan.sewn.panels}
    darts = {ref for dart in plan.sewn.darts for ref in dart.legs}
    for k, stitch in enumerate(plan.sewn.pattern.stitches):
        if plan.closing is not None and plan.closing.extension and stitch.first in plan.closing.edges:
            continue  # fronts that lap are not sewn together there
        if stitch.first in darts or plan.sewn.partner.get(stitch.first) != stitch.second:
            continue
        sides = [_shares(printed[r.panel], plan.sewn.panel(r.panel), r) for r in stitch.sides]
        longest = max(plan.sewn.length(r) for r in stitch.sides)
        near = min(_END_CM / max(longest, 1e-9), 0.2)
        other = {(s if stitch.right_wrong else 1.0 - s, t) for s, t in sides[1] if near < s < 1 - near}
        own = {(s, t) for s, t in sides[0] if near < s < 1 - near}
        unmatched = [n for n in own if not any(_same(n, m, longest) for m in other)]
        unmatched += [n for n in other if not any(_same(n, m, longest) for m in own)]
        if unmatched:
            faults.append(f"stitch {k}: notch at {unmatched[0][0]:.3f} of one edge alone")
        marks = sorted({0.0, 1.0, *(s for s, _ in own)})
        if max(np.diff(marks)) * longest > EVERY_CM + 0.1:
            faults.append(f"stitch {k}: {longest:.1f} cm with {len(own)} notches")
    return faults


def _same(a: tuple[float, int], b: tuple[float, int], length: float) -> bool:
    return abs(a[0] - b[0]) * length < _SAME_CM and a[1] == b[1]


def _on_panel(piece: Piece, panel: FlatPanel, plan: CuttingPlan) -> list[tuple[Floats, int]]:
    """Notches of the printed piece, turned over where the panel is cut mirrored, moved onto the panel."""
    first = plan.sewn.panel((*piece.panels, *piece.mirrored)[0])
    mirrored = panel.name in piece.mirrored
    middle_of_first = _middle(first.outline)
    sign = np.array([-1.0, 1.0]) if mirrored else np.ones(2)
    return [((n.point - middle_of_first) * sign + _middle(panel.outline), n.teeth) for n in piece.notches]


def _shares(notches: list[tuple[Floats, int]], panel: FlatPanel, ref: EdgeRef) -> set[tuple[float, int]]:
    """Shares of an edge's length at which notches lie on it."""
    points = panel.edges[ref.edge]
    fine = np.linspace(0.0, 1.0, max(int(panel.lengths[ref.edge] / 0.02), 2) + 1)
    samples = along(points, fine)
    found = set()
    for point, teeth in notches:
        away = np.hypot(*(samples - point).T)
        if away.min() < _HERE_CM:
            found.add((float(fine[away.argmin()]), teeth))
    return found


def _middle(outline: Floats) -> Floats:
    return (outline.min(axis=0) + outline.max(axis=0)) / 2

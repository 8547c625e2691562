"""More or less cloth gathered into seams: panels made wider or narrower, darts let out."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern import Pattern
from swifttailor.recutting.table.workbench import Workbench


def widen_panels(
    pattern: Pattern,
    names: Collection[str],
    factor: float,
    *,
    keep_lower: bool = False,
    over: float | None = None,
) -> Pattern | None:
    """Stretches panels across, in their local x, about their middles.

    Args:
        pattern: Any pattern.
        names: Panels that stand upright, their local y being up.
        factor: New width over old.
        keep_lower: Whether they are stretched less the further down, and not at all at their lower ends.
        over: How far below their upper ends they are stretched at all, cm; all the way down when None.

    Returns:
        The recut pattern, arcs bent; None where an arc sweeps too far for that.
    """
    bench = Workbench(pattern)
    for name in names:
        panel = pattern.panel(name)
        box = panel.bounding_box()
        middle, (low, high) = float(box[:, 0].mean()), box[:, 1]
        low = low if over is None else max(low, high - over)

        def stretch(points: Floats, middle: float = middle, low: float = low, high: float = high) -> Floats:
            share = np.clip((points[:, 1] - low) / (high - low), 0.0, 1.0) if keep_lower else 1.0
            across = (1.0 + (factor - 1.0) * share) * (points[:, 0] - middle)
            return np.stack([middle + across, points[:, 1]], axis=1)

        if not bench.map_points(name, stretch, {s.id for s in bench.pieces[name].sides}, bend_arcs=True):
            return None
    return bench.pattern()


def let_out_darts(pattern: Pattern, names: Collection[str]) -> Pattern | None:
    """Takes the darts out of panels: what they took in is gathered into the seam that they start from.

    Returns:
        The recut pattern; None where there is no dart, or one that does not start from a seam with another
        panel.
    """
    bench = Workbench(pattern)
    darts = [s for s in pattern.stitches if s.first.panel == s.second.panel and s.first.panel in names]
    for dart in darts:
        first, second = bench.at[dart.first], bench.at[dart.second]
        if bench.neighbour(second, 1) == first:
            first, second = second, first
        before, after = bench.neighbour(first, -1), bench.neighbour(second, 1)
        partners = [bench.partner(s) for s in (before, after)]
        own = bench.piece_of(first)
        if bench.neighbour(first, 1) != second or any(
            p is None or bench.piece_of(p) is own for p in partners
        ):
            return None
        mouth = (bench.side(first).start + bench.side(after).start) / 2
        bench.drop(first)
        bench.drop(second)
        bench.side(after).start = mouth
    return bench.pattern() if darts else None

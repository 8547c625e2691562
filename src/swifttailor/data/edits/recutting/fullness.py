"""Making panels wider or narrower, so that more or less cloth is gathered into their seams."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np
from numpy.typing import NDArray

from swifttailor.data.edits.recutting.workbench import Workbench
from swifttailor.pattern import Pattern

Floats = NDArray[np.float64]


def widen_panels(
    pattern: Pattern, names: Collection[str], factor: float, *, bend_arcs: bool = False
) -> Pattern | None:
    """Stretches panels across, in their local x, about their middles.

    Args:
        pattern: Any pattern.
        names: Panels that stand upright, their local y being up.
        factor: New width over old.
        bend_arcs: Whether arcs become other curves.

    Returns:
        The recut pattern; None where a panel has arcs, which would have to become ellipses, and may
        not bend or sweep too far.
    """
    bench = Workbench(pattern)
    for name in names:
        panel = pattern.panel(name)
        middle = float(panel.bounding_box()[:, 0].mean())

        def stretch(points: Floats, middle: float = middle) -> Floats:
            return np.stack([middle + factor * (points[:, 0] - middle), points[:, 1]], axis=1)

        if not bench.map_points(name, stretch, {s.id for s in bench.pieces[name].sides}, bend_arcs=bend_arcs):
            return None
    return bench.pattern()

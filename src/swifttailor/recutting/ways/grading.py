"""Making a bodice wider or narrower all around, neckline and armholes kept as they are cut."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern import Pattern
from swifttailor.recutting.table.workbench import Workbench


@dataclass(frozen=True)
class Spread:
    """Where across a panel the cloth is spread: nothing moves nearer the middle, all moves alike beyond."""

    inner: float
    """Distance from the middle of the body, cm."""
    outer: float


def spread_panels(
    pattern: Pattern,
    spreads: Mapping[str, Spread],
    distance: float,
    *,
    beside: Collection[str] = (),
    below: Collection[str] = (),
    factor: float = 1.0,
) -> Pattern | None:
    """Moves the outer part of upright panels outward.

    Args:
        pattern: Any pattern.
        spreads: Panels to spread, and where.
        distance: How far their outer parts move on each side, cm; negative inward.
        beside: Panels that move along, such as sleeves.
        below: Panels that hang from them and become wider by a factor.
        factor: New width over old of those below.

    Returns:
        The recut pattern; None where a curve cannot follow.
    """
    bench = Workbench(pattern)
    for name, spread in spreads.items():
        panel = bench.pieces[name].panel
        across = panel.placement.matrix()[0, :2]
        if (
            spread.outer - spread.inner < max(2.0, -2.0 * distance)
            or abs(float(np.hypot(*across)) - 1.0) > 0.01
        ):
            return None

        def move(points: Floats, panel=panel, spread=spread, across=across) -> Floats:
            x = panel.to_world(points)[:, 0]
            share = np.clip((np.abs(x) - spread.inner) / (spread.outer - spread.inner), 0.0, 1.0)
            return points + (distance * np.sign(x) * share)[:, None] * across

        if not bench.map_points(name, move, {s.id for s in bench.pieces[name].sides}, bend_arcs=True):
            return None
    for name in beside:
        piece = bench.pieces[name]
        x = float(piece.panel.to_world(piece.panel.vertices)[:, 0].mean())
        bench.shift([name], [distance * np.sign(x), 0.0, 0.0])
    for name in below:
        middle = float(pattern.panel(name).bounding_box()[:, 0].mean())

        def stretch(points: Floats, middle: float = middle) -> Floats:
            return np.stack([middle + factor * (points[:, 0] - middle), points[:, 1]], axis=1)

        if not bench.map_points(name, stretch, {s.id for s in bench.pieces[name].sides}, bend_arcs=True):
            return None
    return bench.pattern()

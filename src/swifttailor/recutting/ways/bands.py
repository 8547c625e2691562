"""Sewing on bands: cuffs at the ends of sleeves and legs, waistbands, bands at a hem."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern import EdgeRef, Line, Panel, Pattern
from swifttailor.pattern.panel import Edge
from swifttailor.recutting.table.workbench import Workbench
from swifttailor.recutting.ways.ends import End, find_ends

GAP_CM = 2.0
"""Between a band and what it is sewn to, as placed."""


@dataclass(frozen=True)
class BandPlan:
    """One panel of a band."""

    name: str
    edges: tuple[EdgeRef, ...]
    """What it is sewn to: free edges of one face, all the way from side seam to side seam."""


def add_band(
    pattern: Pattern,
    plans: Sequence[BandPlan],
    height: float,
    *,
    share: float = 1.0,
    flare: float = 1.0,
    label: str = "",
) -> Pattern | None:
    """Sews a band of straight panels to free edges and its panels to each other.

    Args:
        pattern: Any pattern.
        plans: The panels of the band; together they go all the way around.
        height: Of the band, cm.
        share: Length of the band over that of the edges, below 1 where they are gathered into it.
        flare: Length of the band's free edge over its sewn one.
        label: Attachment label of the band's free edges; the edges it is sewn to lose theirs.

    Returns:
        The pattern with the band; None where a name is taken, an edge is sewn, or the sides do not meet.
    """
    bench = Workbench(pattern)
    corners: dict[tuple[int, str], int] = {}
    for plan in plans:
        if plan.name in bench.pieces or any(bench.partner(bench.at[r]) is not None for r in plan.edges):
            return None
        ends = _in_order(bench, pattern, find_ends(bench, pattern, plan.edges))
        if not ends:
            return None
        run = [s for end in ends for s in end.run]
        sides = _lay_band(bench, pattern, plan, ends, run, (height, share, flare))
        for side, id in zip(run, reversed(sides[: len(run)]), strict=True):
            bench.sew(side, id)
        for side in run:
            if label:
                bench.relabel(side, "")
        first, free, last = sides[len(run) :]
        if label:
            bench.relabel(free, label)
        # The band's side beside the start of the run continues the seam that leads there.
        corners[(ends[0].before, "before")] = first
        corners[(ends[-1].after, "after")] = last
    return bench.pattern() if _join_sides(bench, corners) else None


def _in_order(bench: Workbench, pattern: Pattern, ends: list[End]) -> list[End]:
    """Ends of one face in the direction of travel: around their panel, and from panel to panel."""
    if len(ends) < 2:
        return ends
    places = [pattern.panel(e.panel).to_world(bench.run_chord(e.run)) for e in ends]
    along = sum(p[1] - p[0] for p in places)
    order = np.argsort([float(p.mean(axis=0) @ along) for p in places])
    return [ends[k] for k in order]


def _lay_band(
    bench: Workbench,
    pattern: Pattern,
    plan: BandPlan,
    ends: list[End],
    run: list[int],
    shape: tuple[float, float, float],
) -> list[int]:
    """Lays one straight panel; its sides are the joints from the run's end to its start, then around."""
    height, share, flare = shape
    model = pattern.panel(ends[0].panel)
    start = bench.run_chord(ends[0].run)[0]
    finish_panel = pattern.panel(ends[-1].panel)
    finish = _to_local(model, finish_panel.to_world(bench.run_chord(ends[-1].run)[1:])[0])
    along = (finish - start) / max(float(np.hypot(*(finish - start))), 1e-9)
    # The panel lies to the left of a loop that runs counter-clockwise, so outward is to the right.
    turn = 1.0 if model.signed_area() >= 0 else -1.0
    outward = turn * np.array([along[1], -along[0]])
    lengths = [bench.piece_of(s).length(s) * share for s in run]
    total = sum(lengths)
    middle = (start + finish) / 2 + GAP_CM * outward
    at = middle + np.outer(total / 2 - np.concatenate([[0.0], np.cumsum(lengths[::-1])]), along)
    spread = (flare - 1.0) * total / 2
    corners = [at[-1] - spread * along + height * outward, at[0] + spread * along + height * outward]
    vertices = np.concatenate([at, corners])
    origin = model.to_world(vertices[:1])[0]
    x, y, z = (float(v) for v in origin)
    placement = replace(model.placement, translation=(x, y, z))
    panel = Panel(plan.name, vertices - vertices[0], (Edge(Line()),) * len(vertices), placement, model.label)
    return bench.add(panel)


def _join_sides(bench: Workbench, corners: dict[tuple[int, str], int]) -> bool:
    """Sews the band's panels to each other where the seams beside their edges are sewn."""
    done: set[int] = set()
    for (side, which), own in corners.items():
        partner = bench.partner(side)
        other = (
            corners.get((partner, "after" if which == "before" else "before"))
            if partner is not None
            else None
        )
        if other is None:
            return False
        if own not in done:
            bench.sew(own, other)
            done |= {own, other}
    return True


def _to_local(panel: Panel, point: Floats) -> Floats:
    """A world point (3,) in the plane of a panel, local cm."""
    matrix = panel.placement.matrix()
    return ((point - np.asarray(panel.placement.translation)) @ matrix)[:2]

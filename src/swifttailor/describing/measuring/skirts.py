"""Skirts: length, fullness, rows of panels, godets."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.describing.facts import Skirt
from swifttailor.describing.measuring.anatomy import Anatomy, Border, Seam
from swifttailor.describing.measuring.hems import HemLine
from swifttailor.describing.measuring.parts import SKIRT_PARTS, Part
from swifttailor.describing.measuring.slices import girth_at
from swifttailor.describing.measuring.wear import Worn
from swifttailor.pattern import EdgeRef
from swifttailor.pattern.overlaps import lap_of_skirt

CURVED_CIRCLE = 0.25
"""Skirts that flare more are cut as arcs, and are measured along them."""
RUNS_DOWN = 0.75
"""An edge that falls by more of its own length is a side seam."""


def upper_edges(anatomy: Anatomy, part: Part) -> tuple[tuple[EdgeRef, ...], Seam]:
    """Upper edges of a skirt or of trousers and the seam that holds them (empty where they are free)."""
    seam = anatomy.seam(part, {Part.TORSO, Part.WAISTBAND})
    free = {r for loop in anatomy.loops(Border.TOP) for r in loop.edges}
    return (*seam.own, *(r for r in anatomy.free_edges(part) if r in free)), seam


def measure_skirt(anatomy: Anatomy, worn: Worn, hem: HemLine) -> Skirt | None:
    """Measures the skirt; None where there is none."""
    panels = anatomy.panels(Part.SKIRT)
    top, seam = upper_edges(anatomy, Part.SKIRT)
    if not panels or not top:
        return None
    cloth, length_of = anatomy.cloth, anatomy.edge_length
    fall = _fall(anatomy, top)
    own_upper = sum(map(length_of, top))
    upper = min(seam.length, seam.other_length) + sum(length_of(r) for r in top if r not in set(seam.own))
    rows = _rows(anatomy, fall, top)
    base = [name for name, row in rows.items() if row == 0]
    skirt_hem = [r for r in hem.edges if anatomy.part_of(r) in SKIRT_PARTS]
    hem_length = sum(map(length_of, skirt_hem)) or own_upper
    length = float(fall[cloth.nodes(skirt_hem)].mean()) if skirt_hem else float(fall.max())
    base_length, base_lower = _base(anatomy, fall, base, rows, skirt_hem)
    circle = (hem_length - own_upper) / (2 * math.pi * length) if length > 1.0 else 0.0
    if circle > CURVED_CIRCLE:  # a front that lies on another one does not make it wider
        circle -= lap_of_skirt(anatomy.pattern) / (2 * math.pi * length)
    level = float(worn.levels(anatomy, top).mean())
    godets = anatomy.panels(Part.GODET)
    tiers = max(rows.values()) + 1
    return Skirt(
        length=length,
        upper=upper,
        gather=seam.gather,
        hips=_hips(anatomy, top, base, base_length, own_upper, base_lower, level),
        hem=hem_length,
        circle=circle,
        gores=_gores(anatomy, base),
        tiers=tiers,
        tier_gather=_tier_gather(anatomy, rows),
        base_length=base_length,
        base_hem=base_lower,
        godets=len(godets),
        godet_width=float(np.mean([_free_length(anatomy, p.name) for p in godets])) if godets else 0.0,
        godet_height=float(np.mean([np.ptp(p.vertices[:, 1]) for p in godets])) if godets else 0.0,
        darts=anatomy.darts(Part.SKIRT),
        slits=tuple(s for s in hem.slits),
    )


def _gores(anatomy: Anatomy, base: Sequence[str]) -> int:
    """Pieces side by side; those that are folded upon each other, as in pleats, count as one."""
    group = {name: name for name in base}
    for stitch in anatomy.cloth.stitches:
        one, other = stitch.first.panel, stitch.second.panel
        if stitch.right_wrong and one in group and other in group:
            joined = group[one]
            group = {name: group[other] if g == joined else g for name, g in group.items()}
    return len(set(group.values()))


def _fall(anatomy: Anatomy, top: Sequence[EdgeRef]) -> Floats:
    """(nodes,) cm from the upper edges along the cloth; straight down, as placed, where no cloth leads."""
    cloth = anatomy.cloth
    fall = cloth.distances(cloth.nodes(top))
    lost = ~np.isfinite(fall)
    if lost.any():
        height = np.zeros(len(fall))
        height[cloth.node] = cloth.world[:, 1]
        fall[lost] = np.maximum(cloth.placed(top)[:, 1].mean() - height[lost], 0.0)
    return fall


def _rows(anatomy: Anatomy, fall: Floats, top: Sequence[EdgeRef]) -> dict[str, int]:
    """Row of every skirt panel: 0 at the waist, then what is sewn below it."""
    names = [p.name for p in anatomy.panels(Part.SKIRT)]
    middle = {n: float(fall[anatomy.cloth.nodes(_edges(anatomy, n))].mean()) for n in names}
    above: dict[str, set[str]] = {n: set() for n in names}
    for s in anatomy.cloth.stitches:
        for a, b in (s.sides, s.sides[::-1]):
            across = a.panel in middle and b.panel in middle and not _runs_down(anatomy, fall, a)
            if across and middle[a.panel] > middle[b.panel]:
                above[a.panel].add(b.panel)
    rows = dict.fromkeys((r.panel for r in top), 0)
    for name in sorted(names, key=lambda n: middle[n]):
        known = [rows[p] for p in above[name] if p in rows]
        # What hangs from nothing known stands beside the panels at the waist.
        rows.setdefault(name, 1 + min(known) if known else 0)
    return rows


def skirt_rows(anatomy: Anatomy) -> dict[str, int]:
    """Row of every skirt panel, counted from 0 at the waist; empty without a skirt."""
    top, _ = upper_edges(anatomy, Part.SKIRT)
    return _rows(anatomy, _fall(anatomy, top), top) if top else {}


def _edges(anatomy: Anatomy, name: str) -> list[EdgeRef]:
    return [EdgeRef(name, k) for k in range(len(anatomy.pattern.panel(name).edges))]


def _runs_down(anatomy: Anatomy, fall: Floats, ref: EdgeRef) -> bool:
    """Whether an edge leads down the skirt, as side seams do, rather than around it."""
    start, end = fall[anatomy.cloth.node[anatomy.cloth.samples[ref][[0, -1]]]]
    return bool(abs(end - start) > RUNS_DOWN * anatomy.edge_length(ref))


def _base(
    anatomy: Anatomy, fall: Floats, base: Sequence[str], rows: dict[str, int], hem: Sequence[EdgeRef]
) -> tuple[float, float]:
    """Length of the first row and of its lower edge, cm."""
    cloth = anatomy.cloth
    lower = [r for r in hem if r.panel in base]
    for s in cloth.stitches:
        for a, b in (s.sides, s.sides[::-1]):
            if rows.get(a.panel) == 0 and rows.get(b.panel) == 1:
                lower.append(a)
    if not lower:
        return float(fall.max()), 0.0
    length = sum(map(anatomy.edge_length, lower))
    return float(fall[cloth.nodes(lower)].mean()), length


def _tier_gather(anatomy: Anatomy, rows: dict[str, int]) -> float:
    """Upper edges of all lower rows over what they are sewn to."""
    own = other = 0.0
    for s in anatomy.cloth.stitches:
        for a, b in (s.sides, s.sides[::-1]):
            if a.panel in rows and b.panel in rows and rows[a.panel] == rows[b.panel] + 1:
                own += anatomy.edge_length(a)
                other += anatomy.edge_length(b)
    return own / other if other > 0 else 1.0


def _hips(
    anatomy: Anatomy,
    top: Sequence[EdgeRef],
    base: Sequence[str],
    base_length: float,
    upper: float,
    lower: float,
    level: float,
) -> float:
    """Girth at the height of the hips; of the lower edge of the first row where that ends above."""
    depth = level - anatomy.figure.hip_y
    if depth <= 1.0:
        return upper
    if depth >= base_length - 1.0 or base_length < 1.0:
        return lower
    flares = (lower - upper) / (2 * math.pi * base_length)
    if flares > CURVED_CIRCLE:
        return upper + (lower - upper) * depth / base_length
    # Along the straight panels: where they are placed, the same way below their upper edges.
    total = 0.0
    for name in base:
        own = [r for r in top if r.panel == name] or top  # a panel that hangs beside the others
        placed = float(anatomy.cloth.placed(own)[:, 1].mean())
        total += girth_at([anatomy.pattern.panel(name)], placed - depth)
    return total


def _free_length(anatomy: Anatomy, name: str) -> float:
    """Length of a panel's free edges, cm."""
    free = [r for r in anatomy.free_edges(Part.GODET) if r.panel == name]
    return sum(map(anatomy.edge_length, free))

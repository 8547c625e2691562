"""Which part of the body each panel covers, from its seams where neither label nor name says it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from types import MappingProxyType

import numpy as np

from swifttailor.arrays import Floats, read_only
from swifttailor.pattern.check.body_levels import BodyLevels
from swifttailor.pattern.check.outline import Outline, trace_outline
from swifttailor.pattern.check.seam_topology import SeamTopology
from swifttailor.pattern.check.stitch_checks import single_stitches, usable_stitches
from swifttailor.pattern.names import BodyRegion, said_region
from swifttailor.pattern.pattern import EdgeRef, Pattern

_BAND = re.compile(r"^wb|(^|_)wb(_|\d|$)|waist_?band|belt", re.IGNORECASE)
_NECKWEAR = re.compile(r"hood|collar|lapel", re.IGNORECASE)
_APART_CM = 6.0
"""Borders whose middle lies further from the middle of the garment are at its side: armholes, legs."""
_CHEST = BodyLevels()
_ABOVE_WAIST_CM = 15.0
_ABOVE_NECK_CM = 45.0
"""What ends between these heights, and has no armholes, is a bodice rather than a skirt; with a hood at the
upper one."""
_ABOVE_LEGS = 0.3
"""Share of a garment's height below a border at its side from which that is an armhole, not a leg."""


@dataclass(frozen=True, eq=False)
class Border:
    """A free border of the sewn garment: edges without a seam that hang together."""

    edges: tuple[EdgeRef, ...]
    points: Floats
    """(k, 3) of its placed outline, cm."""

    @cached_property
    def middle(self) -> Floats:
        """(3,) mean of its points, cm."""
        return read_only(self.points.mean(axis=0))


def is_band(name: str) -> bool:
    """Whether a panel's name speaks of a waistband or belt."""
    return bool(_BAND.search(name))


def is_neckwear(name: str) -> bool:
    """Whether a panel's name speaks of a hood, collar or lapel."""
    return bool(_NECKWEAR.search(name))


@lru_cache(maxsize=64)
def panel_regions(pattern: Pattern) -> Mapping[str, BodyRegion]:
    """The part of the body each panel covers, by name.

    A panel's label decides, then its name. Where neither says it (``front``, ``Lback``), the garment does:
    one with sleeves, or with borders at its sides well above its lower end, has a bodice; so has one whose
    top stands at the chest; others are skirts or trousers. But for the chest only shapes, seams and
    differences of height count, so that a garment may stand anywhere.

    Args:
        pattern: Any pattern, faulty ones included; what was found in the latest is remembered.
    """
    regions = dict(said_regions(pattern))
    unsaid = {p.name for p in pattern.panels} - set(regions)
    if unsaid:
        outlines = {panel.name: trace_outline(panel) for panel in pattern.panels}
        regions |= _judged(pattern, outlines, regions, unsaid)
    return MappingProxyType({p.name: regions[p.name] for p in pattern.panels})


@lru_cache(maxsize=64)
def said_regions(pattern: Pattern) -> Mapping[str, BodyRegion]:
    """The part of the body for those panels, by name, whose label or name says it, and for their cuffs.

    What `panel_regions` says of the others is a guess.

    Args:
        pattern: Any pattern, faulty ones included; what was found in the latest is remembered.
    """
    said = {p.name: said_region(p.name, p.label) for p in pattern.panels}
    said |= _cuffs(pattern, said)
    return MappingProxyType({name: region for name, region in said.items() if region is not None})


def hangs_from_shoulders(pattern: Pattern) -> bool:
    """Whether the pattern has a bodice, sleeves, a hood or a collar (waistbands do not count)."""
    return any(region != "leg" and not is_band(name) for name, region in panel_regions(pattern).items())


@lru_cache(maxsize=64)
def garment_borders(pattern: Pattern) -> tuple[Border, ...]:
    """The free borders of a pattern once it is sewn, in the order of their first edges.

    Args:
        pattern: Any pattern; what was found in the latest is remembered.
    """
    usable = single_stitches(pattern, usable_stitches(pattern))
    topology = SeamTopology(pattern, usable)
    sewn = {ref for k in usable for ref in pattern.stitches[k].sides}
    free = [EdgeRef(p.name, k) for p in pattern.panels for k in range(len(p.edges))]
    free = [ref for ref in free if ref not in sewn]
    leader = dict.fromkeys(topology.class_of, -1)

    def find(corner: int) -> int:
        while leader[corner] >= 0:
            corner = leader[corner]
        return corner

    ends = [[topology.class_of[c] for c in topology.corners(ref)] for ref in free]
    for start, end in ends:
        a, b = find(start), find(end)
        if a != b:
            # The larger tree takes in the smaller: minus its size is what a leader holds.
            a, b = (a, b) if leader[a] <= leader[b] else (b, a)
            leader[a], leader[b] = leader[a] + leader[b], a
    outlines = {panel.name: trace_outline(panel) for panel in pattern.panels}
    groups: dict[int, list[EdgeRef]] = {}
    for ref, (start, _) in zip(free, ends, strict=True):
        groups.setdefault(find(start), []).append(ref)
    placed = {ref: placed_edge(outlines[ref.panel], ref.edge) for ref in free}
    return tuple(
        Border(tuple(refs), read_only(np.concatenate([placed[ref] for ref in refs])))
        for refs in groups.values()
    )


def placed_edge(outline: Outline, edge: int) -> Floats:
    """Points (k, 3) of a placed edge's outline, both ends included, cm."""
    own = np.flatnonzero(outline.edge_of_segment == edge)
    return outline.panel.to_world(outline.points[np.append(own, (own[-1] + 1) % len(outline.points))])


def _cuffs(pattern: Pattern, said: Mapping[str, BodyRegion | None]) -> dict[str, BodyRegion]:
    """Panels about which nothing is said and that only sleeves of one side hold: they go on along the arm."""
    unsaid = [p for p in pattern.panels if said[p.name] is None]
    if not unsaid or "arm" not in said.values():
        return {}
    names = {p.name for p in unsaid}
    inner = [s for s in pattern.stitches if all(ref.panel in names for ref in s.sides)]
    holders: dict[str, set[str]] = {name: set() for name in names}
    for stitch in pattern.stitches:
        for one, other in (stitch.sides, stitch.sides[::-1]):
            if one.panel in names and other.panel in said and other.panel not in names:
                holders[one.panel].add(other.panel)
    found: dict[str, BodyRegion] = {}
    for group in Pattern(tuple(unsaid), tuple(inner)).components():
        held = set().union(*(holders[name] for name in group))
        sides = {float(np.mean(trace_outline(pattern.panel(n)).world[:, 0])) > 0 for n in held}
        if held and all(said[n] == "arm" for n in held) and len(sides) == 1:
            found |= dict.fromkeys(group, "arm")
    return found


def _judged(
    pattern: Pattern, outlines: Mapping[str, Outline], said: Mapping[str, BodyRegion], unsaid: set[str]
) -> dict[str, BodyRegion]:
    heights = {name: outline.world[:, 1] for name, outline in outlines.items()}
    low = min(float(h.min()) for h in heights.values())
    high = max(float(h.max()) for h in heights.values())
    borders = garment_borders(pattern)
    center = float(np.mean([outline.world[:, 0].mean() for outline in outlines.values()]))
    sides = [border for border in borders if abs(border.middle[0] - center) > _APART_CM]
    # Trousers end in the middle once, at the waist: what ends there at a hem too has sleeves, however low.
    ends_twice = len(borders) - len(sides) > 1 and len(sides) == 2
    arms = [
        border
        for border in sides
        if (ends_twice or border.middle[1] > low + _ABOVE_LEGS * (high - low))
        and not all(said.get(ref.panel) == "leg" for ref in border.edges)
    ]
    bodice = any(region != "leg" and not is_band(name) for name, region in said.items())
    if not bodice and not arms and not _CHEST.waist + _ABOVE_WAIST_CM < high < _CHEST.neck + _ABOVE_NECK_CM:
        return dict.fromkeys(unsaid, "leg")
    upper = {ref.panel for border in arms for ref in border.edges}
    middle = [border for border in borders if border not in arms]
    if middle:
        upper |= {ref.panel for ref in max(middle, key=lambda b: b.middle[1]).edges}
    for stitch in pattern.stitches:
        for one, other in (stitch.sides, stitch.sides[::-1]):
            arm_or_neck = said.get(other.panel) == "arm" or is_neckwear(other.panel)
            if arm_or_neck and one.panel in outlines:  # a stitch may name a panel that is not there
                upper.add(one.panel)
    sure = [float(heights[name].mean()) for name in upper if said.get(name, "body") == "body"]
    lowest = min(sure, default=low)
    return {
        name: "body" if name in upper or float(heights[name].max()) > lowest else "leg" for name in unsaid
    }

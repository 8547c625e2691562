"""The hem: which edges it is made of, how high it hangs, and its slits."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats
from swifttailor.describing.facts import HemFacts, Place, Slit
from swifttailor.describing.measuring.anatomy import Anatomy, Border
from swifttailor.describing.measuring.chain import edge_runs
from swifttailor.describing.measuring.wear import Worn
from swifttailor.pattern import EdgeRef

_STEEP = 0.8
"""A border edge that rises by more of its own length is the side of a slit, not hem."""
_SHORTEST_SLIT_CM = 2.0
_OVER_LEG_CM = 6.0
"""A slit that is nearer to the middle is over neither leg."""
_SECTOR_DEGREES = 35.0
_ARC_CM, _WIDEST_ARC_CM, _ARCS = 1.5, 30.0, 3
"""How far a scallop hangs down at least, how long it is at most, and how many of them a panel has."""


@dataclass(frozen=True)
class HemLine:
    """The lower border taken apart."""

    edges: tuple[EdgeRef, ...]
    """Of the hem itself."""
    slits: tuple[Slit, ...]


def find_hem(anatomy: Anatomy, worn: Worn) -> HemLine:
    """Tells the hem from the sides of its slits; for trousers both legs' ends."""
    loops = anatomy.loops(Border.LEG) or ((anatomy.hem,) if anatomy.hem else ())
    edges, steep = [], []
    for loop in loops:
        for ref in loop.edges:
            levels = worn.level[anatomy.cloth.node[anatomy.cloth.samples[ref]]]
            length = anatomy.edge_length(ref)
            rises = abs(float(levels[-1] - levels[0])) > _STEEP * length and length > _SHORTEST_SLIT_CM
            (steep if rises else edges).append(ref)
    if not edges:
        return HemLine(tuple(steep), ())
    return HemLine(tuple(edges), _slits(anatomy, worn, steep))


def measure_hem(anatomy: Anatomy, worn: Worn, hem: HemLine) -> HemFacts | None:
    """Heights of the hem all around; None without one."""
    if not hem.edges:
        return None
    levels = worn.levels(anatomy, hem.edges)
    weights = np.concatenate([_weights(anatomy, r) for r in hem.edges])
    mean = float(np.average(levels, weights=weights))
    placed = anatomy.cloth.placed(hem.edges)
    if anatomy.loops(Border.LEG):
        front = back = mean
        left, right = (
            float(levels[side].mean()) if side.any() else mean
            for side in (placed[:, 0] > 0, placed[:, 0] < 0)
        )
    else:
        front, back, left, right = (
            float(levels[near].mean()) if (near := _sector(placed, place)).any() else mean
            for place in ("front", "back", "left", "right")
        )
    length = sum(map(anatomy.edge_length, hem.edges))
    return HemFacts(
        level=mean,
        front=front,
        back=back,
        left=left,
        right=right,
        length=length,
        dip=_dip(anatomy, worn, hem.edges),
        arcs=_arcs(anatomy, worn, hem.edges),
    )


def place_of(point: Floats) -> Place:
    """On which side of the body a placed point (3,) lies."""
    angle = abs(np.degrees(np.arctan2(point[0], point[2])))
    if angle < _SECTOR_DEGREES:
        return "front"
    if angle > 180.0 - _SECTOR_DEGREES:
        return "back"
    return "left" if point[0] > 0 else "right"


def _sector(placed: Floats, place: Place) -> NDArray[np.bool_]:
    """(n,) which placed points (n, 3) lie on one side of the body."""
    return np.array([place_of(p) == place for p in placed])


def _weights(anatomy: Anatomy, ref: EdgeRef) -> Floats:
    """What share of the border each sample of an edge stands for, cm."""
    count = len(anatomy.cloth.samples[ref])
    step = anatomy.edge_length(ref) / (count - 1)
    weights = np.full(count, step)
    weights[[0, -1]] /= 2
    return weights


def _dip(anatomy: Anatomy, worn: Worn, edges: Sequence[EdgeRef]) -> float:
    """How far the hem's corners hang below the middles between them, mean over the panels."""
    dips = []
    for name in dict.fromkeys(r.panel for r in edges):
        panel = anatomy.pattern.panel(name)
        for run in edge_runs(panel, [r.edge for r in edges if r.panel == name]):
            levels = worn.levels(anatomy, [EdgeRef(name, k) for k in run])
            dips.append(float(levels[len(levels) // 2] - (levels[0] + levels[-1]) / 2))
    return float(np.mean(dips)) if dips else 0.0


def _arcs(anatomy: Anatomy, worn: Worn, edges: Sequence[EdgeRef]) -> int:
    """Scallops; the single curved hem of a gore is none."""
    counts: dict[str, int] = {}
    for ref in edges:
        levels = worn.levels(anatomy, [ref])
        hangs = min(levels[0], levels[-1]) - levels[len(levels) // 2]
        if hangs >= _ARC_CM and anatomy.edge_length(ref) <= _WIDEST_ARC_CM:
            counts[ref.panel] = counts.get(ref.panel, 0) + 1
    return sum(count for count in counts.values() if count >= _ARCS)


def _slits(anatomy: Anatomy, worn: Worn, steep: Sequence[EdgeRef]) -> tuple[Slit, ...]:
    """Pairs of steep edges that meet at their upper ends."""
    cloth = anatomy.cloth
    chains: list[tuple[set[int], list[EdgeRef]]] = []
    for ref in steep:
        ends = {int(n) for n in cloth.node[cloth.samples[ref][[0, -1]]]}
        touching = [c for c in chains if c[0] & ends]
        chains = [c for c in chains if c not in touching]
        nodes, refs = ends, [ref]
        for other_nodes, other_refs in touching:
            nodes, refs = nodes | other_nodes, refs + other_refs
        chains.append((nodes, refs))
    slits = []
    for _, refs in chains:
        samples = np.concatenate([cloth.samples[r] for r in refs])
        levels = worn.level[cloth.node[samples]]
        height = float(np.ptp(levels))
        lower = levels < levels.min() + 0.25 * height
        if height < _SHORTEST_SLIT_CM or len(refs) < 2:
            continue
        top = cloth.world[samples[levels.argmax()]]
        same_panel = len({r.panel for r in refs}) == 1
        width = float(np.ptp(cloth.world[samples[lower]], axis=0).max()) if same_panel else 0.0
        place, x = place_of(top), float(top[0])
        over = None if place in ("left", "right") or abs(x) < _OVER_LEG_CM else "left" if x > 0.0 else "right"
        slits.append(Slit(place, height, width, over))
    return tuple(sorted(slits, key=lambda s: (s.place, s.height)))

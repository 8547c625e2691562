"""How high every point of a garment hangs when it is worn, from the pattern alone.

A garment hangs from its shoulder seams, or from its upper border where it has none, and reaches down as far
as its cloth does (`Cloth.distances`). A band or seam that is too tight to pass the hips stays where it
fits, and what is below it with it: the cloth above blouses. Compared with drapes in docs/captions.md.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats, read_only
from swifttailor.describing.measuring.anatomy import Anatomy, Seam
from swifttailor.describing.measuring.neckline import bare_back_edges, below_strap
from swifttailor.describing.measuring.parts import LOWER_PARTS, Part
from swifttailor.describing.measuring.shoulders import as_cut, shoulder_seam
from swifttailor.pattern import EdgeRef
from swifttailor.pattern.drafts.figure import Figure

CONTOUR_CM = 1.3
"""What cloth loses on its way over shoulder blades and seat, on top of the way over the bust."""
STRAPLESS_LIFT_CM = 3.0
"""GarmentCode places bodices this much lower than they are worn."""
STRETCH = 1.04
"""How far a tight seam gives; a straight band below it is pulled over the hips by `BAND_STRETCH`."""
BAND_STRETCH = 1.1
WAIST_EASE_CM = 3.0
"""Room that the upper border of a skirt or trousers may have and still sit where it fits."""
WELL_BELOW_HIPS_CM = 12.0
"""What hangs lower than this below the hips has passed them."""
_STRIP_CM = 3.0
"""How far above the crotch what is sewn on there ends at most."""
LIGHT_CM2 = 15_000.0
"""A skirt or trousers of less cloth leave a tight waist where it fits; `HEAVY_CM2` pull it down."""
HEAVY_CM2 = 30_000.0


@dataclass(frozen=True, eq=False)
class Worn:
    """Heights above the floor at which a garment is worn, cm."""

    level: Floats
    """(nodes,) of every node of the cloth; lower than the floor where it would drag."""
    top: float
    """Of the upper border; of the shoulders where it hangs from them."""
    shoulders: tuple[Seam | None, Seam | None]
    """Left and right shoulder seams, seen from the front; None where that side is bare."""
    lifted: float
    """By how much tight bands or seams hold up the lowest part against its free fall, cm."""

    def levels(self, anatomy: Anatomy, refs: Sequence[EdgeRef]) -> Floats:
        """Heights (k,) of the samples of some edges, cm."""
        return np.concatenate([self.level[anatomy.cloth.node[anatomy.cloth.samples[r]]] for r in refs])


@lru_cache(maxsize=32)
def wear(anatomy: Anatomy) -> Worn:
    """Works out the heights."""
    shoulders = (shoulder_seam(anatomy, "left"), shoulder_seam(anatomy, "right"))
    sources, starts, top = _hangers(anatomy, shoulders)
    neck = anatomy.figure.neck_y
    fall = anatomy.cloth.distances(sources, neck - starts) if len(sources) else None
    if fall is None:  # a closed garment without top or shoulders: as it is placed
        level = _placed_levels(anatomy)
        return Worn(read_only(level), float(level.max(initial=0.0)), shoulders, 0.0)
    level = neck - fall
    if any(shoulders):
        level += _contour(anatomy, level)
    level = np.where(np.isfinite(level), level, _placed_levels(anatomy))
    level, lifted = _lift(anatomy, level)
    return Worn(read_only(level), top, shoulders, lifted)


def fitting_level(figure: Figure, girth: float) -> float:
    """The height below which a closed band of that girth cannot slide, cm; minus infinity past the hips."""
    if girth > figure.hips.girth:
        return -np.inf
    share = (girth - figure.waist.girth) / (figure.hips.girth - figure.waist.girth)
    return figure.waist_y - max(share, 0.0) * (figure.waist_y - figure.hip_y)


def _hangers(
    anatomy: Anatomy, shoulders: tuple[Seam | None, Seam | None]
) -> tuple[NDArray[np.int64], Floats, float]:
    """Nodes the garment hangs from, their heights, and the height of its top."""
    cloth, figure = anatomy.cloth, anatomy.figure
    sewn = [ref for seam in shoulders if seam for ref in seam.own]
    if sewn:
        samples = np.concatenate([cloth.samples[ref] for ref in sewn])
        placed = np.concatenate([as_cut(anatomy, ref, cloth.world[cloth.samples[ref]]) for ref in sewn])
        levels = figure.neck_y - figure.slope * np.maximum(np.abs(placed[:, 0]) - figure.neck_x, 0.0)
        nodes = cloth.node[samples]
        bare = _bare_edges(anatomy, shoulders)
        if bare:
            lift = float((levels - placed[:, 1]).mean())
            more = np.concatenate([cloth.samples[ref] for ref in bare])
            nodes = np.concatenate([nodes, cloth.node[more]])
            levels = np.concatenate([levels, np.minimum(cloth.world[more, 1] + lift, figure.neck_y)])
        top = float(levels.max())
        back = below_strap(anatomy, anatomy.panels(Part.TORSO, face="back"))
        if back:  # nothing holds it but its sides, between which it is as high as it is cut
            more = np.concatenate([cloth.samples[ref] for ref in bare_back_edges(anatomy, back)])
            own = cloth.world[more, 1]
            nodes = np.concatenate([nodes, cloth.node[more]])
            levels = np.concatenate([levels, own - _contour(anatomy, own)])
        return nodes, levels, top
    if anatomy.top is None:
        return np.zeros(0, np.int64), np.zeros(0), 0.0
    samples = np.concatenate([cloth.samples[ref] for ref in anatomy.top.edges])
    if any(anatomy.part_of(ref) is Part.TORSO for ref in anatomy.top.edges):
        levels = np.minimum(cloth.world[samples, 1] + STRAPLESS_LIFT_CM, figure.neck_y)
        return cloth.node[samples], levels, float(levels.mean())
    top = max(fitting_level(figure, anatomy.top.length - WAIST_EASE_CM), figure.hip_y)
    return cloth.node[samples], np.full(len(samples), top), top


def _bare_edges(anatomy: Anatomy, shoulders: tuple[Seam | None, Seam | None]) -> list[EdgeRef]:
    """Upper edges of a side without a shoulder, where the other has one."""
    if all(shoulders) or anatomy.top is None:
        return []
    bare = "left" if shoulders[0] is None else "right"
    return [
        ref
        for ref in anatomy.top.edges
        if anatomy.part_of(ref) is Part.TORSO and anatomy.parts[ref.panel].side == bare
    ]


def _contour(anatomy: Anatomy, level: Floats) -> Floats:
    """What the way over the body takes, growing from shoulder to bust, cm."""
    figure = anatomy.figure
    loss = figure.front_fullness + CONTOUR_CM
    return loss * np.clip((figure.neck_y - level) / (figure.neck_y - figure.bust_y), 0.0, 1.0)


def _lift(anatomy: Anatomy, level: Floats) -> tuple[Floats, float]:
    """Holds up what hangs from a tight band or seam; of several the one that holds it highest."""
    cloth, figure = anatomy.cloth, anatomy.figure
    if not anatomy.has(Part.TORSO):
        return level, 0.0
    below = frozenset({Part.WAISTBAND}) | LOWER_PARTS
    lift, lifted = 0.0, np.zeros(0, np.int64)
    for refs, girth, lower in _rings(anatomy, below):
        now = float(level[cloth.nodes(refs)].mean())
        needed = fitting_level(figure, girth) - now
        if needed > lift and now > figure.hip_y - WELL_BELOW_HIPS_CM:
            names = {p.name for p in anatomy.panels(lower)} if lower else set()
            lift, lifted = needed, cloth.nodes([r for r in cloth.samples if r.panel in names] + list(refs))
    lift *= 1.0 - _weighed_down(anatomy)
    if lift > 0.0:
        level = level.copy()
        level[lifted] += lift
    return level, lift


def _weighed_down(anatomy: Anatomy) -> float:
    """How far the weight of what hangs below pulls a tight waist down: 0 not at all, 1 all the way."""
    area = sum(abs(p.signed_area()) for p in anatomy.panels(LOWER_PARTS))
    return float(np.clip((area - LIGHT_CM2) / (HEAVY_CM2 - LIGHT_CM2), 0.0, 1.0))


def _rings(
    anatomy: Anatomy, below: frozenset[Part]
) -> Iterator[tuple[tuple[EdgeRef, ...], float, frozenset[Part]]]:
    """Closed lines around the body below the torso: edges, girth, and the parts that hang from them."""
    waist = anatomy.seam(Part.TORSO, below)
    if waist.pairs and not _is_between_legs(anatomy, waist):
        yield waist.own, STRETCH * min(waist.length, waist.other_length), below
    band = anatomy.seam(Part.WAISTBAND, LOWER_PARTS)
    if band.pairs:
        yield band.own, BAND_STRETCH * min(band.length, band.other_length), LOWER_PARTS
    elif anatomy.hem is not None and not anatomy.has(Part.SKIRT):
        lower = frozenset({Part.WAISTBAND}) if waist.pairs else frozenset()
        yield anatomy.hem.edges, (BAND_STRETCH if lower else STRETCH) * anatomy.hem.length, lower


def _is_between_legs(anatomy: Anatomy, seam: Seam) -> bool:
    """Whether a seam goes around nothing, as that of the strip between the legs of a swimsuit."""
    return float(anatomy.cloth.placed(seam.own)[:, 1].mean()) < anatomy.figure.crotch_y + _STRIP_CM


def _placed_levels(anatomy: Anatomy) -> Floats:
    """(nodes,) mean height of each node's samples as the panels are placed, cm."""
    node = anatomy.cloth.node
    return np.bincount(node, weights=anatomy.cloth.world[:, 1]) / np.bincount(node)

"""Bodices, waistbands, collars and hoods."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np

from swifttailor.describing.facts import Band, Collar, Hood, Torso
from swifttailor.describing.measuring.anatomy import Anatomy, Border
from swifttailor.describing.measuring.neckline import measure_armhole
from swifttailor.describing.measuring.parts import LOWER_PARTS, Part
from swifttailor.describing.measuring.slices import half_widths, lies_across, whole_widths
from swifttailor.describing.measuring.wear import Worn
from swifttailor.describing.measuring.wings import find_wing, wing_underarm
from swifttailor.pattern import EdgeRef, Panel, Stitch

_BELOW_UNDERARM_CM = (0.2, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0)
_AROUND_WAIST_CM = (-1.0, 0.0, 1.0)
_BELOW_WAIST_CM = 4.0
_STAND_FLARE = 1.15
_SIDES: tuple[Literal["left", "right"], ...] = ("left", "right")


def measure_torso(anatomy: Anatomy, worn: Worn) -> Torso | None:
    """Measures the bodice; None without one."""
    panels = anatomy.panels(Part.TORSO)
    if not panels:
        return None
    lower, gather = _lower_edges(anatomy)
    underarm, placed = _underarm(anatomy, worn)
    lower_level = float(worn.levels(anatomy, lower).mean()) if lower else anatomy.figure.waist_y
    lower_edge = sum(map(anatomy.edge_length, lower))
    winged = find_wing(anatomy, "left") is not None or find_wing(anatomy, "right") is not None
    waist = _girth(panels, placed - (underarm - anatomy.figure.waist_y), _AROUND_WAIST_CM, winged=winged)
    if lower_level > anatomy.figure.waist_y - _BELOW_WAIST_CM or underarm < anatomy.figure.waist_y + 3.0:
        waist = lower_edge
    chest = _girth(panels, placed, _BELOW_UNDERARM_CM, winged=winged)
    hips = None
    if lower_level < anatomy.figure.hip_y and not any(map(anatomy.has, LOWER_PARTS)):
        placed_hips = placed - (underarm - anatomy.figure.hip_y)
        hips = _girth(panels, placed_hips, _AROUND_WAIST_CM, winged=winged)
    left, right = worn.shoulders
    sleeved = {s: bool(anatomy.panels(Part.SLEEVE, side=s) or find_wing(anatomy, s)) for s in _SIDES}
    return Torso(
        left_shoulder=left.length if left else None,
        right_shoulder=right.length if right else None,
        chest=chest,
        chest_ease=chest - anatomy.body.bust,
        waist=waist if lower_level < anatomy.figure.waist_y + _BELOW_WAIST_CM else None,
        lower_edge=lower_edge,
        lower_level=lower_level,
        gather=gather,
        darts=anatomy.darts(Part.TORSO),
        blouson=worn.lifted,
        left_armhole=measure_armhole(anatomy, "left") if left and not sleeved["left"] else None,
        right_armhole=measure_armhole(anatomy, "right") if right and not sleeved["right"] else None,
        hips=hips,
    )


def measure_band(anatomy: Anatomy, worn: Worn) -> Band | None:
    """Measures the waistband; None without one."""
    if not anatomy.has(Part.WAISTBAND):
        return None
    cloth = anatomy.cloth
    above = anatomy.seam(Part.WAISTBAND, Part.TORSO)
    below = anatomy.seam(Part.WAISTBAND, LOWER_PARTS)
    top_loop = {r for loop in anatomy.loops(Border.TOP) for r in loop.edges}
    free = anatomy.free_edges(Part.WAISTBAND)
    upper = above.own or tuple(r for r in free if r in top_loop)
    lower = below.own or tuple(r for r in free if r not in top_loop)
    if not upper or not lower:
        return None
    height = float(cloth.distances(cloth.nodes(upper))[cloth.nodes(lower)].mean())
    upper_length, lower_length = (sum(map(anatomy.edge_length, refs)) for refs in (upper, lower))
    level = float(worn.levels(anatomy, upper).mean())
    return Band(height, upper_length, lower_length, not below.pairs, level)


def measure_collar(anatomy: Anatomy) -> Collar | None:
    """Measures the collar: its width behind the neck; None without one.

    A stand continues all the way around the neckline with its upper edge free. What lies open on the
    front, its front edges sewn far down the neckline or its wrong side turned out, is a lapel; so is one
    that is turned down over a stand, but where it goes all around, as roll necks do.
    """
    panels = anatomy.panels(Part.COLLAR)
    seam = anatomy.seam(Part.COLLAR, {Part.TORSO, Part.SLEEVE})
    if not panels or not seam.pairs:
        return None
    cloth = anatomy.cloth
    sewn = cloth.nodes(seam.own)
    free = anatomy.free_edges(Part.COLLAR)
    if not free:
        return None
    names = {p.name for p in panels}
    turned = any(s.right_wrong and len({r.panel for r in s.sides} & names) == 1 for s in cloth.stitches)
    upper = sum(map(anatomy.edge_length, free))
    behind = [r for r in free if anatomy.parts[r.panel].face == "back"] or list(free)
    height = float(cloth.distances(sewn)[cloth.nodes(behind)].max())
    closed = upper < _STAND_FLARE * seam.length and not _parts_in_front(cloth.stitches)
    return Collar("lapel" if turned or not closed else "stand", height)


def _parts_in_front(stitches: Sequence[Stitch]) -> bool:
    """Whether what is turned down over a stand begins on both sides of the middle, as lapels do."""
    joined = [{ref.panel for ref in stitch.sides} for stitch in stitches]
    falls = {f"{side}_collar_fall_front" for side in _SIDES}
    return any(falls & names for names in joined) and falls not in joined


def measure_hood(anatomy: Anatomy) -> Hood | None:
    """Measures the hood; None without one."""
    panels = anatomy.panels(Part.HOOD)
    if not panels:
        return None
    spans = [np.ptp(p.to_world(p.outline(0.1)), axis=0) for p in panels]
    height = float(np.mean([s[1] for s in spans]))
    depth = float(np.mean([max(s[0], s[2]) for s in spans]))
    return Hood(height, depth)


def _lower_edges(anatomy: Anatomy) -> tuple[tuple[EdgeRef, ...], float]:
    """Lower edges of the torso and how much they are gathered."""
    seam = anatomy.seam(Part.TORSO, {Part.WAISTBAND} | LOWER_PARTS)
    hem = {r for loop in anatomy.loops(Border.HEM) for r in loop.edges}
    free = tuple(r for r in anatomy.free_edges(Part.TORSO) if r in hem)
    return (*seam.own, *free), seam.gather


def _girth(panels: Sequence[Panel], level: float, below: Sequence[float], *, winged: bool = False) -> float:
    """Girth at a placed height, cm: of several cuts the widest, since a dart may open into one of them.

    Args:
        panels: Of the torso.
        level: The height, cm.
        below: How far below it is looked as well, cm.
        winged: Whether sleeves are cut in one with them, which hang beside the body and do not count.
    """
    levels = [level - b for b in below]
    girth = 0.0
    for back in (False, True):
        face = [p for p in panels if (p.normal()[2] < 0) == back]
        if len(face) > 1 and any(map(lies_across, face)):  # one front runs on into the other's half
            girth += float(whole_widths(face, levels, inmost=winged).max())
        else:
            girth += sum(float(half_widths(p, levels, inmost=winged).max()) for p in face)
    return girth


def _underarm(anatomy: Anatomy, worn: Worn) -> tuple[float, float]:
    """Height of the underarm as worn and as placed, cm; of the lowest upper border where there is none."""
    cloth = anatomy.cloth
    wing = find_wing(anatomy, "left") or find_wing(anatomy, "right")
    if wing is not None:
        sample = wing_underarm(anatomy, wing)
        return float(worn.level[cloth.node[sample]]), float(cloth.world[sample, 1])
    refs = [r for loop in anatomy.loops(Border.ARM) for r in loop.edges if anatomy.part_of(r) is Part.TORSO]
    refs += anatomy.seam(Part.TORSO, Part.SLEEVE).own
    if not refs and anatomy.top is not None:
        refs = [r for r in anatomy.top.edges if anatomy.part_of(r) is Part.TORSO]
    if not refs:
        return anatomy.figure.bust_y, anatomy.figure.bust_y
    samples = np.concatenate([cloth.samples[r] for r in refs])
    lowest = samples[cloth.world[samples, 1].argmin()]
    return float(worn.level[cloth.node[lowest]]), float(cloth.world[lowest, 1])

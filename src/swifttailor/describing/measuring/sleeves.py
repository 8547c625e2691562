"""Sleeves and the cuffs of sleeves and legs."""

from __future__ import annotations

from typing import Literal

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.describing.facts import Cuff, Sleeve
from swifttailor.describing.measuring.anatomy import Anatomy, Border
from swifttailor.describing.measuring.parts import ARM_PARTS, Part
from swifttailor.describing.measuring.shoulders import as_cut, shoulder_seam
from swifttailor.describing.measuring.slices import width_in_plane
from swifttailor.describing.measuring.wings import Wing, find_wing, wing_width
from swifttailor.pattern import EdgeRef, Panel

FLOUNCE_FLARE = 1.15
"""A cuff whose free end is this much wider than its sewn end is a flounce."""
_PAST_UNDERARM_CM = 1.0


def measure_sleeve(anatomy: Anatomy, side: Literal["left", "right"]) -> Sleeve | None:
    """Measures the sleeve of one side; None without one."""
    panels = anatomy.panels(Part.SLEEVE, side=side)
    if not panels:
        wing = find_wing(anatomy, side)
        return _cut_in_one(anatomy, side, wing) if wing else None
    names = {p.name for p in panels}
    head = anatomy.seam(Part.SLEEVE, Part.TORSO, side=side)
    ends = _ends(anatomy, names, side)
    cuff = measure_cuff(anatomy, Part.SLEEVE, Part.CUFF, side)
    joined = anatomy.seam(Part.SLEEVE, Part.CUFF, side=side)
    end_width = sum(map(anatomy.edge_length, ends))
    return Sleeve(
        length=_length(anatomy, side, head.pairs, ends),
        upper_width=max(_upper_width(anatomy, panels, head.own, ends), 0.0) or end_width,
        end_width=end_width,
        opening=_opening(anatomy, side, end_width),
        head_gather=head.gather,
        end_gather=joined.gather,
        cuff=cuff,
    )


def _cut_in_one(anatomy: Anatomy, side: Literal["left", "right"], wing: Wing) -> Sleeve:
    """Measures a sleeve that is part of the torso panels."""
    cloth = anatomy.cloth
    samples = np.concatenate([cloth.samples[ref] for ref in wing.over])
    tip = int(np.abs(cloth.world[samples, 0]).argmin())
    length = _from_tip(anatomy, side, samples[tip], cloth.world[samples[tip]], list(wing.end))
    end_width = sum(map(anatomy.edge_length, wing.end))
    joined = anatomy.seam(Part.TORSO, Part.CUFF, side=side)
    return Sleeve(
        length=length,
        upper_width=wing_width(anatomy, wing),
        end_width=end_width,
        opening=_opening(anatomy, side, end_width),
        head_gather=1.0,
        end_gather=joined.gather,
        cuff=measure_cuff(anatomy, Part.TORSO, Part.CUFF, side),
    )


def measure_cuff(anatomy: Anatomy, upper: Part, lower: Part, side: Literal["left", "right"]) -> Cuff | None:
    """Measures what is sewn to the end of a sleeve or leg.

    Args:
        anatomy: The garment.
        upper: What it is sewn to.
        lower: The cuff's own part.
        side: Which arm or leg.
    """
    panels = anatomy.panels(lower, side=side)
    joined = anatomy.seam(lower, upper, side=side)
    names = {p.name for p in panels}
    ends = [r for r in anatomy.free_edges(lower) if r.panel in names]
    if not joined.pairs or not ends:
        return None
    cloth = anatomy.cloth
    fall = cloth.distances(cloth.nodes(joined.own))
    length = float(fall[cloth.nodes(ends)].mean())
    opening = sum(map(anatomy.edge_length, ends))
    first_row = {r.panel for r in joined.own}
    onto = [
        b
        for s in cloth.stitches
        for a, b in (s.sides, s.sides[::-1])
        if a.panel in names - first_row and b.panel in first_row
    ]
    if onto:
        flare = opening / max(sum(map(anatomy.edge_length, onto)), 1e-6)
        return Cuff("band and flounce", length, opening, flare)
    flare = opening / max(joined.length, 1e-6)
    widens = flare > FLOUNCE_FLARE or joined.gather > FLOUNCE_FLARE
    return Cuff("flounce" if widens else "band", length, opening, flare)


def _ends(anatomy: Anatomy, names: set[str], side: Literal["left", "right"]) -> list[EdgeRef]:
    """Lower edges of a sleeve: free ones, and those sewn to its cuff."""
    cuffed = anatomy.seam(Part.SLEEVE, Part.CUFF, side=side).own
    free = {r for loop in anatomy.loops(Border.ARM) for r in loop.edges}
    return [*cuffed, *(r for r in anatomy.free_edges(Part.SLEEVE) if r.panel in names and r in free)]


def _length(
    anatomy: Anatomy,
    side: Literal["left", "right"],
    head: tuple[tuple[EdgeRef, EdgeRef], ...],
    ends: list[EdgeRef],
) -> float:
    """From the shoulder tip of the body over the top of the sleeve to its end or that of its cuff."""
    cloth = anatomy.cloth
    if not head or not ends:
        return 0.0
    own = shoulder_seam(anatomy, side)
    if own is not None and anatomy.part_of(own.own[0]) is Part.SLEEVE:  # a raglan one
        samples = np.concatenate([cloth.samples[r] for r in own.own])
        places = np.concatenate([as_cut(anatomy, r, cloth.world[cloth.samples[r]]) for r in own.own])
        tip = int(np.abs(places[:, 0]).argmax())
    else:
        samples = np.concatenate([cloth.samples[b] for _, b in head])
        places = cloth.world[samples]
        tip = int(places[:, 1].argmax())
    return _from_tip(anatomy, side, samples[tip], places[tip], ends)


def _from_tip(
    anatomy: Anatomy, side: Literal["left", "right"], sample: int, place: Floats, ends: list[EdgeRef]
) -> float:
    """From the shoulder tip of the body, a sample near which lies at a place (3,), to the end of all, cm."""
    cloth = anatomy.cloth
    cuffs = {p.name for p in anatomy.panels(Part.CUFF, side=side)}
    last = [r for r in anatomy.free_edges(Part.CUFF) if r.panel in cuffs] or ends
    way = cloth.distances(cloth.node[[sample]])[cloth.nodes(last)]
    beyond = (abs(float(place[0])) - anatomy.figure.shoulder_x) * np.hypot(1, anatomy.figure.slope)
    return float(way.min() + beyond)


def _upper_width(
    anatomy: Anatomy, panels: tuple[Panel, ...], head: tuple[EdgeRef, ...], ends: list[EdgeRef]
) -> float:
    """Width around, just below the underarm, across the sleeve."""
    cloth = anatomy.cloth
    total = 0.0
    for panel in panels:
        top = [r for r in head if r.panel == panel.name]
        low = [r for r in ends if r.panel == panel.name]
        if not top or not low:
            return 0.0
        along = cloth.placed(low).mean(axis=0) - cloth.placed(top).mean(axis=0)
        along /= np.linalg.norm(along)
        underarm = max(float((cloth.placed(top) @ along).max()), -np.inf)
        total += width_in_plane(panel, along, underarm + _PAST_UNDERARM_CM)
    return total


def _opening(anatomy: Anatomy, side: Literal["left", "right"], end_width: float) -> float:
    """Around the free end."""
    for loop in anatomy.loops(Border.ARM):
        own = {anatomy.parts[r.panel] for r in loop.edges}
        if all(p.part in ARM_PARTS and p.side == side for p in own):
            return loop.length
    return end_width

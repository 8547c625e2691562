"""Sleeves that are cut in one with the body: parts of torso panels beyond the shoulder tip and the side."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.describing.measuring.anatomy import Anatomy, Border
from swifttailor.describing.measuring.parts import Part
from swifttailor.pattern import EdgeRef

_INSIDE_CM = 1.5
"""A seam over the arm begins at the shoulder tip, or at most so far inside it."""
_WIDTH_AT = 0.35
"""Where on its length, from the shoulder tip, the width of a sleeve is taken."""


@dataclass(frozen=True)
class Wing:
    """What of one side's torso panels is a sleeve."""

    over: tuple[EdgeRef, ...]
    """Edges over the arm, front and back."""
    under: tuple[EdgeRef, ...]
    """Edges under it."""
    end: tuple[EdgeRef, ...]
    """Edges around the hand, or those that the cuff is sewn to."""


@lru_cache(maxsize=64)
def find_wing(anatomy: Anatomy, side: Literal["left", "right"]) -> Wing | None:
    """The sleeve that is cut in one with the torso on one side; None where there is none."""
    end = _ends(anatomy, side)
    if not end:
        return None
    cloth, reach = anatomy.cloth, anatomy.figure.shoulder_x - _INSIDE_CM
    border = set(cloth.nodes(end).tolist())
    over, under = [], []
    for own, other in anatomy.seam(Part.TORSO, Part.TORSO, side=side).pairs:
        if anatomy.parts[own.panel].face == anatomy.parts[other.panel].face:
            continue
        samples = cloth.samples[own][[0, -1]]
        at_end = [int(node) in border for node in cloth.node[samples]]
        if sum(at_end) != 1:
            continue
        outer, inner = cloth.world[samples[at_end.index(True)]], cloth.world[samples[at_end.index(False)]]
        if abs(inner[0]) < reach or abs(outer[0]) <= abs(inner[0]):
            continue
        heights = [cloth.world[cloth.samples[ref], 1].mean() for ref in end if ref.panel == own.panel]
        if heights:
            (over if outer[1] > np.mean(heights) else under).append(own)
    return Wing(tuple(over), tuple(under), end) if over and under else None


def wing_underarm(anatomy: Anatomy, wing: Wing) -> int:
    """The sample where the sleeve leaves the side."""
    cloth = anatomy.cloth
    samples = np.concatenate([cloth.samples[ref][[0, -1]] for ref in wing.under])
    return int(samples[np.abs(cloth.world[samples, 0]).argmin()])


def _ends(anatomy: Anatomy, side: Literal["left", "right"]) -> tuple[EdgeRef, ...]:
    cuffed = anatomy.seam(Part.TORSO, Part.CUFF, side=side).own
    free = [
        ref
        for loop in anatomy.loops(Border.ARM)
        for ref in loop.edges
        if anatomy.part_of(ref) is Part.TORSO and anatomy.parts[ref.panel].side == side
    ]
    return cuffed or tuple(free)


def wing_width(anatomy: Anatomy, wing: Wing) -> float:
    """Around, some way down the arm, of front and back together, cm."""
    total = 0.0
    for ref in wing.over:
        line = _front_view(anatomy, ref)
        tip, wrist = sorted((line[0], line[-1]), key=lambda p: abs(p[0]))
        along = (wrist - tip) / np.hypot(*(wrist - tip))
        lower = [_front_view(anatomy, low) for low in wing.under if low.panel == ref.panel]
        points = np.concatenate(lower) - tip
        far, deep = points @ along, np.abs(points @ np.array([-along[1], along[0]]))
        order = np.argsort(far)
        total += float(np.interp(_WIDTH_AT * np.hypot(*(wrist - tip)), far[order], deep[order]))
    return total


def _front_view(anatomy: Anatomy, ref: EdgeRef) -> Floats:
    return anatomy.cloth.world[anatomy.cloth.samples[ref]][:, :2]

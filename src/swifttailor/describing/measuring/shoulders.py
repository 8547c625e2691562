"""Shoulder seams: those of torsos, and those that raglan sleeves bring with them."""

from __future__ import annotations

from typing import Literal

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.describing.measuring.anatomy import Anatomy, Seam
from swifttailor.describing.measuring.parts import Part, Side
from swifttailor.describing.measuring.wings import find_wing
from swifttailor.pattern import EdgeRef

_SHOULDER_REGION_CM = 16.0
_PAST_TIP_CM = 10.0
"""So far beyond the shoulder tip, laid back on the torso, a shoulder may end that is part of a sleeve."""


def shoulder_seam(anatomy: Anatomy, side: Literal["left", "right"]) -> Seam | None:
    """The seam on one shoulder, seen from the front panels; None where that shoulder is bare.

    Of raglan sleeves it is the part of the seam over the arm that lies on the shoulder.
    """
    torso = anatomy.panels(Part.TORSO)
    if not torso:
        return None
    highest = max(float(p.to_world(p.vertices)[:, 1].max()) for p in torso)
    for part in (Part.TORSO, Part.SLEEVE):
        pairs = [
            (a, b)
            for a, b in anatomy.seam(part, part, face="front").pairs
            if anatomy.parts[b.panel].face == "back" and _on_shoulder(anatomy, a, part, side, highest)
        ]
        if pairs:
            own, other = (sum(map(anatomy.edge_length, refs)) for refs in zip(*pairs, strict=True))
            return Seam(tuple(pairs), own, other)
    return None


def sleeves_carry_shoulders(anatomy: Anatomy) -> bool:
    """Whether the garment hangs from its sleeves, as with raglan ones: without them shoulders are bare."""
    return any(
        seam is not None and anatomy.part_of(seam.own[0]) is Part.SLEEVE
        for seam in (shoulder_seam(anatomy, "left"), shoulder_seam(anatomy, "right"))
    )


def _on_shoulder(
    anatomy: Anatomy, ref: EdgeRef, part: Part, side: Literal["left", "right"], highest: float
) -> bool:
    start, end = anatomy.cloth.world[anatomy.cloth.samples[ref][[0, -1]]]
    middle = (start + end) / 2
    if middle[1] <= highest - _SHOULDER_REGION_CM or (middle[0] > 0) != (side == "left"):
        return False
    if part is Part.TORSO:
        wing = find_wing(anatomy, side)
        over_arm = wing is not None and ref in wing.over
        return not over_arm and abs(end[0] - start[0]) > abs(end[1] - start[1])
    points = as_cut(anatomy, ref, np.array([start, end]))
    inner, outer = sorted(np.abs(points[:, 0]).tolist())
    tip = anatomy.figure.shoulder_x
    return inner < tip and outer < tip + _PAST_TIP_CM


def as_cut(anatomy: Anatomy, ref: EdgeRef, points: Floats) -> Floats:
    """Placed points of an edge, a raglan sleeve's moved to where they would lie on the torso.

    Raglan sleeves stand beside the torso and are turned upwards; laid back on it along their seam, shoulder
    and neckline go on where those of the torso end.

    Args:
        anatomy: The garment.
        ref: The edge; nothing is moved unless it is a sleeve's.
        points: (k, 3) of it, cm.

    Returns:
        (k, 3) cm.
    """
    joined = [(a, b) for a, b in anatomy.seam(Part.SLEEVE, Part.TORSO).pairs if a.panel == ref.panel]
    if not joined:
        return points
    cloth = anatomy.cloth
    own, other = max(joined, key=lambda pair: float(cloth.world[cloth.samples[pair[1]], 1].max()))
    ours, theirs = cloth.world[cloth.samples[own]], cloth.world[cloth.samples[other]][::-1]
    turn = np.angle(complex(*(theirs[-1] - theirs[0])[:2]) / complex(*(ours[-1] - ours[0])[:2]))
    c, s = np.cos(turn), np.sin(turn)
    around = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    return (points - ours[0]) @ around.T + theirs[0]


def sleeve_neck(anatomy: Anatomy, side: Side, face: str) -> tuple[EdgeRef, ...]:
    """Edges of a raglan sleeve that are part of the neckline of one side and face."""
    free = set(anatomy.top.edges) if anatomy.top is not None else set()
    sewn = set(anatomy.seam(Part.SLEEVE, {Part.COLLAR, Part.HOOD}).own)
    return tuple(
        ref
        for ref in sorted(free | sewn)
        if anatomy.part_of(ref) is Part.SLEEVE
        and (anatomy.parts[ref.panel].side, anatomy.parts[ref.panel].face) == (side, face)
    )

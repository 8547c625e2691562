"""Sleeves and trouser legs that are placed for a body in another pose: arms raised, legs apart."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.check.body_levels import BodyLevels
from swifttailor.pattern.check.covering import garment_borders, panel_regions, placed_edge
from swifttailor.pattern.check.outline import Outline
from swifttailor.pattern.pattern import EdgeRef, Pattern

Limb = Literal["sleeve", "leg"]

_ABOVE_ARM_CM = 10.0
_FLATTER_DEGREES = 15.0
"""How far the end of a sleeve may be placed above the line of the arm. GarmentCode's stay within one of them:
very long ones rise above the hand."""
_BESIDE_LEG_CM = 24.0
_SPREAD_DEGREES = 15.0
"""How far the end of a trouser leg may be placed outside the thigh; GarmentCode's are at most 21 cm away."""


@dataclass(frozen=True)
class LimbPose:
    """A sleeve that points well above the arm, or a trouser leg that stands well beside the leg."""

    limb: Limb
    panels: tuple[str, ...]
    angle: float
    """Of its end below the horizontal, seen from shoulder or hip, degrees."""
    body_angle: float
    """The same of the body's arm or leg."""
    pivot: Floats
    """(3,) the shoulder or hip, cm."""
    turn: float
    """Degrees about z that bring it down."""


def judge_limbs(
    pattern: Pattern, outlines: Mapping[str, Outline], levels: BodyLevels, shift: Floats
) -> tuple[LimbPose, ...]:
    """Finds the sleeves and trouser legs in another pose than the body's.

    Args:
        pattern: Any pattern.
        outlines: Outline of each panel by name.
        levels: Of the body that it is placed around.
        shift: (3,) motion of the whole pattern that precedes, cm; `LimbPose.pivot` is as before it.
    """
    regions = panel_regions(pattern)
    found = []
    limbs: tuple[Limb, ...] = ("sleeve", "leg")
    for limb in limbs:
        region, ends = ("arm", _sleeve_ends) if limb == "sleeve" else ("leg", _leg_ends)
        names = {name for name, own in regions.items() if own == region}
        for group, end in ends(pattern, outlines, names):
            pose = _pose(limb, group, end + shift, levels, shift)
            found += [] if pose is None else [pose]
    return tuple(found)


def _pose(
    limb: Limb, group: tuple[str, ...], end: Floats, levels: BodyLevels, shift: Floats
) -> LimbPose | None:
    side = 1.0 if end[0] > 0 else -1.0
    if limb == "sleeve":
        x, y, down = levels.shoulder_x, levels.shoulder, np.deg2rad(levels.arm_angle)
    else:
        x, y, down = levels.hip_x, levels.hips, np.pi / 2
    out, up = side * end[0] - x, end[1] - y
    angle = float(np.arctan2(-up, out))
    beside = out * np.sin(down) + up * np.cos(down)
    far, steep = (_ABOVE_ARM_CM, _FLATTER_DEGREES) if limb == "sleeve" else (_BESIDE_LEG_CM, _SPREAD_DEGREES)
    if beside <= far or down - angle <= np.deg2rad(steep):
        return None
    pivot = np.array([side * x, y, 0.0]) - shift
    turn = float(np.rad2deg(-side * (down - angle)))
    return LimbPose(limb, group, float(np.rad2deg(angle)), float(np.rad2deg(down)), pivot, turn)


def _sleeve_ends(
    pattern: Pattern, outlines: Mapping[str, Outline], arms: set[str]
) -> Iterator[tuple[tuple[str, ...], Floats]]:
    """Sleeves that are sewn to something else, and the middle of their free edges (3,), cm."""
    taken = {ref for stitch in pattern.stitches for ref in stitch.sides}
    joined = set()
    for stitch in pattern.stitches:
        sides = {ref.panel for ref in stitch.sides}
        joined |= sides & arms if sides - arms else set()
    for group in _groups(pattern, arms):
        free = [
            placed_edge(outlines[name], k)
            for name in group
            for k in range(len(outlines[name].panel.edges))
            if EdgeRef(name, k) not in taken
        ]
        if free and not joined.isdisjoint(group):
            yield group, np.concatenate(free).mean(axis=0)


def _leg_ends(
    pattern: Pattern, outlines: Mapping[str, Outline], legs: set[str]
) -> Iterator[tuple[tuple[str, ...], Floats]]:
    """Panels of one trouser leg, and the middle of the border at its end (3,), cm."""
    sides = {name: float(outlines[name].world[:, 0].mean()) > 0 for name in legs}
    for left in (True, False):
        own = {name for name, side in sides.items() if side == left}
        borders = garment_borders(pattern, outlines) if own and own != legs else ()
        for group in _groups(pattern, own):
            ends = [b.middle for b in borders if {ref.panel for ref in b.edges} <= set(group)]
            if ends:
                yield group, min(ends, key=lambda middle: float(middle[1]))


def _groups(pattern: Pattern, names: set[str]) -> list[tuple[str, ...]]:
    """Panels of the given names as they hang together by seams between them."""
    inner = [s for s in pattern.stitches if all(ref.panel in names for ref in s.sides)]
    return Pattern(tuple(p for p in pattern.panels if p.name in names), tuple(inner)).components()

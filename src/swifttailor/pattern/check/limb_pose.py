"""Sleeves and trouser legs that are placed for a body in another pose: arms raised, legs apart."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.check.body_levels import BodyLevels
from swifttailor.pattern.check.covering import (
    Border,
    garment_borders,
    panel_regions,
    placed_edge,
    said_regions,
)
from swifttailor.pattern.check.outline import Outline
from swifttailor.pattern.pattern import EdgeRef, Pattern

Limb = Literal["sleeve", "leg"]

_OTHER_POSE_DEGREES = {"sleeve": 20.0, "leg": 12.0}
"""How far sleeves and legs may point outside the limbs; GarmentCode's run along them where they
end straight."""
_APART_CM = 6.0
"""The middle of a leg's hem is further from the middle of the body; that of a skirt's is nearer."""
_LEVEL = 0.4
"""A waist or neck is less high, at most this share of the way down to the hems; an open front is higher."""
_BELOW_HIPS_CM = 4.0
"""What ends above this, below the hips, is cut out over the legs: it has none that could stand apart."""
_STRAIGHT = 0.5
"""Share of the length of an opening's edges that must run one way for it to be a straight one."""


@dataclass(frozen=True)
class LimbPose:
    """A sleeve that points well above the arm, or a trouser leg that stands well beside the leg."""

    limb: Limb
    panels: tuple[str, ...]
    angle: float
    """Below the horizontal, degrees: square to the opening at its end."""
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
        for group, opening in ends(pattern, outlines, names):
            pose = _pose(limb, group, opening, levels, shift)
            found += [] if pose is None else [pose]
    return tuple(found)


def _pose(
    limb: Limb, group: tuple[str, ...], opening: Floats, levels: BodyLevels, shift: Floats
) -> LimbPose | None:
    side = 1.0 if opening[..., 0].mean() > 0 else -1.0
    if limb == "sleeve":
        x, y, down = levels.shoulder_x, levels.shoulder, levels.arm_angle
    else:
        x, y, down = levels.hip_x, levels.hips, 90.0
        if opening[..., 1].max() + shift[1] > levels.hips - _BELOW_HIPS_CM:
            return None
    angle = _angle_below_horizontal(opening, side, limb)
    if angle is None or down - angle <= _OTHER_POSE_DEGREES[limb]:
        return None
    pivot = np.array([side * x, y, 0.0]) - shift
    return LimbPose(limb, group, angle, down, pivot, -side * (down - angle))


def _angle_below_horizontal(opening: Floats, side: float, limb: Limb) -> float | None:
    """How steeply a tube falls that ends in the edges (k, 2, 3) as seen from the front, degrees.

    It runs square to their mean direction, a sleeve outwards, a leg downwards; directions that differ by half
    a turn are the same, so they are added at twice their angles. None where the edges run every way, as at an
    end that is no line.
    """
    along = (opening[:, 1] - opening[:, 0])[:, :2] @ np.array([1.0, 1.0j])
    length = np.abs(along)
    total = (along**2 / np.maximum(length, 1e-9)).sum()
    if abs(total) < _STRAIGHT * length.sum():
        return None
    square = 1j * np.exp(0.5j * np.angle(total))
    out, up = float(square.real) * side, float(square.imag)
    if (out if limb == "sleeve" else -up) < 0.0:
        out, up = -out, -up
    return float(np.rad2deg(np.arctan2(-up, out)))


def _sleeve_ends(
    pattern: Pattern, outlines: Mapping[str, Outline], arms: set[str]
) -> Iterator[tuple[tuple[str, ...], Floats]]:
    """Sleeves that are sewn to something else, and the ends (k, 2, 3) of their free edges, cm."""
    taken = {ref for stitch in pattern.stitches for ref in stitch.sides}
    joined = set()
    for stitch in pattern.stitches:
        sides = {ref.panel for ref in stitch.sides}
        joined |= sides & arms if sides - arms else set()
    for group in _groups(pattern, arms):
        refs = [EdgeRef(name, k) for name in group for k in range(len(outlines[name].panel.edges))]
        free = [ref for ref in refs if ref not in taken]
        if free and not joined.isdisjoint(group):
            yield group, _edge_ends(outlines, free)


def _leg_ends(
    pattern: Pattern, outlines: Mapping[str, Outline], legs: set[str]
) -> Iterator[tuple[tuple[str, ...], Floats]]:
    """Panels of each trouser leg of two, and the ends (k, 2, 3) of the edges of its hem, cm."""
    said = said_regions(pattern)
    aside = {name: float(outlines[name].world[:, 0].mean()) for name in legs}
    # A panel in the middle whose name says nothing, such as a waistband, belongs to neither leg.
    sides = {name: x > 0 for name, x in aside.items() if name in said or abs(x) > _APART_CM}
    if len(set(sides.values())) < 2 or not (legs <= set(said) or _has_legs(pattern)):
        return
    groups = [
        group
        for left in (True, False)
        for group in _groups(pattern, {name for name, side in sides.items() if side == left})
    ]
    group_of = {name: k for k, group in enumerate(groups) for name in group}
    hems: dict[int, Border] = {}
    for border in garment_borders(pattern):
        around = {group_of.get(ref.panel, -1) for ref in border.edges}
        k = around.pop()
        if around or k < 0 or abs(border.middle[0]) <= _APART_CM:
            continue
        if k not in hems or border.middle[1] < hems[k].middle[1]:
            hems[k] = border
    if len({sides[groups[k][0]] for k in hems}) == 2:
        yield from ((groups[k], _edge_ends(outlines, hem.edges)) for k, hem in hems.items())


def _has_legs(pattern: Pattern) -> bool:
    """Whether seams alone show legs.

    The garment ends above in the middle, at a waist or neck, and below it on either side: once, at the hems,
    or twice, at hems and further up at armholes or sleeves.
    """
    borders = garment_borders(pattern)
    upper = [border for border in borders if abs(border.middle[0]) <= _APART_CM]
    left = sorted((b for b in borders if b.middle[0] > _APART_CM), key=lambda b: b.middle[1])
    right = sorted((b for b in borders if b.middle[0] < -_APART_CM), key=lambda b: b.middle[1])
    if len(upper) != 1 or len(left) != len(right) or len(left) not in (1, 2):
        return False
    hems = np.concatenate([left[0].points, right[0].points])[:, 1]
    ends = upper[0].points[:, 1]
    over = np.concatenate([border.points for border in (*upper, *left[1:], *right[1:])])[:, 1]
    return over.min() > hems.max() and float(np.ptp(ends)) <= _LEVEL * float(ends.max() - hems.min())


def _edge_ends(outlines: Mapping[str, Outline], refs: Sequence[EdgeRef]) -> Floats:
    return np.array([placed_edge(outlines[ref.panel], ref.edge)[[0, -1]] for ref in refs])


def _groups(pattern: Pattern, names: set[str]) -> list[tuple[str, ...]]:
    """Panels of the given names as they hang together by seams between them."""
    inner = [s for s in pattern.stitches if all(ref.panel in names for ref in s.sides)]
    return Pattern(tuple(p for p in pattern.panels if p.name in names), tuple(inner)).components()

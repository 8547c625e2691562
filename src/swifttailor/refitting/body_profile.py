"""A body as a cutter sees it: girths and widths along the trunk, the legs and the arms."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.body import Body, BodyMeasurements
from swifttailor.body.measuring import arm_axis, girth, open_girth, side_depth, slice_girth, slice_points
from swifttailor.body.parts import BodyPart, face_parts

KNEE = 0.621
"""Of the height of the crotch."""
ANKLE = 0.125
_STEPS = 6
"""Slices from one level to the next."""
_ARM_PLACES = np.linspace(0.3, 1.0, 9)
"""Where arms are measured, as shares of the way from the shoulder to the wrist."""


@dataclass(frozen=True, eq=False)
class BodyProfile:
    """Levels of a body, and its girths between them; cm."""

    measurements: BodyMeasurements
    levels: Floats
    """(L,) heights of floor, ankle, knee, crotch, hips, waist, bust, armpit, shoulder, neck and crown: the
    same on every body."""
    heights: Floats
    """(n,) of the slices of the trunk, from the crotch to the armpits; as many between two levels on every
    body."""
    front: Floats
    """(n,) girth of the trunk in front of its sides."""
    back: Floats
    """(n,) behind it."""
    side: Floats
    """(n,) z of the sides."""
    half_width: Floats
    """(n,)."""
    ahead: Floats
    """(n,) how far the trunk reaches forward of `side`."""
    behind: Floats
    """(n,) how far backward."""
    leg_heights: Floats
    """(m,) of the slices of the legs, from the floor to below the crotch."""
    leg: Floats
    """(m,) girth of one leg."""
    shoulder: Floats
    """(3,) the middle of the left arm's joint."""
    arm_axis: Floats
    """(3,) direction from there to the hand."""
    arm: Floats
    """(a,) girths of the left arm at `ARM_PLACES` of its length."""

    @property
    def girth(self) -> Floats:
        """(n,) of the whole trunk."""
        return self.front + self.back


ARM_PLACES = _ARM_PLACES


def profile_of(body: Body) -> BodyProfile:
    """Measures a body along its trunk, legs and arms."""
    m = body.measurements
    crotch = m.crotch_level
    levels = np.array(
        [
            0.0,
            ANKLE * crotch,
            KNEE * crotch,
            crotch,
            m.hips_level,
            m.waist_level,
            m.bust_level,
            m.armpit_level,
            m.shoulder_level,
            m.neck_level,
            m.height,
        ]
    )
    # Bodies that were measured by hand may have levels a little out of order.
    levels = np.maximum.accumulate(levels + 1e-3 * np.arange(len(levels)))
    trunk = body.faces[
        ~np.isin(face_parts(body.faces, body.vertex_part), [BodyPart.LEFT_ARM, BodyPart.RIGHT_ARM])
    ]
    heights = np.interp(np.arange(3 * _STEPS, 7 * _STEPS + 1), np.arange(len(levels)) * _STEPS, levels)
    slices = np.array([_trunk_slice(body.vertices, trunk, float(h)) for h in heights])
    leg_heights = np.interp(np.arange(_STEPS // 2, 3 * _STEPS), np.arange(len(levels)) * _STEPS, levels)
    left = trunk[body.vertices[trunk].mean(axis=1)[:, 0] > 0]
    legs = np.array([girth(body.vertices, left, float(h)) for h in leg_heights])
    shoulder, axis = arm_axis(body.vertices, body.faces, body.vertex_part, BodyPart.LEFT_ARM)
    own = body.faces[face_parts(body.faces, body.vertex_part) == BodyPart.LEFT_ARM]
    start = float(shoulder @ axis)
    arm = np.array(
        [slice_girth(body.vertices, own, axis, start + place * m.arm_length) for place in _ARM_PLACES]
    )
    return BodyProfile(m, levels, heights, *slices.T, leg_heights, legs, shoulder, axis, arm)


def _trunk_slice(vertices: Floats, faces: Floats, height: float) -> tuple[float, ...]:
    """Front and back girth, z of the sides, half width, reach forward and backward."""
    outline = slice_points(vertices, faces, np.array([0.0, 1.0, 0.0]), height)[:, [0, 2]]
    half = float(np.ptp(outline[:, 0])) / 2
    side = side_depth(outline)
    whole = girth(vertices, faces, height)
    ahead, behind = outline[outline[:, 1] >= side], outline[outline[:, 1] <= side]
    front, back = open_girth(ahead), open_girth(behind)
    share = whole / max(front + back, 1e-6)
    return (
        front * share,
        back * share,
        side,
        half,
        float(outline[:, 1].max()) - side,
        side - float(outline[:, 1].min()),
    )

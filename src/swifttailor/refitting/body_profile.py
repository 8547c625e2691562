"""A body as a cutter sees it: girths and widths along the trunk, the legs and the arms."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter1d

from swifttailor.arrays import Floats
from swifttailor.body import Body, BodyMeasurements
from swifttailor.body.measuring import arm_axis, girth, side_depth, slice_girth, slice_points, split_girth
from swifttailor.body.parts import BodyPart, face_parts

KNEE = 0.621
"""Of the height of the crotch."""
ANKLE = 0.125
_STEPS = 6
"""Slices from one level to the next."""
_UP = np.array([0.0, 1.0, 0.0])
_BELOW_ARMPIT_CM = 3.5
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
    """(n,) of the slices of the trunk, from the knees to the armpits; as many between two levels on every
    body. Below the crotch the tape goes around both legs."""
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
    leg_middle: Floats
    """(m,) x of the middle of the left leg."""
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
    heights = np.interp(np.arange(2 * _STEPS, 7 * _STEPS + 1), np.arange(len(levels)) * _STEPS, levels)
    outlines = [slice_points(body.vertices, trunk, _UP, float(h))[:, [0, 2]] for h in heights]
    # The sides run straight down; where they lie in one slice alone is not certain to a centimetre.
    below = heights < levels[7] - _BELOW_ARMPIT_CM
    depths = np.array([side_depth(outline) for outline in outlines])
    trunk_alone = below & (heights > crotch)
    straight = np.polyfit(heights[trunk_alone], depths[trunk_alone], 1)
    sides = np.polyval(straight, np.maximum(heights, crotch))
    slices = np.array([_trunk_slice(outline, side) for outline, side in zip(outlines, sides, strict=True)])
    # Close to the armpits slices cut what is left of the arms.
    slices[~below] = slices[below][-1]
    slices = gaussian_filter1d(slices, 1.0, axis=0, mode="nearest")
    leg_heights = np.interp(np.arange(_STEPS // 2, 3 * _STEPS), np.arange(len(levels)) * _STEPS, levels)
    left = trunk[body.vertices[trunk].mean(axis=1)[:, 0] > 0]
    legs = np.array([girth(body.vertices, left, float(h)) for h in leg_heights])
    middles = np.array([_middle_x(slice_points(body.vertices, left, _UP, float(h))) for h in leg_heights])
    shoulder, axis = arm_axis(body.vertices, body.faces, body.vertex_part, BodyPart.LEFT_ARM)
    own = body.faces[face_parts(body.faces, body.vertex_part) == BodyPart.LEFT_ARM]
    start = float(shoulder @ axis)
    arm = np.array(
        [slice_girth(body.vertices, own, axis, start + place * m.arm_length) for place in _ARM_PLACES]
    )
    front, back, half, ahead, behind = slices.T
    return BodyProfile(
        m,
        levels,
        heights,
        front,
        back,
        sides,
        half,
        ahead,
        behind,
        leg_heights,
        legs,
        middles,
        shoulder,
        axis,
        arm,
    )


def _middle_x(points: Floats) -> float:
    return float(points[:, 0].min() + points[:, 0].max()) / 2


def _trunk_slice(outline: Floats, side: float) -> tuple[float, ...]:
    """Front and back girth, half width, reach forward and backward of the sides."""
    x, z = outline.T
    return *split_girth(outline, side), float(np.ptp(x)) / 2, float(z.max()) - side, side - float(z.min())

"""What a cutter notes down before drafting: heights, half girths and landmarks of a body."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from swifttailor.pattern.drafts.measurements import Measurements

UPPER_ARM_PER_ARMSCYE = 2.35
"""Upper arm girth over armscye depth on the default body; GarmentCode does not measure the upper arm."""
ROUND_THE_NECK = 0.08
"""Cloth lies round the base of the neck, not straight across it: part by which its half width is more."""
KNEE_PER_CROTCH = 0.6
"""Height of the knee over the height of the crotch."""
CALF_PER_THIGH = 0.61
"""Calf girth over thigh girth; the knee is about as wide."""
ANKLE_PER_CALF = 0.66
"""Ankle girth over calf girth."""
ANKLE_X_PER_HIPS = 0.103
"""How far from the middle the ankles stand over the hip girth; GarmentCode does not measure it."""
_RIBS = 0.5
"""Part of the way from waist to bust that the ribs just above the waist widen."""
_CALF_PER_KNEE, _ANKLE_PER_KNEE = 0.7, 0.25
"""Heights of calf and ankle over the height of the knee."""


@dataclass(frozen=True)
class Halves:
    """A girth cut at centre front, sides and centre back: half of its front and half of its back, cm."""

    front: float
    back: float

    @property
    def girth(self) -> float:
        """The whole way round, cm."""
        return 2 * (self.front + self.back)

    def eased(self, ease: float) -> Halves:
        """With `ease` cm more around, spread evenly over front and back."""
        return Halves(self.front + ease / 4, self.back + ease / 4)

    def times(self, factor: float) -> Halves:
        """Wider by that factor."""
        return Halves(factor * self.front, factor * self.back)


@dataclass(frozen=True)
class Figure:
    """Landmarks of a standing body, cm; heights above the floor, x to the wearer's left."""

    neck_x: float
    neck_y: float
    slope: float
    """Fall of the shoulder over its run (a tangent)."""
    shoulder_x: float
    armpit_y: float
    bust: Halves
    bust_x: float
    bust_y: float
    waist: Halves
    waist_y: float
    front_fullness: float
    """By how much the way over the bust to the waist is longer than the straight fall."""
    hips: Halves
    hip_y: float
    crotch_y: float
    knee_y: float
    thigh: float
    upper_arm: float
    wrist: float
    arm_length: float
    arm_angle: float
    """Arm below the horizontal, degrees."""
    head_length: float

    @classmethod
    def of(cls, m: Measurements) -> Figure:
        """Derives the landmarks from measurements; see `DraftMeasurements` for their meaning."""
        neck_y = m.height - m.head_l
        waist_y = neck_y - m.waist_line
        hip_y = waist_y - m.hips_line
        crotch_y = hip_y - m.crotch_hip_diff
        slope = math.tan(math.radians(m.shoulder_incl))
        bust = _halves(m.bust, m.back_width)
        # A shoulder wider than the chest would turn the armhole inside out.
        neck_x = (1 + ROUND_THE_NECK) * m.neck_w / 2
        shoulder_x = m.shoulder_w / 2 + neck_x - m.neck_w / 2
        shoulder_x = max(min(shoulder_x, min(bust.front, bust.back) - 2.5), neck_x + 5.0)
        return cls(
            neck_x=neck_x,
            neck_y=neck_y,
            slope=slope,
            shoulder_x=shoulder_x,
            armpit_y=neck_y - slope * (m.shoulder_w - m.neck_w) / 2 - m.armscye_depth,
            bust=bust,
            bust_x=m.bust_points / 2,
            bust_y=neck_y - m.vert_bust_line,
            waist=_halves(m.waist, m.waist_back_width),
            waist_y=waist_y,
            front_fullness=min(max(m.waist_over_bust_line - m.waist_line, 0.0), 7.0),
            hips=_halves(m.hips, m.hip_back_width),
            hip_y=hip_y,
            crotch_y=crotch_y,
            knee_y=KNEE_PER_CROTCH * crotch_y,
            thigh=m.leg_circ,
            upper_arm=UPPER_ARM_PER_ARMSCYE * m.armscye_depth,
            wrist=m.wrist,
            arm_length=m.arm_length,
            arm_angle=m.arm_pose_angle,
            head_length=m.head_l,
        )

    def for_cloth(self, stretch: float) -> Figure:
        """As cloth is cut for it that gives by that share all around: girths are smaller, heights are not."""
        less = 1 / (1 + stretch)
        return replace(
            self,
            bust=self.bust.times(less),
            bust_x=less * self.bust_x,
            waist=self.waist.times(less),
            hips=self.hips.times(less),
            thigh=less * self.thigh,
            upper_arm=less * self.upper_arm,
            wrist=less * self.wrist,
        )

    def shoulder_line(self, x: float) -> float:
        """Height of the shoulder at distance `x` cm from the middle."""
        return self.neck_y - self.slope * (x - self.neck_x)

    def girth_below_waist(self, drop: float) -> Halves:
        """Half girths `drop` cm below the waist: straight between waist and hips, constant beyond."""
        t = min(max(drop / (self.waist_y - self.hip_y), 0.0), 1.0)
        return Halves(
            (1 - t) * self.waist.front + t * self.hips.front, (1 - t) * self.waist.back + t * self.hips.back
        )

    def girth_above_waist(self, rise: float) -> Halves:
        """Half girths `rise` cm above the waist: they widen half as fast as straight lines to the bust do."""
        t = _RIBS * min(max(rise / (self.bust_y - self.waist_y), 0.0), 1.0)
        return Halves(
            (1 - t) * self.waist.front + t * self.bust.front, (1 - t) * self.waist.back + t * self.bust.back
        )

    def arm_girth(self, distance: float) -> float:
        """Girth of the arm at that distance from the shoulder tip, thinning to elbow and wrist."""
        elbow = 0.56 * self.arm_length
        at_elbow = 0.83 * self.upper_arm
        if distance < elbow:
            return self.upper_arm + (at_elbow - self.upper_arm) * max(distance, 0.0) / elbow
        t = min((distance - elbow) / (self.arm_length - elbow), 1.0)
        return at_elbow + (self.wrist - at_elbow) * t

    def leg_girth(self, y: float) -> float:
        """Girth of one leg at height `y`: thinning from thigh to knee, as wide as the calf below."""
        t = min(max((self.crotch_y - y) / (self.crotch_y - self.knee_y), 0.0), 1.0)
        return self.thigh * (1 - t + CALF_PER_THIGH * t)

    def close_leg_girth(self, y: float) -> float:
        """As `leg_girth`, but thinning from calf to ankle: of what is close there."""
        calf, ankle = _CALF_PER_KNEE * self.knee_y, _ANKLE_PER_KNEE * self.knee_y
        t = min(max((calf - y) / (calf - ankle), 0.0), 1.0)
        return self.leg_girth(y) * (1 - t + ANKLE_PER_CALF * t)


def _halves(girth: float, back: float) -> Halves:
    """Splits a girth; a back outside 42 to 56 % of it is a slip of the tape and is held to that."""
    back = min(max(back, 0.42 * girth), 0.56 * girth)
    return Halves((girth - back) / 2, back / 2)

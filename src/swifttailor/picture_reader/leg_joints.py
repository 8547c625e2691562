"""Where the joints of somebody's legs are in a photograph, and how high above the floor a row of it lies."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np

from swifttailor.describing.facts import LandmarkFacts
from swifttailor.describing.measuring.whole_pattern import landmarks_of
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.measurements import DraftMeasurements
from swifttailor.picture_reader.body_joints import ANKLES, HIPS, KNEES, LEAST_SEEN, BodyJoints

_LEAST_THIGH = 0.55
"""Height of the thighs in that of the shins: those of somebody who sits, or bends, are shorter."""
_ANKLE_CM = 8.0
"""Of the default body, above the floor."""


@dataclass(frozen=True)
class LegJoints:
    """Rows of a picture in which somebody has hips, knees and ankles, both sides together, pixels."""

    hips: float
    knees: float
    ankles: float

    @staticmethod
    def of(joints: BodyJoints) -> LegJoints | None:
        """Those of somebody; None where hips or knees are not seen on either side, and of who sits."""
        if min(joints.surest(HIPS), joints.surest(KNEES)) < LEAST_SEEN:
            return None
        hips = float(joints.middle(HIPS)[1])
        knees, ankles = (
            float(np.average(joints.places[list(at), 1], weights=joints.seen[list(at)]))
            for at in (KNEES, ANKLES)
        )
        if ankles <= knees or knees - hips < _LEAST_THIGH * (ankles - knees):
            return None
        return LegJoints(hips, knees, ankles)

    def level(self, row: float) -> float:
        """How high above the floor a row lies on the default body, cm."""
        body = default_landmarks()
        if row < self.knees:
            share = (row - self.hips) / (self.knees - self.hips)
            return body.hips - share * (body.hips - body.knee)
        share = (row - self.knees) / (self.ankles - self.knees)
        return body.knee - share * (body.knee - _ANKLE_CM)


@cache
def default_landmarks() -> LandmarkFacts:
    """Of the default body."""
    return landmarks_of(Figure.of(DraftMeasurements()))

"""Where the joints of somebody's legs are in a photograph, and how high above the floor a row of it lies."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.describing.facts import LandmarkFacts
from swifttailor.describing.measuring.whole_pattern import landmarks_of
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.measurements import DraftMeasurements
from swifttailor.picture_reader.said import share_of
from swifttailor.picture_reader.view import Square

_HIPS, _KNEES, _ANKLES = slice(23, 25), slice(25, 27), slice(27, 29)
"""Of the places that BlazePose's cutter tells: left and right."""
_LEAST_SEEN = 0.5
"""How sure hips and knees have to be in the picture, on one side at least."""
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
    def of(said: NDArray[Any], square: Square, size: int) -> LegJoints | None:
        """What the network says of joints.

        Args:
            said: (39, 5) of each place x, y and z, pixels of what it is shown, and logits that it is in the
                picture and that it is there.
            square: Of the picture, which it is shown.
            size: Pixels along each side of what it is shown.

        Returns:
            None where hips or knees are not seen, and of who sits.
        """
        seen = share_of(said[:, 3])
        if min(seen[_HIPS].max(), seen[_KNEES].max()) < _LEAST_SEEN:
            return None
        rows = square[1] + said[:, 1].astype(np.float64) * square[2] / size
        hips = float(rows[_HIPS].mean())
        knees, ankles = (float(np.average(rows[at], weights=seen[at])) for at in (_KNEES, _ANKLES))
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

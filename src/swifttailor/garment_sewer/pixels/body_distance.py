"""The body as cloth feels it: its distance, with the arms or without them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Bools, Floats
from swifttailor.body import Body, BodyMeasurements, DistanceField
from swifttailor.body.parts import ARMS
from swifttailor.pattern import Pattern
from swifttailor.pattern.check import panel_regions

FIELD_SPACING_CM = 1.0


@dataclass(frozen=True, eq=False)
class BodyDistance:
    """Signed distance to a body in cm, negative inside.

    Panels that cover the legs pass through the arms, as in the drape: a wide skirt hangs where the hands are.
    """

    full: DistanceField
    without_arms: DistanceField
    measurements: BodyMeasurements

    @staticmethod
    def of(body: Body) -> BodyDistance:
        """The distance fields of a body, kept between runs."""
        return BodyDistance(
            body.distance_field(spacing=FIELD_SPACING_CM),
            body.distance_field(spacing=FIELD_SPACING_CM, without=ARMS),
            body.measurements,
        )

    def sample(self, points: Floats, ignores_arms: Bools) -> tuple[Floats, Floats]:
        """Distance (n,) and direction away from the body (n, 3) at points (n, 3)."""
        if not ignores_arms.any():
            return self.full.sample(points)
        distance, direction = self.without_arms.sample(points)
        rest = np.flatnonzero(~ignores_arms)
        if len(rest):
            distance[rest], direction[rest] = self.full.sample(points[rest])
        return distance, direction

    def push_out(self, points: Floats, ignores_arms: Bools, clearance: float, rounds: int = 1) -> Floats:
        """Points (n, 3) moved along the direction away from the body until `clearance` cm from it."""
        points = points.copy()
        for _ in range(rounds):
            distance, direction = self.sample(points, ignores_arms)
            lacking = np.maximum(clearance - distance, 0.0)
            if not lacking.any():
                break
            points += direction * lacking[:, None]
        return points


def panels_ignoring_arms(pattern: Pattern) -> Bools:
    """(p,) whether each panel covers the legs, and hence passes through the arms."""
    return np.array([region == "leg" for region in panel_regions(pattern).values()], np.bool_)

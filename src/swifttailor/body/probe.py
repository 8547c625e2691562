"""What the checks of a pattern need to know of a body."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from scipy.spatial import KDTree

from swifttailor.arrays import Floats
from swifttailor.body.body import Body
from swifttailor.body.measurements import BodyMeasurements
from swifttailor.pattern.check import BodyLevels, BodyProbe


@lru_cache(maxsize=4)
def probe_body(body: Body) -> BodyProbe:
    """Probes a body by its nearest vertices and their normals.

    Good to about a centimetre, which is what the checks ask for, and ready at once, unlike the exact
    distances, whose compiled code takes seconds the first time. The latest bodies are remembered.
    """
    corners = body.vertices[body.faces]
    face_normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals = np.zeros_like(body.vertices)
    for k in range(3):
        np.add.at(normals, body.faces[:, k], face_normals)
    tree = KDTree(body.vertices)

    def signed_distance(points: Floats) -> Floats:
        distance, nearest = tree.query(points)
        outward = ((points - body.vertices[nearest]) * normals[nearest]).sum(axis=1)
        return np.where(outward < 0, -distance, distance)

    heights = body.vertices[:, 1]
    levels = body_levels(body.measurements)
    return BodyProbe(signed_distance, float(heights.min()), float(heights.max()), levels)


def body_levels(measurements: BodyMeasurements) -> BodyLevels:
    """Where garments are worn on a body of these measurements."""
    return BodyLevels(
        neck=measurements.neck_level,
        shoulder=measurements.shoulder_level,
        armpit=measurements.armpit_level,
        waist=measurements.waist_level,
        hips=measurements.hips_level,
        shoulder_x=measurements.shoulder_w / 2,
        arm_angle=measurements.arm_pose_angle,
    )

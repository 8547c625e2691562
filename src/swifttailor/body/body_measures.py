"""The measures that a body can be made to, each taken on its mesh between landmarks."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from swifttailor.body.body import Body
from swifttailor.body.landmarks import Landmarks
from swifttailor.body.measurements import BodyMeasurements


@dataclass(frozen=True)
class Measure:
    """One measure of a body."""

    take: Callable[[Landmarks], float]
    """From the landmarks of a body, cm."""
    smallest: float
    """What is less is no measure of a person, cm."""
    largest: float
    """What is more is none, cm."""
    meaning: str
    """How a person takes it."""
    calibrated: bool = False
    """Whether GarmentCode means something that a mesh does not mark, so that what is taken is counted from
    the default body, whose value is known."""


def _straight(m: Landmarks, *names: str) -> float:
    points = [m.ring(n)[0] if n in ("elbow", "wrist") else m.point(n) for n in names]
    return float(sum(np.linalg.norm(b - a) for a, b in pairwise(points)))


MEASURES: dict[str, Measure] = {
    "height": Measure(lambda m: float(np.ptp(m.vertices[:, 1])), 75, 225, "floor to the top of the head"),
    "bust": Measure(lambda m: m.girth("bust"), 40, 200, "girth at the fullest part of the chest"),
    "underbust": Measure(lambda m: m.girth("underbust"), 38, 190, "girth just below the breasts"),
    "waist": Measure(lambda m: m.girth("waist"), 38, 190, "girth at the natural waist"),
    "hips": Measure(lambda m: m.girth("hips"), 40, 210, "girth at the fullest part of the seat"),
    "leg_circ": Measure(lambda m: m.girth("thigh"), 22, 110, "girth of the thigh just below the crotch"),
    "knee": Measure(lambda m: m.girth("knee"), 17, 75, "girth of the knee"),
    "calf": Measure(lambda m: m.girth("calf"), 15, 75, "girth of the calf at its fullest"),
    "ankle": Measure(lambda m: m.girth("ankle"), 11, 45, "girth above the ankle bone"),
    "biceps": Measure(lambda m: m.girth("upper arm"), 11, 70, "girth of the upper arm"),
    "elbow": Measure(lambda m: m.girth("elbow"), 10, 60, "girth of the elbow"),
    "wrist": Measure(lambda m: m.girth("wrist"), 8, 32, "girth of the wrist"),
    "neck": Measure(lambda m: m.girth("throat"), 18, 70, "girth of the neck at its middle"),
    "inseam": Measure(lambda m: m.level("crotch"), 25, 120, "crotch to the floor"),
    "waist_height": Measure(lambda m: m.level("waist"), 40, 150, "waist to the floor, straight down"),
    "knee_height": Measure(lambda m: m.level("knee"), 15, 75, "middle of the knee to the floor"),
    "head_l": Measure(
        lambda m: float(m.vertices[:, 1].max()) - m.level("neck"),
        12,
        45,
        "top of the head to the base of the neck at the back, straight down",
    ),
    "waist_line": Measure(
        lambda m: m.level("neck") - m.level("waist"), 15, 65, "base of the neck to the waist, straight down"
    ),
    "hips_line": Measure(
        lambda m: m.level("waist") - m.level("hips"), 6, 45, "waist to the fullest part of the hips"
    ),
    "crotch_hip_diff": Measure(
        lambda m: m.level("hips") - m.level("crotch"), 1, 25, "fullest part of the hips to the crotch"
    ),
    "vert_bust_line": Measure(
        lambda m: m.level("neck") - m.level("bust"), 8, 45, "base of the neck to the bust points"
    ),
    "armscye_depth": Measure(
        lambda m: m.level("neck") - m.level("armpit"), 5, 30, "base of the neck to the armpit"
    ),
    "shoulder_w": Measure(
        lambda m: 2 * float(m.point("shoulder point")[0]),
        15,
        65,
        "from shoulder point to shoulder point",
        calibrated=True,
    ),
    "neck_w": Measure(
        lambda m: 2 * float(m.point("neck point")[0]), 7, 35, "width of the neck at its base", calibrated=True
    ),
    "bust_points": Measure(
        lambda m: 2 * float(m.point("bust point")[0]),
        7,
        40,
        "distance of the foremost points of the chest",
        calibrated=True,
    ),
    "bum_points": Measure(
        lambda m: 2 * float(m.point("seat point")[0]),
        7,
        40,
        "distance of the hindmost points of the seat",
        calibrated=True,
    ),
    "arm_length": Measure(
        lambda m: _straight(m, "shoulder point", "elbow", "wrist"),
        20,
        85,
        "shoulder point over the elbow to the wrist",
        calibrated=True,
    ),
    "bust_line": Measure(
        lambda m: _straight(m, "neck point", "bust point"),
        10,
        55,
        "neck beside the shoulder to the bust point",
        calibrated=True,
    ),
    "waist_over_bust_line": Measure(
        lambda m: _straight(m, "neck point", "bust point", "waist point"),
        18,
        75,
        "neck beside the shoulder over the bust point to the waist",
        calibrated=True,
    ),
}
"""By name: GarmentCode's, where it has one."""


def take(name: str, landmarks: Landmarks) -> float:
    """One of `MEASURES` of a body, cm."""
    measure = MEASURES[name]
    taken = measure.take(landmarks)
    return taken * _calibration(name) if measure.calibrated else taken


@functools.lru_cache(maxsize=64)
def _calibration(name: str) -> float:
    body = Body.default()
    return getattr(body.measurements, name) / MEASURES[name].take(Landmarks(body.vertices))


def measurements_of(landmarks: Landmarks) -> BodyMeasurements:
    """GarmentCode's 26 measurements of a body whose landmarks are known."""
    default = _default_landmarks()
    known = Body.default().measurements
    values = {name: take(name, landmarks) for name in MEASURES if hasattr(known, name)}
    backs = (("back_width", "bust"), ("waist_back_width", "waist"), ("hip_back_width", "hips"))
    for name, level in backs:
        (front, back), (front_0, back_0) = landmarks.widths(level), default.widths(level)
        share = getattr(known, name) / getattr(known, level)
        # More at the back than the default body has, more at GarmentCode's back.
        share *= (back / (front + back)) / (back_0 / (front_0 + back_0))
        values[name] = min(max(share, 0.3), 0.7) * values[level]
    for name, angle in _ANGLES.items():
        values[name] = max(getattr(known, name) + angle(landmarks) - angle(default), 0.0)
    return BodyMeasurements.from_mapping(values)


@functools.cache
def _default_landmarks() -> Landmarks:
    return Landmarks(Body.default().vertices)


def _slope(start: str, end: str) -> Callable[[Landmarks], float]:
    def angle(m: Landmarks) -> float:
        first = m.point(start)
        last = m.ring(end)[0] if end == "wrist" else m.point(end)
        return math.degrees(math.atan2(first[1] - last[1], last[0] - first[0]))

    return angle


_ANGLES: dict[str, Callable[[Landmarks], float]] = {
    "shoulder_incl": _slope("neck point", "shoulder point"),
    "arm_pose_angle": _slope("shoulder point", "wrist"),
    "hip_inclination": lambda m: 90.0 - _slope("waist side", "hip side")(m),
}
"""Degrees; counted from the default body's."""

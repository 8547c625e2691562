"""Body measurements that drafts read: GarmentCode's names, in cm and degrees."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Protocol

from swifttailor.errors import PatternError


class Measurements(Protocol):
    """Anything with GarmentCode's measurements as attributes, such as `swifttailor.body.Body.measurements`.

    Lengths are cm, angles degrees; `DraftMeasurements` says what each one is.
    """

    @property
    def height(self) -> float: ...  # noqa: D102
    @property
    def head_l(self) -> float: ...  # noqa: D102
    @property
    def neck_w(self) -> float: ...  # noqa: D102
    @property
    def shoulder_w(self) -> float: ...  # noqa: D102
    @property
    def shoulder_incl(self) -> float: ...  # noqa: D102
    @property
    def armscye_depth(self) -> float: ...  # noqa: D102
    @property
    def arm_length(self) -> float: ...  # noqa: D102
    @property
    def arm_pose_angle(self) -> float: ...  # noqa: D102
    @property
    def wrist(self) -> float: ...  # noqa: D102
    @property
    def bust(self) -> float: ...  # noqa: D102
    @property
    def back_width(self) -> float: ...  # noqa: D102
    @property
    def bust_points(self) -> float: ...  # noqa: D102
    @property
    def vert_bust_line(self) -> float: ...  # noqa: D102
    @property
    def waist(self) -> float: ...  # noqa: D102
    @property
    def waist_back_width(self) -> float: ...  # noqa: D102
    @property
    def waist_line(self) -> float: ...  # noqa: D102
    @property
    def waist_over_bust_line(self) -> float: ...  # noqa: D102
    @property
    def hips(self) -> float: ...  # noqa: D102
    @property
    def hip_back_width(self) -> float: ...  # noqa: D102
    @property
    def hips_line(self) -> float: ...  # noqa: D102
    @property
    def bum_points(self) -> float: ...  # noqa: D102
    @property
    def crotch_hip_diff(self) -> float: ...  # noqa: D102
    @property
    def leg_circ(self) -> float: ...  # noqa: D102


@dataclass(frozen=True)
class DraftMeasurements:
    """A body in numbers; the defaults are GarmentCode's ``mean_all``, the package's default body."""

    height: float = 171.99
    """Floor to crown, cm."""
    head_l: float = 26.3262
    """Crown to the point where neck meets shoulder, cm."""
    neck_w: float = 18.9328
    """Between the two points where neck meets shoulder, cm."""
    shoulder_w: float = 36.4568
    """Between the shoulder tips, cm."""
    shoulder_incl: float = 21.6777
    """Slope of the shoulder below the horizontal, degrees."""
    armscye_depth: float = 12.8679
    """Shoulder tip straight down to the armpit, cm."""
    arm_length: float = 53.9697
    """Shoulder tip to wrist, cm."""
    arm_pose_angle: float = 45.483
    """Arm below the horizontal in the body's pose, degrees."""
    wrist: float = 16.5945
    """Wrist girth, cm."""
    bust: float = 99.8407
    """Bust girth, cm."""
    underbust: float = 86.2455
    """Girth under the bust, cm."""
    back_width: float = 47.6761
    """Back part of the bust girth, side to side, cm."""
    bust_points: float = 16.9463
    """Between the bust points, cm."""
    bust_line: float = 25.6947
    """Neck-shoulder point to bust level along the body, cm."""
    vert_bust_line: float = 21.1388
    """Neck-shoulder point straight down to bust level, cm."""
    waist: float = 84.3338
    """Waist girth, cm."""
    waist_back_width: float = 39.1358
    """Back part of the waist girth, cm."""
    waist_line: float = 36.8913
    """Neck-shoulder point straight down to the waist, cm."""
    waist_over_bust_line: float = 40.5603
    """Neck-shoulder point over the bust to the waist, along the body, cm."""
    hips: float = 103.478
    """Hip girth, cm."""
    hip_back_width: float = 54.8237
    """Back part of the hip girth, cm."""
    hips_line: float = 23.4837
    """Waist straight down to the hips, cm."""
    hip_inclination: float = 9.86489
    """Slope of the side from waist to hips, degrees."""
    bum_points: float = 18.2342
    """Between the most prominent points of the seat, cm."""
    crotch_hip_diff: float = 8.81363
    """Hips straight down to the crotch, cm."""
    leg_circ: float = 60.2039
    """Thigh girth below the crotch, cm."""


_READ = tuple(name for name in vars(Measurements) if not name.startswith("_"))


def checked(measurements: Measurements | None) -> Measurements:
    """Returns the measurements, or the default body's, after checking that drafts can use them.

    Raises:
        PatternError: One is missing, or is not a positive number.
    """
    if measurements is None:
        return DraftMeasurements()
    for name in _READ:
        value = getattr(measurements, name, None)
        if not isinstance(value, int | float) or not 0 < value < 1000:
            unit = "degrees" if name in ("shoulder_incl", "arm_pose_angle") else "cm"
            known = next(f.default for f in fields(DraftMeasurements) if f.name == name)
            raise PatternError(
                f"Body measurement '{name}' must be a positive number in {unit}, got {value!r} "
                f"(the default body has {known})."
            )
    return measurements

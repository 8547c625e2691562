"""What the programs know of the body: its measurements and a few that follow from them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from swifttailor.body.measurements import BodyMeasurements
from swifttailor.errors import InputError


class BodyParameters(Mapping[str, float]):
    """Measurements by GarmentCode's names, cm and degrees; what is derived begins with an underscore."""

    def __init__(self, measurements: BodyMeasurements | Mapping[str, float]) -> None:
        """Derives the rest from the measurements.

        Raises:
            InputError: A measurement is missing, is not a finite number or is not above zero.
        """
        if not isinstance(measurements, BodyMeasurements):
            measurements = BodyMeasurements.from_mapping(measurements)
        p = measurements.as_dict()
        p["_waist_level"] = p["height"] - p["head_l"] - p["waist_line"]
        p["_leg_length"] = p["_waist_level"] - p["hips_line"]
        p["_base_sleeve_balance"] = p["shoulder_w"] - 2  # the sleeve begins a little nearer to the neck
        p["_bust_line"] = (1 - 1 / 3) * p["vert_bust_line"] + 1 / 3 * p["bust_line"]
        p["_hip_inclination"] = p["hip_inclination"] / 2
        p["_shoulder_incl"] = p["shoulder_incl"]
        p["_armscye_depth"] = p["armscye_depth"] + 2.5  # ease
        self._values = p

    @classmethod
    def default(cls) -> BodyParameters:
        """GarmentCode's mean body, the default of this package."""
        return _DEFAULT

    def with_measures(self, **values: float) -> BodyParameters:
        """The body with other measurements.

        Raises:
            InputError: There is no such measurement, or it is not a number above zero.
        """
        unknown = [name for name in values if name not in self._values or name.startswith("_")]
        if unknown:
            known = ", ".join(name for name in self._values if not name.startswith("_"))
            raise InputError(f"There is no body measurement '{unknown[0]}'. The measurements are: {known}.")
        return BodyParameters({**self._values, **values})

    def __getitem__(self, name: str) -> float:
        return self._values[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)


_DEFAULT = BodyParameters(
    {
        "arm_length": 53.9697,
        "arm_pose_angle": 45.483,
        "armscye_depth": 12.8679,
        "back_width": 47.6761,
        "bum_points": 18.2342,
        "bust": 99.8407,
        "bust_line": 25.6947,
        "bust_points": 16.9463,
        "crotch_hip_diff": 8.81363,
        "head_l": 26.3262,
        "height": 171.99,
        "hip_back_width": 54.8237,
        "hip_inclination": 9.86489,
        "hips": 103.478,
        "hips_line": 23.4837,
        "leg_circ": 60.2039,
        "neck_w": 18.9328,
        "shoulder_incl": 21.6777,
        "shoulder_w": 36.4568,
        "underbust": 86.2455,
        "vert_bust_line": 21.1388,
        "waist": 84.3338,
        "waist_back_width": 39.1358,
        "waist_line": 36.8913,
        "waist_over_bust_line": 40.5603,
        "wrist": 16.5945,
    }
)

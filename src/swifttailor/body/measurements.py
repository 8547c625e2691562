"""Body measurements under GarmentCode's names, and reading them from a file."""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Any

from swifttailor.errors import InputError

MAX_FILE_BYTES = 1_000_000


def is_finite_number(value: object) -> bool:
    """Whether something is a number that a float can hold; whole numbers may have hundreds of digits."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    return abs(value) <= sys.float_info.max


@dataclass(frozen=True)
class BodyMeasurements:
    """Measurements of a standing body; lengths in cm, angles in degrees.

    Names and meaning follow GarmentCode, so patterns drafted for a GarmentCode body use the same numbers.
    "Vertical" means a difference of heights, everything else runs along the surface.
    """

    height: float
    """Floor to the top of the head."""
    head_l: float
    """Vertical, from the top of the head to the base of the neck at the back."""
    neck_w: float
    """Width of the neck at its base."""
    shoulder_w: float
    """Straight from one shoulder point to the other."""
    shoulder_incl: float
    """Slope of the shoulder against the horizontal, degrees."""
    bust: float
    """Girth at the fullest part of the chest."""
    underbust: float
    """Girth just below the breasts."""
    waist: float
    """Girth at the waist."""
    hips: float
    """Girth at the fullest part of the hips."""
    bust_line: float
    """From the neck beside the shoulder over the front to the bust points."""
    waist_line: float
    """Vertical, from the base of the neck to the waist."""
    hips_line: float
    """Vertical, from the waist to the hips."""
    arm_length: float
    """From the shoulder point to the wrist."""
    arm_pose_angle: float
    """Angle of the arms below the horizontal, degrees."""
    armscye_depth: float
    """Vertical, from the base of the neck to the armpit."""
    wrist: float
    """Girth of the wrist."""
    leg_circ: float
    """Girth of the thigh just below the crotch."""
    crotch_hip_diff: float
    """Vertical, from the hips to the crotch."""
    back_width: float
    """Back half of `bust`."""
    waist_back_width: float
    """Back half of `waist`."""
    hip_back_width: float
    """Back half of `hips`."""
    bum_points: float
    """Distance between the hindmost points of the two buttocks."""
    bust_points: float
    """Distance between the foremost points of the two breasts."""
    waist_over_bust_line: float
    """From the neck beside the shoulder over the bust point to the waist."""
    vert_bust_line: float
    """Vertical, from the base of the neck to the bust points."""
    hip_inclination: float
    """Slope of the side from waist to hips against the vertical, degrees."""

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if not is_finite_number(value):
                raise InputError(
                    f"The body measurement '{field.name}' is {value!r}; it must be a finite number "
                    "(cm, or degrees for angles)."
                )
            if value <= 0 and field.name not in _MAY_BE_ZERO:
                raise InputError(f"The body measurement '{field.name}' is {value!r}; it must be above zero.")
            object.__setattr__(self, field.name, float(value))

    @property
    def neck_level(self) -> float:
        """Height of the base of the neck, cm."""
        return self.height - self.head_l

    @property
    def shoulder_level(self) -> float:
        """Height of the shoulder points, cm."""
        drop = (self.shoulder_w - self.neck_w) / 2 * math.tan(math.radians(self.shoulder_incl))
        return self.neck_level - drop

    @property
    def armpit_level(self) -> float:
        """Height of the armpits, cm."""
        return self.neck_level - self.armscye_depth

    @property
    def bust_level(self) -> float:
        """Height of the bust points, cm."""
        return self.neck_level - self.vert_bust_line

    @property
    def waist_level(self) -> float:
        """Height of the waist, cm."""
        return self.neck_level - self.waist_line

    @property
    def hips_level(self) -> float:
        """Height of the fullest part of the hips, cm."""
        return self.waist_level - self.hips_line

    @property
    def crotch_level(self) -> float:
        """Height of the crotch, cm."""
        return self.hips_level - self.crotch_hip_diff

    @property
    def leg_length(self) -> float:
        """From the hips to the floor, cm."""
        return self.hips_level

    @property
    def waist_front_width(self) -> float:
        """Front half of `waist`, cm."""
        return self.waist - self.waist_back_width

    @property
    def bust_front_width(self) -> float:
        """Front half of `bust`, cm."""
        return self.bust - self.back_width

    @property
    def hip_front_width(self) -> float:
        """Front half of `hips`, cm."""
        return self.hips - self.hip_back_width

    def as_dict(self) -> dict[str, float]:
        """The measurements by name, in the order of the class."""
        return asdict(self)

    @classmethod
    def from_mapping(
        cls, values: Mapping[str, Any], fallback: BodyMeasurements | None = None
    ) -> BodyMeasurements:
        """Makes measurements from names and numbers.

        Args:
            values: GarmentCode names to numbers. Names this class does not know are ignored: other
                programs keep notes of their own in the same files.
            fallback: Where missing measurements come from; without it all are required.

        Raises:
            InputError: A measurement is missing, is no finite number or not above zero.
        """
        names = [field.name for field in fields(cls)]
        known = {name: values[name] for name in names if name in values}
        missing = [name for name in names if name not in known]
        if missing and fallback is None:
            raise InputError(f"Body measurements are missing: {', '.join(missing)}. Add them, in cm.")
        rest = fallback.as_dict() if fallback is not None else {}
        return cls(**{name: known.get(name, rest.get(name)) for name in names})


_MAY_BE_ZERO = frozenset({"shoulder_incl", "arm_pose_angle", "hip_inclination"})


def read_measurements(path: Path | str) -> dict[str, float]:
    """Reads named measurements from a GarmentCode body file (YAML) or a JSON file.

    Both hold a mapping of names to numbers, at the top or under the key ``body``. Not every measurement
    has to be there.

    Raises:
        InputError: The file is missing, too large, no YAML or JSON, or holds no known measurement.
    """
    path = Path(path)
    try:
        size = path.stat().st_size
        if size > MAX_FILE_BYTES:
            raise InputError(f"'{path}' has {size} bytes; a measurements file has at most {MAX_FILE_BYTES}.")
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(
            f"Cannot read the measurements '{path}': {error}. Give a GarmentCode body YAML or a JSON file."
        ) from error
    content = _parse(text, path)
    if isinstance(content, dict) and isinstance(content.get("body"), dict):
        content = content["body"]
    names = {field.name for field in fields(BodyMeasurements)}
    if not isinstance(content, dict) or not names & set(content):
        raise InputError(
            f"'{path}' holds no body measurements. Accepted is a mapping of names to cm, for example "
            "'body: {height: 172, waist: 84}', with names such as " + ", ".join(sorted(names)[:6]) + "."
        )
    return {name: content[name] for name in content if name in names}


def _parse(text: str, path: Path) -> Any:
    """The content of a YAML or JSON text."""
    if path.suffix.lower() == ".json":
        try:
            return json.loads(text)
        except (ValueError, RecursionError) as error:
            raise InputError(f"'{path}' is not valid JSON: {error}.") from error
    import yaml

    try:
        return yaml.safe_load(text)
    except (yaml.YAMLError, ValueError, RecursionError) as error:
        raise InputError(f"'{path}' is not valid YAML: {error}.") from error

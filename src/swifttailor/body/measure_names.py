"""Names that measures go by: GarmentCode's, FreeSewing's, and those of everyday."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from swifttailor.body.body_measures import MEASURES
from swifttailor.body.measurements import is_finite_number
from swifttailor.errors import InputError
from swifttailor.inches import CM_PER_INCH

EVERYDAY = {
    "chest": "bust",
    "hip": "hips",
    "seat": "hips",
    "thigh": "leg_circ",
    "shoulders": "shoulder_w",
    "shoulder": "shoulder_w",
    "shoulder_width": "shoulder_w",
    "sleeve": "arm_length",
    "arm": "arm_length",
    "inside_leg": "inseam",
    "inner_leg": "inseam",
    "upper_arm": "biceps",
    "bicep": "biceps",
    "stature": "height",
    "back_length": "waist_line",
}
"""Of ``--measure``: other names for measures."""
FREESEWING = {
    "ankle": "ankle",
    "biceps": "biceps",
    "bustSpan": "bust_points",
    "chest": "bust",
    "inseam": "inseam",
    "knee": "knee",
    "neck": "neck",
    "seat": "hips",
    "shoulderToShoulder": "shoulder_w",
    "shoulderToWrist": "arm_length",
    "underbust": "underbust",
    "upperLeg": "leg_circ",
    "waist": "waist",
    "waistToFloor": "waist_height",
    "waistToSeat": "hips_line",
    "wrist": "wrist",
}
"""FreeSewing's measurements that mean the same as one of ours; its ``hips`` lie above the seat."""
FREESEWING_ALONE = frozenset(
    """bustFront bustPointToUnderbust bustSpan chest crossSeam crossSeamFront crotchDepth heel highBust
    highBustFront hpsToBust hpsToWaistBack hpsToWaistFront seat seatBack shoulderSlope shoulderToElbow
    shoulderToShoulder shoulderToWrist upperLeg waistBack waistToArmpit waistToFloor waistToHips waistToKnee
    waistToSeat waistToUnderbust waistToUpperLeg""".split()
)
"""Names that only FreeSewing has, by which its files are told."""
LEFT_OPEN = frozenset(
    {
        *("arm_pose_angle", "shoulder_incl", "hip_inclination"),
        *("back_width", "waist_back_width", "hip_back_width"),
    }
)
"""GarmentCode's measurements that are not asked of a body: its pose, and what follows from the others."""
_MAX_BYTES = 1_000_000
_MILLIMETRES = 300.0
"""A chest of so many units is in millimetres."""
_INCHES = {"in", "inch", "inches", '"'}


def parse_measures(words: Iterable[str]) -> dict[str, float]:
    """Measures from ``bust=96 height=172cm waist=30in``.

    Raises:
        InputError: A word is no such pair, or its name is unknown.
    """
    found: dict[str, float] = {}
    for word in words:
        name, equals, value = word.partition("=")
        if not equals:
            raise InputError(
                f"'{word}' is no measure. Give name=cm, such as bust=96 height=172. "
                f"Names: {', '.join(MEASURES)}."
            )
        found[measure_name(name)] = _length(value, word)
    return found


def measure_name(name: str) -> str:
    """The name of `MEASURES` that a name means.

    Raises:
        InputError: There is none.
    """
    plain = name.strip().lower().replace("-", "_").replace(" ", "_")
    known = EVERYDAY.get(plain, plain)
    if known not in MEASURES:
        from difflib import get_close_matches

        close = get_close_matches(plain, [*MEASURES, *EVERYDAY], n=2, cutoff=0.7)
        hint = " Did you mean " + " or ".join(f"'{one}'" for one in close) + "?" if close else ""
        raise InputError(f"There is no measure '{name}'.{hint} There are: {', '.join(MEASURES)}.")
    return known


def read_measures(path: Path) -> dict[str, float]:
    """Measures from a file of GarmentCode's or FreeSewing's measurements (YAML or JSON).

    Raises:
        InputError: It cannot be read or holds no measure that is known.
    """
    content = _parsed(path)
    for key in ("body", "measurements"):
        if isinstance(content, Mapping) and isinstance(content.get(key), Mapping):
            content = content[key]
    if not isinstance(content, Mapping):
        raise InputError(f"'{path}' holds no measures: names and numbers in cm are expected.")
    numbers = {str(k): v for k, v in content.items() if is_finite_number(v)}
    if FREESEWING_ALONE & set(numbers):
        unit = 0.1 if float(numbers.get("chest", numbers.get("waist", 0.0))) > _MILLIMETRES else 1.0
        found = {FREESEWING[k]: float(v) * unit for k, v in numbers.items() if k in FREESEWING}
    else:
        found = {}
        for name, value in numbers.items():
            known = EVERYDAY.get(name.lower(), name.lower())
            if known in MEASURES and name not in LEFT_OPEN:
                found[known] = float(value)
    if not found:
        raise InputError(
            f"'{path}' holds no measure that is known. GarmentCode's and FreeSewing's names are, and "
            f"{', '.join(MEASURES)}."
        )
    return found


def _parsed(path: Path) -> Any:
    try:
        if path.stat().st_size > _MAX_BYTES:
            raise InputError(f"'{path}' is larger than a file of measures, {_MAX_BYTES} bytes.")
        text = path.read_text("utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"Cannot read the measures '{path}': {error}.") from error
    try:
        if path.suffix.lower() == ".json":
            return json.loads(text)
        import yaml

        return yaml.safe_load(text)
    except Exception as error:  # yaml raises several families
        raise InputError(f"'{path}' is no valid YAML or JSON: {str(error)[:200]}.") from error


def _length(text: str, word: str) -> float:
    number = text.strip().lower().rstrip('cmin"hes ')
    unit = text.strip().lower()[len(number) :].strip()
    try:
        value = float(number)
    except ValueError as error:
        raise InputError(f"'{word}': a number of cm was expected, such as 96 or 38in.") from error
    if unit not in {"", "cm", *_INCHES}:
        raise InputError(f"'{word}': the unit may be cm or in.")
    return value * CM_PER_INCH if unit in _INCHES else value

"""Where the parts of a body are that garments are worn on."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, kw_only=True)
class BodyLevels:
    """Heights above the floor, cm, and the pose of a body; the defaults are those of the default body."""

    neck: float = 145.6638
    """Base of the neck."""
    armpit: float = 132.7959
    shoulder: float = 142.1809
    """Shoulder points; they are `shoulder_x` from the middle."""
    waist: float = 108.7725
    hips: float = 85.2888
    hip_x: float = 10.0
    """Middle of the thigh, from the middle of the body."""
    shoulder_x: float = 18.2284
    arm_angle: float = 45.483
    """Arm below the horizontal, degrees."""

"""Other sizes than the default body's, smooth from joint to joint."""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np

from swifttailor.arrays import Array
from swifttailor.body.rig import Rig
from swifttailor.errors import InputError

SMALLEST, LARGEST = 0.5, 1.6


@dataclass(frozen=True)
class BodyShape:
    """Sizes as multiples of the default body's; 1 leaves them."""

    stature: float = 1.0
    """Everything, head included."""
    leg_length: float = 1.0
    torso_length: float = 1.0
    arm_length: float = 1.0
    shoulder_width: float = 1.0
    """From the neck to the shoulder."""
    chest_width: float = 1.0
    chest_depth: float = 1.0
    breast_depth: float = 1.0
    """How far they stand out; 0.6 is a flat chest."""
    waist_width: float = 1.0
    waist_depth: float = 1.0
    hip_width: float = 1.0
    hip_depth: float = 1.0
    thigh_girth: float = 1.0
    calf_girth: float = 1.0
    arm_girth: float = 1.0
    neck_girth: float = 1.0
    head_size: float = 1.0

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if not np.isfinite(value) or not SMALLEST <= value <= LARGEST:
                raise InputError(
                    f"A shape's {field.name} is {SMALLEST:g} to {LARGEST:g} times the default body's, "
                    f"received {value!r}."
                )

    def sizes(self, rig: Rig) -> Array:
        """(J, 3, 3) symmetric matrices that stretch what each joint of a rig carries, about the joint."""
        return np.stack([self._size(rig, name) for name in rig.names]) * self.stature

    def _size(self, rig: Rig, name: str) -> Array:
        side, _, rest = name.partition("_")
        joint = rest if side in ("left", "right") else name
        if joint in _LIMBS:
            end, along, across = _LIMBS[joint]
            bone = rig.joints[rig.index(f"{side}_{end}")] - rig.joints[rig.index(name)]
            return _stretch(bone, getattr(self, along), getattr(self, across))
        long, wide, deep = self.torso_length, self.chest_width, self.chest_depth
        table = {
            "pelvis": (self.hip_width, long, self.hip_depth),
            "spine": (self.waist_width, long, self.waist_depth),
            "chest": (wide, long, deep),
            "breast": (wide, long, deep * self.breast_depth),
            "clavicle": (self.shoulder_width, long, deep),
            "neck": (self.neck_girth, 0.5 * (1.0 + long), self.neck_girth),
            "head": (self.head_size,) * 3,
            "hand": (np.sqrt(self.arm_girth),) * 3,
        }
        return np.diag(table.get(joint, (1.0, 1.0, 1.0)))


_LIMBS = {
    "arm": ("forearm", "arm_length", "arm_girth"),
    "arm_twist": ("forearm", "arm_length", "arm_girth"),
    "forearm": ("hand", "arm_length", "arm_girth"),
    "thigh": ("shin", "leg_length", "thigh_girth"),
    "shin": ("foot", "leg_length", "calf_girth"),
}
"""Joint: where its bone ends, and what stretches it along and across."""


def _stretch(bone: Array, along: float, across: float) -> Array:
    unit = bone / np.linalg.norm(bone)
    return across * np.eye(3) + (along - across) * np.outer(unit, unit)


def random_shape(chance: np.random.Generator) -> BodyShape:
    """A body that one could meet: slim or broad, womanly, girlish or manly, long or short legs.

    Args:
        chance: Where the draw comes from.
    """
    weight = float(np.clip(chance.normal(0.0, 0.07), -0.14, 0.15))
    manly = bool(chance.random() < 0.25)

    def near(value: float, spread: float) -> float:
        return value + spread * float(np.clip(chance.normal(), -2.0, 2.0))

    stature = near(1.04 if manly else 0.985, 0.03)
    return BodyShape(
        stature=stature,
        leg_length=near(1.0, 0.025),
        torso_length=near(1.0, 0.02),
        arm_length=near(1.0, 0.02),
        shoulder_width=near(1.12 if manly else 0.98, 0.03),
        chest_width=near((1.06 if manly else 0.97) + 0.8 * weight, 0.02),
        chest_depth=near(1.0 + weight, 0.025),
        breast_depth=near(0.62, 0.05) if manly else near(1.0 + weight, 0.13),
        waist_width=near((1.02 if manly else 0.94) + 1.1 * weight, 0.03),
        waist_depth=near((0.98 if manly else 0.94) + 1.2 * weight, 0.03),
        hip_width=near((0.94 if manly else 0.99) + 0.8 * weight, 0.025),
        hip_depth=near((0.94 if manly else 0.99) + 0.9 * weight, 0.025),
        thigh_girth=near((0.98 if manly else 0.97) + 0.7 * weight, 0.02),
        calf_girth=near(0.98 + 0.6 * weight, 0.025),
        arm_girth=near((1.06 if manly else 0.93) + 0.8 * weight, 0.03),
        neck_girth=near((1.12 if manly else 0.97) + 0.5 * weight, 0.03),
        head_size=near(1.0 / stature, 0.015),
    )

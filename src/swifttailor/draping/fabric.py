"""A cloth's material in physical units. Those that are known by name are in `known_fabrics`."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields

from swifttailor.errors import InputError

STRETCHY = 185.0
"""Membrane stiffness of knits, N/m: of the interlock that Wang et al. 2011 measured."""


@dataclass(frozen=True)
class Fabric:
    """Mechanical properties of a cloth, the same in all its directions.

    Stretch stiffness should stay below about 2000 N/m, which is what the solver resolves in one frame: woven
    cloth then gives by well under one per cent under its own weight.
    """

    name: str
    density: float
    """Mass per area, kg/m^2."""
    stretch: float
    """Membrane stiffness, N/m."""
    bending: float
    """Bending rigidity, N m."""
    friction: float = 0.5
    """Coulomb friction on the body."""
    thickness: float = 0.3
    """Distance kept between two layers and from the body, cm."""
    kind: str = ""
    """What it is, in words."""
    source: str = ""
    """Where weight, stretch and bending come from."""

    def membrane(self, cloth_stretch: float) -> float:
        """Its membrane stiffness, N/m, in a garment of that `Pattern.cloth_stretch`.

        Such a garment is made of what gives: woven cloth with a few per cent of elastane, not without.
        """
        return min(self.stretch, STRETCHY) if cloth_stretch else self.stretch

    @property
    def is_measured(self) -> bool:
        """Whether a source says so; else they are estimated."""
        return self.source not in ("", "estimated")

    def __post_init__(self) -> None:
        for f in fields(self)[1:6]:
            value = getattr(self, f.name)
            low = 0.0 if f.name in ("bending", "friction") else 1e-6
            if not (isinstance(value, int | float) and math.isfinite(value) and low <= value <= 1e7):
                raise InputError(
                    f"Fabric '{self.name}': {f.name} must be a number of at least {low:g}, got {value!r}."
                )

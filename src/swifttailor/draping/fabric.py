"""Cloth materials in physical units."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields

from swifttailor.errors import InputError


@dataclass(frozen=True)
class Fabric:
    """Mechanical properties of a cloth.

    The presets follow the ranges that the Kawabata evaluation system reports for each kind of cloth
    (bending rigidity, weight). Stretch stiffness is limited from above by what the solver resolves in one
    frame: woven cloth then gives by well under one per cent under its own weight.
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

    def __post_init__(self) -> None:
        for f in fields(self)[1:]:
            value = getattr(self, f.name)
            low = 0.0 if f.name in ("bending", "friction") else 1e-6
            if not (isinstance(value, int | float) and math.isfinite(value) and low <= value <= 1e7):
                raise InputError(
                    f"Fabric '{self.name}': {f.name} must be a number of at least {low:g}, got {value!r}."
                )


FABRICS: dict[str, Fabric] = {
    f.name: f
    for f in (
        Fabric("cotton", density=0.15, stretch=1000.0, bending=1e-5),
        Fabric("denim", density=0.40, stretch=2000.0, bending=8e-5, friction=0.6, thickness=0.35),
        Fabric("silk", density=0.08, stretch=800.0, bending=3e-6, friction=0.3, thickness=0.25),
        Fabric("jersey", density=0.20, stretch=300.0, bending=4e-6, friction=0.6),
    )
}
"""The presets by name."""


def get_fabric(fabric: Fabric | str) -> Fabric:
    """A preset by name; a fabric is itself.

    Raises:
        InputError: There is no such preset.
    """
    if isinstance(fabric, str) and fabric not in FABRICS:
        raise InputError(f"There is no fabric '{fabric}'. Known fabrics: {', '.join(FABRICS)}.")
    return FABRICS[fabric] if isinstance(fabric, str) else fabric

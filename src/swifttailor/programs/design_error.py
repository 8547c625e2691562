"""The error of designs that cannot be drafted."""

from __future__ import annotations

from swifttailor.errors import InputError


class DesignError(InputError):
    """Design parameters that make no garment, or one that GarmentCode refuses."""

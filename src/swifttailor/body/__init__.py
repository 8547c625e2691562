"""The body a garment is sewn around: a mesh, its measurements, and the distance to its surface.

May import the lowest floors (errors, files). The names below are loaded on first use, so importing this room
costs next to nothing.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from swifttailor.first_use import loaded_on_first_use
from swifttailor.numba_cache import provide_numba_cache

if TYPE_CHECKING:
    from swifttailor.body.body import Body
    from swifttailor.body.distance_field import DistanceField
    from swifttailor.body.measurements import BodyMeasurements
    from swifttailor.body.measuring import girth, measure_body
    from swifttailor.body.parts import BodyPart
    from swifttailor.body.surface_distance import SurfaceTree, signed_distance
    from swifttailor.body.wearer import body_for

_PUBLIC = {
    "Body": "body",
    "BodyMeasurements": "measurements",
    "BodyPart": "parts",
    "DistanceField": "distance_field",
    "SurfaceTree": "surface_distance",
    "body_for": "wearer",
    "girth": "measuring",
    "measure_body": "measuring",
    "signed_distance": "surface_distance",
}

__all__ = [
    "Body",
    "BodyMeasurements",
    "BodyPart",
    "DistanceField",
    "SurfaceTree",
    "body_for",
    "girth",
    "measure_body",
    "signed_distance",
]


provide_numba_cache(Path(__file__).parent)  # before any kernel, here or in draping, is imported


__getattr__ = loaded_on_first_use(__name__, _PUBLIC)


def __dir__() -> list[str]:
    return __all__

"""GarmentSewer (paper, Sec. 4.3): the network that turns a pattern's images into its geometry image.

May import ggi, draping (its coarse drape), networks and what lies below them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from swifttailor.first_use import loaded_on_first_use

if TYPE_CHECKING:
    from swifttailor.garment_sewer.sewer import GarmentSewer

_PUBLIC = {
    "GarmentSewer": "sewer",
}

__all__ = [
    "GarmentSewer",
]

__getattr__ = loaded_on_first_use(__name__, _PUBLIC)

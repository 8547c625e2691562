"""What the networks learn from: drapes in shards, captions, edits, renders (paper, Sec. 5.1).

May import tailor's floor and everything below it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from swifttailor.first_use import loaded_on_first_use

if TYPE_CHECKING:
    from swifttailor.data.edits.pairs import geometric_pairs
    from swifttailor.data.garmentcodedata import GarmentCodeData, read_sample_folder
    from swifttailor.data.geometry_images import GeometryImages
    from swifttailor.data.reader import SplitReader
    from swifttailor.data.renders.files import SplitRenders

_PUBLIC = {
    "GarmentCodeData": "garmentcodedata",
    "GeometryImages": "geometry_images",
    "SplitReader": "reader",
    "SplitRenders": "renders.files",
    "geometric_pairs": "edits.pairs",
    "read_sample_folder": "garmentcodedata",
}

__all__ = [
    "GarmentCodeData",
    "GeometryImages",
    "SplitReader",
    "SplitRenders",
    "geometric_pairs",
    "read_sample_folder",
]

__getattr__ = loaded_on_first_use(__name__, _PUBLIC)

"""Folders laid out like GarmentCodeData, and the captions and edits that GCD-MM adds to them."""

from __future__ import annotations

from swifttailor.data.garmentcodedata.dataset import GarmentCodeData, SampleFolder, read_split_lists
from swifttailor.data.garmentcodedata.multimodal import EditPair, read_captions, read_edit_pair
from swifttailor.data.garmentcodedata.sample_folder import read_sample_folder

__all__ = [
    "EditPair",
    "GarmentCodeData",
    "SampleFolder",
    "read_captions",
    "read_edit_pair",
    "read_sample_folder",
    "read_split_lists",
]

"""What is known of the folders of one system."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import PurePosixPath

from swifttailor.data.released.known_place import KnownPlace
from swifttailor.data.released.listing import Listing
from swifttailor.pattern import Reading, read_pattern_file
from swifttailor.pattern.panel import RotationReading


@dataclass(frozen=True)
class Answer:
    """Where a folder holds one output."""

    input: str
    """Name of the input that it answers."""
    file: PurePosixPath | None
    """Its file, relative to the folder."""
    part: str = ""
    """Which garment of the answer it is, where an answer has several: ``upper``."""
    error: str = ""
    """Why there is no file."""


@dataclass(frozen=True)
class Layout:
    """How a system names and nests its files."""

    name: str
    system: str
    """Its name in messages."""
    looks_like: str
    """The file that tells it, for messages."""
    rotation: RotationReading
    """How its placement angles are meant."""
    answers: Callable[[Listing], list[Answer]]
    """All outputs of a folder; none where the folder is not of this system."""
    read: Callable[[Listing, Answer], Reading] | None = None
    """Reads an output's file; None for the pattern format of GarmentCode and its forerunners."""

    place: KnownPlace | None = None
    """The body that its patterns are placed around, where panels are called by numbers."""

    def reading(self, listing: Listing, answer: Answer) -> Reading:
        """Reads the file of an answer that has one.

        Raises:
            SwiftTailorError: It is damaged, or holds no pattern.
        """
        assert answer.file is not None
        if self.read is not None:
            return self.read(listing, answer)
        return read_pattern_file(listing.root / answer.file, rotation=self.rotation)

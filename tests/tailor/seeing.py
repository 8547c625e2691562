"""A reader of pictures that says what it is told to: everything that is made of it is real."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from swifttailor.describing.claims import Claim
from swifttailor.picture_reader.figures import Figures
from swifttailor.picture_reader.reading import (
    Measure,
    PartReading,
    PictureReading,
    SeenCells,
    Statement,
)
from swifttailor.render import Camera


def worn(
    name: str, said: dict[str, tuple[str, float]], measures: tuple[Measure, ...] = (), covers: float = 0.5
) -> PartReading:
    """What is worn on a part of the body.

    Args:
        name: Of the part.
        said: Word and certainty, by claim.
        measures: Of it.
        covers: Share of the picture that it covers.
    """
    found = [Statement(Claim(claim, word), certain) for claim, (word, certain) in said.items()]
    found.sort(key=lambda s: -s.certainty)
    return PartReading(name, 0.97, tuple(found), measures, (), np.full((1, 1), covers, np.float32))


class Seeing:
    """Answers with the next of its readings each time, and with the last from then on."""

    def __init__(
        self,
        *readings: tuple[PartReading, ...],
        figures: Figures = "one",
        cells: SeenCells | None = None,
        is_plain: bool = False,
        is_photograph: bool = False,
        is_laid: bool = False,
        azimuth: float = 0.0,
    ) -> None:
        self.is_photograph, self.is_laid = is_photograph, is_laid
        self.cells, self.is_plain, self.camera = cells, is_plain, Camera(azimuth=azimuth)
        self.card = {"model": "PictureReader", "parameters": 5}
        self.readings, self.figures = list(readings), figures
        self.shown: list[np.ndarray] = []

    def read(self, pixels):
        parts = self.readings[min(len(self.shown), len(self.readings) - 1)] if self.readings else ()
        self.shown.append(pixels)
        height, width = pixels.shape[:2]
        found = []
        for part in parts:
            mask = np.zeros((height, width), np.float32)
            mask[: round(height * float(part.mask[0, 0]))] = 1
            found.append(replace(part, mask=mask, cells=self.cells))
        box = 0, 0, width, height
        read = PictureReading(tuple(found), self.camera, box, self.figures, 0.9, self.is_plain)
        return replace(read, is_photograph=self.is_photograph, is_laid=self.is_laid)

"""What was read of a picture."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.describing.claims import Claim
from swifttailor.picture_reader.figures import Figures
from swifttailor.picture_reader.seen_design import SeenDesign
from swifttailor.picture_reader.seen_print import SeenPrint
from swifttailor.render import Camera

TOLD = 0.3
"""What is less sure is not told to people."""


@dataclass(frozen=True)
class Statement:
    """Something that a picture says of a garment."""

    claim: Claim
    certainty: float
    """0 to 1: of what is said with 0.9, nine in ten hold."""


@dataclass(frozen=True)
class Measure:
    """A dimension as a picture shows it."""

    name: str
    """Of `describing.dimensions.DIMENSIONS`."""
    value: float
    """cm, pieces or a ratio."""
    off: float
    """Half of such measures are off by at most this."""
    certainty: float
    """That the garment has such a thing at all."""


@dataclass(frozen=True)
class SeenPanel:
    """A panel that the pattern of the garment has."""

    name: str
    certainty: float
    box: tuple[float, float, float, float, float]
    """Where its middle is placed, x, y, z, and the sides of its flat outline, cm."""


@dataclass(frozen=True, eq=False)
class SeenCells:
    """What each cell of the square around a garment shows; row 0 at the top."""

    box: tuple[int, int, int, int]
    """The square of the picture: left, top, right, bottom; may lie outside."""
    mask: NDArray[np.float32]
    """(n, n) 0 to 1: where the garment is."""
    places: NDArray[np.float32]
    """(n, n, 3) where on the wearer it looks, cm, as on the default body that stands: docs/conventions.md."""
    kinds: NDArray[np.uint8]
    """(n, n) number of the likeliest of `panel_kinds.PANEL_KINDS`; anything where no garment is."""


@dataclass(frozen=True, eq=False)
class PartReading:
    """What is worn on one part of the body."""

    part: str
    """``upper`` (dresses and jumpsuits too) or ``lower``."""
    certainty: float
    """That anything is worn there."""
    statements: tuple[Statement, ...]
    """Of each claim the likeliest words, surest first."""
    measures: tuple[Measure, ...]
    panels: tuple[SeenPanel, ...]
    mask: NDArray[np.float32]
    """(h, w) where in the picture it is, 0 to 1."""
    cells: SeenCells | None = None
    """The same and more, of the square that was looked at."""
    design: SeenDesign | None = None
    """Where the network reads design parameters."""
    called: str = ""
    """What clothes are called in photographs that a network has learnt from: "Shirt"; where it is sure of
    that. On somebody jackets and coats alone have a name, "Outwear"."""
    print: SeenPrint | None = None
    """Of its cloth; None of plain cloth, where that is not sure, and in drawn pictures."""

    def certainty_of(self, claim: str, word: str) -> float:
        """How sure a statement is; 0 where it is not among those that were read."""
        return next((s.certainty for s in self.statements if s.claim == Claim(claim, word)), 0.0)


@dataclass(frozen=True, eq=False)
class PictureReading:
    """What a picture shows."""

    parts: tuple[PartReading, ...]
    """Those where something is worn, surest first."""
    camera: Camera
    """That shows the wearer as the crop does."""
    box: tuple[int, int, int, int]
    """The square of the picture that the camera shows: left, top, right, bottom; may lie outside."""
    figures: Figures = "one"
    """How many people there are; ``none`` where there is no garment either."""
    figures_certainty: float = 1.0
    is_plain: bool = False
    """Whether it looks like those of GarmentCodeData, which networks read that know no others."""
    is_laid: bool = False
    """Whether nobody wears what it shows; a network reads it that knows no others."""

    is_photograph: bool = False
    """Whether it is seen to be no drawing."""

    @property
    def face(self) -> str:
        """Which side of the wearer is seen: ``front``, ``back`` or ``side``."""
        facing = float(np.cos(np.deg2rad(self.camera.azimuth)))
        return "front" if facing > _FRONTAL else "back" if facing < -_FRONTAL else "side"

    @property
    def shown(self) -> str:
        """Which side is seen, in words, and where nobody wears it that, too."""
        return f"{self.face}, worn by nobody" if self.is_laid else self.face

    def to_json(self) -> dict[str, Any]:
        """For a report."""
        return {
            "figures": self.figures,
            "figures_certainty": round(self.figures_certainty, 3),
            "side": self.face,
            "worn": not self.is_laid,
            "photograph": self.is_photograph,
            "box": list(self.box),
            "parts": [
                {
                    "part": part.part,
                    "certainty": round(part.certainty, 3),
                    "statements": [
                        s.claim.to_json() | {"certainty": round(s.certainty, 3)}
                        for s in part.statements
                        if s.certainty >= TOLD
                    ],
                    "measures": [
                        {
                            "name": m.name,
                            "value": round(m.value, 1),
                            "off": round(m.off, 1),
                            "certainty": round(m.certainty, 3),
                        }
                        for m in part.measures
                        if m.certainty >= TOLD
                    ],
                    "panels": [
                        {"name": p.name, "certainty": round(p.certainty, 3)}
                        for p in part.panels
                        if p.certainty >= TOLD
                    ],
                }
                for part in self.parts
            ],
        }


_FRONTAL = 0.5
"""Cosine of 60 degrees."""

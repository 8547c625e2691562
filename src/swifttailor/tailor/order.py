"""What a tailor is asked for."""

from __future__ import annotations

import unicodedata
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from swifttailor.errors import InputError
from swifttailor.pattern import Pattern
from swifttailor.pattern_maker.temperatures import USUAL_TEMPERATURE

MOST_SAMPLES = MOST_ATTEMPTS = 64
USUAL_ATTEMPTS = 4
LONGEST_TITLE = 60

Image = NDArray[np.uint8] | Path | str


@dataclass(frozen=True, eq=False)
class Order:
    """A garment that is wanted, or several, and how to make them."""

    text: str = ""
    """Description; the instruction where there is a pattern to edit."""
    image: Image | None = None
    """(h, w, 3) sRGB with row 0 at the top, or a file."""
    edit: Pattern | None = None
    """Pattern to change."""
    crop: bool = True
    """Whether a picture with a plain background is cropped to what stands before it (`framing`)."""
    samples: int = 1
    """How many are made."""
    seed: int = 0
    """Of the first; each has one more than the one before."""
    temperature: float = USUAL_TEMPERATURE
    """0 takes the likeliest token always, 1 draws tokens by their probability. Each attempt is
    drawn at 0.15 more than the one before."""
    attempts: int | None = None
    """Patterns that are written at most until one can be sewn (the paper's sampling attempts); 4, or 1 at
    temperature 0, when None."""
    alter: bool = True
    """Whether patterns are recut until what the text asks for holds, as far as that can be cut."""
    edge_length: float = 2.0
    """Of the mesh, cm."""
    finish: bool = False
    """Whether the garment hangs to rest by physics in the end."""

    def __post_init__(self) -> None:
        if not 1 <= self.samples <= MOST_SAMPLES:
            raise InputError(f"samples is {self.samples}; 1 to {MOST_SAMPLES} is accepted.")
        if self.attempts is not None and not 1 <= self.attempts <= MOST_ATTEMPTS:
            raise InputError(f"attempts is {self.attempts}; 1 to {MOST_ATTEMPTS} is accepted.")
        if self.temperature == 0 and max(self.samples, self.attempts or 1) > 1:
            many = "samples" if self.samples > 1 else "attempts"
            raise InputError(f"At temperature 0 all {many} are the same. Give a temperature above 0.")

    @property
    def most_attempts(self) -> int:
        """`attempts`, or what is usual."""
        if self.attempts is not None:
            return self.attempts
        return USUAL_ATTEMPTS if self.temperature > 0 else 1

    @property
    def title(self) -> str:
        """A name for the pattern: what was asked for, on one short line."""
        asked = one_line(self.text)
        if self.edit is not None:
            asked = f"{one_line(self.edit.name)}: {asked}"
        if not asked and isinstance(self.image, Path | str):
            asked = one_line(Path(self.image).stem)
        return asked or "pattern"

    def to_json(self) -> dict[str, object]:
        """For a report: what was given, and all that decides what comes of it; no paths."""
        return {
            "text": self.text,
            "image": Path(self.image).name if isinstance(self.image, Path | str) else self.image is not None,
            "edited": self.edit.name if self.edit is not None else None,
            "crop": self.crop,
            "temperature": self.temperature,
            "attempts": self.most_attempts,
            "alter": self.alter,
        }


def one_line(text: str, longest: int = LONGEST_TITLE) -> str:
    """A text for people on one line: no control characters, single spaces, cut where it is long."""
    shown = text[: 20 * longest]
    seen = "".join(" " if c.isspace() or unicodedata.category(c)[0] == "C" else c for c in shown)
    line = " ".join(seen.split())
    return line if len(line) <= longest and len(shown) == len(text) else line[: longest - 3].rstrip() + "..."

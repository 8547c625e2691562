"""What a tailor is asked for."""

from __future__ import annotations

import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from swifttailor.errors import InputError
from swifttailor.pattern import Pattern
from swifttailor.pattern_maker.temperatures import USUAL_TEMPERATURE

if TYPE_CHECKING:
    from swifttailor.body import Body
    from swifttailor.draping.fabric import Fabric
    from swifttailor.garment.cloth_print import ClothPrint
    from swifttailor.garment.part_looks import PartLook
    from swifttailor.tailor.looking import SeenPicture
    from swifttailor.wishes.outfits.two_garments import TwoGarments

MOST_SAMPLES = MOST_ATTEMPTS = 64
USUAL_ATTEMPTS = 4
USUAL_REFINED, MOST_REFINED = 4, 32
LONGEST_TITLE = 60

Image = NDArray[np.uint8] | Path | str
Source = Literal["both", "drafts", "designs", "library", "writer"]
"""Where patterns come from: drafts that words name, drafts of design parameters that are read in pictures
and words, known patterns, and written ones where none of these will do; or one of the four alone."""
Part = Literal["upper", "lower", "whole", "beside"]
"""Where a garment of a picture, or of a text that names two, is worn; ``whole`` is one garment, of a picture
a dress or jumpsuit. Of two that a text names of which one is worn over the other, ``upper`` is that on top;
``beside`` is a third: the waistcoat of a suit."""
MOST_PICTURES = 2
NO_READER = (
    "Pictures cannot be read: this version comes without weights of a picture reader. Train one (see "
    "docs/picture-reader.md) and give its model file, as --picture-reader-weights or picture_reader=."
)


@dataclass(frozen=True, eq=False)
class Order:
    """A garment that is wanted, or several, and how to make them."""

    text: str = ""
    """Description; the instruction where there is a pattern to edit."""
    image: Image | SeenPicture | Sequence[Image | SeenPicture] | None = None
    """(h, w, 3) sRGB with row 0 at the top, a file, or what was read of one (`Tailor.look`); or two of the
    same garment, front and back."""
    edit: Pattern | None = None
    """Pattern to change."""
    color: str | None = None
    """Of the cloth of the garment to change, ``#rrggbb``; what its pattern has by itself when None."""
    print: ClothPrint | None = None
    """Of the cloth of the garment to change."""
    looks: tuple[PartLook, ...] = ()
    """Of parts of the garment to change that look otherwise than the rest."""
    part: Part | None = None
    """Which of the garments in the picture; the one that covers most of it when None. Without a picture which
    of the two that the text names (`wishes.two_garments`); one garment of the whole text when None."""
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
    """Patterns that are tried at most until one can be sewn (the paper's sampling attempts); 4, or 1 at
    temperature 0, when None."""
    refine: int | None = None
    """Known patterns that are sewn and compared with the pictures, of which the most alike is taken; 4 when
    None, and 0 takes the one that fits best what was read."""
    source: Source = "both"
    """Edits are always written."""
    alter: bool = True
    """Whether patterns are recut until what the text asks for holds, as far as that can be cut."""
    fabric: Fabric | str | None = None
    """What it is made of; what the text names, or the tailor's, when None."""
    body: Body | None = None
    """Whom patterns are refitted to; the one that the text names, or the tailor's, when None."""
    edge_length: float = 2.0
    """Of the mesh, cm."""
    finish: bool = False
    """Whether the garment hangs to rest by physics in the end."""
    relax: bool = True
    """Whether the cloth falls for a moment: smooths seams, and gives wide skirts their folds."""

    def __post_init__(self) -> None:
        if len(self.images) > MOST_PICTURES:
            raise InputError(
                f"{len(self.images)} pictures were given; one is accepted, or a front and a back."
            )
        if self.part not in (None, *get_args(Part)):
            raise InputError(f"part is {self.part!r}; {', '.join(get_args(Part))} are accepted.")
        if self.part is not None and self.image is None and (self.edit is not None or not self.text.strip()):
            raise InputError(
                f"part is '{self.part}' and there is neither a picture nor a description; leave part out."
            )
        if self.part == "beside" and (self.outfit is None or not self.outfit.third):
            raise InputError("part is 'beside' and the text names no third garment: leave part out.")
        if self.is_of_two and self.outfit is None:
            raise InputError(
                f"part is '{self.part}' and the text names no two garments, one for the upper body and one "
                "for the lower: leave part out."
            )
        if self.source not in get_args(Source):
            raise InputError(f"source is {self.source!r}; {', '.join(get_args(Source))} are accepted.")
        if self.source in ("library", "designs") and (self.edit is not None or not self.alter):
            what = "Known patterns" if self.source == "library" else "Drafts of designs"
            raise InputError(f"{what} are there to be altered, and not for edits: leave source out.")
        if not 1 <= self.samples <= MOST_SAMPLES:
            raise InputError(f"samples is {self.samples}; 1 to {MOST_SAMPLES} is accepted.")
        if self.attempts is not None and not 1 <= self.attempts <= MOST_ATTEMPTS:
            raise InputError(f"attempts is {self.attempts}; 1 to {MOST_ATTEMPTS} is accepted.")
        if self.refine is not None and not 0 <= self.refine <= MOST_REFINED:
            raise InputError(f"refine is {self.refine}; 0 to {MOST_REFINED} is accepted.")
        if self.refine and self.image is None:
            raise InputError(
                f"refine is {self.refine} and there is no picture to compare with: leave it out."
            )
        if self.temperature == 0 and max(self.samples, self.attempts or 1) > 1:
            many = "samples" if self.samples > 1 else "attempts"
            raise InputError(f"At temperature 0 all {many} are the same. Give a temperature above 0.")

    @property
    def images(self) -> tuple[Image | SeenPicture, ...]:
        """All pictures."""
        if self.image is None:
            return ()
        many = isinstance(self.image, Sequence) and not isinstance(self.image, str)
        return tuple(self.image) if many else (self.image,)

    @property
    def is_of_two(self) -> bool:
        """Whether it is about one of two garments that the text names, or about the third beside them."""
        return self.part in ("upper", "lower", "beside") and self.image is None

    @property
    def outfit(self) -> TwoGarments | None:
        """The two garments that the description names; None where it names one."""
        from swifttailor.wishes.outfits.two_garments import two_garments

        return two_garments(self.text) if self.edit is None and self.text.strip() else None

    @property
    def words(self) -> str:
        """The text; where it is about one of two garments, what the text says of that."""
        if not self.is_of_two or (outfit := self.outfit) is None:
            return self.text
        if self.part == "beside":
            return outfit.third
        return outfit.upper if self.part == "upper" else outfit.lower

    @property
    def most_attempts(self) -> int:
        """`attempts`, or what is usual."""
        if self.attempts is not None:
            return self.attempts
        return USUAL_ATTEMPTS if self.temperature > 0 else 1

    @property
    def may_be_designed(self) -> bool:
        """Whether the pattern may be drafted from parameters that are read."""
        return self.source in ("both", "designs") and self.edit is None and self.alter

    @property
    def most_refined(self) -> int:
        """`refine`, or what is usual."""
        return USUAL_REFINED if self.refine is None else self.refine

    @property
    def title(self) -> str:
        """A name for the pattern: what was asked for, on one short line."""
        asked = one_line(self.words)
        if self.edit is not None:
            asked = f"{one_line(self.edit.name)}: {asked}"
        if not asked and self.images:
            asked = one_line(Path(_name(self.images[0]) or "").stem)
            asked = f"{asked} {self.part}".strip() if self.part else asked
        return asked or "pattern"

    def to_json(self) -> dict[str, object]:
        """For a report: what was given, and all that decides what comes of it; no paths."""
        return {
            "text": self.text,
            "words": self.words if self.is_of_two else None,
            "images": [_name(one) or True for one in self.images],
            "part": self.part,
            "edited": self.edit.name if self.edit is not None else None,
            "crop": self.crop,
            "temperature": self.temperature,
            "attempts": self.most_attempts,
            "refine": self.most_refined if self.images else 0,
            "source": self.source,
            "alter": self.alter,
        }


def _name(image: Image | SeenPicture) -> str | None:
    """Of its file; None where it came as an array."""
    if isinstance(image, Path | str):
        return Path(image).name
    return None if isinstance(image, np.ndarray) else image.name or None


def one_line(text: str, longest: int = LONGEST_TITLE) -> str:
    """A text for people on one line: no control characters, single spaces, cut where it is long."""
    shown = text[: 20 * longest]
    seen = "".join(" " if c.isspace() or unicodedata.category(c)[0] == "C" else c for c in shown)
    line = " ".join(seen.split())
    return line if len(line) <= longest and len(shown) == len(text) else line[: longest - 3].rstrip() + "..."

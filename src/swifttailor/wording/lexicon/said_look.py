"""What a text says of how one part looks."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from swifttailor.wording.lexicon.colors import NamedColor

if TYPE_CHECKING:
    from swifttailor.wording.lexicon.reading import WordMark

WHOLE = "all"
"""The part that is the whole garment."""
OPAQUE, OTHER = "opaque", "other"


@dataclass(frozen=True, slots=True)
class SaidLook:
    """That a part looks otherwise, or that the whole garment is of a sheer cloth."""

    part: str
    """A part that words can name, `WHOLE`, or something that is put on: "buttons"."""
    noun: str
    """As the text has it; empty of the whole garment."""
    color: NamedColor | None = None
    cloth: str | None = None
    """A key of `garment.part_looks.OPACITIES`, with ``lined_`` before what lies on a lining; or
    ``contrast``: another colour than the garment's; or ``other``: a cloth that is not sheer."""
    said: bool = True
    """Whether a word about the look says so; otherwise the name of a garment implies it."""
    marks: tuple[WordMark, ...] = ()
    """The words for the look."""
    noun_marks: tuple[WordMark, ...] = ()
    """The words for the part."""

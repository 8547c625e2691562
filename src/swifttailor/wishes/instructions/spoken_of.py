"""What an instruction speaks of by its words, and so what of it a network may guess.

The network for people's own words says something of every text. Where it is not sure and no word speaks of
the part that it would change ("raglan", "make it cuter"), it is right in two of five texts, and in the others
something is changed that nobody asked for.
"""

from __future__ import annotations

import re
from collections.abc import Set
from dataclasses import dataclass

from swifttailor.describing.claims import CLAIM_TYPES, Claim
from swifttailor.describing.differences import Change, Gain, subject_of
from swifttailor.recutting.unasked import part_of
from swifttailor.wishes.instructions.change_parts import subjects_of
from swifttailor.wishes.instructions.change_words import find_parts
from swifttailor.wording.claim_kinds import fits_kind

UNNAMED = 0.7
"""What is read with less about a part that no word names is told and not done: of 736 instructions in
people's own words 12 such readings are meant and 16 are not."""
NEVER = 2.0
"""More than any certainty: where the garment lacks all the parts that are named, nothing else is done
instead."""
ONE_LEG = re.compile(
    r"(?<!\w)(?:left|right|one|other) (?:trouser |pant )?leg(?!\w)(?! of)"
    r"|(?<!\w)legs? of different lengths?(?!\w)",
    re.IGNORECASE,
)
"""One leg alone, which cannot be cut otherwise than the other."""
OF_LEGS = frozenset(
    {"legs", "leg_hem", "leg_cuffs", "leg length", "leg end", "leg cuff length", "thigh", "inseam_cm"}
)
HEM_CLAIMS = frozenset({"skirt_hem", "leg_hem", "top_hem"})
_SLITS = frozenset({"slit", "back_slit"})
_TO_WHERE = frozenset({"thigh", "legs", "leg_end", "hips", "back"})
"""Places that a slit reaches."""
_OF_LENGTHS = re.compile(r"(?<!\w)(?:long\w*|short\w*|length\w*|hem\w*|mini|midi|maxi)(?!\w)")
_UNEVEN = Gain(Claim("sides", "different"))
_OF_SIDES = re.compile(
    r"(?<!\w)(?:left|right|sides?|one|half|halves|a?symm?et\w*|uneven|unequal|lopsided|odd|mismatch\w*)(?!\w)"
)
_SIDED = frozenset({"left_sleeve", "right_sleeve"})
_OF_GARMENTS = frozenset({"sleeves", "collar", "hood", "straps", "skirt"})
"""Parts that are not called like places of the body."""
_ONE_SIDE = ("lower ", "bare ", "left only", "right only", "unequal", "high-low")
_OF_BODIES = {"hips": ("skirt", "legs"), "waist": ("waist", "bodice", "skirt", "legs"), "all": ()}
"""Places of the body, and the parts that are there."""


@dataclass(frozen=True)
class SpokenOf:
    """The parts that a text names."""

    parts: Set[str]
    """As `recutting.unasked` has them."""
    sided: bool = True
    """Whether it speaks of sides at all: "a different colour" makes none unlike the other."""
    lacking: bool = False
    """Whether the garment has none of those that are named."""
    of_slits_alone: bool = False
    """Whether it speaks of slits and of nothing else that ends somewhere."""

    def least(self, change: Change) -> float:
        """How sure a network has to be that a change is meant, for it to be done."""
        if self.lacking or self.is_none_of(change):
            return NEVER
        return 0.0 if self.speaks_of(change) else UNNAMED

    def is_none_of(self, change: Change) -> bool:
        """Whether a change makes the sides unlike each other, of which it does not speak at all."""
        return change == _UNEVEN and not self.sided

    def speaks_of(self, change: Change) -> bool:
        """Whether the part that a change is about is named."""
        return part_of(subject_of(change)) in self.parts


def parts_spoken_of(text: str, kind: str | None) -> SpokenOf:
    """The parts that an instruction names.

    Args:
        text: In any case.
        kind: Of the garment; None where that is not known.
    """
    named = {found.part for found in find_parts(text.lower())} - {"all"}
    subjects = {name: subjects_of(name) for name in named}
    parts = {part for some in subjects.values() for each in some if (part := part_of(each)) is not None}
    parts |= {part for name in named for part in _OF_BODIES.get(name, ())}
    lacking = bool(named) and kind is not None and all(is_lacking(name, kind) for name in named)
    sided = bool(named) or _OF_SIDES.search(text.lower()) is not None
    slits = bool(named & _SLITS) and named <= _SLITS | _TO_WHERE and _OF_LENGTHS.search(text.lower()) is None
    return SpokenOf(frozenset(parts), sided, lacking, slits)


def is_lacking(part: str | None, kind: str) -> bool:
    """Whether a garment of a kind has no such part; places of the body are there in any.

    Args:
        part: As `change_parts` has them.
        kind: Of the garment.
    """
    if part not in _OF_GARMENTS:
        return False
    claims = [each for each in subjects_of(part) if " " not in each and each in CLAIM_TYPES]
    return bool(claims) and not any(fits_kind(each, kind) for each in claims)


def is_of_places(change: Change) -> bool:
    """Whether words say it of one side or end of a garment: they tell left from right, a network does not."""
    if not isinstance(change, Gain):
        return False
    claim = change.claim
    return claim.name in _SIDED or str(claim.value).startswith(_ONE_SIDE)

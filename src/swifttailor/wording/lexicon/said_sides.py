"""Sleeves and legs that a text gives each its own colour: "one red sleeve and one white sleeve"."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from swifttailor.wording.lexicon.said_look import SaidLook

_PAIRS = ("sleeves", "legs")
_ONE = r"(?:one|a single|ein|eine|einen|einem|einer|un|une|una|unas?)"
_OTHER = (
    r"(?:(?:the |an)?other|another|die andere|der andere|das andere|den anderen|l['’]autre"
    r"|(?:la |el )otra|(?:el )?otro)"
)
_ONE_OF = re.compile(rf"{_ONE}\s", re.IGNORECASE)
_BEFORE = re.compile(rf"(?<!\w){_ONE}\s+$", re.IGNORECASE)
_OTHER_BEFORE = re.compile(
    rf"(?<!\w){_OTHER}(?:\s+(?:one|sleeve|leg|ärmel|bein|manche|manga|pierna))?(?:\s+(?:is|in|one|ist|en))*\s+$",
    re.IGNORECASE,
)


def with_sides(text: str, found: Sequence[SaidLook], others: Sequence[SaidLook]) -> list[SaidLook]:
    """The looks, those of one of two sleeves or legs on that alone: the left one first.

    Args:
        text: That was read.
        found: What is said of parts.
        others: The colours that are said of no part, which may be those of "the other one".
    """
    new: list[SaidLook] = []
    sides = dict.fromkeys(_PAIRS, 0)
    for look in found:
        side = _side_of(text, look, sides)
        new.append(look if side is None else replace(look, part=f"{side}_{look.part.removesuffix('s')}"))
    halved = [look for look, old in zip(new, found, strict=True) if look is not old]
    if not halved:
        return list(found)
    for other in others:
        before = text[: other.marks[0].start]
        if _OTHER_BEFORE.search(before) or _BEFORE.search(before):
            last = halved[-1]
            side = "right" if last.part.startswith("left") else "left"
            part = f"{side}_{last.part.split('_')[1]}"
            if part not in [look.part for look in new]:
                new.append(replace(last, part=part, color=other.color, cloth=None, marks=other.marks))
    return new


def _side_of(text: str, look: SaidLook, sides: dict[str, int]) -> str | None:
    """Which of two it is that a look is said of; None where it is both, or no such part."""
    if look.part not in _PAIRS or look.color is None or not look.marks or not look.noun_marks:
        return None
    noun = look.noun_marks[0]
    before = text[: min(noun.start, *[mark.start for mark in look.marks])]
    is_one = _BEFORE.search(before) or _OTHER_BEFORE.search(before) or _ONE_OF.match(noun.word)
    if noun.word.lower().endswith("s") or not is_one:
        return None
    sides[look.part] += 1
    return "left" if sides[look.part] == 1 else "right"

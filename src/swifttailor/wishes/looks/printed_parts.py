"""Prints that a text says of parts alone: "a white tee with striped sleeves", "collar in leopard"."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from swifttailor.garment.cloth_print import KINDS
from swifttailor.garment.part_looks import PANEL_PARTS
from swifttailor.wording.lexicon import WordMark, WordReading
from swifttailor.wording.lexicon.look_words import category_of

_BESIDE = re.compile(r"[\s-]*(?:(?:print(?:ed)?|pattern(?:ed)?|fabric)[\s-]+)?", re.IGNORECASE)
"""What may stand between a print and the part behind it."""
_BEHIND = re.compile(r"\s+(?:in|of|made of|made from)\s+(?:an?\s+)?", re.IGNORECASE)
"""What stands between a part and the print behind it."""
_ON = re.compile(r"\s+(?:on|at)\s+(?:(?:the|its|both|each|one)\s+)?", re.IGNORECASE)
"""What stands between a print and the part that it is on: "stripes on the sleeves"."""
_JOINED = re.compile(r"\s*(?:,|&|and|und|et|y|e|en)\s+(?:the\s+|an?\s+)?", re.IGNORECASE)
_OF_DRESSES = frozenset({"skirt", "back", "front", "lower_half", "legs"})
"""Parts that are named like garments or sides: they count behind "with" alone."""
_WITH = re.compile(r"(?<!\w)(?:with|but|has|having|and)(?:\s+(?:an?|the|its))?\s*$", re.IGNORECASE)
_NO_PANELS = re.compile(
    r"(?:pockets?|trims?|trimmings?|lining|belt|piping|edging|hem|bow|frills?|ruffles?|buttons?|yoke|patches"
    r"|ribbing|cuffs?)",
    re.IGNORECASE,
)
"""What is of the garment's print wherever it has one."""
_ALONE = re.compile(r"(?:(?:back |front |chest |patch )?pockets?|lining|belt)", re.IGNORECASE)
"""Of that, what "on" says that nothing else has the print."""
_APART = re.compile(r"(?:lining|belt|ribbing|piping)", re.IGNORECASE)
"""Of that, what has a print of its own where one stands before it, also without "with"."""


@dataclass(frozen=True)
class PrintedParts:
    """Which parts a print is on, where it is not on the whole."""

    parts: tuple[str, ...] = ()
    """Panels; a key of `PANEL_PARTS` each."""
    unmade: tuple[str, ...] = ()
    """What a print is said of in vain, as the text calls it: pockets, or sleeves beside a printed body."""
    on_whole: bool = False
    """Whether the whole has a print, and `unmade` another."""
    unused: tuple[WordMark, ...] = ()
    """The words for prints that are drawn on nothing."""
    nouns: tuple[WordMark, ...] = ()
    """The words for `parts` and `unmade`."""

    def __bool__(self) -> bool:
        return bool(self.parts or self.unmade)


ON_ALL = PrintedParts()
"""Where prints are on the whole."""


def printed_parts(text: str, words: WordReading) -> PrintedParts:
    """The parts that the prints of a text are said of; none where they are said of the whole.

    Args:
        text: That the lexicon has read.
        words: By the lexicon.
    """
    marks = words.marks
    prints = [k for k, mark in enumerate(marks) if _is_print(mark)]
    if not prints or not any(mark.role == "garment" for mark in marks):
        return ON_ALL
    said = [(marks[k].word.lower(), _said_of(text, marks, k)) for k in prints]
    on_whole = any(not of for _, of in said)
    first = next((name for name, of in said if any(m.part in PANEL_PARTS for m in of)), "")
    parts: list[str] = []
    unmade: list[str] = []
    for name, of in said:
        for mark in of:
            if not on_whole and name == first and mark.part in PANEL_PARTS:
                parts.append(str(mark.part))
            else:
                unmade.append(mark.word.lower())
    told = zip(prints, said, strict=True)
    unused = [marks[k] for k, (name, of) in told if of and (on_whole or name != first)]
    nouns = tuple([mark for _, of in said for mark in of])
    return PrintedParts(
        tuple(dict.fromkeys(parts)), tuple(dict.fromkeys(unmade)), on_whole, tuple(unused), nouns
    )


def _is_print(mark: WordMark) -> bool:
    return not mark.denied and any(
        entry.print is not None and entry.print.kind in KINDS for entry in mark.entries
    )


def _said_of(text: str, marks: Sequence[WordMark], k: int) -> list[WordMark]:
    """The parts beside a print, in the order of the text."""
    if category_of(marks[k]) != "prints":
        return []
    first = k
    while first > 0 and category_of(marks[first - 1]) in ("colors", "shades"):
        first -= 1  # "with a white polka dot skirt"
    said = _WITH.search(text[: marks[first].start]) is not None
    behind = [m for m in marks[k + 1 :] if category_of(m) != "function"]
    between = text[marks[k].end : behind[0].start] if behind else ""
    if behind and (
        (_is_part(behind, 0, said) and _BESIDE.fullmatch(between))
        or (_ON.fullmatch(between) and (_is_part(behind, 0, False) or _ALONE.fullmatch(behind[0].word)))
    ):
        found = [behind[0]]
        for n, mark in enumerate(behind[1:], 1):
            if not (_is_part(behind, n, said) and _JOINED.fullmatch(text[found[-1].end : mark.start])):
                break
            found.append(mark)
        return found
    before = [m for m in marks[:k] if category_of(m) != "function"]
    if before and _BEHIND.fullmatch(text[before[-1].end : marks[k].start]):
        return [before[-1]] if _is_part(before, len(before) - 1, False) else []
    return []


def _is_part(marks: Sequence[WordMark], n: int, said: bool) -> bool:
    """Whether a word is a part that a print can be said of; `said`: with "with" before the print."""
    mark = marks[n]
    if mark.denied or mark.role == "garment":
        return False
    if mark.part in PANEL_PARTS:
        return said or mark.part not in _OF_DRESSES
    of_garment = n + 1 < len(marks) and marks[n + 1].role == "garment"  # "a floral ruffle dress"
    apart = said or _APART.fullmatch(mark.word) is not None
    return apart and not of_garment and _NO_PANELS.fullmatch(mark.word) is not None

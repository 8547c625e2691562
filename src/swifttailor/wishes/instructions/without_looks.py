"""Instructions without what they say of how parts look, which cuts nothing: "make the collar white"."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from swifttailor.describing.claims import Claim
from swifttailor.describing.facts import GarmentFacts
from swifttailor.garment.part_looks import PANEL_PARTS, PARTS
from swifttailor.wording.lexicon import WordMark, WordReading

_HOLDS_TOGETHER = frozenset({"function", "polite", "degrees", "generic", "negations", "shades"})
_ONLY_CHANGES = re.compile(
    r"(?:make|turn|change|switch|swap|convert|dye|colou?r|recolou?r|set)(?: (?:the|it|its|them|this|all))?$",
    re.IGNORECASE,
)
_JOINS = re.compile(r"^\s*(?:,\s*)?(?:and|&|und|et|y|e)\s+", re.IGNORECASE)
_APART = re.compile(r"[,;.!?\n]")
_AND = frozenset({"and", "&", "und", "et", "y", "e", "but", "plus"})
_DEFINITE = frozenset({"the", "its", "his", "her", "my", "your", "those", "these"})
_NONE_OF = {
    "sleeves": "sleeves",
    "left_sleeve": "sleeves",
    "right_sleeve": "sleeves",
    "collar": "collar",
    "hood": "hood",
    "cuffs": "cuffs",
    "leg_cuffs": "leg_cuffs",
    "waistband": "waistband",
    "hem_band": "waistband",
}
"""Claims whose value is ``none`` of garments without the part."""


def without_looks(text: str, words: WordReading, facts: GarmentFacts | None) -> str:
    """The rest of an instruction; empty where it speaks of nothing but looks.

    A part that the garment has not is still asked for: of "a white collar" a collar.

    Args:
        text: That was read.
        words: By the lexicon.
        facts: Of the garment; None where it cannot be measured.
    """
    looks = [look for look in words.looks if look.said and look.part != "all"]
    if not looks:
        return text
    said = {id(mark) for look in looks for mark in look.marks}
    asked = _is_there(facts, words)
    gone = {id(mark) for look in looks if asked(look.part, look.noun_marks) for mark in look.noun_marks}
    kept = []
    for unit in _units(text, words.marks, said | gone):
        if any(id(mark) in said | gone for mark in unit) and all(
            _says_nothing(mark, said | gone) for mark in unit
        ):
            continue
        kept.append(_without(text, unit, said))
    return " ".join(each for each in kept if each.strip(" ,;.!?"))


def _is_there(facts: GarmentFacts | None, words: WordReading) -> Callable[[str, Sequence[WordMark]], bool]:
    def asked(part: str, marks: Sequence[WordMark]) -> bool:
        if part in _NONE_OF and facts is not None:
            return not Claim(_NONE_OF[part], "none").holds(facts)
        if part in PANEL_PARTS or part not in PARTS:
            return True
        place = [k for k, mark in enumerate(words.marks) if any(mark is one for one in marks)]
        before = [mark for k in place for mark in words.marks[max(0, k - 3) : k]]
        return any(mark.word.lower().split()[-1] in _DEFINITE for mark in before)

    return asked


def _units(text: str, marks: Sequence[WordMark], looked: set[int]) -> list[list[WordMark]]:
    """Words that are said of one thing: parted at commas, and at an "and" before a noun of its own."""
    units: list[list[WordMark]] = []
    for k, mark in enumerate(marks):
        apart = k > 0 and _APART.search(text[marks[k - 1].end : mark.start]) is not None
        if not units or apart or (mark.word.lower() in _AND and _begins(marks[k + 1 :], looked)):
            units.append([])
        units[-1].append(mark)
    return units


def _begins(marks: Sequence[WordMark], looked: set[int]) -> bool:
    """Whether these words have a noun of their own before the next "and"."""
    for mark in marks:
        if mark.word.lower() in _AND:
            return False
        if mark.part is not None or mark.word.lower() in ("it", "them"):
            return True
        if mark.entries and mark.entries[0].category in ("parts", "garments"):
            return True
    return False


def _says_nothing(mark: WordMark, looked: set[int]) -> bool:
    if id(mark) in looked or _ONLY_CHANGES.match(mark.word):
        return True
    return bool(mark.entries) and mark.entries[0].category in _HOLDS_TOGETHER


def _without(text: str, unit: Sequence[WordMark], said: set[int]) -> str:
    """The text of a unit without the words for looks, and what joined them to others."""
    pieces = []
    for k, mark in enumerate(unit):
        end = unit[k + 1].start if k + 1 < len(unit) else _end_of(text, mark.end)
        if id(mark) not in said:
            pieces.append(text[mark.start : end])
    shown = "".join(pieces)
    following = [unit[k + 1].word.lower() in _AND for k, m in enumerate(unit[:-1]) if id(m) in said]
    if any(following):  # "sheer and longer"
        first = next(k for k, m in enumerate(unit[:-1]) if id(m) in said and unit[k + 1].word.lower() in _AND)
        before = "".join(
            text[m.start : unit[k + 1].start] for k, m in enumerate(unit[:first]) if id(m) not in said
        )
        after = shown[len(before) :]
        shown = before + _JOINS.sub("", after, count=1)
    return shown.strip()


def _end_of(text: str, end: int) -> int:
    """Behind what closes a unit: a comma or a full stop."""
    found = re.match(r"\s*[,;.!?]*", text[end:])
    return end + (found.end() if found else 0)

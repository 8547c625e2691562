"""Numbers in a text, and what they are in cm."""

from __future__ import annotations

import re
from dataclasses import dataclass

from swifttailor.inches import CM_PER_INCH

_WORDS = (
    "zero one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen"
).split()
_TENS = {"eighteen": 18, "twenty": 20, "thirty": 30, "forty": 40, "fifty": 50, "sixty": 60, "seventy": 70}
_TENS |= {"eighty": 80, "ninety": 90}
_COUNTS: dict[str, float] = {word: float(k) for k, word in enumerate(_WORDS)} | {
    word: float(value) for word, value in _TENS.items()
}
_CM = {"mm": 0.1, "cm": 1.0, "m": 100.0, "in": CM_PER_INCH, "ft": 12 * CM_PER_INCH}
_SPOKEN = (
    r"millimet(?:re|er)s?|centimet(?:re|er)s?|met(?:re|er)s?|inch(?:es)?|foot|feet"
    r"|[cz]ent[ií]m(?:eter|[eè]tres?|etri|etro|[eé]tros?)n?|pouces?|zoll|pulgadas?|polegadas?|pollic[ei]|duim"
)
_SPOKEN_SMALL = r"centimet(?:re|er)s?|cms?|inch(?:es)?"
_UNIT = rf"{_SPOKEN}|mm|cms?|m|ins?|ft|[\"\u201d\u2033]"
_FEW = {"couple": 2.0, "few": 3.0, "a": 1.0}
_PARTS = {"half": 0.5, "third": 1 / 3, "quarter": 0.25}
_HALF = r"(?: and a half(?! (?:circle|moon))(?!\w))?"
_FIGURE = r"\d{1,5} \d/\d|\d/\d|\d{1,5}(?:[.,]\d{1,3})?"
# Not inside of a word or a longer number; "in" is no unit in "6 in the front".
_MENTION = re.compile(
    rf"(?<![\w.,/])(?:(?P<figure>{_FIGURE})(?:[ -]?(?!in (?:the|front|back|one)\b)(?P<unit>{_UNIT})(?!\w))?"
    rf"|(?P<few>an?|a couple(?: of)?|a few) (?P<few_unit>{_SPOKEN_SMALL})(?P<few_half>{_HALF})"
    rf"|(?P<part>half|(?:a )?third|(?:a )?quarter)(?: of)? an? (?P<whole>{_SPOKEN})"
    rf"|(?P<word>{'|'.join(_COUNTS)})(?![ -]quarter)"
    rf"(?:(?P<half> and a half)?[ -](?P<words_unit>{_SPOKEN}|cms?|mm))?)"
    r"(?![\w/])",
    re.IGNORECASE,
)
_LARGEST = 99_999.0


@dataclass(frozen=True)
class Mention:
    """A number in a text."""

    start: int
    end: int
    """Behind the last character, the unit included."""
    value: float
    """cm where it has a unit."""
    is_length: bool
    """Whether it has a unit."""


def find_mentions(text: str) -> list[Mention]:
    """The numbers of a text in their order, in figures or words, with units or without.

    Args:
        text: Of any length; the time is in proportion to it.
    """
    return [_mention(found) for found in _MENTION.finditer(text)]


def _mention(found: re.Match[str]) -> Mention:
    if found["few"]:
        count = next(number for word, number in _FEW.items() if word in found["few"].lower())
        count += 0.5 * bool(found["few_half"])
        return Mention(found.start(), found.end(), count * _CM[_unit(found["few_unit"].lower())], True)
    if found["part"]:
        value = _PARTS[found["part"].lower().split()[-1]] * _CM[_unit(found["whole"].lower())]
        return Mention(found.start(), found.end(), value, True)
    if found["word"]:
        value, unit = _COUNTS[found["word"].lower()], found["words_unit"]
        value += 0.5 * bool(found["half"])
        factor = _CM[_unit(unit.lower())] if unit else 1.0
        return Mention(found.start(), found.end(), value * factor, unit is not None)
    value = min(_figure(found["figure"]), _LARGEST)
    unit = found["unit"]
    if unit is None:
        return Mention(found.start(), found.end(), value, False)
    return Mention(found.start(), found.end(), value * _CM[_unit(unit.lower())], True)


def _unit(unit: str) -> str:
    if unit.startswith(("c", "zenti", "mm", "milli")):
        return "mm" if unit.startswith("m") else "cm"
    if unit.startswith("f"):
        return "ft"
    return "m" if unit.startswith("m") else "in"


def _figure(figure: str) -> float:
    total = 0.0
    for part in figure.replace(",", ".").split():
        above, _, below = part.partition("/")
        total += float(above) / float(below) if below and float(below) else float(above)
    return total

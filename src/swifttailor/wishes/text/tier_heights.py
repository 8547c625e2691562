"""How high tiers of a skirt are told to be: "first tier 30 cm", "top tier twice as long", "25 cm a tier"."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache

from swifttailor.pattern.drafts.draft_names import NamedDraft

_TIERED, _TIERS, _FIRST = "tiered-skirt", "tiers", "first"
_USUAL_TIERS, _BAND_CM, _USUAL_CM = 3, 4.0, 84.0
"""What the draft has where a text says nothing else: its tiers, height of band and length, cm."""
_TWO_FIRST, _TWO_FULL = 0.44, 1.6
"""The uppermost of two tiers as a part of both, and how wide each is over its edge: as one gathers by eye."""
_LEAST_CM = 8.0
_TIER = r"(?:tier|row|layer|flounce|ruffle|section|level|stage)"
_UPPER = rf"(?:first|top|upper|uppermost|1st|highest) {_TIER}"
_LOWER = rf"(?:second|bottom|lower|lowest|last|2nd|third|3rd|next) (?:{_TIER}|one)"
_LENGTH = r"(?P<number>\d+(?:[.,]\d+)?) ?(?P<unit>cm|centimet(?:er|re)s?|mm|inch(?:es)?|in\b|\")"
_MEASURED = re.compile(rf"(?P<which>{_UPPER}|{_LOWER})\b[^.;,\d]{{0,25}}?{_LENGTH}", re.IGNORECASE)
_COMPARED = re.compile(
    rf"{_UPPER}\b[^.;,\d]{{0,18}}?\b(?P<times>twice|two times|double|2x|2 times|three times|3 times|half|"
    rf"as long as|the same length as|longer than|shorter than)\b[^.;]{{0,30}}?"
    rf"(?:{_LOWER}|others?|rest|second|bottom)",
    re.IGNORECASE,
)
_EACH = re.compile(
    rf"{_LENGTH} ?(?:a|per|each|every|for each|for every|in each|/) ?{_TIER}\b"
    rf"|\b(?:each|every) {_TIER}\b[^.;,\d]{{0,20}}?{_LENGTH.replace('<', '<each_')}"
    rf"|{_TIER}s (?:of|at) {_LENGTH.replace('<', '<of_')}"
    rf"|{_TIER}s\b[^.;,\d]{{0,12}}?{_LENGTH.replace('<', '<deep_')}(?: (?:deep|high|long|tall|wide))? each\b",
    re.IGNORECASE,
)
"""Figures for all tiers alike."""
_LISTED = re.compile(
    rf"\b{_TIER}s\b(?: (?:of|are|at|measure|measuring|that are|which are|being|each|high|deep))*"
    r"\s*[:,(–-]?\s*(?P<list>\d{1,3}(?:[.,]\d)?(?: ?(?:cm|in(?:ch(?:es)?)?\b|\"))?"
    r"(?:(?:\s*[,/+–-]\s*(?:and |then )?|\s+(?:and|then)\s+|\s*&\s*)\d{1,3}(?:[.,]\d)?"
    r"(?: ?(?:cm|in(?:ch(?:es)?)?\b|\"))?){1,5})(?![\w%])",
    re.IGNORECASE,
)
"""Heights of tiers one after the other: "tiers 18, 22 and 26 cm"."""
_LISTED_CM = (5.0, 70.0)
_SHORTEST_CM, _LONGEST_CM = 36.0, 100.0
_TIMES: Mapping[str, float] = {
    **dict.fromkeys(("twice", "two times", "double", "2x", "2 times"), 2.0),
    **dict.fromkeys(("three times", "3 times"), 3.0),
    "half": 0.5,
    "as long as": 1.0,
    "the same length as": 1.0,
    "longer than": 1.5,
    "shorter than": 0.7,
}
_IN_CM: Mapping[str, float] = {"mm": 0.1, "i": 2.54, '"': 2.54, "c": 1.0}


def tier_as_said(draft: NamedDraft, text: str) -> NamedDraft:
    """A skirt in tiers, its uppermost as high as a text says; of two, less than half where it says nothing.

    Args:
        draft: As it goes with all else that is asked for.
        text: The words.
    """
    options = dict(draft.options)
    if draft.name != _TIERED or options.get("close"):
        return draft
    tiers = round(float(options.get(_TIERS, _USUAL_TIERS)))
    band = float(options.get("band_height", _BAND_CM))
    if (each := _each(text)) is not None:
        length = min(max(round(each * tiers + band, 1), _SHORTEST_CM), _LONGEST_CM)
        return replace(draft, options=tuple({**options, "length": length}.items()))
    if len(heights := listed_tiers(text)[0]) > 1:
        options |= {
            "length": min(max(round(sum(heights), 1), _SHORTEST_CM), _LONGEST_CM),
            _TIERS: len(heights),
        }
        options[_FIRST] = round(min(max(heights[0], _LEAST_CM), _LONGEST_CM / 2), 1)
        return replace(draft, options=tuple(options.items()))
    whole = float(options.get("length", _USUAL_CM)) - band
    first = _told(text, tiers, whole)
    if first is None and tiers == 2:
        first = _TWO_FIRST * whole
        options.setdefault("fullness", _TWO_FULL)
    if first is None:
        return draft
    options[_FIRST] = round(min(max(first, _LEAST_CM), whole - _LEAST_CM * (tiers - 1)), 1)
    return replace(draft, options=tuple(options.items()))


@lru_cache(maxsize=64)
def listed_tiers(text: str) -> tuple[tuple[float, ...], tuple[int, int]]:
    """Heights of tiers that are told one after the other, cm, and where; none where they are not.

    Args:
        text: In any case.
    """
    found = _LISTED.search(text)
    if found is None:
        return (), (0, 0)
    said = found["list"].lower()
    scale = 2.54 if re.search(r"in|\"", said) else 1.0
    heights = tuple([float(n.replace(",", ".")) * scale for n in re.findall(r"\d+(?:[.,]\d(?!\d))?", said)])
    if len(heights) > 6 or not all(_LISTED_CM[0] <= height <= _LISTED_CM[1] for height in heights):
        return (), (0, 0)
    return heights, found.span("list")


@lru_cache(maxsize=64)
def tier_figures(text: str) -> tuple[tuple[int, int], ...]:
    """Where figures stand that tell how high a tier is: start and end of each."""
    each = [(m.start(_of(m, "number")), m.end(_of(m, "unit"))) for m in _EACH.finditer(text)]
    each += [listed_tiers(text)[1]] if listed_tiers(text)[0] else []
    return (*[(m.start("number"), m.end("unit")) for m in _MEASURED.finditer(text)], *each)


def _of(found: re.Match[str], name: str) -> str:
    """The group of the way of saying that was found."""
    return next(f"{way}{name}" for way in ("", "each_", "of_", "deep_") if found[f"{way}{name}"])


def _each(text: str) -> float | None:
    """Height of every tier by the text, cm; None where it says nothing of it."""
    found = _EACH.search(text)
    return None if found is None else _in_cm(found[_of(found, "number")], found[_of(found, "unit")])


def _in_cm(number: str, unit: str) -> float:
    scale = next(value for key, value in _IN_CM.items() if unit.lower().startswith(key))
    return float(number.replace(",", ".")) * scale


def _told(text: str, tiers: int, whole: float) -> float | None:
    """Height of the uppermost tier by the text, cm; None where it says nothing of it."""
    for found in _MEASURED.finditer(text):
        height = _in_cm(found["number"], found["unit"])
        if re.fullmatch(_UPPER, found["which"], re.IGNORECASE):
            return height
        if tiers == 2:
            return whole - height
    compared = _COMPARED.search(text)
    if compared is None:
        return None
    times = _TIMES[compared["times"].lower()]
    return whole * times / (times + tiers - 1)

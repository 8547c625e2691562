"""Where a close skirt begins to flare, in figures: "flaring 25 cm above the hem", "a 20 cm flounce"."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft

_LENGTHS: Mapping[str, tuple[str, float]] = {
    "gored-skirt": ("length", 66.0),
    "mermaid-skirt": ("length", 96.0),
    "mermaid-dress": ("skirt_length", 100.0),
}
"""Drafts that are close above and flare below: the option of their length, and its usual value, cm."""
_CLOSE, _HIGHEST_CM, _LEAST_BELOW_CM = "close", 30.0, 8.0
_KNEE_CM, _HIP_CM = 58.0, 20.0
"""How far below the waist the knee and the hips are, cm."""
_NUMBER = r"(?P<number>\d+(?:[.,]\d+)?) ?(?P<unit>cm|centimet(?:er|re)s?|mm|inch(?:es)?|in\b|\")"
_FLARE = r"(?:flar\w*|flounced?|fishtail|trumpet|kick\w*|widen\w*|fulln?ess|godets?|fan\w*)"
_FROM = re.compile(
    rf"\b{_FLARE}\b[^.;\d]{{0,40}}?\b{_NUMBER} ?(?P<where>above|below|under|up from|from|off|over|before)"
    r"(?: the| my| its)? (?P<what>hem(?:line)?|bottom|floor|ground|knees?|hips?|waist(?:line)?)\b",
    re.IGNORECASE,
)
_HIGH = re.compile(
    rf"\b{_NUMBER}(?: deep| high| long| wide)? (?:flounced?|fishtail|trumpet)(?! sleeve)\b", re.IGNORECASE
)
_IN_CM: Mapping[str, float] = {"mm": 0.1, "i": 2.54, '"': 2.54, "c": 1.0}


def flare_as_said(draft: NamedDraft, text: str, claims: Sequence[Claim]) -> NamedDraft:
    """A close skirt that begins to flare where a text says so in figures; others as they are.

    Args:
        draft: As it goes with all else that is asked for.
        text: The words.
        claims: What is asked for: its length in figures counts before that of the draft.
    """
    options = dict(draft.options)
    if draft.name not in _LENGTHS or options.get("tiers"):
        return draft
    name, usual = _LENGTHS[draft.name]
    told = [c.value for c in claims if c.name == "length_cm" and isinstance(c.value, int | float)]
    length = float(options.get(name, usual))
    if told and draft.name != "mermaid-dress":
        length = float(told[0])
    close = _close(text, length)
    if close is None:
        return draft
    options[name] = length
    options[_CLOSE] = round(min(max(close, _HIGHEST_CM), length - _LEAST_BELOW_CM), 1)
    return replace(draft, options=tuple(options.items()))


def flare_figures(text: str) -> tuple[tuple[int, int], ...]:
    """Where figures stand that tell where a skirt begins to flare: start and end of each."""
    levels = [m for m in _FROM.finditer(text) if not _is_a_length(m)]
    found = [*levels, *_HIGH.finditer(text)]
    return tuple([(m.start("number"), m.end("unit")) for m in found])


def _close(text: str, length: float) -> float | None:
    """From the waist to where it begins to flare, cm; None where no figure says so."""
    found = _FROM.search(text)
    if found is not None and _is_a_length(found):
        found = None
    if found is not None:
        amount, what = _in_cm(found), found["what"].lower()
        if what.startswith(("hem", "bottom", "floor", "ground")):
            return length - amount
        if what.startswith("waist"):
            return amount
        if what.startswith("hip"):
            return _HIP_CM + amount
        return _KNEE_CM + (amount if found["where"].lower() in ("below", "under") else -amount)
    found = _HIGH.search(text)
    return None if found is None else length - _in_cm(found)


def _is_a_length(found: re.Match[str]) -> bool:
    """Whether a comma parts the flare from the knee: "flared, 3 cm below the knee" is how long it is."""
    before = found.string[found.start() : found.start("number")]
    return "," in before and found["what"].lower().startswith("knee")


def _in_cm(found: re.Match[str]) -> float:
    unit = found["unit"].lower()
    return float(found["number"].replace(",", ".")) * next(v for k, v in _IN_CM.items() if unit.startswith(k))

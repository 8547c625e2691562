"""Figures of trousers that no claim states: "rise 28 cm", "knee 46"; and words that figures make needless."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from functools import lru_cache

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.inches import CM_PER_INCH
from swifttailor.wishes.reader import Wish
from swifttailor.wording.lexicon import WordReading

_NUMBER = r"(?P<number>\d{1,3}(?:[.,]\d+)?)"
_UNIT = r"(?:[\s-]?(?P<unit>cm|centimet(?:er|re)s?|inch(?:es)?|in(?![\w-])|[\"”″]))?"
_BETWEEN = r"\s*(?:of|is|at|about|around|ca\.?|:|=)?\s*"


def _said_of(part: str, behind: str) -> tuple[re.Pattern[str], ...]:
    """What tells a figure of a part: its name before it, or behind it."""
    before = rf"(?<![\w-])(?:front |waist )?(?:{part})(?:s|\s+(?:width|girth|circumference|line))?(?!\w)"
    return (
        re.compile(rf"{before}{_BETWEEN}(?<![\d.,]){_NUMBER}(?!\d){_UNIT}(?!\s*(?:below|above|under))", re.I),
        re.compile(rf"(?<![\w.,]){_NUMBER}{_UNIT}\s*{behind}(?:{part})(?!\w)", re.I),
    )


_RISE = _said_of(r"rise|leibhöhe|tiro(?! interior)|montant", r"(?:front\s+)?")
_RISES = ("rise", "leibhöhe", "tiro", "montant")
_KNEE = _said_of(r"knees?|kniew\w+|genoux?|rodilla|ginocchio", r"(?:at|around|round)\s+(?:the\s+)?")
_RISES_CM, _KNEES_CM = (14.0, 40.0), (30.0, 110.0)
"""What rises and widths at the knee may be, cm."""
_FROM_WAIST_CM = 35.0
"""The rise of trousers that begin at the waist of the usual body, cm."""
_HIGH_CM, _LOW_CM = 2.5, 11.0
"""Trousers that begin less far below the waist are high, others mid, and from there on low."""
_TROUSERS = ("trousers", "shorts", "jumpsuit")
_LEG_WIDTH, _TO_THE_KNEE = "leg_width_cm", Claim("leg_hem", "knee")
_STRAIGHT = frozenset({Claim("legs", "straight"), Claim("legs", "tapered"), Claim("legs", "slim")})


def below_waist_cm(text: str) -> float | None:
    """How far below the waist trousers begin whose rise is told, cm; None where none is."""
    rise = _figure(text, _RISE, _RISES_CM)
    return None if rise is None else round(min(max(_FROM_WAIST_CM - rise, 0.0), 16.0), 1)


def knee_cm(text: str) -> float | None:
    """How wide legs are told to be around the knee, cm; None where nothing is told of it."""
    return _figure(text, _KNEE, _KNEES_CM)


def told_rises(text: str, kind: str | None) -> list[Claim]:
    """Where trousers begin whose rise is told, in words."""
    below = below_waist_cm(text) if kind in _TROUSERS[:2] else None
    if below is None:
        return []
    return [Claim("rise", "high" if below < _HIGH_CM else "mid" if below < _LOW_CM else "low")]


@lru_cache(maxsize=64)
def leg_figures(text: str) -> tuple[tuple[int, int], ...]:
    """Where such figures stand: start and end of each."""
    found = (*_found(text, _RISE, _RISES_CM), *_found(text, _KNEE, _KNEES_CM))
    return tuple([(m.start("number"), m.end("unit" if m["unit"] else "number")) for m in found])


def not_of_legs(text: str, unknown: Iterable[str]) -> tuple[str, ...]:
    """Words that no table has, but that of a rise that is told."""
    told = below_waist_cm(text) is not None
    return tuple([word for word in unknown if not (told and word.lower() in _RISES)])


def without_told_shapes(text: str, found: Iterable[Wish]) -> tuple[Wish, ...]:
    """Without shapes of legs in words where it is told how wide they end: of straight ones, 40 cm.

    Legs that are 48 cm wide at the knee do not end there.
    """
    wishes = tuple(found)
    names = {wish.change.claim.name for wish in wishes if isinstance(wish.change, Gain)}
    needless = _STRAIGHT if _LEG_WIDTH in names else frozenset()
    needless |= {_TO_THE_KNEE} if knee_cm(text) is not None else frozenset()
    return tuple([w for w in wishes if not isinstance(w.change, Gain) or w.change.claim not in needless])


def spans_of_told_shapes(text: str, words: WordReading, claims: Sequence[str]) -> list[tuple[int, int]]:
    """Where words stand for shapes of legs that figures say, too, and for the knees of such figures.

    Args:
        text: That was read.
        words: By the lexicon.
        claims: Names of the claims that are heard.
    """
    knees = [(m.start(), m.end()) for m in _found(text, _KNEE, _KNEES_CM)]
    if _LEG_WIDTH not in claims:
        return knees
    shapes = [m for m in words.marks if any(i.claim in _STRAIGHT for e in m.entries for i in e.implied)]
    return [*knees, *[(mark.start, mark.start + 1) for mark in shapes]]


def _figure(text: str, patterns: Sequence[re.Pattern[str]], bounds: tuple[float, float]) -> float | None:
    found = _found(text, patterns, bounds)
    return None if not found else _in_cm(found[0])


def _found(
    text: str, patterns: Sequence[re.Pattern[str]], bounds: tuple[float, float]
) -> list[re.Match[str]]:
    """Figures that may be meant, in cm or inches."""
    found = [m for pattern in patterns for m in pattern.finditer(text)]
    return [m for m in found if bounds[0] <= _in_cm(m) <= bounds[1]]


def _in_cm(found: re.Match[str]) -> float:
    unit = (found["unit"] or "cm").lower()
    return float(found["number"].replace(",", ".")) * (1.0 if unit.startswith("c") else CM_PER_INCH)

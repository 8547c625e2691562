"""How tall and how heavy a wearer is, as people write it."""

from __future__ import annotations

import re
from functools import cache

from swifttailor.wishes.wearers.body_said import KG_PER_POUND, POUNDS_PER_STONE, SaidBody, number
from swifttailor.wishes.wearers.body_words import any_of

_METRES = (
    r"(?P<m>[12][.,]\d{1,2})(?!\d)(?:\s?(?:m|metros?|mètres?|meter|metres?|mt)\b)?"
    r"|(?P<m1>[12])\s?(?:m|metros?|mètres?|meter)\s?(?P<c1>\d{2})(?!\d)"
)
_SHORTEST, _TALLEST = 140.0, 215.0
"""Of grown people, cm: numbers beyond them without words for the height are none."""
_LEAST, _MOST = 75.0, 225.0
_KG = (25.0, 260.0)


@cache
def _led() -> re.Pattern[str]:
    lead, people, after, garment = (any_of("heights", key) for key in ("lead", "people", "after", "garment"))
    return re.compile(
        rf"(?<![\w-])(?:(?:(?P<lead>{lead})[\s:=]+|{people}\s*[,(:]?\s+)(?:(?:is|ist|de|of|about|around|von|circa|ca\.?|etwa|environ)\s+)*"
        rf"(?:{_METRES}|(?P<cm>\d{{3}})(?!\d|[.,]\d)(?:\s?cm\b)?)"
        rf"(?!\w|\s*(?:kg|kilos?|lbs?|{garment})(?!\w))(?:\s+{after}(?!\w))?)",
        re.IGNORECASE,
    )


@cache
def _followed() -> re.Pattern[str]:
    after = any_of("heights", "after")
    return re.compile(
        rf"(?<![\w.,-])(?:{_METRES}|(?P<cm>\d{{2,3}})(?:\s?cm\b)?)\s+(?:{after})(?!\w|-)", re.IGNORECASE
    )


@cache
def _bare() -> re.Pattern[str]:
    garment = any_of("heights", "garment")
    return re.compile(
        r"(?<![\w.,-])(?:(?P<m>1[.,]\d{2})(?!\d)\s?m\b|(?P<m1>1)\s?(?:m|metros?|mètres?|meter)\s?(?P<c1>\d{2})(?!\d)"
        r"|(?:(?<=^)|(?<=[,;(])|(?<=[,;(]\s))(?P<alone>1[.,][4-9]\d)(?=\s*(?:[,;)]|\.(?!\d)|$)))(?!\s*(?:cm\b)?\s*"
        rf"{garment}(?!\w))",
        re.IGNORECASE,
    )


@cache
def _weight() -> re.Pattern[str]:
    weight, kilos, pounds, stone = (any_of("heights", key) for key in ("weight", "kilos", "pounds", "stone"))
    return re.compile(
        rf"(?:(?<!\w){weight}[\s:=]+(?:(?:is|ist|about|around|etwa|unos|environ)\s+)*)?(?<![\w.,])"
        rf"(?:(?P<kg>\d{{2,3}}(?:[.,]\d)?)\s?{kilos}(?!\w)|(?P<lb>\d{{2,3}})\s?{pounds}(?!\w)"
        rf"|(?P<st>\d{{1,2}})\s?{stone}(?!\w)(?:\s?(?P<stlb>\d{{1,2}})(?:\s?{pounds})?(?!\w))?)",
        re.IGNORECASE,
    )


_OF_CLOTH = re.compile(r"^\s*(?:of|de|/|per|pro)(?!\w)", re.IGNORECASE)
_BESIDE = re.compile(
    r"(?<![\w.,])(?P<cm>1[3-9]\d|20\d|21[0-5])\s?(?:cm\b)?\s*(?:[,;/]|and|und|et|y|con|with|mit)?\s*$", re.I
)
"""A height beside a weight: "188 cm 95 kg"."""
_BEHIND = re.compile(
    r"^\s*(?:[,;/]|and|und|et|y|con|with|mit|at|bei)?\s*(?P<cm>1[3-9]\d|20\d|21[0-5])\s?(?:cm\b|(?=\s*(?:[,.;]|$)))",
    re.I,
)
_OF_CLOTHES = re.compile(r"gr(?:ö|oe)(?:ß|ss)e|taille", re.IGNORECASE)
"""Words for a height that are words for sizes of clothes or the waist, too."""
_SURELY_CM, _PERHAPS_CM = 165.0, 150.0
_ANYTHING_LONG = re.compile(
    r"(?<!\w)(?:length|long|länge|lang|longueur|largo|hem)[\s:=]*(?:is|of|de|von)?\s*$", re.IGNORECASE
)


def hear_height(said: SaidBody) -> None:
    """Takes weight and height out of a text."""
    _hear_weight(said)
    for pattern, shortest in ((_led(), _SHORTEST), (_followed(), _LEAST), (_bare(), _SHORTEST)):
        if "height" in said.measures:
            return
        for match in pattern.finditer(said.text):
            groups = match.groupdict()
            tall = float(groups.get("cm") or 0.0)
            if groups.get("alone"):
                tall = 100.0 * number(groups["alone"])
            elif groups.get("m"):
                tall = 100.0 * number(groups["m"])
            elif groups.get("m1"):
                tall = 100.0 * float(groups["m1"]) + float(groups["c1"])
            if _is_size_or_waist(match, tall):
                continue
            if shortest <= tall <= _MOST and not _ANYTHING_LONG.search(said.text, 0, match.start()):
                said.measures["height"] = round(tall, 1)
                said.take(match)
                break


def _is_size_or_waist(match: re.Match[str], tall: float) -> bool:
    """Whether a number is a child's size ("Größe 146") or a waist ("Taille 140 cm") rather than a height."""
    groups = match.groupdict()
    if not groups.get("cm") or not _OF_CLOTHES.fullmatch(groups.get("lead") or ""):
        return False
    return tall < (_PERHAPS_CM if "cm" in match[0].lower() else _SURELY_CM)


def _hear_weight(said: SaidBody) -> None:
    for match in _weight().finditer(said.text):
        if _OF_CLOTH.search(said.text[match.end() :]):
            continue
        kg = number(match["kg"]) if match["kg"] else KG_PER_POUND * float(match["lb"] or 0.0)
        if match["st"]:
            kg = KG_PER_POUND * (POUNDS_PER_STONE * float(match["st"]) + float(match["stlb"] or 0.0))
        if not _KG[0] <= kg <= _KG[1]:
            continue
        said.kg = round(kg, 1)
        before, behind = said.text[: match.start()], said.text[match.end() :]
        near, far = _BESIDE.search(before), _BEHIND.search(behind)
        if near is not None and "height" not in said.measures:
            said.measures["height"] = float(near["cm"])
            before = before[: near.start()]
        elif far is not None and "height" not in said.measures:
            said.measures["height"] = float(far["cm"])
            behind = behind[far.end() :]
        said.text = f"{before} {behind}"
        return

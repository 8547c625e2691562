"""Girths of a body as people write them: names with numbers, three numbers in a row, bras, jeans, jackets."""

from __future__ import annotations

import re
from functools import cache

from swifttailor.inches import CM_PER_INCH
from swifttailor.wishes.wearers.body_said import SaidBody, number
from swifttailor.wishes.wearers.body_words import any_of

_NUMBER = r"\d{2,3}(?:[.,]\d{1,2})?(?![\d]|[.,]\d|\s?(?:%|°))"
_INCH = (
    r"(?:inch(?:es)?\b|in\b(?=\s*(?:[-,.;:!?)/]|$|(?:and|waist|bust|chest|hips?|round|around|tall)(?!\w)))"
    r"|[\"”″]|''|zoll\b|pouces\b|pulgadas\b|pollici\b)"
)
_UNIT = rf"(?:(?P<cm>cm|centimet\w+|zentimeter)\b|(?P<inch>{_INCH}))?"
_UNIT_BEFORE = rf"(?:(?:(?P<cm2>cm|centimet\w+)\b|(?P<inch2>{_INCH})))?"
_LEAD = r"(?:(?<!\w)(?:with|and|a|of|at|mit|avec|con|und|et|y)\s+)*"
_OTHERWISE = r"deep|wide|high|long|longer|wider|shorter|tief|hoch|breit|lang|below|above|from|under"
"""Behind a number that is no girth."""
_ONWARD = r"to|bis|hasta|jusqu|down|up|length|band|tie|darts?|seams?|height|high|ease"
"""Behind a place that a length begins at, or that belongs to the garment."""
_SPANS = {
    "bust": (60.0, 180.0),
    "underbust": (55.0, 170.0),
    "waist": (48.0, 180.0),
    "hips": (62.0, 190.0),
    "leg_circ": (40.0, 100.0),
    "calf": (26.0, 65.0),
    "biceps": (20.0, 65.0),
    "neck": (30.0, 58.0),
}
"""What grown people have, cm; a number beside the name that lies outside is in inches, or none of theirs."""
_CHILDS = {"bust": (45.0, 90.0), "waist": (42.0, 85.0), "hips": (48.0, 95.0)}
_MAIN = ("bust", "waist", "hips")


@cache
def _named() -> re.Pattern[str]:
    first = "|".join(f"(?P<{key}>{any_of('girths', key)})" for key in _SPANS)
    last = "|".join(f"(?P<of_{key}>{any_of('girths', key)})" for key in _SPANS)
    between = rf"\s*[:=(-]?\s*(?:{any_of('girths', 'between')}[\s:]+)*"
    return re.compile(
        rf"{_LEAD}(?<![\w-])(?:(?:{first}){between}(?<![\w.,])(?P<value>{_NUMBER})\s?{_UNIT}"
        rf"(?!\w|\s*[x×/]\s*\d)(?!\s*(?:{_OTHERWISE}))"
        rf"|(?<![.,])(?P<before>{_NUMBER})\s?{_UNIT_BEFORE}"
        r"(?:\s+(?:de|of|di|um die|around the|round the)\s+|\s+|-)"
        rf"(?:{last})(?![\w-])(?!\s*(?:{_ONWARD})(?!\w)))",
        re.IGNORECASE,
    )


@cache
def _not_after() -> re.Pattern[str]:
    return re.compile(
        rf"(?<!\w){any_of('girths', 'not_after')}\s+(?:(?:the|my|la|le|der|die|das|il)\s+)?$", re.IGNORECASE
    )


_TRIPLE = re.compile(
    r"(?<![\w./,-])(\d{2,3}(?:[.,]5)?)\s*[-–—/]\s*(\d{2,3}(?:[.,]5)?)\s*[-–—/]\s*(\d{2,3}(?:[.,]5)?)(?![\w/-]|[.,]\d)"
)
_BRA = re.compile(
    r"(?<![\w.,-])(?P<band>\d{2,3})\s?(?P<cup>A{1,2}|B|C|D{1,3}|E|F|FF|G|H|J)"
    r"(?:[- ]?(?:cup|körbchen|bonnet|copa))?(?![\w'’-]|\s?[-]?line)"
)
_CUPS = {
    "AA": 0,
    "A": 1,
    "B": 2,
    "C": 3,
    "D": 4,
    "DD": 5,
    "E": 5,
    "DDD": 6,
    "F": 6,
    "FF": 7,
    "G": 7,
    "H": 8,
    "J": 9,
}
_FRENCH_BANDS = re.compile(
    r"(?<!\w)(?:je|une?|mon|ma|pour|soutien|talla|para|soy|tengo|uso)(?!\w)", re.IGNORECASE
)
_LEGS = r"jeans?|trousers|pants|chinos?|slacks|hosen?|pantal[oó]n(?:es)?|pantalons?|vaqueros?|jogg\w+|cords?"
_WAIST_LEG = re.compile(
    r"(?<![\w])w\s?(?P<w>\d{2})\s*[-/,x×]?\s*l\s?(?P<l>\d{2})(?![\d])"
    r"|(?<![\w.,/])(?P<w2>2[4-9]|[345]\d|60)\s?"
    r"(?P<by>[-x×/])\s?(?P<l2>2[6-9]|3[0-8])(?![\w/.,]|\s*(?:cm|mm|in)\b)",
    re.IGNORECASE,
)
_INCH_LEG = re.compile(r"(?<![\w.,])(2[4-9]|3\d) ?(?:-| )?(?:inch(?:es)?|in|\"|”) legs?(?!\w)", re.IGNORECASE)
_OF_LEGS = re.compile(rf"(?<!\w)\w*(?:{_LEGS})(?!\w)", re.IGNORECASE)
_TAILLE = re.compile(r"3[2-9]|[45]\d|60")
"""Behind "taille" these are sizes of clothes in French, not girths."""
_SUIT = re.compile(
    r"(?:(?<!\w)(?i:size)\s+)?(?<![\w.,-])(?P<chest>3[4-9]|[45]\d|60)(?:(?P<letter>R|L|S)(?![\w-])"
    r"|\s?-?\s?(?P<word>(?i:regular|reg))(?!\w)|\s(?P<long>(?i:long|short))(?=\s*(?:[,.;!?)]|$|(?i:suit|blazer|jacket|tux\w*)(?!\w))))"
)
_SUIT_HEIGHTS = {"r": 178.0, "l": 187.0, "s": 169.0}
"""Of the wearers of regular, long and short jackets, cm."""


def hear_girths(said: SaidBody, *, child: bool = False) -> None:
    """Takes the girths of a body out of a text.

    Where one of them has inches, those without a unit have them, too; and where those without a unit are
    none of a grown person in centimetres and are so in inches, they are in inches.

    Args:
        said: What was found so far; it is added to.
        child: Whether a child is spoken of.
    """
    _hear_waist_and_leg(said)
    if _OF_LEGS.search(said.text):
        said.text = _INCH_LEG.sub(_in_cm, said.text)
    _hear_triple(said)
    _hear_suit(said)
    _hear_bra(said)
    _hear_named(said, child)


def _in_cm(found: re.Match[str]) -> str:
    return f"inside leg {float(found[1]) * CM_PER_INCH:.0f} cm"


def _hear_named(said: SaidBody, child: bool) -> None:
    found: list[tuple[re.Match[str], str, float, str]] = []
    at = 0
    while (match := _named().search(said.text, at)) is not None:
        groups = match.groupdict()
        key = next(key for key in _SPANS if groups[key] or groups[f"of_{key}"])
        at = match.end()
        if groups["value"] and _not_after().search(said.text, 0, match.start(key)):
            at = match.start("value")
            continue
        unit = "in" if groups["inch"] or groups["inch2"] else "cm" if groups["cm"] or groups["cm2"] else ""
        if not unit and (groups["waist"] or "").lower() == "taille" and _TAILLE.fullmatch(groups["value"]):
            continue
        found.append((match, key, number(groups["value"] or groups["before"]), unit))
    spans = _SPANS | (_CHILDS if child else {})
    loose = [(key, value) for _, key, value, unit in found if not unit and key in _MAIN]
    in_inches = any(unit == "in" for *_, unit in found)
    in_cm = any(unit == "cm" for *_, unit in found)
    if not in_inches and not in_cm and loose:
        in_inches = any(
            not _within(key, value, spans) and _within(key, value * CM_PER_INCH, spans)
            for key, value in loose
        )
    for match, key, value, unit in reversed(found):
        cm = _as_cm(key, value, unit, in_inches, spans)
        if cm is not None:
            said.measures.setdefault(key, cm)
            said.take(match)


def _as_cm(
    key: str, value: float, unit: str, in_inches: bool, spans: dict[str, tuple[float, float]]
) -> float | None:
    """The measure in cm; None where it is none of a body."""
    inches = value * CM_PER_INCH
    if unit == "in":
        return inches if _within(key, inches, spans) else None
    if unit == "" and ((in_inches and _within(key, inches, spans)) or not _within(key, value, spans)):
        # A collar of 16 may be as many centimetres high; 16.5 is the inches of a shirt.
        halves = key != "neck" or in_inches or value % 1 == 0.5
        return inches if halves and _within(key, inches, spans) else None
    return value if key in spans and _beyond(key, value, spans) else None


def _within(key: str, cm: float, spans: dict[str, tuple[float, float]]) -> bool:
    low, high = spans[key]
    return low <= cm <= high


def _beyond(key: str, cm: float, spans: dict[str, tuple[float, float]]) -> bool:
    """Whether a number of cm is a body's, even one that nobody has."""
    low, high = spans[key]
    return 0.9 * low <= cm <= (1.4 * high if key in _MAIN else high)


@cache
def _row() -> re.Pattern[str]:
    three = r"\s*[,;:/–-]?\s*".join(r"(\d{2,3}(?:[.,]5)?)" for _ in _MAIN)
    letters = r"(?<!\w)b\s*[:=]?\s*(\d{2,3})\W{0,3}w\s*[:=]?\s*(\d{2,3})\W{0,3}h\s*[:=]?\s*(\d{2,3})(?!\d)"
    return re.compile(
        rf"(?<!\w){any_of('girths', 'row')}(?:\s+(?:are|sind|sont|son))?\s*[:=]?\s*{three}(?!\d)(?:\s?cm\b)?"
        rf"|{letters}",
        re.IGNORECASE,
    )


def _hear_triple(said: SaidBody) -> None:
    for match in [*_row().finditer(said.text), *_TRIPLE.finditer(said.text)]:
        values = [number(one) for one in match.groups() if one]
        for unit in (1.0, CM_PER_INCH):
            sized = [unit * value for value in values]
            if all(_within(key, cm, _SPANS) for key, cm in zip(_MAIN, sized, strict=True)) and (
                sized[1] <= sized[0] + 20.0 and sized[1] <= sized[2] + 20.0
            ):
                said.measures |= dict(zip(_MAIN, sized, strict=True))
                said.take(match)
                return


def _hear_bra(said: SaidBody) -> None:
    match = next((m for m in _BRA.finditer(said.text)), None)
    if match is None:
        return
    band, cup = float(match["band"]), _CUPS[match["cup"]]
    if 28 <= band <= 56 and band % 2 == 0:
        # Inches: the band is the underbust, each cup an inch.
        said.measures |= {"underbust": band * CM_PER_INCH, "bust": (band + max(cup, 0.5)) * CM_PER_INCH}
    elif 60 <= band <= 130 and band % 5 == 0:
        if band >= 85 and _FRENCH_BANDS.search(said.text):
            band -= 15.0
        said.measures |= {"underbust": band, "bust": band + 11.0 + 2.0 * cup}
    else:
        return
    said.take(match)


def _hear_waist_and_leg(said: SaidBody) -> None:
    for match in _WAIST_LEG.finditer(said.text):
        plain = match["w"] is None
        if plain and not _OF_LEGS.search(said.text):
            continue
        waist, leg = float(match["w"] or match["w2"]), float(match["l"] or match["l2"])
        if match["by"] == "-" and waist < leg:
            continue  # a run of sizes
        if waist >= 24 and 24 <= leg <= 40:
            said.measures["waist"] = waist * CM_PER_INCH
            said.take(match, f", inside leg {leg * CM_PER_INCH:.0f} cm,")
            return


def _hear_suit(said: SaidBody) -> None:
    match = _SUIT.search(said.text)
    if match is None:
        return
    if match[0].lower().startswith("size") and re.match(r"\s*\w", said.text[match.end() :]):
        return  # "size 40 short jacket"
    length = (match["letter"] or match["word"] or match["long"]).lower()[0]
    chest = float(match["chest"])
    said.measures |= {"bust": chest * CM_PER_INCH, "height": _SUIT_HEIGHTS[length]}
    said.take(match)

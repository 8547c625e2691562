"""Girths of wearers in other languages and in inches that are said once, as English centimetres.

"Brust 98, Taille 86, Hüfte 106" and "bust 52 inches, waist 46, hips 58" become what is read of wearers.
"""

from __future__ import annotations

import re

_NAMES = {
    "bust": r"bust|chest|brust(?:umfang)?|oberweite|(?:tour de )?poitrine|busto"
    r"|(?:contorno de )?pecho|petto|seno|torace|borst(?:omvang)?|bovenwijdte|peito",
    "waist": r"waist|(?:tour de )?taille(?:numfang|nweite)?|(?:contorno de )?cintura|vita|girovita|middel",
    "hips": r"hips?|hüfte[n]?|hüftumfang|(?:tour de )?hanches?|bassin|(?:contorno de )?caderas?|fianchi"
    r"|heup(?:en|omvang)?|quadril|ancas?",
}
_INCHES = r"(?:inch(?:es)?\b|ins?\b|[\"”″]|'')"
_ONE = "|".join([rf"(?P<{name}>{words})" for name, words in _NAMES.items()])
_GIRTH = re.compile(
    rf"(?<![\w-])(?:{_ONE})(?: (?:is|are|of|von|ist|de|di|du|da|about|approx))?\s*[:=]?\s*"
    rf"(?P<value>\d{{2,3}}(?:[.,]\d)?)(?![\d/])(?:\s*(?:(?P<cm>cms?\b|centim\w+)|(?P<inches>{_INCHES})))?",
    re.IGNORECASE,
)
_THREE = re.compile(r"(?<![\w.,-])(\d{2,3})\s*[-–/]\s*(\d{2,3})\s*[-–/]\s*(\d{2,3})(?![\w.,-])")
"""Bust, waist and hips as people write them: "92-74-101"."""
_SHORTEST_CM, _LONGEST_CM = 50.0, 180.0
_CM_PER_INCH = 2.54
_IN_INCHES = (20.0, 60.0)
_TALL = re.compile(
    r"(?<!\w)(?:ich bin|mido|je mesure|je fais|sono alt[ao]|ik ben|tenho|eu meço|meço|mesuro)\s+"
    r"(?:(?P<m>[12])\s*(?:[.,]|m\s?)(?P<cm>\d{2})|(?P<whole>1\d\d|2[01]\d)\s*cm)\s*(?:m\b|cm\b)?"
    r"(?: (?:gro(?:ß|ss)|lang|alt[oa]|de haut|de altura))?",
    re.IGNORECASE,
)
"""A height: "ich bin 1,58 m gross", "mido 1.70"."""


def with_english_girths(text: str) -> str:
    """The text with girths and heights of people as "bust 98 cm" and "158 cm tall".

    A lone number of two digits below 45 is in inches, and so is what follows a girth in inches.

    Args:
        text: In any language that is read.
    """
    text = _TALL.sub(_height, text)
    found = list(_GIRTH.finditer(text))
    three = _THREE.search(text)
    if not found and three is not None:
        values = [float(each) for each in three.groups()]
        if all(_SHORTEST_CM <= each <= _LONGEST_CM for each in values) and values[1] <= min(
            values[0], values[2]
        ):
            said = ", ".join(
                [f"{n} {v:g} cm" for n, v in zip(("bust", "waist", "hips"), values, strict=True)]
            )
            return text[: three.start()] + said + text[three.end() :]
    inches = any(each["inches"] for each in found)
    several = len({each.lastgroup for each in found}) > 1 or len(found) > 1
    for each in reversed(found):
        name = next(n for n in _NAMES if each[n])
        value = float(each["value"].replace(",", "."))
        alone = not each["cm"] and not each["inches"]
        short = _IN_INCHES[0] <= value < _SHORTEST_CM - 5 and name in ("bust", "waist", "hips")
        if each["inches"] or (alone and (inches or short) and value <= _IN_INCHES[1]):
            value *= _CM_PER_INCH
        if not _SHORTEST_CM <= value <= _LONGEST_CM:
            continue
        if not several and (each["inches"] or each[name].lower() == "taille"):
            continue  # read as it is, or a French size
        if (
            alone
            and not several
            and each[name].lower() in ("bust", "chest", "waist", "hips", "hip")
            and not short
        ):
            continue  # as it is read anyway
        text = text[: each.start()] + f"{name} {value:.0f} cm" + text[each.end() :]
    return text


def _height(found: re.Match[str]) -> str:
    cm = found["whole"] or f"{found['m']}{found['cm']}"
    return f"{cm} cm tall"

"""Figures of a description in the words that the readers of figures know: "70 cm de largo", "body 82".

Words for long beside a figure may not be read as those of a maxi skirt.
"""

from __future__ import annotations

import re

from swifttailor.inches import CM_PER_INCH

_NUMBER = r"\d{1,3}(?:[.,]\d{1,2})?(?:[ -]\d/\d)?"
_UNIT = r"(?:cms?|centimet\w+|zentimeter|cent[ií]m\w+|inch(?:es)?|ins?(?!\w)|mm|m(?:et\w+)?(?!\w)|[\"”″])"
_LENGTH = rf"(?P<figure>(?<![\w.,/]){_NUMBER}(?:[ -]?{_UNIT})?)"
_FRENCH = re.compile(rf"{_LENGTH} de long(?:ueur)?(?!\w)", re.IGNORECASE)
_SPANISH = re.compile(rf"{_LENGTH} de largo(?!\w)", re.IGNORECASE)
_ITALIAN = re.compile(rf"(?<!\w)lung[aohei]+ {_LENGTH}", re.IGNORECASE)
_WIDE_HEM = re.compile(
    rf"{_LENGTH} (?:wide|in width) (?:at|around|along) (?:the|each) (?:hem|bottom)(?: of the leg)?(?!\w)"
    rf"|(?<!\w)hems?(?: (?:of|is|are|about))? (?P<behind>{_NUMBER} ?{_UNIT}) wide(?!\w)",
    re.IGNORECASE,
)
_BODY = re.compile(
    r"(?<![\w-])(?<!my )(?<!her )(?<!his )(?<!the )body(?: length)?(?:\s*(?:of|is|:|=))? "
    rf"(?P<figure>\d{{2,3}}(?:[.,]\d{{1,2}})?(?! ?(?:%|kg)|[\d.,]*\d)(?: ?{_UNIT})?)(?!\w)",
    re.IGNORECASE,
)
_ELASTIC = re.compile(
    rf"(?<!\w)elastic(?:ated)? (?:casing|waist|channel|tunnel)? ?(?P<figure>{_NUMBER} ?{_UNIT})",
    re.IGNORECASE,
)
_WIDER = re.compile(
    rf"(?<!\w)hems?(?: (?:that is|is|should be|to be|measuring))?(?: (?:only|just|about|some|around))*"
    rf" (?P<number>{_NUMBER}) ?(?P<unit>{_UNIT})? (?:wider|bigger|more) than (?:the |my |her )?hips?"
    r"(?: width)?(?!\w)",
    re.IGNORECASE,
)
_HIPS_CM = 104.0
"""Around the hips of the usual body, for hems that are told from there."""
_COLLAR_SLEEVE = re.compile(
    r"(?<!\w)sleeves?(?: length)?(?: of|:)? (?P<number>3[0-8])(?: ?(?:inch(?:es)?|in(?!\w)|[\"”″]))?"
    r"(?![\w.,]\d|\w| ?cm)",
    re.IGNORECASE,
)
_SHIRT_COLLAR = re.compile(
    r"(?<!\w)(?:collar|neck)(?: size)?(?: of|:)? 1[3-9](?:\.5|½| 1/2)?(?![\w.,]\d|\w| ?cm)", re.IGNORECASE
)
_HALF_SHOULDERS_CM = 21.0
"""From the nape to the shoulder tip: sleeves of shirts are sold from there, in inches."""


def figures_plainly(text: str) -> str:
    """A description with its figures in plain words; the rest as it is.

    Args:
        text: In one of the languages that are read.
    """
    if not any(letter.isdigit() for letter in text):
        return text
    text = _FRENCH.sub(r"longueur \g<figure>", text)
    text = _SPANISH.sub(r"longitud \g<figure>", text)
    text = _WIDE_HEM.sub(lambda m: f"{m['figure'] or m['behind']} across the hem", text)
    text = _ITALIAN.sub(r"lunghezza \g<figure>", text)
    text = _BODY.sub(r"length \g<figure>", text)
    text = _ELASTIC.sub(r"elastic waistband \g<figure>", text)
    text = _WIDER.sub(_from_the_hips, text)
    return _COLLAR_SLEEVE.sub(_from_the_nape, text) if _SHIRT_COLLAR.search(text) else text


def _from_the_hips(found: re.Match[str]) -> str:
    return f"hem circumference {_HIPS_CM + _in_cm(found['number'], found['unit']):.0f} cm"


def _from_the_nape(found: re.Match[str]) -> str:
    return f"sleeve {float(found['number']) * CM_PER_INCH - _HALF_SHOULDERS_CM:.0f} cm"


def _in_cm(number: str, unit: str | None) -> float:
    inches = bool(unit) and (unit or "").lower().startswith(("i", '"', "”", "″"))
    return float(number.replace(",", ".").split()[0]) * (CM_PER_INCH if inches else 1.0)

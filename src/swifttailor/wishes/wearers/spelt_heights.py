"""Heights in feet and inches that are written in words: "six foot one"."""

from __future__ import annotations

import re

_FEET = {"four": "4", "five": "5", "six": "6"}
_INCHES = {
    word: str(number)
    for number, word in enumerate("one two three four five six seven eight nine ten eleven".split(), 1)
}
_SPELT = re.compile(
    rf"(?<![\w-])(?P<feet>{'|'.join(_FEET)})[ -](?:foot|feet|ft)"
    rf"(?:[ -](?:and )?(?P<inches>{'|'.join(_INCHES)}|1[01]|\d)(?![\w-]))?"
    r"(?! (?:square|wide|long|deep|train|buttons?|darts?|pockets?|pleats?))\b",
    re.IGNORECASE,
)


def with_digits(text: str) -> str:
    """The text with such heights in digits: "6 foot 1".

    Args:
        text: As it was typed.
    """

    def digits(found: re.Match[str]) -> str:
        inches = found["inches"]
        more = "" if inches is None else f" {_INCHES.get(inches.lower(), inches)}"
        return f"{_FEET[found['feet'].lower()]} foot{more}"

    return _SPELT.sub(digits, text)

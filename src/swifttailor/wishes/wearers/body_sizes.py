"""Sizes of clothes in the numbers of several countries, and letters."""

from __future__ import annotations

import re
from functools import cache

from swifttailor.body.size_charts import charts
from swifttailor.wishes.wearers.body_said import SaidBody
from swifttailor.wishes.wearers.body_words import any_of

_REGIONS = {
    **dict.fromkeys(("eu", "eur", "european", "de", "german", "deutsche"), "EU"),
    **dict.fromkeys(("uk", "gb", "british", "au", "australian"), "UK"),
    **dict.fromkeys(("us", "usa", "american"), "US"),
    **dict.fromkeys(("fr", "french", "es", "spanish", "be"), "FR"),
    **dict.fromkeys(("it", "italian"), "IT"),
}
_TO_EU = {"FR": -2, "IT": -6}
"""From the numbers of women's sizes there to those of EU charts; men's are the same."""
_LETTER = r"(?:XXXS|XXS|XS|XXXXL|XXXL|XXL|XL|[2-9]\s?-?XL|[1-6]X|S|M|L)"
_REGION = r"(?:EU|EUR|European|UK|GB|British|AU|Australian|US|USA|American|DE|German|FR|French|ES|IT|Italian)"
_LETTERS = {
    "1X": "XL",
    "2X": "XXL",
    "2XL": "XXL",
    "3X": "3XL",
    "XXXL": "3XL",
    "4X": "4XL",
    "XXXXL": "4XL",
    "XXXS": "XXS",
}
_WORDS = {"small": "S", "medium": "M", "large": "L", "extra large": "XL", "extra small": "XS"}
_GARMENT = (
    r"(?:collar|kragen|neck|shoe|shoes|boots?|hat|needles?|buttons?|zips?|belt|ring|print|font|schuh\w*)"
)
_BABY_SIZES = range(44, 98, 6)
_PLUS = re.compile(r"(?<![\w-])(?P<letter>[1-6]x)(?![\w-])", re.IGNORECASE)
"""Beside "plus size"."""
_PLUS_NUMBER = re.compile(
    r"(?<![\w.,/-])(?P<number>1[468]|2[02468]|3[02])(?:\s?(?P<wide>W)(?!\w))?"
    r"(?![\w/]|[.,]\d|\s?(?:cm|mm|in|inch\w*|[\"”″%])|\s(?:years?|tiers?|buttons?|gores?|panels?|pcs|pieces|pleats)(?!\w))"
)
"""The same as a number by itself: "plus size, 24"."""
_RANGES_END = 50
"""Runs of sizes that end below are those of a shop ("size 8-16"), not a child's of two ("98/104")."""
_SHORT_CM = {"women": 160.0}
"""Of German short sizes, which are half the number."""
BABY = (
    "No body of a baby or small child can be had: it is made for the smallest that there is, {tall} cm tall "
    "and about three years old."
)


@cache
def _sized() -> re.Pattern[str]:
    size = any_of("sizes", "size")
    return re.compile(
        rf"(?:\b(?:in|of|a|an|en|de|für|bin|trage|habe|uso|tengo|je fais du|je fais un)\s+)*"
        rf"(?:(?<!\w)(?P<before>{_REGION})\s+)?(?<![\w-])(?P<size>{size})(?![^\W\d])(?:\s+(?:is|ist|:|nr\.?|no\.?))?\s*:?\s*"
        rf"(?:(?P<between>{_REGION})\s*)?"
        rf"(?:(?P<number>\d{{1,3}})(?:\s?[-/–]\s?(?P<to>\d{{2,3}}))?(?P<wide>\s?W)?|(?P<letter>{_LETTER})"
        rf"|(?P<word>(?:extra )?(?:small|large)|medium))"
        rf"(?![\w]|[.,]\d|\s?(?:cm|mm|m|in|inch\w*|[\"”″])(?!\w)|\s{_GARMENT})(?:\s+(?P<after>{_REGION})(?!\w))?",
        re.IGNORECASE,
    )


@cache
def _weak() -> re.Pattern[str]:
    return re.compile(
        rf"(?<!\w){any_of('sizes', 'weak')}\s+(?P<number>[1-5]?[02468])(?![.,]\d)"
        r"(?=\s*(?:[,.;:!?)]|$|(?:and|et|y|und|in|or)(?!\w)))",
        re.IGNORECASE,
    )


_BY_REGION = re.compile(
    r"(?:\b(?:in|of|a|an)\s+)*(?<![\w-])(?P<region>EU|EUR|UK|GB|AU|USA?|DE|FR|ES|IT)\s?(?P<number>\d{1,2})(?P<wide>\s?W)?"
    r"(?![\w]|[.,]\d|\s?(?:cm|mm|in)\b)"
)
_BY_LETTER = re.compile(
    r"(?:(?<!\w)(?i:in|an?|en|de|size)\s+)*(?<![\w-])(?P<letter>(?i:XXXS|XXS|XS|XXXXL|XXXL|XXL|XL|[2-9]\s?-?XL)|[1-6]X)(?![\w-])"
)
_RUN = re.compile(
    rf"(?<![\w-]){_LETTER}\s*(?:to|through|thru|until|till|bis|à|a|hasta|tot|-|–|—|/)\s*{_LETTER}(?![\w-])"
    rf"|(?<![\w-]){_LETTER}(?:(?:\s*[,/]\s*|,? (?:and|or|und|et|y) ){_LETTER}){{2,}}(?![\w-])"
)
"""Sizes of a shop: its garments are shown on the usual body."""


def hear_size(said: SaidBody, figure: str | None, *, child: bool = False) -> None:
    """Takes a size out of a text; the nearest of the chart, where it has none of that number.

    Args:
        said: What was found so far; it is added to.
        figure: ``women``, ``men`` or ``children``, as the text says it.
        child: Whether a child is spoken of.
    """
    if (run := _RUN.search(said.text)) is not None:
        said.text = f"{said.text[: run.start()]}{said.text[run.end() :]}"
    match = next((m for m in _sized().finditer(said.text) if _is_meant(m, said)), None)
    if match is not None:
        region = match["before"] or match["between"] or match["after"] or ""
        region = _REGIONS.get(region.lower(), "") or _of_language(match["size"])
        if match["number"]:
            _take_number(said, match, int(match["to"] or match["number"]), region, figure, child)
        else:
            label = match["letter"] or _WORDS[match["word"].lower()]
            _take_letter(said, match, label, figure)
        return
    for match in _BY_REGION.finditer(said.text):
        _take_number(said, match, int(match["number"]), _REGIONS[match["region"].lower()], figure, child)
        return
    weak = _weak().search(said.text)
    if weak is not None:
        _take_number(said, weak, int(weak["number"]), _of_language(weak[0]), figure, child)
        return
    plus = _PLUS_NUMBER.search(said.text) if said.build == "plus" else None
    if plus is not None:
        _take_number(said, plus, int(plus["number"]), "", figure, child)
        return
    match = _BY_LETTER.search(said.text) or (_PLUS.search(said.text) if said.build == "plus" else None)
    if match is not None:
        _take_letter(said, match, match["letter"], figure)


def _is_meant(match: re.Match[str], said: SaidBody) -> bool:
    if match["number"] is None:
        return True
    if match["to"] and int(match["to"]) < _RANGES_END and int(match["to"]) - int(match["number"]) != 2:
        return False
    if re.fullmatch(any_of("sizes", "french"), match["size"], re.IGNORECASE):
        # A "taille" of the 60s and more is a waist; where other girths are given it was read before.
        return int(match["number"]) <= 60 or int(match["number"]) >= 98
    return True


def _of_language(word: str) -> str:
    if word.lower().startswith("je "):
        return "FR"
    for key, region in (("spanish", "FR"), ("french", "FR"), ("italian", "IT"), ("german", "DE")):
        if re.fullmatch(any_of("sizes", key), word, re.IGNORECASE):
            return region
    return ""


def _take_letter(said: SaidBody, match: re.Match[str], letter: str, figure: str | None) -> None:
    plain = re.sub(r"[\s-]", "", letter.upper())
    label = _LETTERS.get(plain, plain)
    chart = charts()["men" if figure == "men" else "women", "letters"]
    if label not in chart:
        largest = list(chart)[-1]
        said.notes.append(
            f"There is no body of size {plain}: the largest that there is was taken, {largest}."
        )
        label = largest
    said.size = label
    said.take(match)


def _take_number(
    said: SaidBody, match: re.Match[str], value: int, region: str, figure: str | None, child: bool
) -> None:
    german = region == "DE"
    of_a_child = str(value) in charts()["children", "EU"] and figure != "men"
    if child or of_a_child or (value in _BABY_SIZES and value > 60 and figure is None):
        if value < 40 and not said.age:
            said.age = value if 1 <= value <= 16 else None
        elif value >= 40:
            _take_child(said, value)
        said.take(match)
        return
    if figure == "men":
        chart_of = "US" if region == "US" or (not region and value < 42) or (region == "UK") else "EU"
    elif german and 16 <= value <= 30:
        said.measures.setdefault("height", _SHORT_CM["women"])
        value, chart_of = 2 * value, "EU"
    elif region in _TO_EU:
        value, chart_of = value + _TO_EU[region], "EU"
    elif region in ("UK", "US"):
        chart_of = region
    else:
        chart_of = "EU" if value >= 34 or german else "UK" if value > 2 else "US"
    if match.groupdict().get("wide"):
        chart_of = "US"
    chart = charts()["men" if figure == "men" else "women", chart_of]
    if chart_of == "US" and figure != "men" and value > 20:
        value, chart_of = value + 4, "UK"
        chart = charts()["women", "UK"]
    if str(value) in chart:
        label = str(value)
    else:
        label = min(chart, key=lambda one: abs(int(one) - value))
        if abs(int(label) - value) > 2:
            said.notes.append(
                f"There is no body of size {value}: the nearest size that there is was taken, {label}."
            )
    said.size, said.region = label, chart_of
    said.take(match)


def _take_child(said: SaidBody, tall: int) -> None:
    """A child's size, which is the height."""
    chart = charts()["children", "EU"]
    label = min(chart, key=lambda one: abs(int(one) - tall))
    if tall < 95:
        said.notes.append(BABY.format(tall=label))
    said.size, said.region = f"children {label}", "EU"

"""Who is to wear a garment, as a text says it: sizes, heights, girths, figures and ages."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass

from swifttailor.body.size_charts import charts, find_size
from swifttailor.body.wearer import Wearer
from swifttailor.errors import InputError
from swifttailor.wishes.girth_names import with_english_girths
from swifttailor.wishes.not_the_wearer import hide_others, with_finished_chest
from swifttailor.wording.lexicon import read_words

CM_PER_INCH = 2.54
PETITE_CM, TALL_CM = {"women": 157.0}, {"women": 180.0, "men": 192.0}
"""Heights of those who are called so."""
PLUS_SIZE = "women EU 50"
CHILD_SIZE = "children EU 128"
"""A child of whom nothing else is said."""

_REGION = r"(?:EU|EUR|European|UK|GB|British|US|USA|American)"
_LETTER = r"(?:XXS|XS|XXL|XL|S|M|L|2XL)"
_WORD_SIZES = {"small": "S", "medium": "M", "large": "L", "extra large": "XL", "extra small": "XS"}
_FIGURES = {
    "women": r"women'?s?|woman'?s?|lad(?:y|ies)'?s?|her|wife|mother|mum|mom|girlfriend",
    "men": r"men'?s?|man'?s?|gent(?:s|lemen|leman)?'?s?|him|husband|father|dad|boyfriend",
    "children": r"child(?:ren)?'?s?|kid'?s?|girl'?s?|boy'?s?|daughter|son|toddler",
}
_CHILD = rf"(?<![\w-])(?:{_FIGURES['children']})(?![\w-])"
_GROWN = re.compile(
    r"(?<!\w)(?:grown[- ]?up|adult|teen(?:age)?r?|(?:1[4-9]|[2-9]\d)[- ]?(?:years?|yrs?)[- ]?olds?"
    r"|is (?:1[4-9]|[2-9]\d|fourteen|fifteen|sixteen|seventeen|eighteen|nineteen|(?:twen|thir)ty\S*))(?!\w)",
    re.IGNORECASE,
)
"""What says that a daughter or a son is no child."""
_ANYBODY = "|".join(_FIGURES.values())
_TALL_OR = r"(?:tall|petite|short|plus[- ]size[d]?|curvy)"


_METRES_AND = re.compile(
    r"(?<![\w.,])([12]) ?m(?:et(?:er|re)s?)? ?(\d\d)(?: ?cm)?(?![\w.,]\d|\w)", re.IGNORECASE
)
"""A height in metres and centimetres: "1 m 20", "1m65"."""
_TALL = r"(?: (?:tall|high|in height))?"
_FEET_AND_INCHES = re.compile(
    r"(?<![\w.,'’])([4-6]) ?(?:['’′]|ft\.?|feet|foot) ?(1[01]|\d)(?: ?(?:\"|”|″|''|in(?:ch(?:es)?)?(?!\w)))?"
    rf"(?![\w.,]\d|\w){_TALL}",
    re.IGNORECASE,
)
"""A height in feet and inches: 5'4", "5 foot 4", "5ft4"."""
_PERSON = r"(?<!\w)(i['’]?m|i am|she['’]?s|he['’]?s|she is|he is|someone|somebody|(?:a )?(?:wo)?man of)"
_FEET = re.compile(rf"{_PERSON} ([4-6]) ?(?:ft|feet|foot)(?!\w){_TALL}", re.IGNORECASE)
_METRIC = re.compile(rf"{_PERSON} (\d{{3}} ?cm|[12]\.\d{{1,2}} ?m)(?!\w){_TALL}", re.IGNORECASE)
"""Heights of people: "I'm 6ft", "someone 1.80 m"."""


_OF_GARMENT = re.compile(r"(?<!\w)finished\s*$", re.IGNORECASE)
"""Before a girth that is the garment's own."""


@dataclass(frozen=True)
class HeardWearer:
    """What a text says of the wearer."""

    wearer: Wearer | None
    """None where it says nothing that changes the body."""
    rest: str
    """The text without the words that say it."""


def hear_wearer(text: str, *, instruction: bool = False) -> HeardWearer:
    """Takes out of a text what it says of who wears the garment.

    A lone "women's" or "men's" changes nothing: garments are made for the default body then.

    Args:
        text: Description or instruction.
        instruction: Whether it says what to change, so that girths are the garment's and not the wearer's.
    """
    found: dict[str, str] = {}
    measures: dict[str, float] = {}
    text = _with_metric_heights(text if instruction else with_english_girths(text))
    hidden = hide_others(text if instruction else with_finished_chest(text))
    rest = text = hidden.text
    for pattern, take in _PHRASES:
        if instruction and take is _either_girth:
            continue
        match = next((m for m in pattern.finditer(rest) if not _OF_GARMENT.search(rest, 0, m.start())), None)
        if match is not None and take(match, found, measures):
            rest = rest[: match.start()] + " " + rest[match.end() :]
    figure = _figure(_without_looks(text))
    wearer = _wearer(found, measures, figure)
    if wearer is None:
        return HeardWearer(None, hidden.shown(text))
    rest = re.sub(rf"\bfor (?:an? |my )?(?:{_ANYBODY})\b(?!['\w])", " ", rest, flags=re.IGNORECASE)
    if figure == "children":
        rest = _without_children(rest)
    rest = re.sub(r"\s+([,.;])", r"\1", " ".join(rest.split()))
    rest = re.sub(r"(?:[,;]\s*)+(?=[,;.]|$)", "", rest).strip(" ,;")
    return HeardWearer(wearer, hidden.shown(rest))


def _with_metric_heights(text: str) -> str:
    """The text with the heights of people as "160 cm tall"."""

    def metric(feet: str, inches: str) -> str:
        return f"{CM_PER_INCH * (12 * int(feet) + int(inches)):.0f} cm tall"

    text = _METRES_AND.sub(r"\1.\2 m", text)
    text = _FEET_AND_INCHES.sub(lambda found: metric(found[1], found[2]), text)
    text = _FEET.sub(lambda found: f"{found[1]} {metric(found[2], '0')}", text)
    return _METRIC.sub(r"\1 \2 tall", text)


def _without_children(text: str) -> str:
    """The text without words for children, but for those in the names of garments: "flower girl dress"."""
    child = rf"\b(?:an? )?(?:{_FIGURES['children']})\b"
    marks = [m.word for m in read_words(text).marks if m.role == "garment" and " " in m.word]
    names = [re.escape(word) for word in marks if re.search(child, word, re.IGNORECASE)]
    if not names:
        return re.sub(child, " ", text, flags=re.IGNORECASE)
    parts = re.split(rf"({'|'.join(names)})", text, flags=re.IGNORECASE)
    return "".join(
        part if k % 2 else re.sub(child, " ", part, flags=re.IGNORECASE) for k, part in enumerate(parts)
    )


def _without_looks(text: str) -> str:
    """The text without what names a look and no wearer: "farm girl", "soft girl"."""
    for mark in read_words(text).marks:
        if " " in mark.word and mark.entries and mark.entries[0].category == "occasions":
            text = re.sub(re.escape(mark.word), " ", text, flags=re.IGNORECASE)
    return text


def _figure(text: str) -> str | None:
    if _GROWN.search(text):
        text = re.sub(_CHILD, " ", text, flags=re.IGNORECASE)
    for figure in ("children", "men", "women"):
        if re.search(rf"(?<![\w-])(?:{_FIGURES[figure]})(?![\w-])", text, re.IGNORECASE):
            return figure
    return None


def _wearer(found: dict[str, str], measures: dict[str, float], figure: str | None) -> Wearer | None:
    size = found.get("size")
    kind = found.get("kind", "")
    if size is None and "age" in found:
        size, figure = f"UK {found['age']}", "children"
    if size is not None:
        title = _size_title(size, figure)
        if title is None:
            return None
        return Wearer(size=title, measures=measures or None)
    if kind.startswith(("plus", "curvy")):
        return Wearer(size=PLUS_SIZE, measures=measures or None)
    if kind in ("petite", "short"):
        measures.setdefault("height", PETITE_CM["women"] if figure != "men" else 166.0)
        figure = figure or "women"
    elif kind == "tall" and figure in TALL_CM:
        measures.setdefault("height", TALL_CM[figure])
    if measures:
        return Wearer(measures=measures, figure=figure)
    return Wearer(size=CHILD_SIZE) if figure == "children" else None


def _size_title(size: str, figure: str | None) -> str | None:
    """The size of a chart that is meant; a number that no EU chart has is British."""
    for attempt in (f"{figure or ''} {size}", f"{figure or ''} UK {size}", f"{figure or ''} US {size}"):
        try:
            return find_size(attempt).title
        except InputError:
            continue
    return None


_Take = Callable[[re.Match[str], dict[str, str], dict[str, float]], bool]


def _size(match: re.Match[str], found: dict[str, str], measures: dict[str, float]) -> bool:
    groups = {k: v for k, v in match.groupdict().items() if v}
    label = groups.get("number") or groups.get("letter") or _WORD_SIZES[groups["word"].lower()]
    region = groups.get("before") or groups.get("between") or groups.get("after") or ""
    known = {one for chart in charts().values() for one in chart}
    if "size" in found or label.upper() not in known:
        return False
    found["size"] = f"{region} {label}".strip()
    return True


def _kind(match: re.Match[str], found: dict[str, str], measures: dict[str, float]) -> bool:
    found["kind"] = match["kind"].lower()
    return True


def _age(match: re.Match[str], found: dict[str, str], measures: dict[str, float]) -> bool:
    age = int(match["age"] or match["aged"])
    if not 4 <= age <= 12:
        return False
    found["age"] = str(age)
    return True


def _height(match: re.Match[str], found: dict[str, str], measures: dict[str, float]) -> bool:
    groups = match.groupdict()
    value = float(groups.get("cm") or 0) or 100.0 * float(groups.get("m") or 0)
    if not 95.0 <= value <= 215.0:
        return False
    measures["height"] = value
    return True


def _compiled(pattern: str, take: _Take) -> tuple[re.Pattern[str], _Take]:
    return re.compile(pattern, re.IGNORECASE), take


_IN = r"(?:\b(?:in|of|a|an)\s+)*"
_WHO = rf"(?:(?:for\s+)?(?:an?\s+|my\s+)?(?:{_ANYBODY})\s+)?"
_INCHES = r"(?:inch(?:es)?\b|in\b|[\"”″]|'')"
_GIRTH = (
    r"(?:\b(?:with|and|a|of|at)\s+)*\b(?:(?P<before>\d{2,3}(?:\.\d)?)[\s-]*"
    rf"(?:cm|(?P<inches>{_INCHES}))\s+(?P<name>bust|chest|waist|hips?)\b"
    r"|(?P<name2>bust|chest|waist|hips?)\s*(?:of|is|are|:|=)?\s*(?P<after>\d{2,3}(?:\.\d)?)"
    rf"(?:\s*(?:cm\b|(?P<inches2>{_INCHES}))|\b(?!\s*cm)))"
)


def _either_girth(match: re.Match[str], found: dict[str, str], measures: dict[str, float]) -> bool:
    value = float(match["before"] or match["after"])
    value *= CM_PER_INCH if match["inches"] or match["inches2"] else 1.0
    name = (match["name"] or match["name2"]).lower()
    if not 45.0 <= value <= 180.0:
        return False
    measures["bust" if name == "chest" else "hips" if name == "hip" else name] = value
    return True


_PHRASES = [
    _compiled(
        rf"{_IN}\b(?:(?P<before>{_REGION})\s+)?size\s+(?:(?P<between>{_REGION})\s*)?"
        rf"(?:(?P<number>\d{{1,3}})|(?P<letter>{_LETTER})|(?P<word>(?:extra )?(?:small|large)|medium))\b"
        rf"(?:\s+(?P<after>{_REGION})\b)?",
        _size,
    ),
    _compiled(rf"{_IN}\b(?P<before>{_REGION})\s*(?P<number>\d{{1,3}})\b", _size),
    _compiled(r"(?:\bin\s+|\ban?\s+)?(?<![\w-])(?P<letter>XXS|XS|XXL|XL|2XL)(?![\w-])", _size),
    _compiled(
        r"(?:\bfor\s+)?(?:\ban?\s+)?\b(?P<age>\d{1,2})[- ]years?[- ]olds?\b|\baged?\s+(?P<aged>\d{1,2})\b",
        _age,
    ),
    _compiled(
        rf"{_WHO}\b(?:who (?:is|am)\s+|of\s+|is\s+|am\s+)?"
        r"(?:(?P<cm>\d{2,3})\s*cm|(?P<m>[12]\.\d{1,2})\s*m)\s+"
        r"(?:tall|high|in height)\b",
        _height,
    ),
    _compiled(
        rf"\bfor\s+(?:an?\s+|my\s+)?(?:{_TALL_OR}\s+)?(?:{_ANYBODY})\s+(?:of|with)\s+"
        r"(?:(?P<cm>\d{3})\s*cm|(?P<m>[12]\.\d{1,2})\s*m)\b",
        _height,
    ),
    _compiled(
        r"(?:\bwith\s+)?(?:\ban?\s+)?\b(?:height|stature)\s*(?:of|is|:|=)?\s*(?:(?P<cm>\d{3})(?:\s*cm)?|(?P<m>[12]\.\d{1,2})\s*m)\b",
        _height,
    ),
    _compiled(_GIRTH, _either_girth),
    _compiled(_GIRTH, _either_girth),
    _compiled(_GIRTH, _either_girth),
    _compiled(rf"\bfor\s+(?:an?\s+|my\s+)?(?P<kind>{_TALL_OR})\s+(?:{_ANYBODY})\b", _kind),
    _compiled(
        r"(?:\bin\s+)?(?<![\w-])(?P<kind>petite|plus[- ]sized?|curvy)\b(?:\s+(?:figure|woman|women|lady))?",
        _kind,
    ),
]
"""What is looked for, in this order; each phrase once."""

"""Who is to wear a garment, as a text says it: sizes, heights, girths, figures and ages."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache

from swifttailor.body.size_charts import find_size
from swifttailor.body.wearer import Wearer
from swifttailor.inches import CM_PER_INCH
from swifttailor.wishes.text.figures_plainly import figures_plainly
from swifttailor.wishes.wearers.body_ages import OF_AGES, SMALLEST, hear_age
from swifttailor.wishes.wearers.body_arms import hear_arms
from swifttailor.wishes.wearers.body_builds import hear_build
from swifttailor.wishes.wearers.body_figures import is_for_a_child, spoken_figure
from swifttailor.wishes.wearers.body_girths import hear_girths
from swifttailor.wishes.wearers.body_heights import hear_height
from swifttailor.wishes.wearers.body_legs import hear_legs
from swifttailor.wishes.wearers.body_said import SaidBody
from swifttailor.wishes.wearers.body_sizes import hear_size
from swifttailor.wishes.wearers.grown_girls import with_grown_girls
from swifttailor.wishes.wearers.not_the_wearer import hide_others, with_finished_chest
from swifttailor.wishes.wearers.spelt_heights import with_digits
from swifttailor.wording.lexicon import read_words

PETITE_CM, TALL_CM = {"women": 157.0, "men": 166.0}, {"women": 180.0, "men": 192.0}
"""Heights of those who are called so."""
TALL_ANYBODY_CM = 186.0
PLUS_SIZES = {"women": "women EU 50", "men": "men EU 58"}
CHILD_SIZE = "children EU 128"
"""A child of whom nothing else is said."""

_FIGURES = {
    "women": r"women'?s?|woman'?s?|lad(?:y|ies)'?s?|her|wife|mother|mum|mom|girlfriend",
    "men": r"men'?s?|man'?s?|gent(?:s|lemen|leman)?'?s?|him|husband|father|dad|boyfriend",
    "children": r"child(?:ren)?'?s?|kid'?s?|girl'?s?|boy'?s?|daughter|son|toddler|kiddos?"
    r"|grand(?:son|daughter|child)|(?:my|our|the|her|his) (?:little|wee) ones?",
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
_PERSON = (
    r"(?<!\w)(i['’]?m|i am|she['’]?s|he['’]?s|who['’]?s|someone|somebody"
    r"|(?:she|he|who|son|daughter|husband|wife|brother|sister) is|(?:a )?(?:wo)?man of)"
)
_ABOUT = r"(?:(?:nearly|almost|over|about|around|just|only|under) )*"
_FEET = re.compile(
    rf"{_PERSON} {_ABOUT}([4-6]) ?(?:ft|feet|foot)(?!\w)(?: (?:nothing|nowt|exactly))?{_TALL}", re.IGNORECASE
)
_FEET_TALL = re.compile(r"(?<![\w.,'’])([4-6]) ?(?:ft|feet|foot) (?:tall|in height)(?!\w)", re.IGNORECASE)
_HEIGHT_FEET = re.compile(
    r"(?<!\w)(?:height|stature)[\s:=]*(?:is |of )?([4-6]) ?(?:ft|feet|foot)(?!\w)", re.IGNORECASE
)
_METRIC = re.compile(rf"{_PERSON} (\d{{3}} ?cm|[12]\.\d{{1,2}} ?m)(?!\w){_TALL}", re.IGNORECASE)
"""Heights of people: "I'm 6ft", "someone 1.80 m"."""


_NAMES_FIGURE = re.compile(rf"(?<![\w-])(?:{_ANYBODY})(?![\w-])", re.IGNORECASE)
"""What any look that is no wearer is looked for beside."""


@dataclass(frozen=True)
class HeardWearer:
    """What a text says of the wearer."""

    wearer: Wearer | None
    """None where it says nothing that changes the body."""
    rest: str
    """The text without the words that say it."""
    notes: tuple[str, ...] = ()
    """What of the body is otherwise than it is said, for a person."""


@lru_cache(maxsize=16)  # each stage of an order asks for it
def hear_wearer(text: str, *, instruction: bool = False) -> HeardWearer:
    """Takes out of a text what it says of who wears the garment.

    A lone "women's" or "men's" changes nothing: garments are made for the default body then.

    Args:
        text: Description or instruction.
        instruction: Whether it says what to change, so that girths are the garment's and not the wearer's.
    """
    text = with_grown_girls(_with_metric_heights(text if instruction else figures_plainly(text)))
    hidden = hide_others(text if instruction else with_finished_chest(text))
    text = hidden.text
    said = SaidBody(text)
    figure = _figure(_without_looks(text)) if _NAMES_FIGURE.search(text) else None
    child = "children" in (figure, spoken_figure(text)) and not _GROWN.search(text)
    hear_age(said, child=child)
    child = child or said.age is not None or said.is_baby
    _hear_phrases(said, _HEIGHTS)
    hear_height(said)
    _hear_phrases(said, _KINDS)
    if not instruction:
        hear_girths(said, child=child)
        hear_legs(said)
    spoken = figure or spoken_figure(text)
    if not instruction:
        hear_arms(said, spoken)
    hear_size(said, spoken, child=child)
    if not said.build and not instruction:
        hear_build(said)
    wearer = _wearer(said, figure, spoken, child=child and (figure == "children" or is_for_a_child(text)))
    if wearer is None:
        return HeardWearer(None, hidden.shown(text))
    rest = said.text
    rest = re.sub(rf"\bfor (?:an? |my )?(?:{_ANYBODY})\b(?!['\w])", " ", rest, flags=re.IGNORECASE)
    if figure == "children":
        rest = _without_children(rest)
    rest = re.sub(r"\s+([,.;])", r"\1", " ".join(rest.split()))
    rest = re.sub(r"(?:[,;]\s*)+(?=[,;.]|$)", "", rest).strip(" ,;")
    return HeardWearer(wearer, hidden.shown(rest), tuple(said.notes))


def _hear_phrases(said: SaidBody, phrases: Sequence[tuple[re.Pattern[str], _Take]]) -> None:
    for pattern, take in phrases:
        match = pattern.search(said.text)
        if match is not None and take(match, said):
            said.take(match)


def _with_metric_heights(text: str) -> str:
    """The text with the heights of people as "160 cm tall"."""

    def metric(feet: str, inches: str) -> str:
        return f"{CM_PER_INCH * (12 * int(feet) + int(inches)):.0f} cm tall"

    text = with_digits(text)
    text = _METRES_AND.sub(r"\1.\2 m", text)
    text = _FEET_AND_INCHES.sub(lambda found: metric(found[1], found[2]), text)
    text = _FEET.sub(lambda found: f"{found[1]} {metric(found[2], '0')}", text)
    for pattern in (_FEET_TALL, _HEIGHT_FEET):
        text = pattern.sub(lambda found: metric(found[1], "0"), text)
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


def _wearer(said: SaidBody, figure: str | None, spoken: str | None, *, child: bool) -> Wearer | None:
    """Who wears it; None where nothing is said that changes the body.

    Args:
        said: What the text says of the body.
        figure: As English words name it.
        spoken: As any words do.
        child: Whether it is for a child of whom nothing else is said.
    """
    measures = dict(said.measures)
    size = _size_title(said, spoken)
    grown = None if spoken == "children" and size is None and not child else spoken
    if said.build == "petite" and not child:
        grown = grown or "women"
        measures.setdefault("height", PETITE_CM.get(grown, PETITE_CM["women"]))
    elif said.build == "tall" and not child:
        measures.setdefault("height", TALL_CM.get(grown or ("women" if size else ""), TALL_ANYBODY_CM))
    if size is not None:
        return Wearer(size=size, measures=measures or None, nearest=True)
    if said.build == "plus" and not {"bust", "waist", "hips"} & set(measures) and said.kg is None:
        plus = PLUS_SIZES.get(spoken or "", PLUS_SIZES["women"])
        return Wearer(size=plus, measures=measures or None, nearest=True)
    if measures or said.kg is not None:
        return Wearer(measures=measures or None, figure=grown, weight=said.kg, nearest=True)
    return Wearer(size=CHILD_SIZE, nearest=True) if child else None


def _size_title(said: SaidBody, figure: str | None) -> str | None:
    """The size of a chart that is meant, named whole."""
    if said.size.startswith("children"):
        return find_size(said.size).title
    if said.size and said.size.isdigit():
        return find_size(f"{'men' if figure == 'men' else 'women'} {said.region} {said.size}").title
    if said.size:
        return find_size(f"{'men' if figure == 'men' else 'women'} {said.size}").title
    if said.is_baby:
        return find_size(SMALLEST).title
    # A height says more of a child than its age.
    return (
        None
        if said.age is None or "height" in said.measures
        else find_size(OF_AGES.get(said.age, SMALLEST)).title
    )


_Take = Callable[[re.Match[str], SaidBody], bool]


def _kind(match: re.Match[str], said: SaidBody) -> bool:
    kind = match["kind"].lower()
    said.build = "plus" if kind.startswith(("plus", "curvy")) else "tall" if kind == "tall" else "petite"
    return True


def _height(match: re.Match[str], said: SaidBody) -> bool:
    groups = match.groupdict()
    value = float(groups.get("cm") or 0) or 100.0 * float(groups.get("m") or 0)
    if not 75.0 <= value <= 225.0:
        return False
    said.measures["height"] = round(value, 1)
    return True


def _compiled(pattern: str, take: _Take) -> tuple[re.Pattern[str], _Take]:
    return re.compile(pattern, re.IGNORECASE), take


_WHO = rf"(?:(?:for\s+)?(?:an?\s+|my\s+)?(?:{_ANYBODY})\s+)?"
_HEIGHTS = [
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
]
"""What English says of heights, in this order; each phrase once."""
_KINDS = [
    _compiled(rf"\bfor\s+(?:an?\s+|my\s+)?(?P<kind>{_TALL_OR})\s+(?:{_ANYBODY})\b", _kind),
    _compiled(rf"(?:^\W*|\b(?:i['’]?m|i am|as)\s+an?\s+)(?P<kind>{_TALL_OR})\s+(?:{_ANYBODY})\b", _kind),
    _compiled(
        r"(?:\bin\s+)?(?<![\w-])(?P<kind>petite|plus[- ]sized?|curvy)\b(?:\s+(?:figure|woman|women|lady))?",
        _kind,
    ),
]
"""What English says of builds."""

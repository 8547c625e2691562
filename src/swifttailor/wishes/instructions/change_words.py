"""The words of changes, from their table, as patterns that find them."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from swifttailor.wishes.instructions.change_parts import PARTS, Property
from swifttailor.wording.word_tables import Row, read_table

_TABLE = Path(__file__).with_name("change_words.txt")
_NOT = (
    r"(?<!\w)(?:not|never|hardly|barely|nowhere near|far from|(?:is|are|was|were|does|do)n['’]?t"
    r"(?: feel| look| seem| sit| fall| fit)?)"
)
_PROPERTIES: tuple[Property, ...] = ("length", "width", "height", "depth")
_SIGNS = {"+": 1, "-": -1}


@dataclass(frozen=True, slots=True)
class ChangeWord:
    """A word that says that something is to grow or to shrink, with its place in a text."""

    start: int
    end: int
    what: Property
    sign: int
    verb: tuple[int, int] | None = None
    """Where the rest of it stands, which the part may be between: "bring" of "bring the waist in"."""


@dataclass(frozen=True, slots=True)
class PartWord:
    """A part of a garment that a text names."""

    start: int
    end: int
    part: str
    word: str


def find_changes(text: str) -> list[ChangeWord]:
    """Words of changes in their order: "longer", "too tight", "less baggy".

    Args:
        text: In lower case.
    """
    pattern, meaning = _compiled()
    found = []
    for match in pattern.finditer(text):
        if match["grow"] and _CLOSING.match(text, match.start()) and _is_of_closing(text, match):
            continue
        if match["lacking"]:
            found.append(ChangeWord(match.start(), match.end(), *meaning["adjectives"][match["lacking"]]))
        elif match["adjective"]:
            what, sign = meaning["adjectives"][match["adjective"]]
            found.append(ChangeWord(match.start(), match.end(), what, sign if match["more"] else -sign))
        else:
            found.append(ChangeWord(match.start(), match.end(), *meaning["grow"][match["grow"]]))
    for word in (*_apart(text), *_of_nouns(text)):
        spans = [(word.start, word.end)] + ([] if word.verb is None else [word.verb])
        found = [w for w in found if not any(a < w.end and w.start < b for a, b in spans)]
        found.append(word)
    return sorted(found, key=lambda word: word.start)


_CLOSING = re.compile(r"(?:up|down)(?!\w)")
_RUNS = re.compile(
    r"(?:up|down) (?:the |my |its |each |both |one |either )?(?:(?:centre|center|middle of the) )?"
    r"(?:whole )?(?:front|back|sides?|left|right|centre|center|middle|seams?|legs?|sleeves?|arms?)(?!\w)"
)
_CLOSED = re.compile(
    r"(?:zip(?:per)?|button|lac|tie|snap|popper|hook|done|do|fasten|slit|split|open|cut|stripe|piping"
    r"|ruffle|frill|stay|stand|hold|end|show)\w*(?: it)?(?: all the way| right| straight| open)?[ -]$"
)


def _is_of_closing(text: str, match: re.Match[str]) -> bool:
    """Whether "up" or "down" says where a zip runs, and moves no edge: "lace-up", "zip up the back"."""
    closed = _CLOSED.search(text[: match.start()]) is not None
    return closed and (
        _RUNS.match(text, match.start()) is not None
        or text[match.start() - 1] == "-"
        or text[match.end() : match.end() + 1] in ("", ",", ".")
    )


_BEFORE = re.compile(
    r"\W*(?:(?:make|have|want|it|them|this|the|an?|bit|little|lot|much|way|even|just|please|pls|plz|can|could"
    r"|you|we|i|sm|so|like|maybe|ok|okay|hey|um|hm+|soo+|waa+y|far|slightly|tad|touch)\W+)*"
)


def begins_with_change(text: str) -> bool:
    """Whether a text says first of all what is to change: "way baggier, like I borrowed it".

    Args:
        text: In any case.
    """
    small = text.lower()
    at = _BEFORE.match(small)
    return at is not None and any(word.start == at.end() for word in find_changes(small))


def _apart(text: str) -> list[ChangeWord]:
    """Verbs with their particles behind what they are said of: "bring the waist in"."""
    found = []
    for (what, sign), pattern in _apart_patterns():
        found += [
            ChangeWord(m.start("particle"), m.end("particle"), what, sign, m.span("verb"))
            for m in pattern.finditer(text)
        ]
    return found


@cache
def _apart_patterns() -> list[tuple[tuple[Property, int], re.Pattern[str]]]:
    found = []
    for row in _rows("apart"):
        what, sign, particle = row.words
        if what not in _PROPERTIES or sign not in _SIGNS:
            row.wrong(f"'{what} {sign}' is no property with + or -.")
        verbs = _any_of(list(row.texts)).pattern
        # "in the front" and "in blue" say where and how, not that something is taken in.
        behind = (
            r"(?= (?:a|by|at|around|round|some|to|so|just|slightly|from|below|above|\d)\b"
            r"|\W*$|[.,;:!?)]| and\b| please\b)"
        )
        pattern = rf"(?P<verb>{verbs})(?: [\w'’]+){{1,5}}? (?P<particle>{particle}){behind}"
        found.append(((what, _SIGNS[sign]), re.compile(pattern)))
    return found


def _of_nouns(text: str) -> list[ChangeWord]:
    """What there is to be more or less of: "more cloth in the skirt", "take the fullness out"."""
    found = []
    for m in _nouns().finditer(text):
        noun = m["noun"] or m["first"]
        what = _noun_meanings()[noun]
        sign = 1 if m["add"] or m["after"] else -1
        found.append(
            ChangeWord(
                m.start("noun" if m["noun"] else "first"),
                m.end("noun" if m["noun"] else "first"),
                what,
                sign,
                m.span("add" if m["add"] else "take" if m["take"] else "after"),
            )
        )
    return found


@cache
def _noun_meanings() -> dict[str, Property]:
    found: dict[str, Property] = {}
    for row in _rows("nouns"):
        (what,) = row.words
        if what not in _PROPERTIES:
            row.wrong(f"'{what}' is no property. Known: {', '.join(_PROPERTIES)}.")
        found |= dict.fromkeys(row.texts, what)
    return found


@cache
def _nouns() -> re.Pattern[str]:
    add, take = (
        _any_of([word for row in _rows(section) for word in row.texts]).pattern
        for section in ("adding", "taking")
    )
    nouns = _any_of(list(_noun_meanings())).pattern
    amount = r"(?: \d+(?:[.,]\d+)? ?(?:cm|mm|inch(?:es)?|in|zoll)?(?: (?:out|off|away|from))?(?: of)?)?"
    between = rf"{amount}(?: (?!to\b|with\b|in\b|at\b)[\w'’%]+){{0,3}}? "
    few = r"(?:is|are|seems) (?:insufficient|too little|not enough)"
    return re.compile(
        rf"(?:(?P<take>{take})|(?P<add>{add})){between}(?P<noun>{nouns})"
        rf"|(?P<first>{nouns})[^.,;]{{0,30}}? (?P<after>{few})"
    )


def find_adjectives(text: str) -> list[ChangeWord]:
    """Adjectives that say what something is to be like: "make it tight".

    Args:
        text: In lower case.
    """
    _, meaning = _compiled()
    return [
        ChangeWord(m.start(), m.end(), *meaning["adjectives"][m[0]]) for m in _adjectives().finditer(text)
    ]


@cache
def _adjectives() -> re.Pattern[str]:
    return _any_of(list(_compiled()[1]["adjectives"]))


def find_parts(text: str) -> list[PartWord]:
    """Parts of garments that a text names, in their order.

    Args:
        text: In lower case.
    """
    pattern, part_of = _parts()
    return [PartWord(m.start(), m.end(), part_of[m[0]], m[0]) for m in pattern.finditer(text)]


@cache
def kept_words() -> re.Pattern[str]:
    """What says that something is to stay; who keeps rolling the sleeves up says nothing of the kind."""
    words = _any_of([word for row in _rows("keep") for word in row.texts]).pattern
    # "Like the sleeves" at the beginning of a clause, but not "flared like the seventies".
    return re.compile(rf"(?:{words}|(?<!\w )(?<!\w)like the(?!\w))(?! (?:on )?(?!being )\w{{3,}}ing(?!\w))")


@cache
def target_words() -> str:
    """A pattern of the words before what a garment is to become."""
    return _any_of([word for row in _rows("target") for word in row.texts]).pattern


@cache
def _compiled() -> tuple[re.Pattern[str], dict[str, dict[str, tuple[Property, int]]]]:
    meaning: dict[str, dict[str, tuple[Property, int]]] = {"grow": {}, "adjectives": {}}
    for section, found in meaning.items():
        for row in _rows(section):
            what, sign = row.words
            if what not in _PROPERTIES or sign not in _SIGNS:
                row.wrong(f"'{what} {sign}' is no property with + or -.")
            found.update(dict.fromkeys(row.texts, (what, _SIGNS[sign])))
    more, less, adjective, grow = (
        _any_of(list(words)).pattern
        for words in (
            [word for row in _rows("more") for word in row.texts],
            [word for row in _rows("less") for word in row.texts],
            meaning["adjectives"],
            meaning["grow"],
        )
    )
    degree = r"(?:(?:a )?(?:bit|lil|little|tad|tiny bit|touch) )?"
    # "Not long enough" asks for more of what "too long" asks for less of.
    lacking = (
        rf"{_NOT}(?: (?:quite|nearly|really|anywhere near|at all))? (?P<lacking>{adjective}) enough(?!\w)"
    )
    compared = rf"(?:(?P<more>{more})|(?P<less>{less})) {degree}(?P<adjective>{adjective})"
    pattern = rf"{lacking}|{compared}|(?P<grow>{grow})"
    return re.compile(pattern), meaning


@cache
def _parts() -> tuple[re.Pattern[str], dict[str, str]]:
    found = {}
    for row in _rows("parts"):
        if len(row.words) != 1 or row.words[0] not in PARTS:
            row.wrong(f"{' '.join(row.words)!r} is no part. Known: {', '.join(sorted(PARTS))}.")
        found.update(dict.fromkeys(row.texts, row.words[0]))
    return _any_of(list(found)), found


def _any_of(words: list[str]) -> re.Pattern[str]:
    longest = sorted(map(re.escape, words), key=len, reverse=True)
    return re.compile(rf"(?<!\w)(?:{'|'.join(longest)})(?!\w)")


def _rows(section: str) -> list[Row]:
    return [row for row in _table() if row.section == section]


@cache
def _table() -> list[Row]:
    return read_table(_TABLE)

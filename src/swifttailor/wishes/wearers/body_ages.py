"""Children and how old they are, as people write it."""

from __future__ import annotations

import re
from functools import cache

from swifttailor.wishes.wearers.body_said import SaidBody
from swifttailor.wishes.wearers.body_sizes import BABY
from swifttailor.wishes.wearers.body_words import any_of, whole_word

SMALLEST = "children EU 98"
OF_AGES = {
    2: SMALLEST,
    3: SMALLEST,
    **{age: f"children UK {age}" for age in range(4, 13)},
    13: "children EU 158",
}
"""Sizes of children by their age in years; who is older is grown."""
_NUMBER_WORDS = {
    **dict(
        zip(
            "two three four five six seven eight nine ten eleven twelve thirteen".split(),
            range(2, 14),
            strict=True,
        )
    ),
    **dict(zip("drei vier fünf sechs sieben acht neun zehn elf zwölf".split(), range(3, 13), strict=True)),
    **dict(zip("trois quatre cinq six sept huit neuf dix onze douze".split(), range(3, 13), strict=True)),
    **dict(zip("tres cuatro cinco seis siete ocho nueve diez once doce".split(), range(3, 13), strict=True)),
}
_COUNT = rf"(?:\d{{1,2}}|{'|'.join(_NUMBER_WORDS)})"


@cache
def _years() -> re.Pattern[str]:
    years, lead = any_of("ages", "years"), any_of("ages", "lead")
    before, behind = any_of("ages", "not_after"), any_of("ages", "not_before")
    return re.compile(
        rf"(?:(?<!\w)(?P<lead>{lead})\s+(?:\d{{1,2}}\s?[-–/]\s?)?(?P<aged>{_COUNT})"
        rf"(?:\s+(?:to|-)\s+\d{{1,2}})?(?:\s+{years})?(?!\w|[.,]\d)"
        rf"|(?P<not>(?<!\w){before}\s+)?"
        r"(?:(?<!\w)(?:who is|is|aged|hat|tiene|an?|für|for|de|von|pour|para)\s+)*"
        rf"(?<![\w.,-])(?:\d{{1,2}}\s?(?:[-–/]|to|bis|à|a)\s?)?(?P<age>{_COUNT})[\s-]?(?P<years>{years})(?!\w)"
        rf"(?!\s+{behind}(?!\w)))",
        re.IGNORECASE,
    )


@cache
def _months() -> re.Pattern[str]:
    months = any_of("ages", "months")
    return re.compile(
        rf"(?:(?<!\w)(?:de|von|für|for|aged?|a|an)\s+)*(?<![\w.,-])(?:\d{{1,2}}\s?(?:[-–/]|to|bis|à|a)\s?)?"
        rf"(?P<months>\d{{1,2}})[\s-]?{months}(?!\w)(?!\s+(?:pregnant|schwanger|ago|later|enceinte))",
        re.IGNORECASE,
    )


@cache
def _lone() -> re.Pattern[str]:
    """A bare number beside a child: "my son (11)", "my grandson is 3"."""
    return re.compile(
        rf"(?<!\w){any_of('figures', 'children')}\s*(?:is|ist|of|[,(])\s*(?P<age>1[0-3]|[1-9])"
        r"(?=\s*(?:[,.;)!?]|$))",
        re.IGNORECASE,
    )


_TODDLERS = re.compile(r"(?<![\w-])(?P<age>[2-6])T(?![\w-])")
"""American sizes of small children."""
_OLD = re.compile(r"old|alt|jährig|ans|años|anni|yo|y/o|yrs?$|y\.o", re.IGNORECASE)
_CLAUSE_ENDS = re.compile(
    r"^\s*(?:[,.;:!?)/]|$|(?:boy|girl|junge|mädchen|child|kid|slim|tall)(?!\w))", re.IGNORECASE
)


def hear_age(said: SaidBody, *, child: bool) -> None:
    """Takes the age of a child out of a text; of grown people it says nothing.

    Args:
        said: What was found so far; it is added to.
        child: Whether the text speaks of a child.
    """
    baby = whole_word("figures", "baby").search(said.text)
    months = next(
        (
            m
            for m in _months().finditer(said.text)
            if int(m["months"]) <= 36 and (child or baby or _ends(said, m))
        ),
        None,
    )
    if months is not None:
        said.take(months)
        baby = whole_word("figures", "baby").search(said.text)
    if baby is not None:
        said.take(baby)
    if baby is not None or months is not None:
        said.is_baby = True
        said.notes.append(BABY.format(tall=98))
        return
    lone = (_lone().search(said.text) if child else None) or _TODDLERS.search(said.text)
    if lone is not None:
        word = lone.groupdict().get("age") or "2"
        said.age = int(word)
        end = lone.end() if lone.re is _TODDLERS else lone.end("age")
        said.text = f"{said.text[: lone.start('age')]} {said.text[end:]}"
        _note_small(said)
        return
    for match in _years().finditer(said.text):
        word = match["aged"] or match["age"]
        age = _NUMBER_WORDS.get(word.lower()) or (int(word) if word.isdigit() else 0)
        named = match["aged"] is not None or _OLD.search(match["years"] or "") is not None
        if match["not"] or not 1 <= age <= 13:
            continue
        if child or named or _ends(said, match):
            said.age = age
            said.take(match)
            _note_small(said)
            return


def _note_small(said: SaidBody) -> None:
    if said.age is not None and said.age < 3:
        said.is_baby = True
        said.notes.append(BABY.format(tall=98))


def _ends(said: SaidBody, match: re.Match[str]) -> bool:
    return _CLAUSE_ENDS.search(said.text[match.end() :]) is not None

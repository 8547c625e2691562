"""What can be asked for of a garment, from the tables in wording/phrases/."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import NamedTuple

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import QUANTITIES
from swifttailor.wording.claim_marks import check_places, claim_topics, claims_in
from swifttailor.wording.word_tables import Row, read_table

_PHRASES = Path(__file__).parents[1] / "phrases"
_DIRECTIONS = {"more": 1, "less": -1}
_NAMES = ("garment", "band")
"""What is filled into texts: what the garment is called, and which band it has."""
_AMOUNT = "by"


class GainWording(NamedTuple):
    """What can be asked for, in the imperative, when claims become true."""

    claims: tuple[Claim, ...]
    """The first has become true; the others are true afterwards."""
    was: tuple[Claim, ...]
    """What was true before."""
    was_not: tuple[Claim, ...]
    """What was not claimed before."""
    topic: str
    """What it speaks of; an instruction asks for one thing about it."""
    importance: float
    """9 for parts that come or go, down to 2 for what is hardly noticed."""
    texts: tuple[str, ...]


class StepWording(NamedTuple):
    """What can be asked for, in the imperative, when a measure grows or shrinks."""

    topic: str
    importance: float
    texts: tuple[str, ...]
    texts_by: tuple[str, ...]
    """With the amount, {by}."""


@cache
def gain_words() -> tuple[GainWording, ...]:
    """Words for what becomes true of a garment by an edit."""
    return gains_of(read_table(_PHRASES / "gains.txt"))


@cache
def step_words() -> Mapping[tuple[str, int], StepWording]:
    """Words for measures that grow or shrink, by quantity and direction: 1 for more, -1 for less."""
    return steps_of(read_table(_PHRASES / "steps.txt"))


def gains_of(rows: Iterable[Row]) -> tuple[GainWording, ...]:
    """The gains of a table.

    Raises:
        InputError: A row is wrong; the message names it.
    """
    found, said = [], set()
    for row in rows:
        row.check_options("about", "was", "not")
        if row.words or row.numbers or not row.claims:
            row.wrong("claims such as 'hood=hood' stand on the left, nothing else without '=' or ':'.")
        check_places(row, _NAMES)
        for text in row.texts:
            meant = text, row.claims, row.options.get("was"), row.options.get("not")
            if meant in said:
                row.wrong(f"'{text}' is asked for the same in another row already.")
            said.add(meant)
        claims = claims_in(row, row.claims)
        was, was_not = (claims_in(row, row.options.get(name, ())) for name in ("was", "not"))
        found.append(GainWording(claims, was, was_not, *_topic(row, claims[0].name), row.texts))
    return tuple(found)


def steps_of(rows: Iterable[Row]) -> Mapping[tuple[str, int], StepWording]:
    """The steps of a table, by quantity and direction.

    Raises:
        InputError: A row is wrong; the message names it.
    """
    found: dict[tuple[str, int], StepWording] = {}
    for row in rows:
        row.check_options("about")
        if len(row.words) != 2 or row.words[0] not in _DIRECTIONS or row.claims or row.numbers:
            row.wrong("'more' or 'less' and a measure stand on the left.")
        name = row.words[1]
        quantity = name.replace("_", " ")
        if quantity not in QUANTITIES:
            known = ", ".join(QUANTITIES).replace(" ", "_").replace(",_", ", ")
            row.wrong(f"there is no measure '{name}'. Known: {known}.")
        check_places(row, (*_NAMES, _AMOUNT))
        key = quantity, _DIRECTIONS[row.words[0]]
        if key in found:
            row.wrong(f"'{' '.join(row.words)}' has a row already; add the texts to it.")
        amounts = tuple(text for text in row.texts if f"{{{_AMOUNT}}}" in text)
        plain = tuple(text for text in row.texts if text not in amounts)
        if not plain:
            row.wrong("a text without {by} is wanted too, for where no amount is stated.")
        found[key] = StepWording(*_topic(row, name), plain, amounts)
    return found


def _topic(row: Row, name: str) -> tuple[str, float]:
    """Topic and importance."""
    if row.number is None:
        row.wrong("a number from 2 to 9 is missing before ' : ': how important it is.")
    if any("@" in text for text in row.texts):
        row.wrong("instructions are the same in every dialect; '@' has no meaning here.")
    (topic,) = row.options.get("about", (claim_topics().get(name, name),))
    return topic, row.number

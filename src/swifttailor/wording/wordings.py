"""Wordings: phrases with the claims that they make, from the tables in phrases/."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import Any, Literal, NamedTuple

from swifttailor.describing.claims import CLAIM_TYPES, Claim
from swifttailor.wording.claim_marks import check_numbers, check_places, claim_topics, claims_in
from swifttailor.wording.word_tables import Dialect, Row, by_dialect, read_table

Form = Literal["head", "adjective", "feature", "sentence", "tag"]
"""head: what the garment is called. adjective: before the head. feature: after "with". sentence: a whole one,
whose subject is {it}. tag: stands alone, as features can too."""
_FORMS: dict[str, Form] = {
    "heads": "head",
    "adjectives": "adjective",
    "features": "feature",
    "sentences": "sentence",
    "tags": "tag",
}
"""Sections of the tables."""
_TABLES = ("heads.txt", "upper.txt", "sleeves.txt", "lower.txt")
_SUBJECTS = ("it", "has", "sits")
"""What sentences leave open besides numbers."""
_NONE: frozenset[Any] = frozenset()


class Wording(NamedTuple):
    """Phrases for the same claims."""

    form: Form
    topics: frozenset[str]
    """What it speaks of; a caption speaks of nothing twice."""
    needs: tuple[Claim, ...]
    """The claims that it makes, numbers left out."""
    numbers: tuple[str, ...]
    """Names of the measures that it states; the texts hold {name}, or {name-} before a noun."""
    texts: Mapping[Dialect, tuple[str, ...]]
    weight: float
    """How often it is used, compared with others."""
    plural: bool
    """Whether a head is a plural, such as trousers."""
    kinds: frozenset[str]
    """Kinds of garments it can be said of, without claiming the kind; empty for any."""
    avoids: frozenset[Claim]
    """Claims beside which it would be odd, though not wrong."""


@cache
def all_wordings() -> tuple[Wording, ...]:
    """Everything that captions are written with, form after form."""
    folder = Path(__file__).with_name("phrases")
    return wordings_of(row for name in _TABLES for row in read_table(folder / name))


def wordings_of(rows: Iterable[Row]) -> tuple[Wording, ...]:
    """The wordings of tables, form after form.

    Raises:
        InputError: A row is wrong; the message names it.
    """
    found: dict[str, list[Wording]] = {section: [] for section in _FORMS}
    said: dict[str, dict[str, tuple[Row, ...]]] = {section: {} for section in _FORMS}
    for row in rows:
        if row.section not in found:
            row.wrong(f"there is no section '{row.section}'. Known: {', '.join(found)}.")
        wording = _wording(row, _FORMS[row.section])
        found[row.section].append(wording)
        before = said[row.section]
        for text in row.texts:
            others = before.get(text, ())
            for other in others:
                if {*other.claims} == {*row.claims} and other.options == row.options:
                    row.wrong(
                        f"'{text}' is said of the same already in {other.place[0]}, line {other.place[1]}."
                    )
            before[text] = (*others, row)
    return tuple([wording for wordings in found.values() for wording in wordings])


def _wording(row: Row, form: Form) -> Wording:
    if row.words and (row.words != ("plural",) or form != "head"):
        row.wrong(f"'{' '.join(row.words)}' is no mark; 'plural' is one of heads, others hold '=' or ':'.")
    claims = claims_in(row, row.claims)
    if row.numbers:
        check_numbers(row)
    check_places(row, _SUBJECTS if form == "sentence" else (), row.numbers)
    topic = claim_topics()
    topics = {topic[claim.name] for claim in claims}.union([topic[name] for name in row.numbers])
    kinds, avoids = _NONE, _NONE
    if row.options:
        row.check_options("about", "of", "not")
        topics.update(row.options.get("about", ()))
        kinds = frozenset(row.options.get("of", ()))
        avoids = frozenset(claims_in(row, row.options.get("not", ())))
        if not kinds <= CLAIM_TYPES["kind"].words.keys():
            known = ", ".join(CLAIM_TYPES["kind"].words)
            row.wrong(f"of:{','.join(row.options['of'])} is no kind. Known: {known}.")
    if form != "head":
        topics.discard("kind")
    return Wording(
        form,
        frozenset(topics),
        claims,
        row.numbers,
        by_dialect(row.texts),
        1.0 if row.number is None else row.number,
        bool(row.words),
        kinds,
        avoids,
    )

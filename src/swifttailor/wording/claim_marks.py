"""The claims in word tables: ``kind=dress``, ``sleeve_cm=?`` for any number, and what they speak of."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from functools import cache
from pathlib import Path

from swifttailor.describing.claims import CLAIM_TYPES, Claim
from swifttailor.errors import InputError
from swifttailor.wording.word_tables import Row, read_table


def claims_in(row: Row, marks: Iterable[str]) -> tuple[Claim, ...]:
    """The claims of marks such as ``skirt_hem=below_the_knee``.

    Raises:
        InputError: There is no such claim or value; the message names the row.
    """
    try:
        return tuple([_claim(mark) for mark in marks])
    except InputError as error:
        row.wrong(str(error))


def check_numbers(row: Row) -> None:
    """Looks whether there are claims that take the numbers of a row.

    Raises:
        InputError: There are not; the message names the row.
    """
    for name in row.numbers:
        if name not in CLAIM_TYPES or CLAIM_TYPES[name].measure is None:
            row.wrong(f"'{name}' is no number that can be claimed.")


def check_places(row: Row, allowed: Iterable[str], needed: Collection[str] = ()) -> None:
    """Looks whether what stands in braces in the texts of a row can be filled in.

    Args:
        row: Of a table.
        allowed: What may stand there.
        needed: What must stand in every text.

    Raises:
        InputError: It cannot, or something is missing; the message names the row.
    """
    together = "".join(row.texts)
    if not needed and "{" not in together and "}" not in together:
        return
    known = {*allowed, *needed}
    for text in row.texts:
        names = {part.partition("}")[0].removesuffix("-") for part in text.split("{")[1:]}
        if not known >= names >= {*needed} or text.count("{") != text.count("}"):
            listed = ", ".join(f"{{{name}}}" for name in sorted(known)) or "nothing"
            row.wrong(f"in braces can stand {listed}, and each number that is claimed must: '{text}'.")


@cache
def claim_topics() -> dict[str, str]:
    """What each claim speaks of, ``length`` for ``skirt_hem``; its own name where topics.txt is silent."""
    found: dict[str, str] = {}
    for row in read_table(Path(__file__).with_name("phrases") / "topics.txt"):
        if len(row.words) != 1 or row.claims or row.numbers or row.options or row.number is not None:
            row.wrong("a topic of one word stands on the left.")
        for name in row.texts:
            if name not in CLAIM_TYPES or name in found:
                row.wrong(f"'{name}' is no claim, or has a topic already.")
            found[name] = row.words[0]
    return {name: found.get(name, name) for name in CLAIM_TYPES}


@cache
def _claim(mark: str) -> Claim:
    name, _, value = mark.partition("=")
    return Claim(name, value.replace("_", " "))

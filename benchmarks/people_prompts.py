"""Reads the prompts of benchmarks/words, and refuses whatever its README does not describe.

Messages name file, line and key, never the text of a prompt: the final half is not to be read.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Set
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal, TypeVar

from swifttailor.describing import Claim
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.errors import InputError

WORDS = Path(__file__).resolve().parent / "words"
HALVES = ("building", "final")
MEASURES = frozenset(QUANTITIES) | {"waist", "hips"}
"""What an instruction may enlarge or reduce: known quantities, and two girths that people speak of."""
_CLOTH = ("colour", "print", "fabric")
_TEXTS = {"id", "voice", "text", "language"}
_ANSWERS = {"expect", "never", "cloth", "size", "cannot", "unknown", "contradiction", "garment"}
_PROMPT_KEYS = _TEXTS | _ANSWERS
_EDIT_KEYS = _PROMPT_KEYS | {"base", "steps", "keep"}

Sure = Literal["must", "should"]
T = TypeVar("T")


@dataclass(frozen=True)
class Expectation:
    """One of several statements is to hold, or a measure is to lie near a number."""

    claim: str
    values: tuple[str, ...] = ()
    """Any of these; none for a number."""
    number: float | None = None
    within: float = 0.0
    """Largest accepted distance from `number`."""
    sure: Sure = "must"


@dataclass(frozen=True)
class ExpectedStep:
    """A measure is to grow, to shrink, or to stay."""

    measures: tuple[str, ...]
    """Any of these; names from `MEASURES`."""
    direction: Literal["+", "-", "="]
    cm: float | None
    """By how much, in cm or pieces, where that is asked for."""
    sure: Sure


@dataclass(frozen=True)
class PeoplePrompt:
    """A wish for a garment in somebody's own words, and what should come of it."""

    id: str
    voice: str
    text: str = field(repr=False)
    language: str
    expect: tuple[Expectation, ...]
    never: tuple[Expectation, ...]
    """None of their values may hold."""
    cloth: Mapping[str, tuple[str, ...]]
    size: str | None
    cannot: tuple[str, ...]
    unknown: tuple[str, ...]
    contradiction: bool
    garment: bool


@dataclass(frozen=True)
class PeopleEdit(PeoplePrompt):
    """An instruction that changes a garment, and the garment it is meant for."""

    base: tuple[Claim, ...]
    """What is true of it beforehand; the first one is its kind."""
    steps: tuple[ExpectedStep, ...]
    keep: bool
    """Whether the text says that all else is to stay."""


def read_people_prompts(path: Path) -> tuple[PeoplePrompt, ...]:
    """Reads wishes.

    Raises:
        InputError: A line is not as benchmarks/words/README.md describes.
    """
    return tuple(PeoplePrompt(**_common(row, place)) for place, row in _rows(path, _PROMPT_KEYS))


def read_people_edits(path: Path) -> tuple[PeopleEdit, ...]:
    """Reads instructions.

    Raises:
        InputError: A line is not as benchmarks/words/README.md describes.
    """
    return tuple(
        PeopleEdit(
            **_common(row, place),
            base=_base(row["base"], place),
            steps=tuple(_step(item, place) for item in _items(row["steps"], "steps", place)),
            keep=_is(row["keep"], bool, "keep", place),
        )
        for place, row in _rows(path, _EDIT_KEYS)
    )


def _rows(path: Path, keys: set[str]) -> Iterable[tuple[str, dict[str, Any]]]:
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
        place = f"{path.parent.name}/{path.name}, line {number}"
        try:
            row = json.loads(line)
        except json.JSONDecodeError as error:
            raise InputError(f"{place}: not JSON ({error.msg}, column {error.colno}).") from None
        _keys(row, keys, "the line", place)
        yield place, row


def _common(row: dict[str, Any], place: str) -> dict[str, Any]:
    cloth = row["cloth"]
    _keys(cloth, set(), "cloth", place, optional=set(_CLOTH))
    return {
        **{key: _text(row[key], key, place) for key in _TEXTS},
        "expect": tuple(
            _expectation(item, "expect", place) for item in _items(row["expect"], "expect", place)
        ),
        "never": tuple(_expectation(item, "never", place) for item in _items(row["never"], "never", place)),
        "cloth": {key: _texts(words, f"cloth.{key}", place) for key, words in cloth.items()},
        "size": None if row["size"] is None else _text(row["size"], "size", place),
        "cannot": _texts(row["cannot"], "cannot", place, may_be_empty=True),
        "unknown": _texts(row["unknown"], "unknown", place, may_be_empty=True),
        "contradiction": _is(row["contradiction"], bool, "contradiction", place),
        "garment": _is(row["garment"], bool, "garment", place),
    }


def _expectation(item: Any, where: str, place: str) -> Expectation:
    judged = {"sure"} if where == "expect" else set()
    if isinstance(item, dict) and "number" in item and where == "expect":
        _keys(item, {"claim", "number", "within"} | judged, where, place)
        claim = _claim(item["claim"], _number(item["number"], where, place), place)
        within = _number(item["within"], where, place)
        return Expectation(claim.name, number=float(claim.value), within=within, sure=_sure(item, place))
    _keys(item, {"claim", "values"} | judged, where, place)
    values = _texts(item["values"], f"{where}.values", place)
    for value in values:
        _claim(item["claim"], value, place)
    return Expectation(item["claim"], values, sure=_sure(item, place) if judged else "must")


def _step(item: Any, place: str) -> ExpectedStep:
    _keys(item, {"measure", "direction", "cm", "sure"}, "steps", place, optional={"or"})
    measures = (
        _text(item["measure"], "steps.measure", place),
        *_texts(item.get("or", []), "or", place, True),
    )
    for name in measures:
        if name not in MEASURES:
            raise InputError(f"{place}: there is no measure {name!r}. Known: {', '.join(sorted(MEASURES))}.")
    if item["direction"] not in ("+", "-", "="):
        raise InputError(f"{place}: a step's direction is '+', '-' or '=', received {item['direction']!r}.")
    cm = None if item["cm"] is None else _number(item["cm"], "steps.cm", place)
    return ExpectedStep(measures, item["direction"], cm, _sure(item, place))


def _base(item: Any, place: str) -> tuple[Claim, ...]:
    _keys(item, {"kind", "statements"}, "base", place)
    claims = [_claim("kind", item["kind"], place)]
    for statement in _items(item["statements"], "base.statements", place):
        _keys(statement, {"claim", "value"}, "base.statements", place)
        claims.append(_claim(statement["claim"], statement["value"], place))
    return tuple(claims)


def _claim(name: Any, value: Any, place: str) -> Claim:
    try:
        return Claim(name, value)
    except InputError as error:
        raise InputError(f"{place}: {error}") from None


def _sure(item: dict[str, Any], place: str) -> Sure:
    if item["sure"] not in ("must", "should"):
        raise InputError(f"{place}: 'sure' is 'must' or 'should', received {item['sure']!r}.")
    return item["sure"]


def _keys(item: Any, keys: Set[str], where: str, place: str, optional: Set[str] = frozenset()) -> None:
    found = set(_is(item, dict, where, place))
    if missing := keys - found:
        raise InputError(f"{place}: {where} lacks {', '.join(sorted(missing))}.")
    if extra := found - keys - optional:
        raise InputError(f"{place}: {where} has unknown keys: {', '.join(sorted(extra))}.")


def _is(value: Any, kind: type[T], where: str, place: str) -> T:
    if not isinstance(value, kind):
        raise InputError(f"{place}: {where} is {type(value).__name__}; it should be {kind.__name__}.")
    return value


def _number(value: Any, where: str, place: str) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)) or value < 0:
        raise InputError(f"{place}: {where} takes a number from 0, received {value!r}.")
    return float(value)


def _text(value: Any, where: str, place: str) -> str:
    if not _is(value, str, where, place) or value != value.strip():
        raise InputError(f"{place}: {where} is empty or has blanks at its ends.")
    return value


def _items(value: Any, where: str, place: str) -> list[Any]:
    return _is(value, list, where, place)


def _texts(value: Any, where: str, place: str, may_be_empty: bool = False) -> tuple[str, ...]:
    words = tuple(_text(word, where, place) for word in _items(value, where, place))
    if not words and not may_be_empty:
        raise InputError(f"{place}: {where} is empty.")
    if len(set(words)) < len(words):
        raise InputError(f"{place}: {where} names something twice.")
    return words

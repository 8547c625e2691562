"""The statements and changes that can be read from a text, and their names."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache, lru_cache

from swifttailor.describing.claims import CLAIM_TYPES, Claim
from swifttailor.describing.differences import QUANTITIES, Change, Gain, Step
from swifttailor.errors import InputError

_GAIN, _STEP, _MEASURE = "gain", "step", "measure"
_DIRECTIONS = {"up": 1, "down": -1}


@cache
def statement_labels() -> tuple[str, ...]:
    """Names of all that can be said without a number: ``gain:neckline:v``, ``step:length:up``."""
    return tuple(_statements())


@cache
def number_labels() -> tuple[str, ...]:
    """Names of all that a number can be: ``measure:sleeve_cm``, ``step:length:up``."""
    measures = [f"{_MEASURE}:{t.name}" for t in CLAIM_TYPES.values() if t.measure is not None]
    return (*measures, *(label for label in _statements() if label.startswith(_STEP)))


def _statements() -> Iterator[str]:
    for kind in CLAIM_TYPES.values():
        for word in kind.words:
            yield f"{_GAIN}:{kind.name}:{word}"
    for quantity in QUANTITIES:
        for direction in _DIRECTIONS:
            yield f"{_STEP}:{quantity}:{direction}"


def label_of(change: Change) -> str:
    """The name of a change, its number left out."""
    if isinstance(change, Step):
        direction = next(name for name, sign in _DIRECTIONS.items() if sign == change.direction)
        return f"{_STEP}:{change.quantity}:{direction}"
    if isinstance(change.claim.value, str):
        return f"{_GAIN}:{change.claim.name}:{change.claim.value}"
    return f"{_MEASURE}:{change.claim.name}"


def change_of(label: str, number: float | None = None) -> Change:
    """The change of a name.

    Args:
        label: One of `statement_labels` or `number_labels`.
        number: What is said with it, cm or pieces.

    Raises:
        InputError: There is no such name.
    """
    if number is None:
        return _bare_change(label)
    kind, _, rest = label.partition(":")
    if kind == _MEASURE:
        return Gain(Claim(rest, number))
    return _change(label, number)


@lru_cache(maxsize=1024)
def _bare_change(label: str) -> Change:
    """A change without a number: the same object each time, since one text has hundreds that may be meant."""
    return _change(label, None)


def _change(label: str, number: float | None) -> Change:
    kind, _, rest = label.partition(":")
    name, _, value = rest.partition(":")
    if kind == _GAIN:
        return Gain(Claim(name, value))
    if kind == _STEP and value in _DIRECTIONS:
        return Step(name, _DIRECTIONS[value], number)
    raise InputError(
        f"There is no wish '{label}'. Wishes are called gain:CLAIM:VALUE, measure:CLAIM (with a number) and "
        "step:QUANTITY:up or :down."
    )

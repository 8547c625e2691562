"""Options of drafts: what a value may be, how it is declared, and how it is checked."""

from __future__ import annotations

import dataclasses
import difflib
import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Annotated, Any, Literal, get_args, get_origin, get_type_hints

from swifttailor.errors import PatternError


@dataclass(frozen=True)
class Option:
    """What the field of an options dataclass stands for; put it into ``Annotated[type, Option(...)]``."""

    help: str
    """One sentence, without the unit, range and default."""
    unit: str = ""
    """Such as ``cm`` or ``degrees``; empty for plain numbers, choices and switches."""
    low: float | None = None
    """Smallest value accepted."""
    high: float | None = None
    """Largest value accepted."""


@dataclass(frozen=True)
class OptionField:
    """An option as a caller sees it."""

    name: str
    kind: type
    """``float``, ``int``, ``bool`` or ``str`` (one of `choices`)."""
    default: float | int | bool | str
    option: Option
    choices: tuple[str, ...] = ()

    def accepted(self) -> str:
        """What may be given, in words, such as ``5 to 40 cm``."""
        if self.choices:
            return " or ".join(self.choices)
        if self.kind is bool:
            return "true or false"
        unit = f" {self.option.unit}" if self.option.unit else ""
        return f"{self.option.low:g} to {self.option.high:g}{unit}"

    def to_json(self) -> dict[str, object]:
        """The option as plain JSON values."""
        return {
            "name": self.name,
            "type": "choice" if self.choices else self.kind.__name__,
            "default": self.default,
            "unit": self.option.unit,
            "low": self.option.low,
            "high": self.option.high,
            "choices": list(self.choices),
            "help": self.option.help,
        }


@lru_cache(maxsize=64)
def option_fields(options_class: type[Any]) -> tuple[OptionField, ...]:
    """The options that a dataclass declares, in order."""
    hints = get_type_hints(options_class, include_extras=True)
    declared = []
    for field in dataclasses.fields(options_class):
        hint = hints[field.name]
        assert get_origin(hint) is Annotated, f"{options_class.__name__}.{field.name} must be Annotated"
        kind, option = get_args(hint)[:2]
        choices = get_args(kind) if get_origin(kind) is Literal else ()
        assert field.default is not dataclasses.MISSING, f"{field.name} must have a default"
        kind = str if choices else kind
        declared.append(OptionField(field.name, kind, field.default, option, tuple(map(str, choices))))
    return tuple(declared)


def make_options(draft: str, options_class: type, values: Mapping[str, Any]) -> Any:
    """Builds an options dataclass from named values; hyphens in names count as underscores.

    Raises:
        PatternError: A name is unknown, or a value is of the wrong kind or out of range.
    """
    known = {f.name: f for f in option_fields(options_class)}
    checked = {}
    for given, value in values.items():
        name = given.replace("-", "_")
        if name not in known:
            raise PatternError(_unknown(f"Draft '{draft}' has no option", given, list(known)))
        checked[name] = _checked(draft, known[name], value)
    return options_class(**checked)


def check_options(draft: str, options: Any) -> None:
    """Checks an options dataclass that was filled in directly (raises `PatternError`)."""
    for field in option_fields(type(options)):
        _checked(draft, field, getattr(options, field.name))


def _checked(draft: str, field: OptionField, value: Any) -> float | int | bool | str:
    """The value as its option's type."""
    refusal = PatternError(
        f"Draft '{draft}': option '{field.name}' must be {field.accepted()}, got {value!r} "
        f"(default {field.default})."
    )
    if field.choices or field.kind is bool:
        if (field.choices and value not in field.choices) or (
            field.kind is bool and not isinstance(value, bool)
        ):
            raise refusal
        return value
    try:
        number = float(value)
    except (TypeError, ValueError, OverflowError):
        raise refusal from None
    low, high = field.option.low, field.option.high
    assert low is not None and high is not None, f"option {field.name} declares no range"
    whole = field.kind is not int or number.is_integer()
    if isinstance(value, bool) or not math.isfinite(number) or not low <= number <= high or not whole:
        raise refusal
    return int(number) if field.kind is int else number


def _unknown(what: str, given: str, known: list[str]) -> str:
    near = difflib.get_close_matches(given.replace("-", "_"), known, n=3, cutoff=0.4)
    meant = f" Did you mean {' or '.join(repr(n) for n in near)}?" if near else ""
    return f"{what} '{given}'.{meant} Known: {', '.join(known)}."

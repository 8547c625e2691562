"""Facts as JSON values and back: measuring takes half a tenth of a second, so they are kept."""

from __future__ import annotations

import dataclasses
import types
import typing
from functools import cache
from typing import Any

from swifttailor.describing.facts import GarmentFacts


def facts_values(facts: GarmentFacts) -> dict[str, Any]:
    """Facts as JSON values."""
    return dataclasses.asdict(facts)


def facts_from(values: dict[str, Any]) -> GarmentFacts:
    """The inverse of `facts_values`.

    Raises:
        TypeError, KeyError, ValueError: They are not those of facts.
    """
    return _read(GarmentFacts, values)


def _read(kind: Any, value: Any) -> Any:
    if value is None:
        return None
    if dataclasses.is_dataclass(kind):
        known = {
            name: hint for name, hint in _hints(kind).items() if name in value or name not in _later(kind)
        }
        return kind(**{name: _read(hint, value[name]) for name, hint in known.items()})
    if typing.get_origin(kind) in (types.UnionType, typing.Union):
        (kind,) = (k for k in typing.get_args(kind) if k is not types.NoneType)
        return _read(kind, value)
    if typing.get_origin(kind) is tuple:
        return tuple(_read(typing.get_args(kind)[0], each) for each in value)
    return value


@cache
def _later(kind: Any) -> frozenset[str]:
    """Fields that earlier versions did not measure: they have defaults."""
    fields = dataclasses.fields(kind)
    return frozenset(one.name for one in fields if one.default is not dataclasses.MISSING)


@cache
def _hints(kind: Any) -> dict[str, Any]:
    return typing.get_type_hints(kind)

"""Configurations of trainings as frozen dataclasses: named, from JSON files, with values changed."""

from __future__ import annotations

import dataclasses
import json
import typing
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeVar

from swifttailor.errors import InputError

T = TypeVar("T")


def read_config_of(named: Mapping[str, T], name: str, overrides: Sequence[str] = ()) -> T:
    """A named configuration or one from a JSON file, with some values changed.

    Args:
        named: Those that have names; files say what differs from the first.
        name: One of them, or a file.
        overrides: ``field=value`` or ``group.field=value``; values are JSON, or plain text.

    Raises:
        InputError: There is no such configuration, field or value.
    """
    base = next(iter(named.values()))
    if name in named:
        config = named[name]
    else:
        try:
            value = json.loads(Path(name).read_text(encoding="utf-8"))
        except (OSError, ValueError, RecursionError) as error:
            raise InputError(
                f"There is no configuration '{name}': {error}. Give {' or '.join(named)}, or a JSON file."
            ) from error
        config = changed_config(base, value)
    if not overrides:
        return config
    # All at once: what is valid together need not be valid one after the other.
    values = config_values(config)
    for override in overrides:
        path, sign, text = override.partition("=")
        if not sign:
            raise InputError(f"'{override}' sets nothing; write field=value, for instance steps=1000.")
        *groups, field = path.split(".")
        inner: Any = values
        for group in groups:
            inner = inner.get(group)
            if not isinstance(inner, dict):
                raise InputError(
                    f"There is no '{path}' in a configuration; '{group}' is not a group of fields."
                )
        try:
            inner[field] = json.loads(text)
        except (ValueError, RecursionError):
            inner[field] = text
    return changed_config(base, values)


def changed_config(base: T, value: Any) -> T:
    """A configuration from what `config_values` gave; what is missing is as in `base`.

    Raises:
        InputError: A field is unknown or a value out of range.
    """
    return _build(base, value, "")


def config_values(config: Any) -> dict[str, Any]:
    """A configuration as JSON values."""
    return json.loads(json.dumps(dataclasses.asdict(config)))


def require(config: Any, name: str, good: bool, accepted: str) -> None:
    """Refuses a value of a configuration that is not good.

    Raises:
        InputError: It is not.
    """
    if not good:
        raise InputError(f"{name} is {getattr(config, name)!r}; {accepted} is accepted.")


def _build(base: Any, value: Any, place: str) -> Any:
    if not isinstance(value, dict):
        raise InputError(f"{place or 'The configuration'} is {value!r}; an object of fields is expected.")
    changed = {}
    for name, part in value.items():
        changed[name] = _typed(base, name, part, f"{place}.{name}" if place else name)
    return replace(base, **changed)


def _typed(base: Any, name: str, value: Any, place: str) -> Any:
    known = {f.name for f in dataclasses.fields(base)}
    if name not in known:
        raise InputError(f"There is no '{place}' in a configuration. Known: {', '.join(sorted(known))}.")
    old = getattr(base, name)
    if dataclasses.is_dataclass(old):
        return _build(old, value, place)
    kind = typing.get_type_hints(type(base))[name]
    if isinstance(old, tuple) and isinstance(value, list | tuple):
        return tuple(value)
    if kind is float and isinstance(value, int) and not isinstance(value, bool):
        return float(value)
    wanted = type(old)
    if not isinstance(value, wanted) or (isinstance(value, bool) and wanted is not bool):
        raise InputError(
            f"{place} is {value!r}; {'a number' if wanted in (int, float) else wanted.__name__} is expected."
        )
    return value

"""Designs from mappings and files: every name known, every value accepted, what is missing filled in."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from swifttailor.errors import InputError
from swifttailor.programs.design import Design
from swifttailor.programs.design_error import DesignError
from swifttailor.programs.design_parameters import DESIGN_PARAMETERS, DesignParameter

MAX_FILE_BYTES = 1_000_000
_DEEPEST = 6
_MOST_GROUPS = 200
_DEFAULTS = {name: parameter.default for name, parameter in DESIGN_PARAMETERS.items()}


def complete_design(values: Mapping[str, Any]) -> Design:
    """A design with every parameter, of values by flat name.

    Raises:
        DesignError: There is no such parameter, or a value is not accepted.
    """
    checked = {name: _checked(name, value) for name, value in values.items()}
    return Design({**_DEFAULTS, **checked})


def read_design(path: Path | str) -> dict[str, Any]:
    """Reads a design from one of GarmentCode's files, YAML or JSON.

    Both the nested form (``design: {sleeve: {length: {v: 0.3}}}``) and flat names (``sleeve.length: 0.3``)
    are read, with or without ``design`` around them.

    Returns:
        Values by flat name, as they are in the file, for `make_pattern`.

    Raises:
        InputError: The file cannot be read or holds no design.
        DesignError: There is no such parameter, or a value is not accepted.
    """
    path = Path(path)
    try:
        with path.open("rb") as file:
            content = file.read(MAX_FILE_BYTES + 1)
        if len(content) > MAX_FILE_BYTES:
            raise InputError(f"'{path}' is larger than {MAX_FILE_BYTES} bytes, which no design file is.")
        parsed = _parse(content.decode("utf-8"), path)
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"Cannot read the design '{path}': {error}. Give a YAML or JSON file.") from error
    if isinstance(parsed, dict) and isinstance(parsed.get("design"), dict):
        parsed = parsed["design"]
    values = _flat(parsed, path) if isinstance(parsed, dict) else {}
    if not values:
        raise InputError(
            f"'{path}' holds no design. Accepted is a mapping of parameters, for example "
            "'design: {meta: {upper: {v: Shirt}}}' or 'meta.upper: Shirt'."
        )
    try:
        return {name: _checked(name, value) for name, value in values.items()}
    except DesignError as error:
        raise DesignError(f"'{path}' is not a design: {error}") from error


def _parse(text: str, path: Path) -> Any:
    if path.suffix.lower() == ".json":
        try:
            return json.loads(text)
        except (ValueError, RecursionError) as error:
            raise InputError(f"'{path}' is not valid JSON: {error}.") from error
    import yaml

    try:
        return yaml.safe_load(text)
    except (yaml.YAMLError, ValueError, RecursionError) as error:
        raise InputError(f"'{path}' is not valid YAML: {error}.") from error


def _flat(nested: dict[Any, Any], path: Path) -> dict[str, Any]:
    """Values by flat name; a mapping with the key ``v`` is a parameter."""
    found: dict[str, Any] = {}
    stack = [("", nested, 0)]
    seen = 0
    while stack:
        start, level, depth = stack.pop()
        seen += 1  # YAML can name one mapping a million times
        if seen > _MOST_GROUPS:
            raise InputError(
                f"'{path}' has more than {_MOST_GROUPS} groups of parameters, which no design has."
            )
        for key, value in level.items():
            name = f"{start}{key}"
            if name in DESIGN_PARAMETERS or not isinstance(value, dict) or "v" in value:
                found[name] = value["v"] if isinstance(value, dict) and "v" in value else value
            elif depth == _DEEPEST:
                raise InputError(f"'{path}': '{name[:80]}' is nested too deeply for a design parameter.")
            else:
                stack.append((name + ".", value, depth + 1))
            if len(found) > len(DESIGN_PARAMETERS):
                raise InputError(
                    f"'{path}' has more parameters than the {len(DESIGN_PARAMETERS)} of a design."
                )
    return found


def _checked(name: str, value: Any) -> Any:
    parameter = DESIGN_PARAMETERS.get(name) if isinstance(name, str) else None
    if parameter is None:
        raise DesignError(f"There is no design parameter {str(name)[:80]!r}{_nearest(str(name)[:80])}.")
    if parameter.kind == "bool":
        if isinstance(value, bool):
            return value
    elif parameter.kind == "select":
        for choice in parameter.choices:
            if not isinstance(value, bool) and value == choice:
                return choice
    elif isinstance(value, int | float) and not isinstance(value, bool):
        low, high = parameter.range
        whole = parameter.kind == "int"
        if low <= value <= high and (not whole or float(value).is_integer()):
            return int(value) if whole else float(value)
    raise DesignError(f"{name} is {str(value)[:80]!r}; accepted is {_accepted(parameter)}.")


def _accepted(parameter: DesignParameter) -> str:
    if parameter.kind in ("bool", "select"):
        return " or ".join(
            [
                "null"
                if c is None
                else str(c).lower()
                if c in (True, False) and isinstance(c, bool)
                else str(c)
                for c in parameter.choices
            ]
        )
    low, high = parameter.range
    return f"{'a whole number' if parameter.kind == 'int' else 'a number'} from {low:g} to {high:g}"


def _nearest(name: str) -> str:
    import difflib

    near = difflib.get_close_matches(name, DESIGN_PARAMETERS, n=1)
    return f"; did you mean '{near[0]}'?" if near else " (they are listed in DESIGN_PARAMETERS)"

"""Typed access to untrusted JSON: every wrong type is a `PatternError` that names the place."""

from __future__ import annotations

import json
import math
from itertools import pairwise
from pathlib import Path
from typing import Any

from swifttailor.errors import InputError, PatternError

MAX_FILE_BYTES = 32 * 1024 * 1024
MAX_ABSOLUTE = 1e7
"""No coordinate of a garment is 100 km; beyond this, arithmetic on it is noise."""


def read_json_file(path: Path | str) -> Any:
    """Reads a JSON file.

    Raises:
        InputError: The file is missing, too large, not text, not JSON, nested too deeply, repeats a key or
            holds NaN or Infinity.
    """
    path = Path(path)
    try:
        size = path.stat().st_size
        if not path.is_file():
            raise InputError(f"'{path}' is not a file. Give the path of a pattern's JSON file.")
        if size > MAX_FILE_BYTES:
            raise InputError(
                f"'{path}' is {size / 1e6:.0f} MB; a sewing pattern is at most {MAX_FILE_BYTES // 2**20} MB. "
                "Is it the right file?"
            )
        data = path.read_bytes()
    except OSError as error:
        raise InputError(f"Cannot read '{path}': {error.strerror or error}.") from error
    except ValueError as error:  # a name with a zero byte in it
        raise InputError(
            f"{str(path)!r} is not a file name: {error}. Give the path of a JSON file."
        ) from error
    return parse_json(data, str(path))


def parse_json(data: bytes | str, source: str) -> Any:
    """Parses JSON text; see `read_json_file` for what is refused. `source` names it in messages."""
    if isinstance(data, bytes):
        try:
            data = data.decode("utf-8-sig")
        except UnicodeDecodeError as error:
            kind = " It looks like a PNG picture." if data[:8] == b"\x89PNG\r\n\x1a\n" else ""
            raise InputError(
                f"'{source}' is not UTF-8 text (byte {error.start}).{kind} "
                "A GarmentCode JSON pattern is expected."
            ) from error
    try:
        return json.loads(data, parse_constant=_refuse_constant, object_pairs_hook=_unique_keys)
    except json.JSONDecodeError as error:
        raise InputError(
            f"'{source}' is not JSON: {error.msg} at line {error.lineno}, column {error.colno}. "
            "A GarmentCode JSON pattern is expected; the file may be cut short."
        ) from error
    except RecursionError as error:
        raise InputError(f"'{source}' is nested too deeply for a sewing pattern.") from error
    except ValueError as error:
        raise InputError(f"'{source}' cannot be read as a pattern: {error}") from error


def as_object(value: Any, where: str) -> dict[str, Any]:
    """`value` as a JSON object, or `PatternError`."""
    if not isinstance(value, dict):
        raise PatternError(f"{where}: an object was expected, got {describe(value)}.")
    return value


def as_list(
    value: Any, where: str, lengths: tuple[int, ...] | None = None, limit: int = 100_000
) -> list[Any]:
    """`value` as a JSON array, of one of the given lengths where stated."""
    if not isinstance(value, list):
        raise PatternError(f"{where}: a list was expected, got {describe(value)}.")
    if lengths is not None and len(value) not in lengths:
        accepted = " or ".join(str(n) for n in lengths)
        raise PatternError(f"{where}: a list of {accepted} values was expected, got {len(value)}.")
    if len(value) > limit:
        raise PatternError(f"{where}: {len(value)} entries; at most {limit} are accepted.")
    return value


def as_number(value: Any, where: str) -> float:
    """`value` as a finite float of sensible size."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise PatternError(f"{where}: a number was expected, got {describe(value)}.")
    if isinstance(value, int) and abs(value) > MAX_ABSOLUTE:
        raise PatternError(f"{where}: the number is larger than any garment (limit {MAX_ABSOLUTE:g}).")
    if not math.isfinite(value) or abs(value) > MAX_ABSOLUTE:
        raise PatternError(f"{where}: {value!r} is not a finite number below {MAX_ABSOLUTE:g}.")
    return float(value)


def as_vector(value: Any, where: str, size: int) -> tuple[float, ...]:
    """`value` as `size` finite floats."""
    return tuple(as_number(x, f"{where}[{k}]") for k, x in enumerate(as_list(value, where, (size,))))


def as_index(value: Any, where: str) -> int:
    """`value` as a whole number (1.0 counts, 1.5 and true do not)."""
    number = as_number(value, where)
    if number != int(number):
        raise PatternError(f"{where}: a whole number was expected, got {value!r}.")
    return int(number)


def as_text(value: Any, where: str, limit: int = 200) -> str:
    """`value` as a string of at most `limit` characters without control characters."""
    if not isinstance(value, str):
        raise PatternError(f"{where}: text was expected, got {describe(value)}.")
    if len(value) > limit or not value.isprintable():
        raise PatternError(f"{where}: at most {limit} printable characters are accepted, got {value[:40]!r}.")
    return value


def describe(value: Any) -> str:
    """A short description of a JSON value for messages."""
    text = json.dumps(value) if isinstance(value, str | int | float | bool | type(None)) else ""
    kind = {dict: "an object", list: "a list", str: "text", bool: "true/false", type(None): "null"}
    name = kind.get(type(value), "a number")
    return f"{name} ({text[:40]})" if text else name


def _refuse_constant(name: str) -> float:
    raise ValueError(f"it holds {name}; every number must be finite.")


def _unique_keys(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    result = dict(pairs)
    if len(result) != len(pairs):
        keys = sorted(key for key, _ in pairs)
        twice = next(a for a, b in pairwise(keys) if a == b)
        raise ValueError(f"the key {twice[:60]!r} occurs twice in one object.")
    return result

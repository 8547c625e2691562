"""Reads plain command lines: names, values and flags, each at most once.

Anything else (help, abbreviations, mistakes) is left to tyro, which takes a tenth of a second to load, knows
all of it, and tells what is wrong. What is read here is what tyro would read.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable
from dataclasses import MISSING, Field, dataclass, fields
from pathlib import Path
from typing import Any

_NUMBERS: dict[str, tuple[str, Callable[[str], Any]]] = {
    "int": (r"\d{1,18}", int),
    "float": (r"\d{1,15}(\.\d{1,15})?", float),
}
_CONF = "tyro.conf."


def operands(kind: type[Any], arguments: list[str]) -> list[str]:
    """What stands on a command line besides options and their values, an option taking one value at most.

    Args:
        kind: As for `read_plain`.
        arguments: Of the command line.
    """
    flags = {f"--{f.name.replace('_', '-')}" for f in fields(kind) if isinstance(f.default, bool)}
    flags |= {flag.replace("--", "--no-", 1) for flag in flags} | {"-h", "--help"}
    found, waiting = [], iter(arguments)
    for argument in waiting:
        if not argument.startswith("-"):
            found.append(argument)
        elif argument not in flags and "=" not in argument:
            next(waiting, None)
    return found


class _NotPlain(Exception):
    """For tyro to read, or to refuse."""


@dataclass(frozen=True)
class _Option:
    """What a field takes."""

    kind: str
    """Path, str, int, float, bool or a Literal."""
    positional: bool
    several: bool
    flags: dict[str, bool]
    """By what a truth value is said; empty for other kinds."""


def read_plain(kind: type[Any], arguments: list[str]) -> Any:
    """An instance of a dataclass of options; None where tyro has to read the arguments.

    Args:
        kind: As for `tyro.cli`, its annotations not evaluated (``from __future__ import annotations``).
        arguments: Of the command line.
    """
    own = [f for f in fields(kind) if f.init]
    try:
        options = {field.name: _option(field) for field in own}
        given = _given(options, arguments)
    except _NotPlain:
        return None
    if any(f.name not in given and f.default is MISSING and f.default_factory is MISSING for f in own):
        return None
    return kind(**given)


def _given(options: dict[str, _Option], arguments: list[str]) -> dict[str, Any]:
    names = {
        f"--{name.replace('_', '-')}": name for name, o in options.items() if not (o.positional or o.flags)
    }
    flags = {flag: (name, value) for name, o in options.items() for flag, value in o.flags.items()}
    given: dict[str, Any] = {}
    bare: list[str] = []
    ended = False
    waiting = iter(arguments)
    for argument in waiting:
        if not argument.startswith("-") and argument:
            if ended:
                raise _NotPlain  # operands in two places
            bare.append(argument)
            continue
        ended = bool(bare)
        if argument in flags:
            name, value = flags[argument]
        elif argument in names:
            name, text = names[argument], next(waiting, "-")
            if options[name].several:  # where they end, tyro says
                raise _NotPlain
            value = _value(options[name].kind, text)
        else:
            raise _NotPlain
        if name in given:
            raise _NotPlain
        given[name] = value
    return given | _operands({name: o for name, o in options.items() if o.positional}, bare)


def _operands(options: dict[str, _Option], bare: list[str]) -> dict[str, Any]:
    if [o.several for o in options.values()] == [True]:
        ((name, option),) = options.items()
        return {name: tuple(_value(option.kind, text) for text in bare)} if bare else {}
    if bare and len(bare) != len(options):
        raise _NotPlain
    return {name: _value(o.kind, text) for (name, o), text in zip(options.items(), bare, strict=False)}


def _value(kind: str, text: str) -> Any:
    if text.startswith("-") or text in ("", "None"):  # tyro may take it for no value at all
        raise _NotPlain
    if kind == "Path":
        return Path(text)
    if kind == "str":
        return text
    if kind in _NUMBERS:
        pattern, convert = _NUMBERS[kind]
        if re.fullmatch(pattern, text, re.ASCII):
            return convert(text)
    elif text in ast.literal_eval(kind):
        return text
    raise _NotPlain


def _option(field: Field[Any]) -> _Option:
    """What the annotation of a field says, which is not evaluated: that would load tyro."""
    node, configured = ast.parse(str(field.type), mode="eval").body, set()
    while isinstance(node, ast.Subscript):
        outer, inner = ast.unparse(node.value), node.slice
        if outer == "Annotated" and isinstance(inner, ast.Tuple):
            configured |= {_configured(one) for one in inner.elts[1:]}
            node = inner.elts[0]
        elif outer.startswith(_CONF):
            configured.add(outer.removeprefix(_CONF))
            node = inner
        else:
            break
    if configured - {"Positional", "FlagCreatePairsOff", ""}:
        raise _NotPlain
    kind, positional = ast.unparse(node), "Positional" in configured
    several = kind in ("tuple[Path, ...]", "tuple[str, ...]")
    kind = kind.removeprefix("tuple[").removesuffix(", ...]") if several else kind.removesuffix(" | None")
    if kind.startswith("Literal["):
        kind = f"({kind.removeprefix('Literal[').removesuffix(']')},)"
    elif kind not in ("Path", "str", "bool", *_NUMBERS) or (
        kind == "bool" and not isinstance(field.default, bool)
    ):
        raise _NotPlain
    flag, flags = field.name.replace("_", "-"), {}
    if kind == "bool":
        flags = {f"--{flag}": True, f"--no-{flag}": False}
        if "FlagCreatePairsOff" in configured:
            flags.pop(f"--no-{flag}" if not field.default else f"--{flag}")
    return _Option(kind, positional, several, flags)


def _configured(node: ast.expr) -> str:
    """Empty for what changes only the help."""
    if isinstance(node, ast.Call) and ast.unparse(node.func) == f"{_CONF}arg":
        return "" if all(k.arg in ("metavar", "help") for k in node.keywords) else ast.unparse(node)
    return ast.unparse(node).removeprefix(_CONF)

"""Damage to JSON: values of other kinds, keys missing, renamed and doubled, numbers no file should hold."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from random import Random
from typing import Any

_RAW = "\x01raw:"
"""Text that begins so is written as it is, without quotes: what no JSON library would write."""
_RAW_TEXTS = (
    *"1e400 -1e999 1E+2 01 +1 .5 1. 0x10 NaN -Infinity Infinity tru nul '' -0 1e-999 2e308 1e308".split(),
    *"[ { ]".split(),
    "9" * 5000,
    "1" + "0" * 400,
    "-" + "9" * 30,
    '"\\ud800"',
    '"\\u0000"',
    '"unended',
    "[" * 3000,
    "[" * 960 + "]" * 960,
    '{"a":' * 2000,
)
_NUMBERS = (
    0, -0.0, 1, -1, 2, 3, 0.5, 1e-9, 1e-300, 5e-324, 1e7, -1e7, 1.0000001e7, 1e16, 1e300, 2**31, 2**53 + 1,
    2**63, -(2**63), 10**30, 1e-3, 100, 360, 0.1, 1.5,
)  # fmt: skip
_TEXTS = (
    "", " ", "\n", "a", "é", "\u202e", "\ufeff", "\x00", "\x1b[31m", "[bold]", "{}", "%s", "../../etc",
    "x" * 201, "x" * 5000, "right_wrong", "circle", "quadratic", "cubic", "absolute", "relative",
    "nan", "0", "true",
    "😀", "\ud800",
)  # fmt: skip


def written(value: Any, random: Random) -> bytes:
    """A JSON value as the bytes of a file, now and then with a key doubled or odd spacing."""
    separators = (",", ":") if random.random() < 0.9 else (" ,\r\n\t", " : ")
    text = json.dumps(value, separators=separators, ensure_ascii=random.random() < 0.9)
    if _RAW_MARK in text:
        text = _RAW_STRING.sub(lambda found: json.loads(found[0])[len(_RAW) :], text)
    if random.random() < 0.02:
        keys = list(re.finditer(r'"[^"\\]*"(?=\s*:)', text))
        if keys:
            chosen = random.choice(keys)
            first = f"{chosen[0]}:{random.choice(('0', '[]', 'null'))},"
            text = text[: chosen.start()] + first + text[chosen.start() :]
    return text.encode("utf-8", "surrogatepass")


_RAW_MARK = json.dumps(_RAW)[1:-1]
_RAW_STRING = re.compile(r'"' + re.escape(_RAW_MARK) + r'(?:[^"\\]|\\.)*"')


def mutate_json(value: Any, random: Random, most: int = 3) -> Any:
    """`value`, changed in place or replaced, with one to `most` pieces of damage."""
    for _ in range(random.randint(1, most)):
        value = _mutated(value, random)
    return value


def odd_value(random: Random, depth: int = 0) -> Any:
    """Any JSON value, most of them small."""
    kind = random.randrange(8 if depth < 3 else 6)
    if kind == 0:
        return random.choice((None, True, False))
    if kind in (1, 2):
        return random.choice(_NUMBERS)
    if kind == 3:
        return random.uniform(-200, 200)
    if kind == 4:
        return random.choice(_TEXTS)
    if kind == 5:
        return _RAW + random.choice(_RAW_TEXTS) if random.random() < 0.3 else []
    if kind == 6:
        return [odd_value(random, depth + 1) for _ in range(random.randrange(4))]
    return {random.choice(_TEXTS): odd_value(random, depth + 1) for _ in range(random.randrange(3))}


def _mutated(value: Any, random: Random) -> Any:
    holder: Any = None
    key: Any = None
    here = value
    while isinstance(here, dict | list) and here and (holder is None or random.random() < 0.85):
        holder, key = (
            here,
            random.choice(list(here)) if isinstance(here, dict) else random.randrange(len(here)),
        )
        here = holder[key]
    if holder is None:
        return odd_value(random)
    random.choice(_WAYS)(holder, key, random)
    return value


def _delete(holder: Any, key: Any, random: Random) -> None:
    del holder[key]


def _replace(holder: Any, key: Any, random: Random) -> None:
    holder[key] = odd_value(random)


def _tweak(holder: Any, key: Any, random: Random) -> None:
    old = holder[key]
    if isinstance(old, bool) or not isinstance(old, int | float):
        holder[key] = random.choice(_NUMBERS)
        return
    way = random.randrange(6)
    scale = random.choice((0.0, -1.0, 0.5, 2.0, 10.0, 1000.0, 1e6, 1e-6))
    changes: tuple[Callable[[], Any], ...] = (
        lambda: old + 1,
        lambda: old - 1,
        lambda: old * scale,
        lambda: str(old),
        lambda: float(old),
        lambda: old + random.gauss(0, 10),
    )
    holder[key] = changes[way]()


def _double(holder: Any, key: Any, random: Random) -> None:
    if isinstance(holder, list):
        holder[key:key] = [holder[key]] * random.choice((1, 1, 1, 5, 100))
    else:
        holder[f"{key}{random.choice(('2', ' ', '_back', ''))}"] = holder[key]


def _rename(holder: Any, key: Any, random: Random) -> None:
    if isinstance(holder, list):
        holder[key] = [holder[key]]
    else:
        holder[random.choice((*_TEXTS, str(key).upper(), f"{key}s"))] = holder.pop(key)


def _swap(holder: Any, key: Any, random: Random) -> None:
    other = random.choice(list(holder)) if isinstance(holder, dict) else random.randrange(len(holder))
    holder[key], holder[other] = holder[other], holder[key]


def _wrap(holder: Any, key: Any, random: Random) -> None:
    value = holder[key]
    for _ in range(random.choice((1, 1, 2, 50, 200))):
        value = [value] if random.random() < 0.5 else {"a": value}
    holder[key] = value


def _more(holder: Any, key: Any, random: Random) -> None:
    if isinstance(holder, list):
        holder.append(odd_value(random))
    else:
        holder[random.choice(_TEXTS)] = odd_value(random)


def _empty(holder: Any, key: Any, random: Random) -> None:
    holder[key] = random.choice((None, [], {}, "", 0, False))


_WAYS = (_delete, _replace, _replace, _tweak, _tweak, _tweak, _double, _rename, _swap, _wrap, _more, _empty)

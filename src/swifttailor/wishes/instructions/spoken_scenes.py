"""Vague words of instructions: "make it work for winter", "more modest", "I want to be able to walk in it".

A table says what such words are taken to mean. Whatever is done for them is told to whoever said them.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from swifttailor.describing.claims import CLAIM_TYPES, Claim
from swifttailor.describing.differences import Change, Gain, Step
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.wording.claim_kinds import fits_kind
from swifttailor.wording.word_tables import Row, read_table

_TABLE = Path(__file__).with_name("scene_words.txt")
_BOUND = re.compile(r"(?P<claim>\w+)=(?P<value>\w+)(?P<how>[+-]?)")
_STEP = re.compile(r"(?P<quantity>\w+)(?P<sign>[+-])")
_DEEP = (Claim("neck_depth", "low"), Claim("neck_depth", "plunging"))
_BARE_BACK = (Claim("back_depth", "low"), Claim("back_depth", "open"))
_UPRIGHT = (Claim("collar", "turtleneck"), Claim("collar", "stand"))
_LEGS = frozenset({"trousers", "shorts", "jumpsuit", "playsuit"})
_LOWER = frozenset({"skirt", "trousers", "shorts"})


@dataclass(frozen=True)
class SpokenScene:
    """Vague words, and what they are taken to mean for a garment."""

    start: int
    end: int
    changes: tuple[Change, ...]


def spoken_scene(
    text: str,
    bounds: tuple[int, int],
    parts: Collection[str],
    kind: str,
    is_so: Callable[[Claim], bool],
    *,
    of_parts: bool = False,
) -> SpokenScene | None:
    """What a clause asks for by the first vague words in it; None where there are none.

    Args:
        text: In lower case.
        bounds: Of the clause.
        parts: That it names.
        kind: Of the garment.
        is_so: Whether a claim is true of the garment: what is long enough is not lengthened.
        of_parts: Whether only words that are said of a part count.
    """
    for row, pattern in _scenes():
        at = row.options.get("at", ())
        found = pattern.search(text, *bounds)
        if found is None or (at and not set(at) & set(parts)) or (of_parts and not at):
            continue
        changes: list[Change] = []
        for mark in (*row.claims, *row.words):
            changes += _asked(mark.replace("_", " ") if "=" not in mark else mark, row, kind, is_so)
        if changes:
            return SpokenScene(found.start(), found.end(), tuple(dict.fromkeys(changes)))
    return None


def _asked(mark: str, row: Row, kind: str, is_so: Callable[[Claim], bool]) -> list[Change]:
    bound = _BOUND.fullmatch(mark)
    if bound:
        return _bounded(bound["claim"], bound["how"], bound["value"].replace("_", " "), kind, is_so)
    step = _STEP.fullmatch(mark.replace(" ", "_"))
    if step:
        quantity = step["quantity"].replace("_", " ")
        if quantity not in QUANTITIES:
            row.wrong(f"there is no quantity '{quantity}'.")
        return [] if kind in _LOWER else [Step(quantity, 1 if step["sign"] == "+" else -1)]
    if mark not in _SPECIAL:
        row.wrong(f"'{mark}' is no change. Known: {', '.join(sorted(_SPECIAL))}.")
    return _SPECIAL[mark](kind, is_so)


def _bounded(claim: str, how: str, value: str, kind: str, is_so: Callable[[Claim], bool]) -> list[Change]:
    wanted = Claim(claim, value)
    if not fits_kind(claim, kind) or is_so(wanted):
        return []
    if not how:
        return [Gain(wanted)]
    scale = list(CLAIM_TYPES[claim].words)
    at = scale.index(value)
    now = [k for k, each in enumerate(scale) if is_so(Claim(claim, each))]
    beyond = max(now, default=at) < at if how == "+" else min(now, default=at) > at
    return [Gain(wanted)] if beyond else []


def _neck_up(kind: str, is_so: Callable[[Claim], bool]) -> list[Change]:
    return [Step("neck depth", -1)] if any(map(is_so, _DEEP)) else []


def _neck_down(kind: str, is_so: Callable[[Claim], bool]) -> list[Change]:
    return [] if kind in _LOWER or is_so(Claim("neck_depth", "plunging")) else [Step("neck depth", 1)]


def _back_up(kind: str, is_so: Callable[[Claim], bool]) -> list[Change]:
    return [Step("back depth", -1)] if any(map(is_so, _BARE_BACK)) else []


def _no_high_collar(kind: str, is_so: Callable[[Claim], bool]) -> list[Change]:
    return [Gain(Claim("collar", "none"))] if any(map(is_so, _UPRIGHT)) else []


def _hem_out(kind: str, is_so: Callable[[Claim], bool]) -> list[Change]:
    return [Step("leg end", 1)] if kind in _LEGS else [Step("skirt hem", 1)] if kind != "top" else []


_SPECIAL: dict[str, Callable[[str, Callable[[Claim], bool]], list[Change]]] = {
    "neck up": _neck_up,
    "neck down": _neck_down,
    "back up": _back_up,
    "no high collar": _no_high_collar,
    "hem out": _hem_out,
}


@cache
def _scenes() -> list[tuple[Row, re.Pattern[str]]]:
    found = []
    for row in read_table(_TABLE):
        row.check_options("at")
        longest = sorted(map(re.escape, row.texts), key=len, reverse=True)
        found.append((row, re.compile(rf"(?<!\w)(?:{'|'.join(longest)})(?!\w)")))
    return found

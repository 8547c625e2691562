"""The table of words for the wearer's body (`body_words.txt`) as parts of patterns."""

from __future__ import annotations

import re
from functools import cache, lru_cache
from pathlib import Path

_FILE = Path(__file__).with_name("body_words.txt")


@cache
def _table() -> dict[tuple[str, str], tuple[str, ...]]:
    """Words by section and key."""
    found: dict[tuple[str, str], tuple[str, ...]] = {}
    section, key = "", ""
    for line in _FILE.read_text("utf-8").splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        if line.startswith("["):
            section = line.strip("[] ")
            continue
        if not line[0].isspace():
            key, _, line = line.partition(":")
            key = key.strip()
        words = tuple(word.strip() for word in re.split(r"\s\|\s|^\s*\|\s", line) if word.strip())
        found[section, key] = (*found.get((section, key), ()), *words)
    return found


def keys(section: str) -> tuple[str, ...]:
    """The keys of a section, in the order of the table."""
    return tuple(key for whose, key in _table() if whose == section)


@lru_cache(maxsize=64)
def any_of(section: str, key: str) -> str:
    """A part of a pattern that finds any word of a key, longer words first, as a group without a number."""
    words = sorted(_table()[section, key], key=len, reverse=True)
    return "(?:" + "|".join(re.sub(r" ", r"\\s+", word) for word in words) + ")"


@lru_cache(maxsize=64)
def whole_word(section: str, key: str) -> re.Pattern[str]:
    """Finds a word of a key by itself."""
    return re.compile(rf"(?<![\w-]){any_of(section, key)}(?![\w-])", re.IGNORECASE)

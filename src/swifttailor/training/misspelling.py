"""Typing errors, so that a network reads texts that have some."""

from __future__ import annotations

import re

import numpy as np

_WORD = re.compile(r"[^\W\d_]{3,}")


def misspell(text: str, chance: np.random.Generator, share: float) -> str:
    """The text with an error in some of its words: a letter left out, doubled, or swapped with the next.

    The first two letters are never left out.

    Args:
        text: Any.
        chance: Decides which words, and how.
        share: Of the words of three letters or more.
    """

    def change(found: re.Match[str]) -> str:
        word = found[0]
        if chance.random() >= share:
            return word
        kind = int(chance.integers(3))
        # Words are told apart by how they begin: a letter left out there makes "skirt" and "shirt" the same.
        first = 2 if kind == 0 else 0
        place = int(chance.integers(first, max(len(word) - 1, first + 1)))
        if kind == 0:
            return word[:place] + word[place + 1 :]
        if kind == 1:
            return word[: place + 1] + word[place:]
        return word[:place] + word[place + 1] + word[place] + word[place + 2 :]

    return _WORD.sub(change, text) if share else text

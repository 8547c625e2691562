"""How people say things that captions and instructions say in fewer ways, and what they say besides."""

from __future__ import annotations

import re

import numpy as np

FILLERS = (
    "red blue navy black white beige pink olive cream yellow floral striped checked plaid satin silk cotton "
    "linen denim wool knit jersey velvet chiffon tulle lace leather soft light heavy elegant casual cosy "
    "cute chic modern vintage romantic simple basic comfy lovely nice pretty summer winter spring autumn "
    "holiday beach office party wedding evening everyday work wear style look fabric print please really "
    "very some kind like something maybe just with pockets buttons zip belt for me my girlfriend going out"
).split()
"""What is not about the cut."""

_OTHERWISE: tuple[tuple[re.Pattern[str], tuple[str, ...]], ...] = tuple(
    (re.compile(pattern, re.IGNORECASE), texts)
    for pattern, texts in (
        (
            r"\b(?:remove|take off) the\b",
            ("lose the", "get rid of the", "drop the", "no", "delete the", "cut off the"),
        ),
        (
            r"\b(make|let) the (?:top|dress|skirt|garment)\b",
            (r"\1 it", r"\1 this", r"\1 the thing", r"\1 my one"),
        ),
        (r"\b(shorten|lengthen) the (?:top|dress|skirt|garment)\b", (r"\1 it", r"\1", r"\1 this")),
        (
            r"\bgive it (an?)\b",
            (r"i want \1", r"add \1", r"put \1", r"it should have \1", r"with \1", r"i need \1"),
        ),
        (
            r"\bchange the (\w+) to (an?)\b",
            (r"\2", r"turn the \1 into \2", r"swap the \1 for \2", r"i prefer \2"),
        ),
        (r"\badd (an?)\b", (r"give it \1", r"with \1", r"put \1", r"sew on \1", r"it needs \1")),
        (r"\bmake the\b", ("i want the", "have the", "the", "can the", "i would like the")),
        (
            r"\b(?:please|can you|could you|i want you to|i'd like you to)\b",
            ("pls", "hey", "ok so", "would you", ""),
        ),
    )
)
_BEHIND = (
    "please",
    "pls",
    "a bit",
    "a little",
    "slightly",
    "much",
    "thanks",
    "thank you",
    "for me",
    "ok?",
    "!!",
    "now",
)
_LETTERS = "abcdefghijklmnopqrstuvwxyz" * 4 + "aeiou" * 8
_SCRIPTS = ((0x3B1, 24), (0x430, 32), (0x5D0, 26), (0x627, 36), (0x4E00, 5000), (0x3041, 80), (0xAC00, 2000))


def say_otherwise(text: str, chance: np.random.Generator) -> str:
    """An instruction in other words that ask for the same.

    Args:
        text: As instructions are written.
        chance: Decides which words, if there are others.
    """
    for pattern, texts in _OTHERWISE:
        if chance.random() < 0.5:
            text = pattern.sub(texts[int(chance.integers(len(texts)))], text, count=1)
    if chance.random() < 0.4:
        text = f"{text.rstrip('.?! ')} {_BEHIND[int(chance.integers(len(_BEHIND)))]}"
    return text


def say_nothing(chance: np.random.Generator) -> str:
    """A text that asks for nothing: words that are not about the cut, letters at random, other scripts."""
    count, kind = int(chance.integers(1, 9)), chance.random()
    if kind < 0.4:
        return " ".join(FILLERS[k] for k in chance.integers(len(FILLERS), size=count))
    if kind < 0.8:
        return " ".join(
            "".join(_LETTERS[k] for k in chance.integers(len(_LETTERS), size=int(chance.integers(1, 11))))
            for _ in range(count)
        )
    first, size = _SCRIPTS[int(chance.integers(len(_SCRIPTS)))]
    return " ".join(
        "".join(chr(first + int(k)) for k in chance.integers(size, size=int(chance.integers(1, 9))))
        for _ in range(count)
    )

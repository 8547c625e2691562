"""Endings: which word of the lexicon a word of a text can be a form of. Never another spelling of it."""

from __future__ import annotations

from typing import Literal

Language = Literal["en", "de", "fr", "es"]
LANGUAGES: tuple[Language, ...] = ("en", "de", "fr", "es")
SHORTEST = 3
"""Letters of a word that takes endings."""
_SIBILANTS = ("s", "x", "z", "ch", "sh", "o")


def base_forms(word: str, language: Language) -> tuple[tuple[str, bool | None], ...]:
    """What a word can be a form of, itself left out, the likeliest first.

    Args:
        word: In lower case.
        language: Whose endings.

    Returns:
        Pairs of a word and whether the ending is a noun's (True), an adjective's (False) or either's (None).
    """
    found = _FORMS[language](word)
    return tuple([(base, noun) for base, noun in found if len(base) >= SHORTEST])


def _english(word: str) -> list[tuple[str, bool | None]]:
    if word.endswith("'s"):
        return [(word[:-2], True)]
    if word.endswith("men"):
        return [(f"{word[:-2]}an", True)]
    if not word.endswith("s") or word.endswith("ss"):
        return []
    found: list[tuple[str, bool | None]] = [(word[:-1], True)]
    if word.endswith("ies"):
        found.append((f"{word[:-3]}y", True))
    elif word.endswith("ves"):
        found += [(f"{word[:-3]}f", True), (f"{word[:-3]}fe", True)]
    elif word.endswith("es") and word[:-2].endswith(_SIBILANTS):
        found.append((word[:-2], True))
    return found


def _german(word: str) -> list[tuple[str, bool | None]]:
    found: list[tuple[str, bool | None]] = []
    if word.endswith("n") and word[:-1].endswith(("e", "l", "r")):
        found.append((word[:-1], True))
    if word.endswith("en"):
        found.append((word[:-2], True))
    if word.endswith("s"):
        found.append((word[:-1], True))
    found += [(word[: -len(end)], False) for end in ("e", "en", "er", "es", "em") if word.endswith(end)]
    return found


def _french(word: str) -> list[tuple[str, bool | None]]:
    return [(word[: -len(end)], None) for end in ("s", "x", "e", "es") if word.endswith(end)]


def _spanish(word: str) -> list[tuple[str, bool | None]]:
    found: list[tuple[str, bool | None]] = [
        (word[: -len(end)], None) for end in ("s", "es") if word.endswith(end)
    ]
    found += [(f"{word[: -len(end)]}o", None) for end in ("a", "as") if word.endswith(end)]
    return found


_FORMS = {"en": _english, "de": _german, "fr": _french, "es": _spanish}

"""Endings: which word of the lexicon a word of a text can be a form of. Never another spelling of it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Literal

Language = Literal["en", "de", "fr", "es", "it", "nl", "pt"]
LANGUAGES: tuple[Language, ...] = ("en", "de", "fr", "es", "it", "nl", "pt")
NAMES: Mapping[Language, str] = {
    "en": "English",
    "de": "German",
    "fr": "French",
    "es": "Spanish",
    "it": "Italian",
    "nl": "Dutch",
    "pt": "Portuguese",
}
"""What people call the languages."""
SHORTEST = 3
"""Letters of a word that takes endings."""
_SIBILANTS = ("s", "x", "z", "ch", "sh", "o")
_VOWELS = "aeiou"
_PAIRS = frozenset(
    "pant sweatpant trackpant legging jegging trouser jogger bottom brief knicker culotte dungaree".split()
)
"""What shops and strangers call in the singular, too, though it has two legs: "a jogging pant"."""
_SHORT_SYLLABLE = re.compile(r"[^aeiou]*[aeiou][^aeiou]")
"""Doubles its last letter in Dutch before an ending: "losse" is of "los", "lose" is not."""
_LITTLE = ("pjes", "tjes", "jes", "pje", "tje", "je")
"""Endings of what is little in Dutch: "mouwtjes"."""
_LITTLE_SPANISH: Mapping[str, tuple[str, ...]] = {
    **{f"cit{end}": ("",) for end in ("o", "a", "os", "as")},
    **{f"it{end}": ("o", "a", "") for end in ("o", "os")},
    **{f"it{end}": ("a", "o", "") for end in ("a", "as")},
}
"""Endings of what is little, and of what it is little: "faldita", "cortito", "pantaloncito"."""
_LITTLE_ITALIAN: Mapping[str, tuple[str, ...]] = {
    **{f"in{end}": ("o", "a") for end in "oi"},
    **{f"in{end}": ("a", "o") for end in "ae"},
}
_HARD = (("qu", "c"), ("gu", "g"), ("ch", "c"))
"""How a consonant is spelt before an "i", and elsewhere: "rebequita" of "rebeca"."""
_LITTLE_PORTUGUESE: Mapping[str, tuple[str, ...]] = {
    **{f"zinh{end}": ("",) for end in ("o", "a", "os", "as")},
    **{f"inh{end}": ("o", "a", "") for end in ("o", "os")},
    **{f"inh{end}": ("a", "o", "") for end in ("a", "as")},
}


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
    if word in _PAIRS:
        return [(f"{word}s", True)]
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
    return found + _of_little(word, _LITTLE_SPANISH)


def _of_little(word: str, endings: Mapping[str, tuple[str, ...]]) -> list[tuple[str, bool | None]]:
    """What a word can be the little one of: faldita of falda, chaquetita of chaqueta, manguinha of manga.

    Args:
        word: In lower case.
        endings: Those of what is little, the longest first, and what stands in their place.
    """
    for little, bases in endings.items():
        stem = word.removesuffix(little)
        if stem == word or len(stem) < SHORTEST:
            continue
        stems = [stem, *[f"{stem[:-2]}{hard}" for soft, hard in _HARD if stem.endswith(soft)]]
        return [(f"{each}{base}", None) for each in stems for base in bases]
    return []


def _italian(word: str) -> list[tuple[str, bool | None]]:
    stem, end = word[:-1], word[-1:]
    found = [f"{stem}{base}" for base in {"a": "o", "e": "ao", "i": "oe"}.get(end, "")]
    if end in ("e", "i") and stem.endswith("h"):
        found += [f"{stem[:-1]}{base}" for base in "ao"]
    elif end in ("e", "i"):  # grigi and grige, camicie and camice
        found += [f"{stem.removesuffix('i')}{base}" for base in ("io", "ia")]
    return [(base, None) for base in found] + _of_little(word, _LITTLE_ITALIAN)


def _dutch(word: str) -> list[tuple[str, bool | None]]:
    found = [_closed_syllable(word[: -len(end)]) for end in ("en", "e") if word.endswith(end)]
    found += [[word[: -len(end)]] for end in ("s", *_LITTLE) if word.endswith(end)]
    stems = [word[: -len(end)] for end in ("en", "e") if word.endswith(end)]
    found += [[stem] for stem in stems if not _SHORT_SYLLABLE.fullmatch(stem)]
    return [(base, None) for bases in found for base in bases]


def _closed_syllable(stem: str) -> list[str]:
    """What a stem is spelt like without an ending behind it: witt as wit, rod as rood, grijz as grijs."""
    if len(stem) < SHORTEST:
        return []
    if stem[-1] == stem[-2]:
        return [stem[:-1]]
    last = {"z": "s", "v": "f"}.get(stem[-1], stem[-1])
    found = [f"{stem[:-1]}{last}"] if last != stem[-1] else []
    if last not in _VOWELS and stem[-2] in _VOWELS and stem[-3] not in _VOWELS:
        found.append(f"{stem[:-1]}{stem[-2]}{last}")
    return found


def _portuguese(word: str) -> list[tuple[str, bool | None]]:
    found = [word[: -len(end)] for end in ("s", "es") if word.endswith(end)]
    found += [f"{word[: -len(end)]}o" for end in ("a", "as") if word.endswith(end)]
    others = (("is", "l"), ("ns", "m"), ("ões", "ão"), ("ã", "ão"), ("eis", "el"))
    found += [f"{word[: -len(end)]}{base}" for end, base in others if word.endswith(end)]
    return [(base, None) for base in found] + _of_little(word, _LITTLE_PORTUGUESE)


_FORMS = {
    "en": _english,
    "de": _german,
    "fr": _french,
    "es": _spanish,
    "it": _italian,
    "nl": _dutch,
    "pt": _portuguese,
}

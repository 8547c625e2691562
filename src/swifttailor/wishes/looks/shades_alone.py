"""Colours of which no more is told than how they are: something dark, bright colours, earth tones."""

from __future__ import annotations

from collections.abc import Mapping

from swifttailor.wording.lexicon import WordReading

_BRIGHT, _DARK, _PALE, _EARTHY, _JEWEL, _SEA = "e4572e", "26272d", "dfe4ea", "9a5f3c", "1f5f55", "2f7f8f"
_COLORS: Mapping[str, str] = {
    **dict.fromkeys(
        ("bright", "vivid", "vibrant", "bright colours", "bright colors", "bright colour", "bright color"),
        _BRIGHT,
    ),
    **dict.fromkeys(
        (
            "happy colours",
            "happy colors",
            "cheerful colours",
            "bold colours",
            "strong colours",
            "warm colours",
            "candy colours",
        ),
        _BRIGHT,
    ),
    **dict.fromkeys(("neon", "neon colours", "fluorescent", "fluoro", "day glo", "highlighter"), "c8f31d"),
    **dict.fromkeys(
        ("dark", "dark colours", "dark colors", "darker colours", "dark colour", "dark color"), _DARK
    ),
    **dict.fromkeys(
        ("pale", "light colours", "light colors", "pale colours", "light colour", "light color"), _PALE
    ),
    **dict.fromkeys(
        ("pastel colours", "pastel colors", "pastels", "spring colours", "soft colours"), "d9c9e6"
    ),
    **dict.fromkeys(("neutral", "neutral colours", "neutrals"), "cdbfa8"),
    **dict.fromkeys(("earth tones", "earth colours", "earthy", "earthy colours", "autumn colours"), _EARTHY),
    **dict.fromkeys(("autumnal colours", "fall colors"), _EARTHY),
    **dict.fromkeys(("jewel tones", "jewel colours", "jewel colors"), _JEWEL),
    **dict.fromkeys(("sea colours", "ocean colours", "cool colours", "cool colors"), _SEA),
    **dict.fromkeys(("muted", "muted colours", "subdued", "dusty colours"), "8a8f98"),
}
"""By words of the lexicon, ``rrggbb``."""


def shade_alone(words: WordReading) -> str | None:
    """The colour that such words mean, ``rrggbb``, where a text names none and no print; else None.

    Args:
        words: By the lexicon.
    """
    if words.colors or words.prints or words.looks:
        return None
    for k, mark in enumerate(words.marks):
        behind = words.marks[k + 1 : k + 2]
        of_part = any(one.entries and one.entries[0].category == "parts" for one in behind)
        if mark.denied or mark.role == "astray" or of_part:
            continue
        names = [mark.word.lower(), *[entry.english or "" for entry in mark.entries]]
        found = next((_COLORS[name] for name in names if name in _COLORS), None)
        if found is not None:
            return found
    return None

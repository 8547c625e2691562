"""Satin, which shines; other silks and what flows like them hardly do."""

from __future__ import annotations

from swifttailor.wording.lexicon import WordReading

SATIN = "satin"
"""As the cloth of a garment: it hangs like silk."""
_SHINING = (
    "satin",
    "satén",
    "satijn",
    "raso",
    "cetim",
    "charmeuse",
    "glossy",
    "shiny",
    "lustrous",
    "slip dress",
    "slip skirt",
    "bias skirt",
    "bias cut skirt",
)
"""Words, or parts of them, that such cloth is named by."""
_DULL = ("raw silk", "washed", "matt", "matte", "crepe", "crêpe")


def is_satin(words: WordReading) -> bool:
    """Whether a text names such cloth."""
    said = [mark.word.lower() for mark in words.marks if not mark.denied]
    shines = any(part in word for word in said for part in _SHINING)
    return shines and not any(word.startswith(_DULL) for word in said)

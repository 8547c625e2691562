"""What can be said of a text before it is read: the network was trained with English descriptions."""

from __future__ import annotations

import re
import unicodedata

SHOWN = 100_000
"""Characters of a text that are looked at."""
_WORD = re.compile(r"[^\W\d_]+")


def says_something(text: str) -> bool:
    """Whether a text holds anything but spaces and characters that are not seen."""
    return any(not c.isspace() and unicodedata.category(c)[0] != "C" for c in text[:SHOWN])


def about_scripts(text: str) -> list[str]:
    """What to tell a person whose text is not, or not only, in Latin letters; nothing where it is."""
    words = _WORD.findall(unicodedata.normalize("NFKC", text[:SHOWN]))
    other = [w for w in words if not all(_is_latin(c) for c in w)]
    trained = "the network was trained with English descriptions"
    if not words and says_something(text):
        return [f"The text holds no word; {trained} and can only guess."]
    if not other:
        return []
    if len(other) == len(words):
        return [f"The text is in a script that the network has never seen: {trained} and can only guess."]
    return [f"{len(other)} of the text's {len(words)} words are in a script never seen: {trained}."]


def _is_latin(character: str) -> bool:
    return character < "\x80" or "LATIN" in unicodedata.name(character, "")

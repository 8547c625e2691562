"""Colours of one garment that a text names side by side, and says of no part: "a red and white dress"."""

from __future__ import annotations

import re
from collections.abc import Sequence

from swifttailor.wording.lexicon import NamedColor, WordReading

_JOINED = re.compile(
    r"\s*(?:[,/&+-]|,?\s*(?:and|und|et|y|e|en|plus|with|mit|avec|con)(?!\w))\s*"
    r"(?:(?:an?|some|the)\s+)?(?:(?:dark|light|pale|deep|bright)\s+)?",
    re.IGNORECASE,
)
"""What stands between two of them; of colours with "or" between one is enough."""
_TWO_SHADES = re.compile(r"[\s-]*", re.IGNORECASE)
"""Between the words of one colour: navy blue."""

_CHOICE = re.compile(
    r"(?<!\w)(?:or|oder|ou|o|u|of|maybe|perhaps|instead|rather|better|no)(?!\w)", re.IGNORECASE
)
"""Between colours of which one is enough."""

_IN_EACH = re.compile(
    r"(?<!\w)(?:colou?r ?ways?|(?:one|some|ten|\d+) (?:in|of) each|(?:shop|wholesale|bulk|trade|stock) order"
    r"|in (?:the following|these|two|three|four|five|several|various|\d) (?:shades|colou?rs)|buyers?"
    r"|stockists?|assorted|sizes? \d{1,2} ?(?:-|–|to) ?\d{1,2}|available in|comes? in"
    r"|(?:XXS|XS|S) ?(?:to|-|–|/) ?(?:L|XL|\d?XXL|\dXL))(?!\w)",
    re.IGNORECASE,
)
"""What a shop says that orders a garment in each of several colours: the first is shown."""


def joined_places(text: str, words: WordReading) -> tuple[int, ...]:
    """Which of the colours of a reading a text joins, in its order; none where it joins no two.

    Args:
        text: That the lexicon has read.
        words: By the lexicon.
    """
    if _IN_EACH.search(text):
        return ()
    found: list[int] = []
    marks = words.color_marks
    for k, color in enumerate(words.colors):
        if found and not _JOINED.fullmatch(text, marks[k - 1].end, marks[k].start):
            if len(found) > 1:
                break
            found = []
        if color.rgb not in [words.colors[one].rgb for one in found]:
            found.append(k)
    return tuple(found) if len(found) > 1 else ()


def joined_colors(text: str, words: WordReading) -> tuple[NamedColor, ...]:
    """The same colours themselves.

    Args:
        text: That the lexicon has read.
        words: By the lexicon.
    """
    return tuple([words.colors[k] for k in joined_places(text, words)])


def left_over(text: str, words: WordReading, shown: Sequence[str]) -> tuple[str, ...]:
    """The colours, as a text has them, that nothing of the garment is in; of a choice one is enough.

    Args:
        text: That the lexicon has read.
        words: By the lexicon.
        shown: Colours of the garment, its print and its parts, ``#rrggbb``.
    """
    missed = []
    marks = words.color_marks
    for k, color in enumerate(words.colors):
        if f"#{color.rgb}" in shown:
            continue
        before = text[marks[k - 1].end : marks[k].start] if k else ""
        if k and (_TWO_SHADES.fullmatch(before) or _CHOICE.search(before)):
            continue
        missed.append(color.words)
    return tuple(dict.fromkeys(missed))

"""What a longer instruction asks for as a whole: by all of it and by each of its sentences.

The network for people's own words has learnt from a sentence or two. Of a letter it hears what stands out;
each sentence alone it hears as well as any.
"""

from __future__ import annotations

import re

from swifttailor.describing.differences import Change
from swifttailor.wishes.reader import WishReader

LONG_WORDS = 24
"""Of shorter texts sentences alone say less than all of it."""
MOST_SENTENCES = 8
"""That are read alone; time is bounded."""
PLAIN, BELIEVED = 0.8, 0.4
"""What a sentence says with less than the first speaks for what is heard besides, and is not enough alone."""
LEAST_WORDS = 3
"""Of a sentence that says something by itself."""
_END = re.compile(r"(?<=[.!?;:])\s+|\n+")


def whole_of(text: str, reader: WishReader) -> dict[Change, float]:
    """How likely it is of every wish that a text asks for it, in one of its sentences or in all of it.

    Args:
        text: In English.
        reader: With the network for people's own words.
    """
    found = reader.whole(text)
    if not is_letter(text):
        return found
    sentences = [each for each in _END.split(text) if len(each.split()) >= LEAST_WORDS]
    if len(sentences) < 2:
        return found
    for sentence in sentences[:MOST_SENTENCES]:
        for change, chance in reader.whole(sentence).items():
            counted = chance if chance >= PLAIN else min(chance, BELIEVED)
            found[change] = max(counted, found.get(change, 0.0))
    return found


def is_letter(text: str) -> bool:
    """Whether a text is longer than what the network has mostly learnt from."""
    return len(text.split()) >= LONG_WORDS

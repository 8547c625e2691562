"""What no guess may ask for where a text calls close what stands off by its name: a tight tent dress."""

from __future__ import annotations

from swifttailor.describing.claims import Claim
from swifttailor.wording.lexicon import WordReading
from swifttailor.wording.lexicon.opposites_in_names import closeness_given_up

_CLOSE = (
    Claim("fit", "close"),
    Claim("hips", "close"),
    Claim("skirt", "straight"),
    Claim("bodice", "darted"),
)


def closeness_refused(words: WordReading) -> tuple[Claim, ...]:
    """Closeness, where it contradicts the name of the garment; that this is so is told.

    Args:
        words: Of a text.
    """
    pairs = [(each.first, each.second) for each in words.contradictions]
    return _CLOSE if closeness_given_up(pairs) else ()

"""How high a slit goes, where a text says so by the body: "a slit, but only up to the knee"."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from swifttailor.describing.claims import Claim
from swifttailor.wishes.text.spoken_sides import SpokenSides
from swifttailor.wording.lexicon import WordReading

_LEVELS_CM: Mapping[str, float] = {
    **dict.fromkeys(("below the knee", "just below the knee", "under the knee"), 42.0),
    **dict.fromkeys(("knee", "knees", "bend of the knee", "back of the knee", "kneecap"), 49.0),
    **dict.fromkeys(("just above the knee", "above the knee"), 55.0),
    **dict.fromkeys(("calf", "mid-calf", "mid calf", "shin"), 34.0),
    **dict.fromkeys(
        ("mid-thigh", "mid thigh", "midthigh", "middle of the thigh", "half way up the thigh"), 65.0
    ),
}
"""How high above the floor such places are, cm, of an adult."""
_HEMS_CM: Mapping[str, float] = {
    "floor": 4.0,
    "maxi": 8.0,
    "ankle": 12.0,
    "midi": 30.0,
    "below the knee": 40.0,
}
"""The same of the hems of skirts."""
_SHORTEST_CM = 8.0
_LEVEL = "|".join(sorted(_LEVELS_CM, key=len, reverse=True))
_PHRASE = re.compile(
    r"(?<!\w)(?:slits?|split|slash)(?!\w)[^.;\n]{0,44}?"
    r"(?P<to>(?:up )?(?:to|until|till|at|as far as|reaching|stops? at|ends? at|stopping at|ending at)"
    rf"(?: just)? (?:(?:the|my|her) )?(?P<level>{_LEVEL}))(?![\w-])",
    re.IGNORECASE,
)


def slit_levels(text: str, words: WordReading, said: Sequence[Claim]) -> SpokenSides:
    """The height of a slit that ends at a place of the body; nothing where the hem is not told.

    Args:
        text: That the lexicon has read.
        words: By the lexicon.
        said: What is said besides, which may tell the hem.
    """
    found = _PHRASE.search(text)
    hems = [claim for claim in said if claim.name == "skirt_hem"]
    hems += [
        i.claim for i in sorted(words.implications, key=lambda i: not i.said) if i.claim.name == "skirt_hem"
    ]
    low = next((_HEMS_CM[str(claim.value)] for claim in hems if claim.value in _HEMS_CM), None)
    if found is None or low is None:
        return SpokenSides((), ())
    height = _LEVELS_CM[re.sub(r"\s+", " ", found["level"].lower())] - low
    if height < _SHORTEST_CM:
        return SpokenSides((), ())
    return SpokenSides((Claim("slit_cm", height),), (found.span("to"),))

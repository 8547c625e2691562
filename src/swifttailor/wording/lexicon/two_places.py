"""Whether two words are said of different places: "V in front, round behind" contradicts nothing."""

from __future__ import annotations

import re

_PLACES: tuple[tuple[tuple[str, str], ...], ...] = (
    (
        ("front", r"in front|front|fronts|vorne|devant|delante"),
        ("back", r"behind|back|rear|hinten|dos|detr[aá]s"),
    ),
    (
        (
            "above",
            r"above|upper|on top|at the top|top|to the elbow|shoulders?|bodice|bust|chest|waist up"
            r"|oben|obenrum|en haut|arriba|(?:di )?sopra|boven|em cima",
        ),
        (
            "below",
            r"below|lower|bottom|from the elbow|under|hem|wrists?|skirt|hips?|waist down|legs?"
            r"|unten|untenrum|en bas|abajo|(?:di )?sotto|onder|em baixo",
        ),
    ),
    (("left", r"left"), ("right", r"right")),
    (("inside", r"inner|inside|under layer|lining"), ("outside", r"outer|outside|over layer")),
)
_WORDS = tuple(
    [
        tuple(
            [(place, re.compile(rf"(?<![\w-])(?:{words})(?![\w-])", re.IGNORECASE)) for place, words in pair]
        )
        for pair in _PLACES
    ]
)
_JOINT = re.compile(r"[,;.:/\n]|(?<!\w)(?:and|but|und|et|y|then|while|with)(?!\w)", re.IGNORECASE)


def of_two_places(text: str, one: tuple[int, int], other: tuple[int, int]) -> bool:
    """Whether each of two words has the name of a place beside it, and these are opposite places.

    Args:
        text: In which they stand.
        one: Where the first begins and ends.
        other: The same of the second, behind it.
    """
    first, second = _beside(text, one, other), _beside(text, other, one)
    for pair in _WORDS:
        of_first, of_second = (
            {place for place, words in pair if words.search(part)} for part in (first, second)
        )
        if len(of_first) == 1 and len(of_second) == 1 and of_first != of_second:
            return True
    return False


def _beside(text: str, word: tuple[int, int], other: tuple[int, int]) -> str:
    """The clause around a word, without the other."""
    start = max([0, *[m.end() for m in _JOINT.finditer(text, 0, word[0])]])
    joint = _JOINT.search(text, word[1])
    end = joint.start() if joint is not None else len(text)
    if other[0] >= word[1]:
        end = min(end, other[0])
    else:
        start = max(start, other[1])
    return text[start:end]

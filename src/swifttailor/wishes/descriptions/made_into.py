"""A garment that is to become a dress: "my dad's cardigan, but as a dress" is a cardigan dress."""

from __future__ import annotations

import re

from swifttailor.wording.lexicon import read_words

_AS_DRESS = re.compile(
    r"(?P<whose>(?<!\w)(?:(?:my|our|his|her|their|the|an?) )?(?:\w+['’]s |(?<=my )\w+s (?=\w))?(?:old )?)"
    r"(?P<name>(?:[\w-]+ )?(?!but |just |only )[\w-]+),? "
    r"(?:(?:but |just |only )*(?:as|(?:re)?made into|turned (?:in)?to|re ?worked (?:as|into)|cut as"
    r"|lengthened (?:in)?to|extended (?:in)?to|but (?:make|made) it|but) an? dress"
    r"|but (?:as long as a dress|(?:in |of )?(?:a )?dress[- ]length))(?!\w)(?! (?:shirt|coat|code|pants))",
    re.IGNORECASE,
)
_LIKE = re.compile(
    r"(?<!\w)dress (?:that is |that's |which is |made |shaped |cut |styled )?(?:just )?like "
    r"(?:an? |my )?(?:old )?"
    r"(?P<name>(?:[\w-]+ )?[\w-]+)",
    re.IGNORECASE,
)


def made_into_a_dress(text: str) -> str:
    """The text with the name of such a dress, where there is one: "hoodie dress", "coat dress".

    Args:
        text: A description in any case.
    """
    for pattern in (_AS_DRESS, _LIKE):
        found = pattern.search(text)
        name = None if found is None else _dress_of(found["name"])
        if found is None or name is None:
            continue
        article = "" if pattern is _LIKE else "a "
        before = found["name"].lower().removesuffix(name.removesuffix(" dress")).strip()
        put = f"{article}{before} {name}" if before and pattern is _AS_DRESS else f"{article}{name}"
        return text[: found.start()] + put + text[found.end() :]
    return text


def _dress_of(garment: str) -> str | None:
    """The name of the dress that is cut like a garment; None where there is none of that name."""
    words = garment.lower().split()
    for k in range(len(words)):
        name = f"{' '.join(words[k:])} dress"
        marks = read_words(name).marks
        if len(marks) == 1 and marks[0].role == "garment" and marks[0].word.lower() == name:
            return name
    return None

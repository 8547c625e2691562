"""Words for bodies that are not of average build: petite, tall, plus-size."""

from __future__ import annotations

import re
from functools import lru_cache

from swifttailor.wishes.wearers.body_said import SaidBody
from swifttailor.wishes.wearers.body_words import any_of, whole_word

BUILDS = ("plus", "petite", "tall")


@lru_cache(maxsize=8)
def _of_person(build: str) -> re.Pattern[str]:
    lead, adverb, person = (any_of("builds", key) for key in ("of_person", "adverb", "person"))
    word = any_of("builds", f"{build}_of")
    return re.compile(
        rf"(?<!\w){_STRONG}\s+(?:{adverb}\s+)*{word}(?!\w|-)"
        r"(?!\s+(?:in the|at the|fan|on|deal|believer))"
        rf"|(?<!\w){lead}\s+(?:{adverb}\s+)*{word}\s+{person}(?!\w)"
        rf"|(?<!\w)(?:femme|frau|mujer|homme|mann|hombre|donna|uomo|woman|man)\s+(?:{adverb}\s+)*{word}(?!\w|-)",
        re.IGNORECASE,
    )


_STRONG = (
    r"(?:i am|i['’]m|im|she is|he is|she['’]s|he['’]s|(?:ich )?bin|sie ist|er ist|je suis|elle est|il est"
    r"|soy|ella es|él es|sono)"
)


def hear_build(said: SaidBody) -> None:
    """Takes the first word for a build out of a text."""
    for build in BUILDS:
        match = whole_word("builds", build).search(said.text) or _of_person(build).search(said.text)
        if match is not None:
            said.build = build
            said.take(match)
            return

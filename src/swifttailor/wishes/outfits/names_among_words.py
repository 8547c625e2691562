"""English names of garments that stand among words of another language: "pyjama top en satin".

What a name of two garments stands for is told in English; the words beside it are those of the text.
"""

from __future__ import annotations

from swifttailor.wording.lexicon import read_words
from swifttailor.wording.lexicon.inflection import Language
from swifttailor.wording.lexicon.vocabulary import vocabulary

_SAYS_NOTHING = frozenset({"function", "polite"})


def in_english(said: str, language: Language) -> str:
    """The text with what is unknown in English as it is called there.

    Args:
        said: Of one garment.
        language: Of the whole text.
    """
    words = read_words(said)
    if language == "en" or words.language != "en" or not words.unknown:
        return said
    for mark in reversed(words.marks):
        senses = () if mark.entries else vocabulary(language).find([mark.word.lower()])
        if senses:
            entry = senses[0].entry
            told = "" if entry.category in _SAYS_NOTHING else entry.english or mark.word
            said = f"{said[: mark.start]}{told}{said[mark.end :]}"
    return " ".join(said.split())

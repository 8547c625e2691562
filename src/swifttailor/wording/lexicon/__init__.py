"""A lexicon of clothes in text tables, and a reader that goes by it alone, without a network."""

from __future__ import annotations

from typing import TYPE_CHECKING

from swifttailor.first_use import loaded_on_first_use

if TYPE_CHECKING:
    from swifttailor.wording.lexicon.colors import NamedColor
    from swifttailor.wording.lexicon.conflicts import exclude
    from swifttailor.wording.lexicon.entries import Entry
    from swifttailor.wording.lexicon.foreign import foreign_language
    from swifttailor.wording.lexicon.glosses import glossed, glossed_change
    from swifttailor.wording.lexicon.reading import (
        SURENESS,
        Implication,
        Lack,
        WordMark,
        WordReading,
        read_words,
    )
    from swifttailor.wording.lexicon.said_look import SaidLook
    from swifttailor.wording.lexicon.usual_colors import usual_color
    from swifttailor.wording.lexicon.vocabulary import all_entries, cannot_texts

_PUBLIC = {
    "SURENESS": "reading",
    "Entry": "entries",
    "Implication": "reading",
    "Lack": "reading",
    "NamedColor": "colors",
    "SaidLook": "said_looks",
    "WordMark": "reading",
    "WordReading": "reading",
    "all_entries": "vocabulary",
    "cannot_texts": "vocabulary",
    "exclude": "conflicts",
    "foreign_language": "foreign",
    "glossed": "glosses",
    "glossed_change": "glosses",
    "read_words": "reading",
    "usual_color": "usual_colors",
}

__all__ = [
    "SURENESS",
    "Entry",
    "Implication",
    "Lack",
    "NamedColor",
    "SaidLook",
    "WordMark",
    "WordReading",
    "all_entries",
    "cannot_texts",
    "exclude",
    "foreign_language",
    "glossed",
    "glossed_change",
    "read_words",
    "usual_color",
]

__getattr__ = loaded_on_first_use(__name__, _PUBLIC)

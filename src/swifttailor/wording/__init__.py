"""Putting what a garment shows into words, and what words of clothes mean.

May import describing and what lies below it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from swifttailor.first_use import loaded_on_first_use

if TYPE_CHECKING:
    from swifttailor.wording.captions import write_caption
    from swifttailor.wording.description import Description, describe
    from swifttailor.wording.lexicon import WordReading, cannot_texts, read_words

_PUBLIC = {
    "Description": "description",
    "WordReading": "lexicon",
    "cannot_texts": "lexicon",
    "describe": "description",
    "read_words": "lexicon",
    "write_caption": "captions",
}

__all__ = [
    "Description",
    "WordReading",
    "cannot_texts",
    "describe",
    "read_words",
    "write_caption",
]

__getattr__ = loaded_on_first_use(__name__, _PUBLIC)

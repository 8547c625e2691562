"""Instructions in languages that have no lexicon, put into English word by word.

"Lite längre ärmar" and "dłuższa spódnica" are too short to need a grammar: what is to change, and which way.
The table is for anybody to extend.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

from swifttailor.wording.word_tables import read_table

_TABLE = Path(__file__).with_name("word_by_word.txt")
_WORD = re.compile(r"[^\W\d_]+")
_LEAST_SHARE = 0.5
"""So many of the words of a text have to be known."""


def in_english(text: str) -> str:
    """An instruction in English, where enough of its words are known in another language.

    Args:
        text: In any case.

    Returns:
        The text as it is, where it is in none of these languages.
    """
    small = text.lower()
    pattern, marks, meaning = _compiled()
    found = list(pattern.finditer(small))
    words = [word for word in _WORD.findall(small) if word not in ("cm", "mm")]
    known = sum(len(_WORD.findall(match[0])) for match in found)
    if not any(match[0] in marks for match in found) or known < _LEAST_SHARE * len(words):
        return text
    said = pattern.sub(lambda match: meaning[match[0]], small)
    # Adjectives stand on either side of what they are said of, and articles on neither.
    return re.sub(r"(?<!\w)the the(?!\w)", "the", said)


@cache
def _compiled() -> tuple[re.Pattern[str], frozenset[str], dict[str, str]]:
    """A pattern of all words, longest first; those that tell the language; and what each means."""
    meaning: dict[str, str] = {}
    marks: set[str] = set()
    for row in read_table(_TABLE):
        english = " ".join(row.words)
        texts = [text.split(" @")[0].lower() for text in row.texts]
        for text in texts:
            meaning.setdefault(text, english)
        if row.section == "marks":
            marks.update(texts)
    words = sorted(meaning, key=lambda word: (-len(word), word))
    return re.compile(rf"(?<!\w)(?:{'|'.join(map(re.escape, words))})(?!\w)"), frozenset(marks), meaning

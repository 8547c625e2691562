"""Names of garments that a search box has the wrong way round: "skirt pencil black" is a black pencil skirt.

Who types the garment first, and then which one, writes no sentence: it is done in a few words alone.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from swifttailor.wishes.text.lexicon_spelling import is_garment
from swifttailor.wording.lexicon.tokens import words_of
from swifttailor.wording.lexicon.vocabulary import PARTS, vocabulary

_MOST_WORDS = 8
_LONGEST_KIND = 2
"""Words that tell which one: "roll neck" of a jumper."""
_WORD = re.compile(r"[^\W\d_]+(?:['’-][^\W\d_]+)*")
_JOINS = re.compile(
    r"(?<!\w)(?:and|with|w/|for|in|of|to|a|an|the|no|not|without|but|or|like|is|that|which|i|my|me|mit|avec|con)(?!\w)",
    re.IGNORECASE,
)
"""Words of sentences, in which garments stand behind what they are."""
_ALSO_KINDS = frozenset(
    "bomber puffer slip sweater jumper kaftan mermaid kimono trench duffle polo pinafore bikini".split()
)
"""Names of garments that tell which dress, jacket or coat it is, too."""
_GUESTS = re.compile(
    r"(?<!\w)(?:guest dress (?:for )?(?:a )?wedding|dress wedding guest|wedding dress guest)(?!\w)",
    re.IGNORECASE,
)
_FROCK = re.compile(r"(?<!\w)([^\W\d_]+) frock(?!\w)", re.IGNORECASE)
_GUEST_DRESS = "wedding guest dress"


def names_turned(text: str) -> str:
    """The text with each name as the tables have it, where it is a few words of a search box."""
    text = _FROCK.sub(_as_a_dress, _GUESTS.sub(_GUEST_DRESS, text))
    words = list(_WORD.finditer(text))
    if not 2 <= len(words) <= _MOST_WORDS or _JOINS.search(text):
        return text
    for k in range(len(words)):
        for count in range(_LONGEST_KIND, 0, -1):
            kind = words[k + 1 : k + 1 + count]
            if len(kind) == count and _is_turned(text, words, k, count):
                told = f"{text[kind[0].start() : kind[-1].end()]} {words[k][0]}"
                return text[: words[k].start()] + told + text[kind[-1].end() :]
    return text


def _as_a_dress(found: re.Match[str]) -> str:
    """What a frock is called as a dress: "tea dress" for "tea frock"."""
    name = f"{found[1]} dress"
    return name if is_garment(name.lower()) and not is_garment(found[0].lower()) else found[0]


def _is_turned(text: str, words: Sequence[re.Match[str]], k: int, count: int) -> bool:
    """Whether the garment k is the one that the words behind it tell of."""
    garment, kind = words[k][0].lower(), [found[0].lower() for found in words[k + 1 : k + 1 + count]]
    if text[words[k].start() : words[k + count].end()].lower() != " ".join([garment, *kind]):
        return False  # something else than spaces between
    if not is_garment(garment) or not is_garment(" ".join([*kind, garment])):
        return False
    if _is_known([garment, *kind]) or any(_is_known([garment, *kind[:n]]) for n in range(1, count)):
        return False  # "shirt dress", "skirt suit"
    if k and (_is_known([words[k - 1][0].lower(), garment]) or is_garment(words[k - 1][0].lower())):
        return False  # "tea dress floral"
    before = words[k - 1][0].lower() if k else ""
    behind = words[k + 1 + count][0].lower() if k + 1 + count < len(words) else ""
    if " ".join(kind) not in _ALSO_KINDS and is_garment(" ".join(kind)):
        return False
    if is_garment(behind) or _goes_with(kind[-1], behind):
        return False  # "skirt shirt", "top lace sleeves"
    return before not in PARTS


def _goes_with(kind: str, behind: str) -> bool:
    """Whether what tells which one goes with the word behind it: the lace of sleeves, a roll neck."""
    known = vocabulary("en")
    if not behind:
        return False
    together = known.find([kind, behind])
    return known.part(behind) is not None or any(s.entry.category != "colors" for s in together)


def _is_known(words: Sequence[str]) -> bool:
    return bool(vocabulary("en").find(words_of(" ".join(words), "en")))

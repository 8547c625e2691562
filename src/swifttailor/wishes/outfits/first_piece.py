"""The one of several garments that is to be made first: "if you can only do one, start with the skirt".

What is said of the others is then left out, or the skirt would have their sleeves and colours.
"""

from __future__ import annotations

import re

from swifttailor.wording.lexicon import WordMark, read_words

_PIECE = r"(?:the|my|her|his|our|that|this|a|an) (?P<what>[\w'’-]+(?: [\w'’-]+)?)"
_ONE = (
    r"(?:(?:one|1|a single)(?: (?:piece|item|garment|thing|part|of (?:them|these|those))s?)?"
    r"(?: (?:at a time|at once))?)"
)
_POLITE = r"(?:(?:please|then|just|kindly|i'?d|i would|we'?d|let'?s|first|can you|could you) )*"
_BEGIN = (
    r"(?:(?:start|begin|go|starting|beginning) (?:off )?with|(?:make|do|sew|take|choose|pick|draw|show|have"
    r"|want|prefer|give (?:me|us)|like)(?: (?:me|us))?)"
)
_FIRST = (
    re.compile(
        rf"(?<!\w)(?:and |but )?if (?:[\w'’-]+ ){{0,6}}?(?:only|just) (?:[\w'’-]+ ){{0,4}}?{_ONE}"
        rf"(?: (?:[\w'’-]+ ?){{0,4}})?[,:;–-]*\s*{_POLITE}(?:{_BEGIN} )?{_PIECE}(?: first)?",
        re.IGNORECASE,
    ),
    re.compile(
        rf"(?<!\w){_POLITE}(?:(?:start|begin)(?: off)? with) {_PIECE}(?! (?:of|and)(?!\w))", re.IGNORECASE
    ),
    re.compile(
        rf"(?<!\w){_POLITE}(?:make|do|sew|draw|show) (?:me |us )?{_PIECE} first(?! (?:layer|tier))(?!\w)",
        re.IGNORECASE,
    ),
    re.compile(
        rf"(?<!\w)(?:just|only) {_PIECE} (?:for now|for the moment|to (?:start|begin) with)(?!\w)", re.I
    ),
)
_STARTS = re.compile(
    r"[,;:.(]\s*|(?<!\w)(?:and|with|plus|over (?:that|it|this|them)|under (?:that|it)|then)(?!\w)\s*",
    re.IGNORECASE,
)
_END = re.compile(r"[.;!?]")


def first_piece(text: str) -> str:
    """What a text says of the one of its garments that it asks for first; the text where it asks for none.

    Args:
        text: A description in any case, in English.
    """
    for pattern in _FIRST:
        for found in pattern.finditer(text):
            before = text[: found.start()].rstrip(" ,;.")
            said = _said_of(before, found["what"].lower())
            if said is not None:
                return said
    return text


def _said_of(text: str, what: str) -> str | None:
    """What is said of the garment of that name; None where no other one is named beside it."""
    named = [mark for mark in read_words(text).marks if _is_garment(mark)]
    words = what.split()
    wanted = [mark for mark in named if set(words) & {*mark.word.lower().split()}]
    if len(wanted) != 1 or len(named) < 2:
        return None
    starts = {id(mark): _start(text, mark) for mark in named}
    start = starts[id(wanted[0])]
    later = [begin for begin in starts.values() if begin > start]
    ended = _END.search(text, wanted[0].end)
    end = min([len(text) if ended is None else ended.start(), *later])
    return re.sub(r"(?:[\s,;:(]|(?<!\w)(?:and|with|plus|over|under|then)(?=[\s,]*$))+$", "", text[start:end])


def _is_garment(mark: WordMark) -> bool:
    return bool(mark.entries) and mark.entries[0].category == "garments" and not mark.denied


def _start(text: str, mark: WordMark) -> int:
    """Where the phrase begins that ends with a garment's name."""
    return max([0, *[found.end() for found in _STARTS.finditer(text, 0, mark.start)]])

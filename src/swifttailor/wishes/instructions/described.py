"""What an instruction names only because it is there: "make the long sleeves short", "long ones instead".

The lexicon reads of two words for one thing the one that says more, so that of "make the crew neck a V" only
the crew neck would be heard. What describes the garment is left out before anything else is read.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from swifttailor.describing.claims import Claim
from swifttailor.wishes.instructions.change_words import find_adjectives, find_parts
from swifttailor.wording.lexicon import WordMark, WordReading

_POINTED_AT = re.compile(r"(?<!\w)(?:the|this|my|its|these|those|her|his)\s+$")
_ENDS = re.compile(r"[.;!?\n]")
_ONES = re.compile(
    r"(?<!\w)(?P<how>long|short|longer|shorter|wide|wider|narrow|narrower|straight|flared|tight|tighter"
    r"|loose|looser|slim|puffed|puffy|puff|balloon|bell|bishop|cap|elbow|elbow[- ]length|three[- ]quarter|3/4"
    r"|round|square|tapered|full|high|higher|low|lower|thin|thinner|thick|thicker|plain|normal|regular)"
    r" (?P<ones>ones?)(?=\s*(?:$|[.,;!?]|please|instead|rather|in place|and|but|would|for(?!\w)))"
)


def without_described(text: str, words: WordReading, is_so: Callable[[Claim], bool]) -> str:
    """An instruction without words for what is there already, where it asks for another of the same thing.

    Args:
        text: In lower case.
        words: By the lexicon.
        is_so: Whether a claim is true of the garment.
    """
    adjectives = [(a.start, a.end) for a in find_adjectives(text)]
    spans = []
    for k, mark in enumerate(words.marks):
        if mark.denied or _POINTED_AT.search(text[: mark.start]) is None:
            continue
        so = {claim.name for claim in _claims(mark) if is_so(claim)}
        if not so:
            continue
        ends = _ENDS.search(text, mark.end)
        end = len(text) if ends is None else ends.start()
        others = [m for m in words.marks[k + 1 :] if m.start < end and not m.denied]
        asked = any(c.name in so and not is_so(c) for m in others for c in _claims(m))
        behind = re.compile(r"\s+(?:\w+\s+)?").match(text, mark.end)
        plain = any(a < end and behind is not None and a == behind.end() for a, _ in adjectives)
        named = any(p.start == 0 and p.end == len(mark.word) for p in find_parts(mark.word.lower()))
        if asked or (plain and not named):
            spans.append((mark.start, _adjective_end(mark)))
    for start, end in spans:
        text = text[:start] + " " * (end - start) + text[end:]
    return text


def with_their_names(text: str) -> str:
    """An instruction in which "long ones" are the part that is meant, where it names but one.

    Args:
        text: In lower case.
    """
    parts = {p.part: p.word for p in find_parts(text) if p.part != "all"}
    if len(parts) != 1:
        return text
    (word,) = parts.values()
    return _ONES.sub(lambda found: f"{found['how']} {word}", text)


def _claims(mark: WordMark) -> list[Claim]:
    if any(entry.category == "garments" for entry in mark.entries) and _adjective_end(mark) == mark.end:
        return []
    return [claim for entry in mark.entries for claim in entry.claims("certain") if claim.name != "kind"]


def _adjective_end(mark: WordMark) -> int:
    """Where the word for what it is like ends: "long" of "long sleeves"."""
    parts = [p for p in find_parts(mark.word.lower()) if p.end == len(mark.word) and p.start > 0]
    return mark.start + parts[-1].start if parts else mark.end

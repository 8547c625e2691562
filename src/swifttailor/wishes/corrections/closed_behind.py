"""What words about a detail speak against: of "buttons down the back" nothing hangs lower behind."""

from __future__ import annotations

from collections.abc import Sequence

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes.reader import Wish
from swifttailor.wording.lexicon import WordReading

_DETAILS, _ASIDE = "styles", "asymmetric_closing"
_GARMENTS, _BARE_BACK = "garments", Claim("back_depth", "open")
_OPENS_IN_FRONT, _OPEN = "open_front", "open"


def without_opposites(found: Sequence[Wish], words: WordReading) -> tuple[Wish, ...]:
    """The wishes, without what the words of a trim or a closing speak against and no other word says.

    A network hears two unlike sides, and sleeves of two lengths, in "an asymmetrical zip", and a bare back in
    "open cardigan": what opens in front is open there.

    Args:
        found: What is heard.
        words: The words of the text.
    """
    trims = [
        entry
        for mark in words.marks
        if not mark.denied
        for entry in mark.entries
        if (entry.category == _DETAILS and (entry.trims or _ASIDE in entry.cannot))
        or (_BARE_BACK in entry.against and entry.category == _GARMENTS)
    ]
    against = {claim for entry in trims for claim in entry.against}
    entries = [entry for mark in words.marks if not mark.denied for entry in mark.entries]
    in_front = any(entry.category == _GARMENTS and _OPENS_IN_FRONT in entry.cannot for entry in entries)
    against |= {_BARE_BACK} if in_front else set()
    implied = {i.claim for i in words.implications if not (in_front and i.mark.word.casefold() == _OPEN)}
    against -= implied
    return tuple([w for w in found if not (isinstance(w.change, Gain) and w.change.claim in against)])

"""What words about a detail speak against: of "buttons down the back" nothing hangs lower behind."""

from __future__ import annotations

from collections.abc import Sequence

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes.reader import Wish
from swifttailor.wording.lexicon import WordReading

_DETAILS, _ASIDE = "styles", "asymmetric_closing"
_GARMENTS, _BARE_BACK = "garments", Claim("back_depth", "open")


def without_opposites(found: Sequence[Wish], words: WordReading) -> tuple[Wish, ...]:
    """The wishes, without what the words of a trim or a closing speak against and no other word says.

    A network hears two unlike sides, and sleeves of two lengths, in "an asymmetrical zip", and a bare back in
    "open cardigan".

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
    implied = {i.claim for i in words.implications}
    against = {claim for entry in trims for claim in entry.against} - implied
    return tuple([w for w in found if not (isinstance(w.change, Gain) and w.change.claim in against)])

"""What stands beside a refusal or a comparison and is not meant by it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from swifttailor.describing.claims import Claim

if TYPE_CHECKING:
    from swifttailor.wording.lexicon.reading import WordMark

_COMPARED = re.compile(
    r"(?<!\w)(?:longer|shorter|wider|narrower|looser|tighter|higher|lower|fuller|slimmer|warmer|smarter)"
    r" than (?:an? |the |my |those |these )?(?:[\w-]+ )?$",
    re.IGNORECASE,
)


def is_compared(text: str, start: int) -> bool:
    """Whether what is asked for is compared with a garment, and so is another: "longer than hot pants".

    Args:
        text: In which the garment is named.
        start: Where its name begins.
    """
    return _COMPARED.search(text[:start]) is not None


def is_said_beside(marks: Sequence[WordMark], refused: Claim) -> bool:
    """Whether a detail says what only goes along with what is refused.

    A sleeveless dress with no thin straps has no sleeves.

    Args:
        marks: The words of a text.
        refused: What follows from one of them that is denied.
    """
    denied = [entry for mark in marks if mark.denied for entry in mark.entries]
    if any(refused in entry.claims("certain")[:1] for entry in denied):
        return False
    said = [m.entries[0] for m in marks if not m.denied and m.role == "word" and len(m.entries) == 1]
    return any(refused in entry.claims("certain") for entry in said)

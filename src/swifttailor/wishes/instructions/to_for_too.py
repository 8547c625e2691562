"""A slip of the pen in complaints: "its to tight", "sleeves to long" of sleeves that are long."""

from __future__ import annotations

import re
from collections.abc import Callable

from swifttailor.describing.claims import Claim

_TO = re.compile(
    r"(?<!\w)(?P<to>to|two) (?P<how>long|short|tight|loose|wide|big|large|small|narrow|baggy|deep|low|high"
    r"|thin|thick|full|puffy|clingy|revealing|open|bare)"
    r"(?=\s*(?:$|[.,;!?)]|(?:for|on|at|in|around|round|over|across|and|but|please|now|so|can)(?!\w)))",
    re.IGNORECASE,
)
_MADE = re.compile(
    r"(?<!\w)(?:change|make|turn|go|switch|take|from|set|move|cut|shorten|lengthen|bring|convert|alter|get|let"
    r"|swap|adjust|back|down|up|sleeves?:|length:)(?!\w)[^.,;!?]*$",
    re.IGNORECASE,
)
"""Before "to" where it leads somewhere."""
_IS = re.compile(
    r"(?<!\w)(?:is|are|was|its|it['’]s|they['’]re|theyre|bit|way|far|much|just|little|looks?|feels?|seems?"
    r"|fits?) $",
    re.IGNORECASE,
)
_ENDS = frozenset({"long", "short"})


def with_too(text: str, is_so: Callable[[Claim], bool]) -> str:
    """An instruction in which what complains of something does so.

    Args:
        text: In any case.
        is_so: Whether a claim is true of the garment.
    """

    def right(found: re.Match[str]) -> str:
        before, how = text[: found.start()], found["how"].lower()
        if _MADE.search(before):
            return found[0]
        ended = how in _ENDS and not _IS.search(before)
        return found[0] if ended and not is_so(Claim("sleeves", how)) else f"too {found['how']}"

    return _TO.sub(right, text)

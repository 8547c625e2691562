"""Verbs of instructions that a spelling check takes for other words: "strip the cuffs" is no stripe."""

from __future__ import annotations

import re

_REMOVED = re.compile(
    r"(?<!\w)strip(?: off| out| away)?(?= (?:the|its|all|those|these|my|her|his)(?!\w))", re.IGNORECASE
)


def with_plain_verbs(text: str) -> str:
    """An instruction with such verbs put plainly.

    Args:
        text: In any case.
    """
    return _REMOVED.sub("remove", text)

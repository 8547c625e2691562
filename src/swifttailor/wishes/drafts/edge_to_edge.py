"""Coats and jackets whose fronts meet and do not close: edge to edge, worn open, without fastening."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft

_MEETS = re.compile(
    r"(?<!\w)(?:edge[- ]to[- ]edge|worn open|open[- ]front(?:ed)?"
    r"|(?:no|without(?: an?y?)?) (?:fastenings?|closures?|fasteners?)"
    r"|kante an kante|ohne verschluss|bord à bord|sans fermeture|sin cierre)(?!\w)",
    re.IGNORECASE,
)
_EDGE = re.compile(r"(?<!\w)(?:edge[- ]to[- ]edge|kante an kante|bord à bord)(?!\w)", re.IGNORECASE)
_LAPELLED, _ROUND = ("coat", "blazer"), "cardigan"
_OPEN = {"opening": 8.0, "closed_to": -30.0}
"""How far the edges have moved back from the middle at the hem, and where they are joined last, cm."""
_LONG_CM, _SHORT_OPENING_CM = 40.0, 4.0
"""Fronts of what ends less far below the waist part by so much alone, cm."""
_OF_LAPELS = ("lapels", "lapel_width", "collar_width", "crossing")


def meets_without_fastening(text: str) -> bool:
    """Whether a text says of a front that it does not close."""
    return _MEETS.search(text) is not None


def edge_to_edge_as_said(draft: NamedDraft, text: str, claims: Sequence[Claim]) -> NamedDraft:
    """A coat, jacket or cardigan that is open from the neck down where a text says so; others as they are.

    Where the edges meet "edge to edge" it has no collar, unless one is asked for.

    Args:
        draft: As it was asked for otherwise.
        text: All of it.
        claims: What is asked for.
    """
    if draft.name not in (*_LAPELLED, _ROUND) or not meets_without_fastening(text):
        return draft
    options = dict(draft.options) | _OPEN
    if float(options.get("length", _LONG_CM if draft.name == "coat" else 0.0)) < _LONG_CM:
        options["opening"] = _SHORT_OPENING_CM
    collared = any(claim.name in ("collar", "hood") and claim.value != "none" for claim in claims)
    if draft.name in _LAPELLED and _EDGE.search(text) and not collared and options.get("collar") is None:
        options = {name: value for name, value in options.items() if name not in _OF_LAPELS}
        options["collar"] = "none"
    return replace(draft, options=tuple(options.items()))

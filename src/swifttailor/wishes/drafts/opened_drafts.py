"""Wide garments that open in front, are buttoned or have sleeves like wings, where a text asks for those."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft

_KAFTAN, _ROBE, _CAPE = "kaftan", "robe", "cape"
_OPEN, _BUTTONS = "open_front", "buttons"
_APART_CM, _OPEN_CM = 10.0, 70.0
"""How far the edges of an open one have moved back from the middle at the hem, and how far up, cm."""
_FLARE_CM, _LONGEST_CM = 20.0, 100.0
_BUTTONED: dict[str, str | float] = {"closed": 90.0, "opening": 4.0}
"""Of a cape that is buttoned down the front, cm; its draft leaves the hem open."""
_BELL = Claim("sleeve_shape", "bell")
_WINGS = {"arm_ease": 34.0, "sleeve_end": 70.0}
"""Options of sleeves like wings, cm."""


def opened_as_asked(draft: NamedDraft, claims: Sequence[Claim], wanted: Collection[str]) -> NamedDraft:
    """A kaftan that is to open is cut as a robe, a cape with buttons is closed, sleeves that widen are wings.

    Args:
        draft: As a table names it.
        claims: What is asked for, all of it.
        wanted: What the text itself asks for that no way to cut makes: keys of ``cannot.txt``.
    """
    options = dict(draft.options)
    if draft.name == _CAPE and _BUTTONS in wanted and options.get("front") != "closed":
        return NamedDraft(_CAPE, tuple({**options, **_BUTTONED}.items()))
    if draft.name not in (_KAFTAN, _ROBE):
        return draft
    name = draft.name
    if name == _KAFTAN and _OPEN in wanted:
        kept = ("length", "chest_ease", "sleeve_length", "sleeve_end", "arm_ease")
        options = {key: value for key, value in options.items() if key in kept}
        options |= {"flare": _FLARE_CM, "opening": _APART_CM, "neck_depth": 20.0, "front_slit": _OPEN_CM}
        options["length"] = min(float(options.get("length", _LONGEST_CM)), _LONGEST_CM)
        name = _ROBE
    if _BELL in claims:
        options |= {key: max(float(options.get(key, 0.0)), least) for key, least in _WINGS.items()}
    return draft if options == dict(draft.options) else NamedDraft(name, tuple(options.items()))

"""Named drafts of tops that are to be close: their sides bend in at the waist."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import SIDE_SLITS, NamedDraft

SHAPED_TO_CM = 7.0
"""What is darted to the waist may end so far below it; above, it would seem cropped."""
_CLOSE = Claim("fit", "close")
_PULLED_ON: Mapping[str, tuple[float, float]] = dict.fromkeys(
    ("t-shirt", "tank-top", "turtleneck"), (3.0, 3.0)
)
"""Room on top of the bust girth, and how far each side bends in at the waist, cm."""
_BUTTONED: Mapping[str, tuple[float, float]] = dict.fromkeys(
    ("shirt", "polo-shirt", "blazer", "cardigan"), (4.0, 2.5)
)
"""The same of what has buttons; made close by cutting it would be too narrow at the hips, and ride up."""

_CAMISOLE: Mapping[str, float] = {"chest_ease": 3.0, "flare": 0.0, "waist_shaping": 2.0}


def close_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A top that is to be close, its sides bent in at the waist; others as they are.

    Args:
        draft: As it was asked for otherwise.
        claims: What is asked for, all of it.
    """
    options = dict(draft.options)
    if _CLOSE not in claims or SIDE_SLITS in options:
        return draft
    if draft.name in _BUTTONED:
        room, shaping = _BUTTONED[draft.name]
        options["chest_ease"] = min(float(options.get("chest_ease", room)), room)
        options = {"waist_shaping": shaping, **options}
        options["waist_shaping"] = max(float(options["waist_shaping"]), shaping)
        return replace(draft, options=tuple(options.items()))
    if draft.name == "camisole":
        return replace(draft, options=tuple({**options, **_CAMISOLE}.items()))
    if draft.name not in _PULLED_ON:
        return draft
    room, shaping = _PULLED_ON[draft.name]
    short = float(options.get("length", 99.0)) <= SHAPED_TO_CM
    if short and options.get("waist_shaping") and not options.get("stretch"):  # darted, so close as it is
        return draft
    options["chest_ease"] = min(float(options.get("chest_ease", room)), room)
    return replace(draft, options=tuple({**options, "waist_shaping": shaping}.items()))

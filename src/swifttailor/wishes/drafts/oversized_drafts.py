"""Named drafts of tops that are to be far too wide: dropped shoulders, long bodies and wide sleeves."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import ARMHOLE, NamedDraft

_FITS: Mapping[str, Mapping[str, float]] = {
    "oversized": {
        "chest_ease": 30.0,
        "length": 32.0,
        "shoulder_extension": 8.0,
        "armhole_drop": 5.0,
        "arm_ease": 16.0,
    },
    "loose": {"chest_ease": 18.0, "length": 27.0, "shoulder_extension": 4.0, "arm_ease": 10.0},
}
"""What such tops have at least, cm: a wide chest alone stands off the back, and ends at the waist."""
_FITS_OF: Mapping[str, Mapping[str, Mapping[str, float]]] = {
    "blazer": {
        "oversized": {
            "chest_ease": 22.0,
            "length": 32.0,
            "shoulder_extension": 3.5,
            "arm_ease": 13.0,
            "closed_to": 10.0,
        },
        "loose": {"chest_ease": 14.0, "length": 27.0, "shoulder_extension": 1.5, "arm_ease": 10.0},
    }
}
"""The same of drafts whose shoulders are not to slope down the arms."""
_WITH_SHOULDERS = frozenset({"chest_ease", "length", "shoulder_extension", "armhole_drop", "arm_ease"})
_PLAIN = _WITH_SHOULDERS - {"shoulder_extension"}
_OPTIONS: Mapping[str, frozenset[str]] = {
    "t-shirt": _WITH_SHOULDERS,
    "shirt": _WITH_SHOULDERS,
    "cardigan": _WITH_SHOULDERS,
    "sweatshirt": _WITH_SHOULDERS - {"armhole_drop"},
    "hoodie": _WITH_SHOULDERS - {"armhole_drop"},
    "turtleneck": _PLAIN,
    "polo-shirt": _PLAIN,
    "tank-top": frozenset({"chest_ease", "length"}),
    "blazer": (_WITH_SHOULDERS - {"armhole_drop"}) | {"closed_to"},
    "hooded-coat": _WITH_SHOULDERS - {"length"},
}
"""Which of them each draft has."""
_OF_SHOULDERS = frozenset({"shoulder_extension", "arm_ease"})
_HOODED, _OPENING = "hooded-coat", "opening"
_ELBOW_CM, _SHORT_CM, _DROPPED_CM = 40.0, 26.0, 6.0
"""Longer sleeves reach the wrist; shorter ones fall to the elbow; how much lower the former begin."""
_SLEEVES: Mapping[str, tuple[float, float | None]] = {
    "t-shirt": (22.0, 30.0),
    "cardigan": (58.5, 32.0),
    "turtleneck": (58.5, 29.0),
    "polo-shirt": (24.0, 34.0),
    _HOODED: (60.0, 34.0),
    "shirt": (60.0, None),
}
"""Usual length of each draft's sleeves, and width around at the end of long ones, cm; None: in a cuff."""
_SHORT_END_CM, _LONGEST_SHORT_CM = 46.0, 26.0
"""Width around at the end of short ones; and their length where they are called short: longer ones reach the
elbow, and would be cut back to a cap."""
_BARE_EASE_CM = 24.0
"""Without sleeves, wider ones gape beside the arms."""
_LONG, _LONG_CM = ("long", "extra-long"), 60.0
_HEMS = frozenset({"top_hem", "length_cm"})


def oversized_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A top that is to be oversized or loose, wide all over and long; others as they are.

    Args:
        draft: As it was asked for otherwise.
        claims: What is asked for, all of it.
    """
    fits = [str(claim.value) for claim in claims if claim.name == "fit" and claim.value in _FITS]
    known = _OPTIONS.get(draft.name)
    options = dict(draft.options)
    if not fits or known is None or (draft.name == _HOODED and options.get(_OPENING) != 0.0):
        return draft
    told_hem = any(claim.name in _HEMS for claim in claims)
    shaped = options.get(ARMHOLE, "set-in") != "set-in" or options.get("sleeve_shape", "plain") != "plain"
    for name, least in _FITS_OF.get(draft.name, _FITS)[fits[0]].items():
        if name not in known or (name == "length" and told_hem) or (shaped and name in _OF_SHOULDERS):
            continue
        least = min(least, _BARE_EASE_CM) if draft.name == "tank-top" and name == "chest_ease" else least
        options[name] = max(least, float(options.get(name, least)))
    options.pop("waist_shaping", None)
    options |= {"waist_shaping": 0.0} if draft.name in _FITS_OF else {}
    if not shaped and fits[0] == "oversized" and draft.name in _SLEEVES and options.get("sleeves", True):
        told = [str(claim.value) for claim in claims if claim.name == "sleeves"]
        options |= _sleeves(draft.name, options, told)
    return replace(draft, options=tuple(options.items()))


def _sleeves(
    name: str, options: Mapping[str, float | bool | str], told: Sequence[str]
) -> Mapping[str, float]:
    """Sleeves as wide as such tops have them; long ones begin lower, and end where they did."""
    usual, end = _SLEEVES[name]
    length = float(options.get("sleeve_length", usual))
    length = max(length, _LONG_CM) if any(word in _LONG for word in told) else length
    if length < _ELBOW_CM:
        longest = _LONGEST_SHORT_CM if "short" in told else _ELBOW_CM
        return {"sleeve_length": min(max(length, _SHORT_CM), longest), "sleeve_end": _SHORT_END_CM}
    dropped = length - (_DROPPED_CM if "shoulder_extension" in _OPTIONS[name] else 0.0)
    return {"sleeve_length": dropped} | ({} if end is None else {"sleeve_end": end})

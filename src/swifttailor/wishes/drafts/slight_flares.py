"""Skirts that are to be only a little flared: close over the hips, and slanting at the sides from there."""

from __future__ import annotations

import re

from swifttailor.pattern.drafts.draft_names import NamedDraft

_SLIGHTLY = (
    r"(?:slight(?:ly)?|gent(?:ly|le)|soft(?:ly)?|subtl[ey]|modest(?:ly)?"
    r"|an? (?:little|bit|touch|tad)(?: bit)?|somewhat|only just|barely|not (?:too|very|so)|hardly)"
)
_FLARED = r"(?:flared?|flaring|fuller?|fullness|wider?|open|swing|swingy|a-?line)"
_SAID = re.compile(
    r"(?<!\w)(?:skirts?(?: part)?,? "
    r"(?:(?:that|which|is|are|to be|should be|and|only|just|with an?|flaring) )*"
    rf"{_SLIGHTLY} {_FLARED}|{_SLIGHTLY} {_FLARED} (?:(?!leg|sleeve|and )[\w-]+ ){{0,2}}?skirts?"
    rf"|{_SLIGHTLY} {_FLARED} (?:in|at|of|to) the (?:skirt|hem)"
    r"|rock,? (?:(?:ist|soll|nur|der) )*(?:leicht|etwas|ein wenig|nicht zu) (?:aus)?(?:gestellt\w*|weit\w*)"
    r"|(?:leicht|etwas) (?:ausgestellt|weit)\w* rock"
    r"|jupe,? (?:légèrement|un peu) (?:évasée|ample|large)|falda,? (?:ligeramente|un poco) \w+"
    r"|rok,? (?:licht|iets) (?:uitlopend|wijd)\w*|gonna,? (?:leggermente|un po') \w+"
    r"|saia,? (?:ligeiramente|um pouco) \w+)(?!\w)",
    re.IGNORECASE,
)
_MOST_ROUND = 0.75
_FLARE, _HIP_EASE_CM = 10.0, 6.0
"""Slant of the side seams, degrees, and room over the hips, cm."""
_OF_BODICE = frozenset(
    (
        *("bust_ease", "waist_ease", "neckline", "neck_widening", "neck_depth", "back_neck_depth"),
        *("armhole_drop", "stretch", "skirt_length"),
        *("sleeves", "sleeve_length", "arm_ease", "sleeve_end", "cap_ease", "sleeve_shape"),
    )
)
"""Options that fitted and skater dresses share."""


def slightly_flared_as_said(draft: NamedDraft, text: str) -> NamedDraft:
    """A skirt, or a dress with one, that flares a little where a text says so; others as they are.

    Args:
        draft: As it goes with all else that is asked for.
        text: The words.
    """
    options = dict(draft.options)
    fraction = float(options.get("skirt_fraction", options.get("fraction", 0.75)))
    gathered = float(options.get("gathers", 1.0)) > 1.0 or options.get("pleats") or options.get("racer")
    if fraction > _MOST_ROUND or gathered or _SAID.search(text) is None:
        return draft
    if draft.name == "circle-skirt" and not (options.get("yoke") or options.get("below_waist")):
        kept = {name: options[name] for name in ("length", "band_height") if name in options}
        return NamedDraft(
            "fitted-skirt",
            tuple({"length": 60.0, **kept, "flare": _FLARE, "hip_ease": _HIP_EASE_CM}.items()),
        )
    if draft.name != "skater-dress":
        return draft
    kept = {name: value for name, value in options.items() if name in _OF_BODICE}
    flared = {"skirt_flare": _FLARE, "hip_ease": _HIP_EASE_CM}
    return NamedDraft("fitted-dress", tuple({**kept, **flared}.items()))

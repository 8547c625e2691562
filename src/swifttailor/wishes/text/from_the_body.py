"""Lengths said from a place of the body: "two inches above the knee", "28 inches below the waist"."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

from swifttailor.describing.claims import Claim
from swifttailor.describing.facts import LandmarkFacts
from swifttailor.wishes.text.mentions import Mention, find_mentions

_PLACES: Mapping[str, tuple[str, float, Callable[[LandmarkFacts], float]]] = {
    "knee": (r"knees?(?:caps?)?", 45.9, lambda body: body.knee),
    "waist": (r"(?:natural )?waist(?:line|band)?", 108.8, lambda body: body.waist),
    "hips": (r"hips?(?:[ -]?(?:line|bones?))?", 85.3, lambda body: body.hips),
    "crotch": (r"crotch", 76.5, lambda body: body.crotch),
    "ankle": (r"ankles?(?:[ -]?bones?)?", 8.0, lambda body: 8.0),
    "floor": (r"floor|ground", 0.0, lambda body: 0.0),
}
"""Words for places, and their heights: of the default body, and of another."""
_SAID = re.compile(
    r"\s*(?P<way>above|over|below|under(?:neath)?|beneath|past|beyond|lower than|higher than|off|from)\s+"
    rf"(?:the|my|her|his|your)?\s*(?:{'|'.join(f'(?P<{key}>{p[0]})' for key, p in _PLACES.items())})(?!\w)",
    re.IGNORECASE,
)
_LEGGED = ("trousers", "shorts", "jumpsuit", "playsuit")
_UP = ("above", "over", "higher than")
_FROM = ("off", "from")
"""Only the floor is gone from: what is measured from the waist is a length anyway."""
_SHOULDER_CM, _NECK_CM = 144.5, 145.7
"""Heights of the default body."""
_HANGS_CM = 2.5
"""So much lower than on their patterns dresses end on the body."""
_TO_THE_WAIST_CM = 34.0
"""From the shoulder to the waist, on the patterns of tops."""
_FROM_WAIST_CM = 25.0
"""What is less below the waist is where something sits, not where a skirt ends."""
_SEAMS = re.compile(
    r"(?<!\w)(?:sits?|sitting|rise|waist ?(?:band|line|seam)?|seam|yoke|band|begins?|starts?|from|darts?"
    r"|pockets?|slits?|splits?|vents?|buttons?|belt|pleats?|flar\w+|gather\w*|tie[sd]?|sleeves?)(?!\w)[^.;,]{0,24}$",
    re.IGNORECASE,
)
"""Before a figure that tells where something else is than the hem."""


def said_from_the_body(text: str, mention: Mention, kind: str | None) -> tuple[Claim | None, bool]:
    """The length that leads to where a figure says that a garment ends, and whether it says so.

    Args:
        text: In any case.
        mention: The figure.
        kind: Of the garment, where that is known.
    """
    found = _place(text, mention)
    if found is None:
        return None, False
    place, level = found
    waist = _PLACES["waist"][1]
    if place in ("waist", "hips", "crotch"):
        short = waist - level < _FROM_WAIST_CM
        if _SEAMS.search(text, 0, mention.start) or (short and kind not in ("top", "tunic")):
            return None, False
    if kind == "skirt":
        return Claim("skirt_length_cm", round(waist - level, 1)), True
    if kind == "dress":
        return Claim("length_cm", round(_SHOULDER_CM - level - _HANGS_CM, 1)), True
    if kind in ("top", "tunic") and place in ("waist", "hips", "crotch", "knee"):
        return Claim("length_cm", round(waist - level + _TO_THE_WAIST_CM, 1)), True
    if kind in _LEGGED and place not in ("waist", "hips"):
        return Claim("inseam_cm", round(_PLACES["crotch"][1] - level, 1)), True
    return None, True


def length_on(text: str, claim: Claim, body: LandmarkFacts) -> Claim:
    """A stated length as it is on another body, where the text says it from a place of the body.

    Args:
        text: It is said in.
        claim: A length, as `said_from_the_body` states it, of the default body.
        body: Whose heights count.
    """
    top = {
        "length_cm": (_SHOULDER_CM, body.neck - _NECK_CM + _SHOULDER_CM),
        "skirt_length_cm": (_PLACES["waist"][1], body.waist),
        "inseam_cm": (_PLACES["crotch"][1], body.crotch),
    }
    if claim.name not in top:
        return claim
    told = [found for m in find_mentions(text) if m.is_length and (found := _place(text, m)) is not None]
    if len(told) != 1:
        return claim
    key, _ = told[0]
    (usual_top, own_top), usual_end, own_end = top[claim.name], _PLACES[key][1], _PLACES[key][2](body)
    longer = (own_top - own_end) - (usual_top - usual_end)
    return Claim(claim.name, round(float(claim.value) + longer, 1))


def _place(text: str, mention: Mention) -> tuple[str, float] | None:
    """The place that is named behind a figure, and the height that is meant."""
    said = _SAID.match(text, mention.end) if mention.is_length else None
    if said is None:
        return None
    key = next(key for key in _PLACES if said[key])
    way = said["way"].lower()
    if way in _FROM and key != "floor":
        return None
    up = way in _UP or key == "floor"
    return key, _PLACES[key][1] + mention.value * (1 if up else -1)

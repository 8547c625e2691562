"""Hems that are longer on one side: "hem dropping toward the right", "longer behind than in front"."""

from __future__ import annotations

import re

from swifttailor.describing.claims import Claim
from swifttailor.wording.lexicon import WordReading

_LONGER = (
    r"longer|lower|more long|dropping|drops?|dipping|dips?|falling|falls?|sloping|slopes?|slanting|slants?"
    r"|trailing|länger|tiefer|plus longue?|más larg[oa]"
)
_SHORTER = r"shorter|higher|rising|rises?|more short|kürzer|höher|plus courte?|más cort[oa]"
_PLACE = (
    r"(?P<left>left|links|gauche|izquierda)|(?P<right>right|rechts|droite|derecha)"
    r"|(?P<back>back|behind|rear|hinten|derrière|arrière|detrás|atrás)"
    r"|(?P<front>front|vorne|vorn|devant|delante)"
)
_SAID = re.compile(
    rf"(?<!\w)(?:(?P<longer>{_LONGER})|(?P<shorter>{_SHORTER}))(?!\w)\W+(?:\w+\W+){{0,3}}?(?:{_PLACE})(?!\w)"
)
_BEFORE = re.compile(
    rf"(?<!\w)(?:{_PLACE})(?!\w)\W+(?:\w+\W+){{0,2}}?(?:(?P<longer>{_LONGER})|(?P<shorter>{_SHORTER}))(?!\w)"
)
_OTHER_PARTS = re.compile(r"(?<!\w)(?:neck\w*|sleeve\w*|collar|waist|slit|back neck\w*|zip\w*)(?!\w)")
_OTHER_SIDE = {"left": "right", "right": "left", "back": "front", "front": "back"}


def spoken_hem(text: str, kind: str | None) -> Claim | None:
    """What a text says of a hem that is longer on one side; None where it says nothing of that.

    Args:
        text: Of a description, in any case.
        kind: Of the garment; trousers have no such hem.
    """
    if kind in ("trousers", "shorts", "jumpsuit", "playsuit"):
        return None
    for sentence in re.split(r"[.;!?,\n]", text.lower()):
        if _OTHER_PARTS.search(sentence):
            continue
        said = _SAID.search(sentence) or _BEFORE.search(sentence)
        if said is None:
            continue
        place = next(name for name in _OTHER_SIDE if said[name])
        lower = place if said["longer"] else _OTHER_SIDE[place]
        if lower in ("left", "right"):
            return Claim("hem_shape", f"lower {lower}")
        if lower == "back":
            return Claim("hem_shape", "high-low")
    return None


_THAN = re.compile(r"(?<!\w)(?:than|als|que)\s+(?:the|my|to the|a)?\s*$", re.IGNORECASE)
_LENGTHS = frozenset({"skirt_hem", "top_hem", "leg_hem", "sleeves"})


def spoken_bounds(text: str, words: WordReading) -> list[Claim]:
    """Lengths beyond which nothing may go: "nothing shorter than the calf" asks for the calf.

    Args:
        text: That the lexicon has read.
        words: By the lexicon; what stands behind "than" is denied in it.
    """
    found = []
    for mark in words.marks:
        if not mark.denied or not _THAN.search(text[: mark.start]):
            continue
        claims = [each.claim for entry in mark.entries for each in entry.implied]
        found += [claim for claim in claims if claim.name in _LENGTHS][:1]
    return found


def spoken_slit(text: str, words: WordReading) -> Claim | None:
    """Where a slit is whose place stands apart from it: "slit to mid-thigh on the right"."""
    if any(i.claim.name == "slit" for i in words.implications):
        return None
    for mark in words.marks:
        if mark.denied or not mark.entries or mark.entries[0].part != "slit":
            continue
        clause = re.split(r"[.;,\n]", text[mark.start :].lower())[0]
        place = re.search(rf"(?<!\w)(?:{_PLACE})(?!\w)", clause)
        return Claim("slit", next(name for name in _OTHER_SIDE if place[name]) if place else "left")
    return None

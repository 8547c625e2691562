"""Hems that are longer on one side: "hem dropping toward the right", "longer behind than in front"."""

from __future__ import annotations

import re

from swifttailor.describing.claims import Claim
from swifttailor.wording.lexicon import WordReading

_LONGER = (
    r"longer|lower|more long|dropping|drops?|dipping|dips?|falling|falls?|sloping|slopes?|slanting|slants?"
    r"|trailing|länger|tiefer|plus longue?|más larg[oa]|più lung[oa]|mais (?:long|comprid)[oa]"
)
_SHORTER = (
    r"shorter|higher|rising|rises?|more short|kürzer|höher|plus courte?|más cort[oa]|più cort[oa]"
    r"|mais curt[oa]"
)
_PLACE = (
    r"(?P<left>left|links|gauche|izquierda|sinistra|esquerda)|(?P<right>right|rechts|droite|derecha|destra|direita)"
    r"|(?P<back>back|behind|rear|hinten|derrière|arrière|detrás|atrás|dietro|achter|achteraan)"
    r"|(?P<front>front|vorne|vorn|devant|delante|davanti|vooraan|na frente)"
)
_SAID = re.compile(
    rf"(?<!\w)(?:(?P<longer>{_LONGER})|(?P<shorter>{_SHORTER}))(?!\w)\W+(?:\w+\W+){{0,3}}?(?:{_PLACE})(?!\w)"
)
_BEFORE = re.compile(
    rf"(?<!\w)(?:{_PLACE})(?!\w)\W+(?:\w+\W+){{0,2}}?(?:(?P<longer>{_LONGER})|(?P<shorter>{_SHORTER}))(?!\w)"
)
_OTHER_PARTS = re.compile(r"(?<!\w)(?:neck\w*|sleeve\w*|collar|waist|slit|back neck\w*|zip\w*)(?!\w)")
_THAN_WHAT = re.compile(r"(?<!\w)(?:than|als|que)(?!\w)(?!.*(?<!\w)(?:in|at|behind)(?!\w))")
"""What is longer than the front is so behind."""
_ONE_LONG = re.compile(
    r"(?<!\w)(?:(?P<long>long|longer)|(?:short|shorter)) (?:on|at) (?:one|the (?:left|right)) side[,;]?"
    r"(?: and| but)? (?(long)(?:short|shorter)|(?:long|longer)) (?:on|at) the other(?!\w)"
    r"|(?<!\w)one side (?:\w+ )?longer than the other(?! (?:sleeve|arm))(?!\w)"
)
"""Which side is longer is left open where nothing tells."""
_OTHER_SIDE = {"left": "right", "right": "left", "back": "front", "front": "back"}


def spoken_hem(text: str, kind: str | None) -> Claim | None:
    """What a text says of a hem that is longer on one side; None where it says nothing of that.

    Args:
        text: Of a description, in any case.
        kind: Of the garment; trousers have no such hem.
    """
    if kind in ("trousers", "shorts", "jumpsuit", "playsuit"):
        return None
    small = text.lower()
    if _ONE_LONG.search(small) and not _OTHER_PARTS.search(small):
        side = re.search(r"(?<!\w)(left|right)(?!\w)", small)
        return Claim("hem_shape", f"lower {side[1] if side else 'left'}")
    for sentence in re.split(r"[.;!?,\n]", small):
        if _OTHER_PARTS.search(sentence):
            continue
        said = _SAID.search(sentence) or _BEFORE.search(sentence)
        if said is None:
            continue
        place = next(name for name in _OTHER_SIDE if said[name])
        longer = bool(said["longer"]) != bool(_THAN_WHAT.search(said[0]))
        lower = place if longer else _OTHER_SIDE[place]
        if lower in ("left", "right"):
            return Claim("hem_shape", f"lower {lower}")
        if lower == "back":
            return Claim("hem_shape", "high-low")
    return None


_THAN = re.compile(r"(?<!\w)(?:than|als|que)\s+(?:the|my|to the|a)?\s*$", re.IGNORECASE)
_LENGTHS = frozenset({"skirt_hem", "top_hem", "leg_hem", "sleeves"})


_COMPARED = re.compile(
    r"(?<!\w)(?P<no>(?:no|not|nothing|never|n['’]t be|nicht)\s+(?:\w+\s+)?)?"
    r"(?P<how>longer|lower|länger|shorter|higher|kürzer)\s+(?:than|als)\s+"
    r"(?:(?:the|my|to the|das|die|der)\s+)?"
    r"(?P<level>knee|knie|mid-?calf|calf|calves|wade|ankle|knöchel|floor|ground|thigh|hip ?bone"
    r"|hip|waist|elbow|wrist)"
)
_NOT_PAST = re.compile(
    r"(?<!\w)(?:nothing|not|never|n['’]t)"
    r"(?: (?:to |should |must |can |may )?(?:go|goes|reach|reaches|come|comes|end|ends|be|fall|falls))?"
    r" (?:below|past|beyond|under|lower than|further than)\s+(?:(?:the|my|her)\s+)?"
    r"(?P<level>knees?|mid-?calf|calf|calves|ankles?|thighs?|hip ?bones?|hips?|waist|elbows?"
    r"|wrists?)(?!\w)"
)
"""What nothing may go beyond is where it ends: "nothing below the knee"."""
_LEVELS = {
    "skirt_hem": {
        **{"knee": "knee", "knie": "knee", "mid-calf": "midi", "midcalf": "midi", "calf": "midi"},
        **{"calves": "midi", "wade": "midi", "ankle": "ankle", "knöchel": "ankle", "floor": "floor"},
        **{"ground": "floor", "thigh": "mini"},
    },
    "leg_hem": {
        **{"knee": "knee", "knie": "knee", "mid-calf": "calf", "midcalf": "calf", "calf": "calf"},
        **{"calves": "calf", "wade": "calf", "ankle": "ankle", "knöchel": "ankle", "thigh": "mid-thigh"},
    },
    "top_hem": {"hip": "hip", "hip bone": "high hip", "hipbone": "high hip", "waist": "waist"},
    "sleeves": {"elbow": "elbow", "wrist": "long"},
}
"""Hems at a height of the body."""
_BESIDE_KNEE = {"longer": "below the knee", "shorter": "above the knee"}


def _compared(text: str, kind: str | None) -> list[Claim]:
    """A hem compared with a height: "no longer than the knee" asks for the knee, "longer" for more."""
    hem = {"trousers": "leg_hem", "shorts": "leg_hem", "jumpsuit": "leg_hem", "top": "top_hem"}.get(
        kind or "", "skirt_hem"
    )
    found = []
    for said in _COMPARED.finditer(text.lower()):
        name = "sleeves" if said["level"] in _LEVELS["sleeves"] else hem
        value = _LEVELS[name].get(said["level"])
        if value is not None and said["no"] is None:
            way = "longer" if said["how"] in ("longer", "lower", "länger") else "shorter"
            value = _BESIDE_KNEE[way] if (name, value) == ("skirt_hem", "knee") else None
        found += [] if value is None else [Claim(name, value)]
    for said in _NOT_PAST.finditer(text.lower()):
        level = said["level"] if said["level"] == "calves" else said["level"].rstrip("s")
        name = "sleeves" if level in _LEVELS["sleeves"] else hem
        value = _LEVELS[name].get(level)
        found += [] if value is None else [Claim(name, value)]
    return found


def spoken_bounds(text: str, words: WordReading, kind: str | None = None) -> list[Claim]:
    """Lengths beyond which nothing may go: "nothing shorter than the calf" asks for the calf.

    Args:
        text: That the lexicon has read.
        words: By the lexicon; what stands behind "than" is denied in it.
        kind: Of the garment, as far as it is named.
    """
    found = _compared(text, kind)
    if found:
        return found
    for mark in words.marks:
        if not mark.denied or not _THAN.search(text[: mark.start]):
            continue
        claims = [each.claim for entry in mark.entries for each in entry.implied]
        found += [claim for claim in claims if claim.name in _LENGTHS][:1]
    return found


_LEG = re.compile(r"(?<!\w)(left|right) (?:leg|thigh)(?!\w)")


def spoken_slit(text: str, words: WordReading) -> Claim | None:
    """Where a slit is whose place stands apart from it: "slit to mid-thigh on the right"."""
    if any(i.claim.name == "slit" for i in words.implications):
        return None
    for mark in words.marks:
        if mark.denied or not mark.entries or mark.entries[0].part != "slit":
            continue
        clause = re.split(r"[.;,\n]", text[mark.start :].lower())[0]
        place = re.search(rf"(?<!\w)(?:{_PLACE})(?!\w)", clause)
        if place is None and (leg := _LEG.search(text.lower())):
            return Claim("slit", leg[1])
        return Claim("slit", next(name for name in _OTHER_SIDE if place[name]) if place else "left")
    return None

"""How deep a neckline is, where a text says so in figures: "the back cut in a V, 12 inches deep"."""

from __future__ import annotations

import re

from swifttailor.describing.claims import Claim
from swifttailor.wishes.text.mentions import Mention

_DEEP = re.compile(
    r"[\s-]*(?:deep|in depth|tief\w*|de profond\w*|profond\w*|diep\w*|de profundidad|profund\w*|di profondità"
    r"|de profundidade|fund[oa]s?)(?!\w)"
)
_DEPTH = re.compile(
    r"(?<!\w)(?:depth|tiefe|profondeur|profundidad|profondità|diepte|profundidade)\W+(?:\w+\W+){0,3}$"
)
_NECK = (
    r"necks?|neckline|necklines|v|v-neck|vee|décolleté|decollete|scoop|boat|plunge|neck opening|\w*ausschnitt"
    r"|encolure|décolletage|escote|scollo|scollatura|decote|\w*hals|hals\w*"
)
_BACK = r"back|behind|backless|hinten|rücken\w*|dos|espalda|schiena|dietro|rug\w*|achter\w*|costas|atrás"
_OTHERS = (
    r"cuffs?|waistband|bands?|hems?|slits?|pockets?|pleats?|yokes?|collars?|frills?|flounces?|ruffles?|tiers?"
    r"|peplum|hood|turn-?ups?|armholes?|border|fringe|lapels?|waist|sleeves?|skirt|bund|saum|kragen|taschen?"
)
_NOUN = re.compile(rf"(?<!\w)(?:(?P<neck>{_NECK})|(?P<back>{_BACK})|(?P<other>{_OTHERS}))(?!\w)")
_FRONT = re.compile(r"(?<!\w)(?:front|vorn\w*|devant|davanti|delante|frente|voor\w*)(?!\w)")
_BACKS = re.compile(rf"(?<!\w)(?:{_BACK})(?!\w)")
_SENTENCE = re.compile(r"[;\n]|[.!?](?=\s)")
_ELSE = re.compile(r",|\d|(?<!\w)(?:and|und|et|y|e|en|with|mit|avec|con)(?!\w)")
"""Behind a figure, where something else begins."""
_BEFORE, _BEHIND, _BESIDE = 70, 32, 40
"""Characters around the figure in which the word for what is deep stands, and beside that word."""
_LEAST_CM, _MOST_CM = 4.0, 60.0


def spoken_depth(text: str, mention: Mention) -> Claim | None:
    """The depth of a front or back neckline that a figure states; None where it states something else.

    Args:
        text: In lower case.
        mention: The figure.
    """
    if not mention.is_length or not _LEAST_CM <= mention.value <= _MOST_CM:
        return None
    if not _DEEP.match(text, mention.end) and not _DEPTH.search(text, 0, mention.start):
        return None
    start = max([m.end() for m in _SENTENCE.finditer(text, 0, mention.start)] or [0])
    start = max(start, mention.start - _BEFORE)
    stop = _SENTENCE.search(text, mention.end)
    end = min(stop.start() if stop else len(text), mention.end + _BEHIND)
    other = _ELSE.search(text, mention.end, end)
    end = other.start() if other else end
    behind = list(_NOUN.finditer(text, mention.end, end))
    before = list(_NOUN.finditer(text, start, mention.start))
    if not before and not behind:
        return None
    # "A 16 cm deep square neck" names it behind the figure, mostly it is named before.
    noun = (
        before[-1]
        if before and (not behind or text.rfind(",", before[-1].end(), mention.start) < 0)
        else None
    )
    noun = noun or (behind[0] if behind else before[-1])
    if noun["other"]:
        return None
    listed = text.rfind(",", start, noun.start()) + 1  # "two darts in the back, neckline 12 cm deep"
    beside = text[max(start, listed, min(noun.start() - _BESIDE, mention.start)) : end]
    backs, fronts = list(_BACKS.finditer(beside)), list(_FRONT.finditer(beside))
    is_back = bool(backs) and (not fronts or fronts[-1].start() < backs[-1].start())
    return Claim("back_depth_cm" if is_back else "neck_depth_cm", round(mention.value, 2))

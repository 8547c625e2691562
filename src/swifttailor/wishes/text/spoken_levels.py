"""Where on the body a garment or its sleeves end: "one that stops at my ankles", "hem just above the knee".

The lexicon has the commonest of these phrases as they stand ("to the knee"); here they are put together from
what ends, how, and where.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from swifttailor.describing.claims import Claim
from swifttailor.wishes.text.spoken_sides import SpokenSides
from swifttailor.wording.lexicon import WordMark, WordReading
from swifttailor.wording.lexicon.conflicts import opposed
from swifttailor.wording.lexicon.two_places import of_two_places

_ENDS = (
    r"(?:stop|end|finish|reach|hit|land|sit|fall|come|go|graze|skim|touch|brush|hang|drop)(?:s|es|ed|ped|(?:p|t|g|m)?ing)?"
    r"|cut(?: off)?|cropped(?: off)?|long enough to (?:reach|touch|come to)|as long as|hem(?:med)?"
)
_TO = r"to|at|on|by|around|about|down to|right to|right down to|all the way to|all the way down to|as far as"
_BARE = frozenset({"to", "down to", "right to", "right down to", "all the way to", "as far as"})
"""What may stand without a verb."""
_WHERE = (
    r"cover(?:s|ing)?|just above|right above|above|just below|right below|just under|below|under|just past"
    r"|past|beyond"
)
_LEVELS = {
    **{"knee": "knee", "knees": "knee", "kneecap": "knee", "kneecaps": "knee"},
    **{"calf": "calf", "calves": "calf", "mid-calf": "calf", "mid calf": "calf", "midcalf": "calf"},
    **{"middle of the calf": "calf", "middle of my calf": "calf", "shin": "calf", "shins": "calf"},
    **{"mid-shin": "calf", "mid shin": "calf"},
    **{"ankle": "ankle", "ankles": "ankle", "ankle bone": "ankle", "ankle bones": "ankle"},
    **{"floor": "floor", "ground": "floor", "toes": "floor", "feet": "floor"},
    **{"top of my feet": "floor", "tops of my feet": "floor", "top of the foot": "floor"},
    **{"thigh": "thigh", "thighs": "thigh", "mid-thigh": "thigh", "mid thigh": "thigh", "midthigh": "thigh"},
    **{"middle of the thigh": "thigh", "middle of my thigh": "thigh"},
    **{"hip": "hip", "hips": "hip", "hip bone": "high hip", "hip bones": "high hip", "hipbone": "high hip"},
    **{"waist": "waist", "waistline": "waist", "belly button": "waist", "navel": "waist"},
    **{"elbow": "elbow", "elbows": "elbow", "wrist": "wrist", "wrists": "wrist"},
}
_LEVEL = "|".join(sorted(_LEVELS, key=len, reverse=True))
_PHRASE = re.compile(
    rf"(?<![\w-])(?:(?P<ends>{_ENDS})\s+)?(?:right |exactly |somewhere |roughly |about |down )?"
    rf"(?:(?P<to>{_TO})\s+)?(?:(?P<where>{_WHERE})\s+)?(?:(?:the|my|her|his|their|your)\s+)?(?P<level>{_LEVEL})"
    r"(?![\w-]|\s+(?:length|high|boots?|socks?|bands?|seams?|line|ties?|straps?|patch(?:es)?|cuffs?|belts?))",
    re.IGNORECASE,
)
_SKIRTS = {
    **{"knee": "knee", "calf": "midi", "ankle": "ankle", "floor": "floor", "thigh": "mini"},
    **{
        "above knee": "above the knee",
        "below knee": "below the knee",
        "below ankle": "floor",
        "below calf": "maxi",
    },
    **{"below thigh": "above the knee"},
}
_LEGS = {
    **{"knee": "knee", "calf": "calf", "ankle": "ankle", "floor": "full", "thigh": "mid-thigh"},
    **{"above knee": "thigh", "below knee": "calf", "above ankle": "ankle", "below ankle": "full"},
}
_TOPS = {
    **{"hip": "hip", "high hip": "high hip", "waist": "waist", "thigh": "long"},
    **{"above waist": "cropped", "below waist": "high hip", "above hip": "high hip", "below hip": "long"},
}
_SLEEVES = {
    **{"elbow": "elbow", "wrist": "long", "above elbow": "short", "below elbow": "three-quarter"},
    **{"above wrist": "three-quarter", "below wrist": "extra-long"},
}
_HEMS = {
    **dict.fromkeys(("dress", "skirt"), ("skirt_hem", _SKIRTS)),
    **dict.fromkeys(("trousers", "jumpsuit", "playsuit"), ("leg_hem", _LEGS)),
    "shorts": ("leg_hem", {**_LEGS, "below knee": "knee"}),
    **dict.fromkeys(("top", "tunic"), ("top_hem", _TOPS)),
}
"""The claim about the hem of a kind, and its values by the level."""
_WHOLE_PARTS = frozenset({"skirt", "legs", "hem", "length"})
"""Parts that end where the garment does."""
_PASSED_OVER = frozenset({"function", "colors", "fabrics", "prints", "numbers", "sizes", "shades", "polite"})
"""Categories of words that may stand between what ends and where it ends."""
_OPENS = re.compile(r"(?:^|[,;.:\n(]|(?<!\w)(?:and|but|or|which|that|one|it))\s*$", re.IGNORECASE)
_SPEAKS_OF_ARMS = re.compile(r"(?<!\w)(?:sleeves?|arms?)(?!\w)", re.IGNORECASE)


def spoken_levels(text: str, words: WordReading, kind: str | None) -> SpokenSides:
    """Where a garment ends, and its sleeves, as far as nothing else in a text says so.

    Args:
        text: That the lexicon has read.
        words: By the lexicon.
        kind: Of the garment, as far as it is named.

    Returns:
        Claims about hems and sleeves, and where in the text each stands.
    """
    told = {i.claim.name for i in words.implications if i.said}
    found: dict[str, tuple[Claim, tuple[int, int]]] = {}
    for claim, said in _said_levels(text, words, kind):
        if claim.name not in told:
            found.setdefault(claim.name, (claim, said.span()))
    return SpokenSides(
        tuple([claim for claim, _ in found.values()]), tuple([span for _, span in found.values()])
    )


def clashing_levels(text: str, words: WordReading, kind: str | None) -> tuple[tuple[str, str], ...]:
    """Words for a length and places where the garment is to stop that cannot both be true.

    Args:
        text: That the lexicon has read.
        words: By the lexicon.
        kind: Of the garment, as far as it is named.

    Returns:
        Pairs in the words of the text: "ankle-length", "stops at the thigh".
    """
    named = [mark for pair in words.contradictions for mark in (pair.first, pair.second)]
    lengths = [i for i in words.implications if i.certainty == "certain" and i.mark not in named]
    return tuple(
        [
            (i.mark.word, said[0].strip())
            for claim, said in _said_levels(text, words, kind)
            for i in lengths
            if said["ends"] and opposed(claim, i.claim)
            if (i.mark.end <= said.start() or said.end() <= i.mark.start)
            if not of_two_places(text, *sorted([(i.mark.start, i.mark.end), said.span()]))
        ]
    )


def _said_levels(text: str, words: WordReading, kind: str | None) -> Iterator[tuple[Claim, re.Match[str]]]:
    for said in _PHRASE.finditer(text):
        bare = said["ends"] is None and said["where"] is None
        if (bare and (said["to"] or "").lower() not in _BARE) or _is_denied(words, said.start(), said.end()):
            continue
        claim = _claim(text, said, words, kind)
        if claim is not None:
            yield claim, said


def _claim(text: str, said: re.Match[str], words: WordReading, kind: str | None) -> Claim | None:
    """What one phrase says."""
    level = _LEVELS[re.sub(r"\s+", " ", said["level"].lower())]
    where = (said["where"] or "").lower().split()[-1:]
    if where:
        level = f"{'above' if where == ['above'] else 'below'} {level}"
    start = said.start()
    subject = _subject(words, start)
    if level in _SLEEVES:
        near = text[max(0, start - 40) : said.end() + 20]
        return Claim("sleeves", _SLEEVES[level]) if _SPEAKS_OF_ARMS.search(near) else None
    name, values = _HEMS.get(kind or "", ("", {}))
    if level not in values or _SPEAKS_OF_ARMS.search(re.split(r"[,;.\n]|(?<!\w)and(?!\w)", text[:start])[-1]):
        return None
    part = None if subject is None else subject.part
    ends = subject is not None and (_is_garment(subject) or part in _WHOLE_PARTS)
    opens = _OPENS.search(text[:start]) is not None and bool(said["ends"] or _stands_alone(text, said))
    return Claim(name, values[level]) if ends or opens else None


def _stands_alone(text: str, said: re.Match[str]) -> bool:
    """Whether a phrase is all of its clause: ", to the knee,"."""
    return re.match(r"\s*(?:$|[,;.:\n)!?]|(?:and|but|or|please|with)(?!\w))", text[said.end() :]) is not None


def _subject(words: WordReading, start: int) -> WordMark | None:
    """The last word before a place that may be what ends there."""
    before = [m for m in words.marks if m.end <= start]
    passed = (m for m in reversed(before) if not (m.entries and m.entries[0].category in _PASSED_OVER))
    return next(passed, None)


def _is_garment(mark: WordMark) -> bool:
    return mark.role == "garment" and not mark.denied


def _is_denied(words: WordReading, start: int, end: int) -> bool:
    """Whether a phrase is refused, or stands where the lexicon has read a comparison."""
    return any(m.denied and m.start < end and start < m.end for m in words.marks)

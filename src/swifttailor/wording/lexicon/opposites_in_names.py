"""Names of garments that other words of a text speak against: "a pleated skirt without any pleats"."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from swifttailor.describing.claims import Claim
from swifttailor.wording.lexicon.opposed_words import opposed_pairs

if TYPE_CHECKING:
    from swifttailor.wording.lexicon.reading import Implication, WordMark

_MADE_WITH = {
    name: (
        re.compile(rf"(?<![\w]){before}(?![\w])", re.IGNORECASE),
        re.compile(rf"^(?:(?:no|without)(?: an?| any)? )?{noun}$", re.IGNORECASE),
    )
    for name, before, noun in (
        ("pleats", "pleated", r"(?:knife |box )?pleat(?:s|ing)?"),
        ("gathers", "gathered", r"gather(?:s|ing)?|fullness"),
        ("tiers", "tiered", r"tiers?"),
        ("ruffles", r"ruffled|ruffle", r"ruffles?"),
        ("frills", r"frilled|frilly", r"frills?"),
        ("belt", "belted", r"belts?"),
        ("buttons", r"buttoned|button[- ](?:down|up|through|front)", r"buttons?"),
        ("fringes", "fringed", r"fring(?:es?|ing)"),
        ("straps", r"strappy|strapped", r"straps?"),
        ("slit", "slit", r"slits?"),
        ("zip", r"zip(?:ped)?(?:[- ](?:up|through|front))?", r"zip(?:per)?s?"),
    )
}
"""How a garment is named that has something, and what that is called by itself."""
_REFUSED = re.compile(r"(?:no|without) ", re.IGNORECASE)
_WITHOUT = re.compile(r"(?<!\w)(?P<part>pocket|button|zip|belt)less(?!\w)", re.IGNORECASE)
_CLOSED_NECK = re.compile(r"turtle ?neck|polo[- ]?neck|roll[- ]?neck|mock[- ]neck|funnel", re.IGNORECASE)
_OPEN_NECK = re.compile(r"^(?:deep |low )?(?:v|square|scoop|boat)[- ]?neck|^plunging", re.IGNORECASE)
_LAYERS = re.compile(r"(?<!\w)(?:under\w*|over|beneath|or|and|with)(?!\w)", re.IGNORECASE)
_SHORT = re.compile(r"(?<!\w)crop(?:ped)?(?!\w)", re.IGNORECASE)
_LONG = re.compile(r"(?<!\w)long[- ]?line", re.IGNORECASE)
_OF_A_PLACE = re.compile(
    r"\s*(?:,\s*)?(?:at|in|on|around|round|over|near|below|above|behind)(?!\w)", re.IGNORECASE
)
"""Behind what is refused: of one place alone, "no pleats at the back"."""
_NARROW = re.compile(r"^(?:(?:very|really) )?(?:narrow|tight|slim|skinny|skin[- ]tight)$", re.IGNORECASE)
_JOINED = re.compile(r",?\s*(?:but|and|yet)?\s*(?:very|really|quite)?\s*", re.IGNORECASE)
_WIDE = re.compile(r"wide|wider|flared|loose|full", re.IGNORECASE)
_AT_THE_FEET = re.compile(
    r"\s*(?:at|towards?|around|near|from) (?:the )?(?:bottoms?|hems?|foot|feet|ankles?|ends?|knees?)(?!\w)",
    re.IGNORECASE,
)
_HUGGING = re.compile(
    r"^(?:(?:very|really) )?(?:hugging|skin[- ]?tight|(?:skin|body|figure)[- ]hugging|clingy|clinging|snug"
    r"|bodycon|fitted|(?:close|tight|form)[- ]fitting)$",
    re.IGNORECASE,
)
_TENTS = re.compile(
    r"(?<!\w)(?:tent|trapeze|trap[eè]ze|sack|muumuu|muu muu|poncho|swing)(?!\w)", re.IGNORECASE
)
"""Names of what stands off the body all around."""
_TOPS = frozenset({"top", "tunic"})
_BELOW = re.compile(
    r"(?<!\w)(?:(?:down )?to|reach(?:es|ing)?|touch(?:es|ing)?|(?:just )?(?:at|below|past|over|above)"
    r"|cover(?:s|ing)?)(?: the| my| her| his)? "
    r"(?P<end>knees?|cal(?:f|ves)|shins?|ankles?|floor|ground|feet)(?!\w)",
    re.IGNORECASE,
)
_LONG_HEM = re.compile(r"knee|calf|shin|ankle|floor|maxi|midi", re.IGNORECASE)
_MINI = re.compile(r"^(?:micro[- ]?)?mini$", re.IGNORECASE)
_TO_ANKLES = re.compile(r"(?:down )?to the ankles?", re.IGNORECASE)
_NO_BEFORE = re.compile(r"(?<!\w)(?:no|without)(?: an?| any)?\s+$", re.IGNORECASE)
_NECKLINE = re.compile(r"neck(?:line)?", re.IGNORECASE)
_WIDE_LEGS = re.compile(r"(?<!\w)(?:baggy|loose|oversized|wide)(?!\w)", re.IGNORECASE)
_WIDE_SKIRTS = frozenset(
    {
        Claim("skirt", value)
        for value in (
            "flared",
            "gathered",
            "circle",
            "half circle",
            "three-quarter circle",
            "more than a circle",
        )
    }
)
_CLOSE = frozenset({Claim("hips", "close"), Claim("legs", "slim"), Claim("fit", "close")})
_BETWEEN = frozenset({"degrees", "colors", "shades", "prints", "fabrics", "lengths", "fits", "function"})
"""What may stand between an adjective and the name that it belongs to."""
_STRAIGHT = frozenset({"straight", "straight leg", "straight-leg", "straight legs"})
_BORROWED = re.compile(r"(?:boyfriend|girlfriend|mom|mum|dad)s? ", re.IGNORECASE)
_SHORTS = Claim("kind", "shorts")
_TO_THE_FLOOR = re.compile(r"(?:floor|full)[- ]length", re.IGNORECASE)
_TO_THE_FEET = re.compile(r"ankle|floor|full[- ]length", re.IGNORECASE)


def contradicting_pairs(
    text: str, marks: Sequence[WordMark], implied: Sequence[Implication]
) -> list[tuple[WordMark, WordMark]]:
    """Pairs of words that cannot both be true of one garment, or of which one speaks against its name.

    Args:
        text: That was read.
        marks: Its words.
        implied: What follows from them.
    """
    pairs = [
        pair
        for pair in opposed_pairs(text, implied)
        if not _straight_by_name(*pair) and not _widens(text, pair)
    ]
    found = {frozenset({first.start, second.start}): (first, second) for first, second in pairs}
    for first, second in _against_names(text, marks, implied):
        found.setdefault(frozenset({first.start, second.start}), (first, second))
    return list(found.values())


def closeness_given_up(pairs: Sequence[tuple[WordMark, WordMark]]) -> list[WordMark]:
    """Words that say that something is close which stands off by its name.

    Args:
        pairs: Of words that cannot both be true.
    """
    return [
        one
        for pair in pairs
        for one, other in (pair, pair[::-1])
        if other.role == "garment" and _TENTS.search(other.word) and one.role == "word"
    ]


def without_closeness(
    implied: Sequence[Implication], pairs: Sequence[tuple[WordMark, WordMark]]
) -> list[Implication]:
    """What follows from a text, without closeness of what stands off by its name: a tent dress is one.

    Args:
        implied: What follows from its words.
        pairs: Of these, those that cannot both be true.
    """
    given_up = [id(mark) for mark in closeness_given_up(pairs)]
    return [i for i in implied if id(i.mark) not in given_up]


def _widens(text: str, pair: tuple[WordMark, WordMark]) -> bool:
    """Whether legs are slim and said to be wide at their ends: "slim but wide at the bottom"."""
    wide = [m for m in pair if _WIDE.fullmatch(m.word) and _AT_THE_FEET.match(text[m.end :])]
    return len(wide) == 1 and any(_NARROW.match(mark.word) for mark in pair)


def _straight_by_name(one: WordMark, other: WordMark) -> bool:
    """Whether legs are said to be straight of jeans that are borrowed ones: some are, and some taper."""
    words = {one.word.lower(), other.word.lower()}
    return bool(words & _STRAIGHT) and any(_BORROWED.match(word) for word in words)


def _against_names(
    text: str, marks: Sequence[WordMark], implied: Sequence[Implication]
) -> list[tuple[WordMark, WordMark]]:
    names = [mark for mark in marks if mark.role == "garment" and not mark.denied]
    made = [m for m in marks if not m.denied and (m in names or m.word.lower().endswith("ed"))]
    pairs = [*_refused(text, marks, made), *_narrow_and_wide(text, marks, names, implied)]
    shorts = [i.mark for i in implied if i.claim == _SHORTS and not i.said]
    shorts += [mark for mark in names if _SHORT.search(mark.word)]
    long = [m for m in marks if not m.denied and _category(m) == "lengths" and _TO_THE_FEET.search(m.word)]
    pairs += [*_cropped_and_long(text, marks, names), *_no_neckline(text, marks), *_long_minis(marks, names)]
    pairs += _by_their_words(text, [mark for mark in marks if not mark.denied])
    pairs += [(mark, name) for name in shorts for mark in long if _adjoins(text, marks, mark, name)]
    return pairs


def _refused(
    text: str, marks: Sequence[WordMark], names: Sequence[WordMark]
) -> list[tuple[WordMark, WordMark]]:
    """What a garment is named after and is refused besides."""
    return [
        (name, mark)
        for named, alone in _MADE_WITH.values()
        for name in names
        if named.search(name.word)
        for mark in marks
        if (mark.denied or _REFUSED.match(mark.word)) and alone.match(mark.word)
        if not _OF_A_PLACE.match(text[mark.end :])
    ]


def _cropped_and_long(
    text: str, marks: Sequence[WordMark], names: Sequence[WordMark]
) -> list[tuple[WordMark, WordMark]]:
    """A crop top that is to reach the knees, where nothing else is named that may be so long."""
    if not names or any(_category(m) == "garments" and not _kinds(m) <= _TOPS for m in marks):
        return []
    ends = [found.start("end") for found in _BELOW.finditer(text)]
    cropped = [m for m in marks if not m.denied and m not in names and m.word.lower() in ("crop", "cropped")]
    long = [
        m
        for m in marks
        if not m.denied
        and (
            (_category(m) == "lengths" and _LONG_HEM.search(m.word))
            or any(m.start <= e < m.end for e in ends)
        )
    ]
    return [
        (name, mark) if name.start < mark.start else (mark, name)
        for name in [*[name for name in names if _SHORT.search(name.word)], *cropped][:1]
        for mark in long[:1]
    ]


def _long_minis(marks: Sequence[WordMark], names: Sequence[WordMark]) -> list[tuple[WordMark, WordMark]]:
    """A mini that is to be longer, and shorts that are to reach the ankles."""
    lengths = [m for m in marks if not m.denied and _category(m) == "lengths"]
    return [
        (name, mark) if name.start < mark.start else (mark, name)
        for name in names
        for mark in lengths
        if (_MINI.search(name.word) and _LONG_HEM.search(mark.word))
        or (_kinds(name) == {"shorts"} and _TO_ANKLES.fullmatch(mark.word))
    ]


def _no_neckline(text: str, marks: Sequence[WordMark]) -> list[tuple[WordMark, WordMark]]:
    """A V neck that is to have no neckline."""
    none = [
        m for m in marks if m.denied and _NECKLINE.fullmatch(m.word) and _NO_BEFORE.search(text[: m.start])
    ]
    named = [
        m
        for m in marks
        if none and not m.denied and any(c.name == "neckline" for e in m.entries for c in e.claims("certain"))
    ]
    return [(name, mark) for name in named[:1] for mark in none[:1]]


def _by_their_words(text: str, marks: Sequence[WordMark]) -> list[tuple[WordMark, WordMark]]:
    """Words that speak against each other as they stand: "pocketless", "pockets"."""
    found = []
    for one in marks:
        if (without := _WITHOUT.search(one.word)) is not None:
            against = re.compile(rf"(?<!\w){without['part']}(?:s|ed)?$", re.IGNORECASE)
        elif _CLOSED_NECK.search(one.word):
            against = _OPEN_NECK
        elif _SHORT.search(one.word):
            against = _LONG
        else:
            continue
        for other in marks:
            between = text[min(one.end, other.end) : max(one.start, other.start)]
            if against is _LONG and between == " " and _TO_THE_FLOOR.match(other.word):
                found.append((one, other) if one.start < other.start else (other, one))
            elif against.search(other.word) and (without is not None or not _LAYERS.search(between)):
                found.append((one, other) if one.start < other.start else (other, one))
    return found


def _narrow_and_wide(
    text: str, marks: Sequence[WordMark], names: Sequence[WordMark], implied: Sequence[Implication]
) -> list[tuple[WordMark, WordMark]]:
    """A narrow full skirt, tight baggy trousers: narrow itself, and not at the waist."""
    close = [i.mark for i in implied if i.claim in _CLOSE and i.said]
    narrow = [mark for mark in close if _NARROW.match(mark.word)]
    hugging = [mark for mark in close if mark in narrow or _HUGGING.match(mark.word)]
    wide = {id(i.mark) for i in implied if i.claim in _WIDE_SKIRTS and i.certainty == "certain"}
    full = [i.mark for i in implied if i.claim in _WIDE_SKIRTS and i.said]
    joined = [
        (mark, other)
        for mark in dict.fromkeys(narrow)
        for other in dict.fromkeys(full)
        if _JOINED.fullmatch(text[mark.end : other.start]) and not _OF_A_PLACE.match(text[other.end :])
    ]
    joined += [
        (mark, name)
        for name in names
        if _TENTS.search(name.word)
        for mark in dict.fromkeys(hugging)
        if _adjoins(text, marks, mark, name)
    ]
    return joined + [
        (mark, name)
        for name in names
        if id(name) in wide or (_WIDE_LEGS.search(name.word) and "trousers" in _kinds(name))
        for mark in dict.fromkeys(narrow)
        if _adjoins(text, marks, mark, name)
    ]


def _adjoins(text: str, marks: Sequence[WordMark], mark: WordMark, name: WordMark) -> bool:
    """Whether an adjective stands before a name with nothing but other adjectives between."""
    between = [m for m in marks if mark.end <= m.start < name.start]
    plain = re.search(r"[^\w\s'’,-]", text[mark.end : name.start]) is None
    return mark.end <= name.start and plain and all(_category(m) in _BETWEEN for m in between)


def _kinds(mark: WordMark) -> frozenset[str]:
    return frozenset().union(*[entry.kinds for entry in mark.entries])


def _category(mark: WordMark) -> str | None:
    return mark.entries[0].category if mark.entries else None

"""One garment over another on the same part of the body: a jacket over a dress, a T-shirt under dungarees.

Which is on top is said ("over", "under", "over it"), or follows from what they are: coats go over dresses.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from swifttailor.wishes.outfits.outfit_chunks import Chunk
from swifttailor.wishes.outfits.outfit_halves import Half, half_named
from swifttailor.wishes.outfits.outfit_pieces import (
    Piece,
    Pieces,
    are_asked_for,
    is_alone,
    is_in_one,
    lead,
    may_lead,
)
from swifttailor.wording.lexicon import WordMark, WordReading

_ON_TOP, _OUTER, _WARM, _PLAIN, _BENEATH = 4, 3, 2, 1, 0
_RANKS = (
    (
        _ON_TOP,
        r"coat|coatigan|cape|capelet|cloak|poncho|ruana|parka|trench|mac|mackintosh|duster|puffer|anorak|shawl"
        r"|raincoat|windbreaker|cagoule",
    ),
    (
        _OUTER,
        r"jacket|blazer|bolero|bomber|blouson|gilet|body ?warmer|cardigan|cardi|shrug|waistcoat|kimono|robe"
        r"|dressing gown|housecoat|bathrobe|zip hoodie|haori|tabard|overshirt|shacket|jerkin|peignoir",
    ),
    (
        _WARM,
        r"jumper|sweater|pullover|hoodie|sweatshirt|fleece|dungarees|overalls|pinafore|pinafore dress"
        r"|slipover|sweater vest|knitted vest|gymslip|corset|bustier|apron dress",
    ),
    (
        _BENEATH,
        r"t ?shirt|tee|shirt|blouse|camisole|cami|turtleneck|polo neck|polo shirt|bodysuit|vest|vest top"
        r"|tank top|slip|bralet|nightie|nightdress|negligee|top|long sleeve top|leggings|petticoat",
    ),
)
"""How far out a garment is worn, by the end of its English name."""
_HEADS = tuple([(rank, re.compile(rf"(?:^|.*[ -])(?:{names})s?$")) for rank, names in _RANKS])
_OVER = re.compile(r"(?<!\w)(?:over|über|sur|sobre|sopra)(?!\w)", re.IGNORECASE)
_UNDER = re.compile(r"(?<!\w)(?:under|unter|sous|bajo|sotto|onder|sob)(?!\w)", re.IGNORECASE)
_BETWEEN = re.compile(
    r"(?<!\w)(?:between|cross|mix|mixture|hybrid|crossover|combination|halfway|half and half|part of"
    r"|turned into|made into|or|either|layer)(?!\w)",
    re.IGNORECASE,
)
"""What says that the two names are one garment, or a choice."""
_FITS = re.compile(
    r"(?<!\w)(?:tight|fitted|close|snug|loose|plain|narrow|slim|clingy|simple|strapless|sleeveless|fits?|shaped|neat)"
    r"(?:er)?\s*$",
    re.IGNORECASE,
)
"""Before "on top": how the upper part of one garment is."""
_LIKENED = re.compile(
    r"(?<!\w)(?:(?<!would )(?<!['’]d )(?<!(?:really|rather) )(?<!also )(?<!\bi )(?<!\bwe )(?<!\bshe )like"
    r"|similar to|just as|the same as) (?:an? |the |my |his |her |those |one of those )(?:[\w-]+ ){0,2}$",
    re.IGNORECASE,
)
"""What says that a garment is like another: "a long coat, like a dressing gown"."""
_WORN = r"(?:worn|layered|thrown|wear|to wear|to go|to put|to throw|that goes|which goes|on|going|all)"
_IT = r"(?: (?:of )?(?:it|the top|top|that|this|them|everything|the dress|the top of it))?"
_END = r"(?=\s*(?:[,.;!)]|$|(?:in|and|with|made|of)(?!\w)))"
_OVER_IT = re.compile(
    rf",?\s*(?<!\w)(?:{_WORN} )*(?:over(?: (?:of )?(?:it|the top|top|that|this|them|everything))"
    rf"|on (?:the )?top(?: of (?:it|that|this|them))?){_END}",
    re.IGNORECASE,
)
_UNDER_IT = re.compile(
    rf",?\s*(?<!\w)(?:{_WORN} )*(?:underneath|beneath|under)(?: (?:it|that|this|them))?{_END}", re.IGNORECASE
)
_NECK = r"(?<!\w)((?:turtle|roll|polo)[ -]?neck)"
_WORDS = (
    (re.compile(r"(?<!\w)on top of(?=\s+\w)", re.IGNORECASE), "over"),
    (
        re.compile(r"(?<!\w)(?:underneath|beneath)(?=\s+(?!it|that|this|them|and|with|in)\w)", re.IGNORECASE),
        "under",
    ),
    (re.compile(r"(?<!be )(?<!\w)(?:worn|layered) (?=(?:over|under)\s+(?!it(?!\w))\w)", re.IGNORECASE), ""),
    (
        re.compile(r"(?<=\w )(over|under) (?=shirts?(?!\w)|coats?(?!\w)|garments?(?!\w)|dress(?!\w))", re.I),
        r"\1 a ",
    ),
    (
        re.compile(rf"{_NECK}(?=\s+(?:under|underneath|beneath)(?!\w))", re.IGNORECASE),
        r"\1 top",
    ),
    (
        re.compile(rf"(?<=\w )((?:over|under) (?:\w+ ){{0,4}}?){_NECK}(?=\s*(?:[,.;!)]|$|and(?!\w)))", re.I),
        r"\1\2 top",
    ),
)
"""Other words for over and under; and what would be read otherwise: "jumper over shirt", a roll neck."""


def said_plainly(text: str) -> str:
    """A text whose words for over and under are these.

    Args:
        text: In any case.
    """
    for pattern, put in _WORDS:
        text = pattern.sub(put, text)
    return text


def without_places(text: str) -> str:
    """What a text says of one garment, without where it is worn: "a jacket over it"."""
    return _UNDER_IT.sub("", _OVER_IT.sub("", text))


def layered_pieces(text: str, words: WordReading, chunks: Sequence[Chunk]) -> Pieces | None:
    """Two garments of which one is worn over the other; None where a text names no two such.

    Args:
        text: That was read.
        words: Of it.
        chunks: Of it.

    Returns:
        As ``upper`` that which is on top, as ``lower`` that which is beneath.
    """
    names = [mark for mark in words.marks if _is_name(mark, words.marks)]
    names = [mark for mark in names if not _LIKENED.search(text[: mark.start])]
    if len(names) < 2 or is_in_one(text) or _BETWEEN.search(text):
        return None
    first = names[0]
    for other in names[1:]:
        on_top = _on_top(text, first, other, chunks)
        if on_top is None:
            continue
        beneath = other if on_top is first else first
        halves: dict[Half, Piece] = {"upper": Piece(on_top, None), "lower": Piece(beneath, None)}
        named: list[tuple[WordMark, Half]] = []
        for mark in names:
            if mark in (on_top, beneath):
                named.append((mark, "upper" if mark is on_top else "lower"))
        pieces = Pieces(tuple(named), (), halves, layered=True)
        if are_asked_for(text, pieces, chunks):
            rest = [m for m in names if m not in (first, other) and _is_joined(m, chunks)]
            return Pieces(tuple(named), (), halves, tuple(rest), layered=True)
    return None


def rank_of(mark: WordMark) -> int:
    """How far out a garment is worn: more is further."""
    for name in [entry.english or mark.word for entry in mark.entries]:
        for rank, head in _HEADS:
            if head.match(name.lower().replace("-", " ")):
                return rank
    return _PLAIN


def _on_top(text: str, first: WordMark, other: WordMark, chunks: Sequence[Chunk]) -> WordMark | None:
    """The outer one of two garments; None where they are not worn together."""
    chunk = next(one for one in chunks if one.has(other))
    if chunk.has(first) or not chunk.joined:
        return None
    joined = text[chunk.start : other.start]
    behind = text[other.end :]
    halves = half_named(first), half_named(other)
    if _OVER.search(joined):
        return first
    if _UNDER.search(joined):
        return other
    ranks = rank_of(first), rank_of(other)
    over = _OVER_IT.search(behind)
    if over is not None and not _FITS.search(behind, 0, over.start()) and ranks[1] >= _BENEATH:
        return other
    if _UNDER_IT.search(behind):  # shorts beneath are sewn in
        return first if halves[1] != "lower" else None
    if max(ranks) < _OUTER and set(ranks) != {_WARM, _BENEATH}:
        return None
    is_part = max(ranks) < _OUTER and re.match(r"\S*(?: \S+)? top(?!\w)", text[other.start :], re.I)
    if "lower" in halves or ranks[0] == ranks[1] or is_part:  # "dungarees with a T-shirt top"
        return None
    return first if ranks[0] > ranks[1] else other


def _is_joined(mark: WordMark, chunks: Sequence[Chunk]) -> bool:
    chunk = next(one for one in chunks if one.has(mark))
    return chunk.joined and all(map(may_lead, lead(mark, chunk)))


def _is_name(mark: WordMark, marks: Sequence[WordMark]) -> bool:
    garment = mark.entries and mark.entries[0].category == "garments" and mark.role not in ("word", "astray")
    return bool(garment) and not mark.denied and is_alone(mark, marks)

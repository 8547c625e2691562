"""Numbers of a text with the measures that they are said of: "inside leg 78", "an 8 cm cuff", "five gores".

Rules and a table, no network. Ranges count as their middle, "at least" as a tenth more, and what stands in
relation to the body ("two inches above the knee") as the length that leads there.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from pathlib import Path

from swifttailor.describing.claims import CLAIM_TYPES, Claim
from swifttailor.describing.differences import Change, Gain
from swifttailor.inches import CM_PER_INCH
from swifttailor.wishes.text.flat_widths import all_around
from swifttailor.wishes.text.from_the_body import said_from_the_body
from swifttailor.wishes.text.mentions import Mention, find_mentions
from swifttailor.wishes.text.spoken_depths import spoken_depth
from swifttailor.wishes.text.tier_heights import listed_tiers
from swifttailor.wording.word_tables import read_table

_TABLE = Path(__file__).with_name("measure_words.txt")
_RANGE = re.compile(r"\s*(?:to|-|–|or|bis|à|a|and|tot|até)\s*", re.IGNORECASE)
_BETWEEN = re.compile(r"between\s*$", re.IGNORECASE)
_CLAUSE = re.compile(
    r"[;:\n]|\.(?=\s|$)|,(?!\d)|(?<!\w)(?:and|with|und|mit|et|avec|y|con|met|com)(?!\w)", re.IGNORECASE
)
_RELATIVE = re.compile(
    r"\s*(?:above|over|below|under|past|from|off|higher|lower|longer|shorter)(?!\w)", re.IGNORECASE
)
_OFF = re.compile(r"\s*(?:off|more|less|extra|plus|minus)(?!\w)", re.IGNORECASE)
_CROTCH_CM = 32.0
"""How far below the waist its crotch is."""
_OUTSEAM = "outseam_cm"
"""In the table what trousers measure on the outside, from the waist to the end of the legs."""
_LEAST, _MOST = 1.1, 0.95
_INCHES_BELOW = 40.0
"""An inseam of a smaller number without unit is in inches."""
_AT_ONCE = -20
"""What stands right before a number comes first: a "sleeve 25 cm long from the shoulder"."""
_OF_ENDS = ("sleeve_cm", "cuff_cm", "collar_cm")
_DETAILS = ("slit_cm", "cuff_cm", "waistband_cm")
"""What a number at the beginning of an item is of, though a word stands between: "15 cm back vent"."""
_NUMBERED = re.compile(r"(?<!\w)(?:\d+|two|three|four|five|six|zwei|drei|vier|deux|trois|dos|tres) $")
"""Before what is counted already: "three tiers: 20, 25, 30"."""
_ACROSS = re.compile(
    r"\s*(?:across|wide|in width|breit|de large|de ancho|breed|di larghezza|de largura)(?!\w)"
)
_INCHES = re.compile(
    r"[\"\u201d\u2033]|(?<!\w)(?:half|quarter|third).*inch|in(?:s|ch(?:es)?)?$", re.IGNORECASE
)
_INCHES_OF_LENGTHS: Mapping[str, float] = {"length_cm": 38.0, "skirt_length_cm": 31.0}
"""Smaller numbers without a unit are in inches: "T-shirt, length 28"."""
_SMALL = ("cuff_cm", "waistband_cm", "collar_cm", "leg_cuff_cm", "neck_depth_cm", "back_depth_cm")
"""Numbers below 12 without a unit are theirs where they stand beside their names: "cuff 7"."""
_SAYING, _ROUGHLY = (
    re.compile(r"[^\W\d_]{3,}"),
    re.compile(r"(?<!\w)(?:between|and|about|around|roughly)(?!\w)"),
)
_NEAR = 26
"""Characters between a number and what it is said of."""
_BOUNDS = {
    "collar_cm": (1, 30),
    "cuff_cm": (1, 40),
    "sleeve_cm": (4, 90),
    "inseam_cm": (2, 110),
    "hem_cm": (40, 1500),
    "waistband_cm": (1, 25),
    "length_cm": (22, 400),
    "skirt_length_cm": (15, 400),
}
_USUAL = (1.0, 400.0)
_LONGEST = {"skirt_length_cm": 130.0, "length_cm": 170.0}
_HEM = re.compile(r"(?<!\w)(?:hem|hemline|sweep|saum|ourlet|bajo|orlo|zoom|bainha)(?!\w)", re.IGNORECASE)
_JUST_LONG = re.compile(r"[\d.,]+ ?\S+ (?:long|in length|lang|longue?|de long|de largo|lung[ao])")
_LOWER = frozenset({"skirt", "trousers", "shorts"})


@dataclass(frozen=True)
class SpokenMeasure:
    """A number of a text, and what it says."""

    mention: Mention
    claim: Claim | None
    """None where it is a measure that is not made."""
    words: tuple[int, int] = (0, 0)
    """From where to where the words stand that say what it is of."""


def can_measure(change: Change) -> bool:
    """Whether a garment can have such a measure: no sleeve is two metres long, as lengths of cloth are."""
    if not isinstance(change, Gain) or isinstance(change.claim.value, str):
        return True
    least, most = _BOUNDS.get(change.claim.name, (0.0, float("inf")))
    return least <= float(change.claim.value) <= most


def spoken_measures(text: str, kind: str | None) -> list[SpokenMeasure]:
    """Measures that a text states.

    Args:
        text: In one of the languages that are read.
        kind: Of the garment, where that is known.
    """
    small = text.lower()
    numbers = _with_ranges(small, find_mentions(text))
    found: list[SpokenMeasure] = []
    corrected = [m.end() for m in _words("corrections").finditer(re.sub(r"[^\w\s]", " ", small))]
    heights, (first, last_tier) = listed_tiers(small)
    if heights:
        found += _of_tiers(heights, [m for m in numbers if first <= m.start < last_tier], kind)
    inches = _all_in_inches(text, numbers)
    for k, mention in enumerate(numbers):
        if heights and first <= mention.start < last_tier:
            continue
        count = _count(small, mention)
        if count is not None:
            found.append(count)
            continue
        ends, told = said_from_the_body(small, mention, kind)
        if told:
            found.append(SpokenMeasure(mention, ends))
            continue
        if _OFF.match(small, mention.end):
            continue
        depth = None if kind in _LOWER else spoken_depth(small, mention)
        if depth is not None:
            found.append(SpokenMeasure(mention, depth))
            continue
        start, end = _bounds(small, mention, numbers, k)
        said = _said_of(small, mention, (start, end), kind, inches=inches)
        if said is not None:
            found.append(said)
    last = max(corrected, default=0)
    behind = [f for f in found if f.mention.start >= last and f.claim is not None]
    if last and behind:
        found = [f if f.mention.start >= last else SpokenMeasure(f.mention, None) for f in found]
    return found


def _of_tiers(heights: Sequence[float], numbers: Sequence[Mention], kind: str | None) -> list[SpokenMeasure]:
    """What a list of heights of tiers says: how many there are and how long a skirt is."""
    claims: list[Claim | None] = [Claim("tiers", float(len(heights)))]
    claims += [Claim("skirt_length_cm", round(sum(heights), 1))] if kind in ("skirt", None) else [None]
    claims += [None] * len(numbers)
    return [SpokenMeasure(m, claim) for m, claim in zip(numbers, claims, strict=False)]


def _all_in_inches(text: str, numbers: Sequence[Mention]) -> bool:
    """Whether all numbers with a unit are in inches: then so are those without one."""
    said = [text[m.start : m.end] for m in numbers if m.is_length]
    return bool(said) and all(_INCHES.search(one) for one in said)


def _with_ranges(text: str, mentions: Sequence[Mention]) -> list[Mention]:
    """Mentions, those that form a range joined to their middle."""
    found: list[Mention] = []
    for mention in mentions:
        if found:
            before = found[-1]
            gap = text[before.end : mention.start]
            joins = _RANGE.fullmatch(gap) is not None and (
                "and" not in gap or _BETWEEN.search(text[: before.start])
            )
            if joins and (mention.is_length or not before.is_length):
                low = before.value
                if mention.is_length and not before.is_length:
                    plain = _plain(text[mention.start : mention.end])
                    low *= mention.value / plain if plain else 1.0
                if 0 < low < mention.value:
                    found[-1] = Mention(
                        before.start, mention.end, (low + mention.value) / 2, mention.is_length
                    )
                    continue
        found.append(mention)
    return found


def _plain(said: str) -> float:
    """The number of a mention without its unit."""
    bare = re.sub(r"[^\d.,/ ]+$", "", said).strip()
    inner = find_mentions(bare) or find_mentions(said.split()[0])
    return inner[0].value if inner else 0.0


def _count(text: str, mention: Mention) -> SpokenMeasure | None:
    """A number of pieces; of what is counted and not made so, the number is nothing else's."""
    if mention.is_length:
        return None
    behind = re.match(r"[\s-]*", text[mention.end :])
    assert behind is not None
    place = mention.end + behind.end()
    for claim, pattern in _counts():
        after = pattern.match(text, place)
        before = re.search(rf"(?:{pattern.pattern})\s*[,:]?\s*$", text[: mention.start])
        before = None if before and _NUMBERED.search(text, 0, before.start()) else before
        if (after or before) and 1 < mention.value <= 40 and mention.value == int(mention.value):
            return SpokenMeasure(mention, None if claim == "none" else Claim(claim, mention.value))
    return None


def _bounds(text: str, mention: Mention, numbers: Sequence[Mention], k: int) -> tuple[int, int]:
    """The stretch of text in which the word for a number stands."""
    start = numbers[k - 1].end if k else 0
    end = numbers[k + 1].start if k + 1 < len(numbers) else len(text)
    for joint in _CLAUSE.finditer(text, start, mention.start):
        if mention.start - joint.end() > 3 or joint[0] in ".;\n" or joint[0].strip().isalpha():
            start = joint.end()
    joint = _CLAUSE.search(text, mention.end, end)
    return start, joint.start() if joint else end


def _said_of(
    text: str, mention: Mention, bounds: tuple[int, int], kind: str | None, *, inches: bool
) -> SpokenMeasure | None:
    start, end = bounds
    comma = text.rfind(", ", start, mention.start)
    begins = comma >= 0 and not text[comma + 1 : mention.start].strip()
    near: list[tuple[int, str, int, tuple[int, int]]] = []
    its_own: list[tuple[int, str, int, tuple[int, int]]] = []
    for rank, (claim, kinds, pattern) in enumerate(_measures()):
        if kinds and kind not in kinds:
            continue
        if not kinds and kind in _LOWER and claim in ("sleeve_cm", "cuff_cm", "collar_cm"):
            continue
        for match in pattern.finditer(text, start, end):
            gap = match.start() - mention.end if match.start() >= mention.end else mention.start - match.end()
            if 0 <= gap <= _NEAR:
                behind = match.start() >= mention.end
                words = len(text[mention.end : match.start()].split()) if behind else 0
                at_once = _AT_ONCE if claim in _OF_ENDS and not behind and gap <= 1 else 0
                weight = gap - len(match[0]) + (3 * words if behind else at_once)
                near.append((weight, claim, rank, match.span()))
                if begins and behind and (words <= 1 if claim in _DETAILS else not words and claim != "none"):
                    its_own.append(near[-1])
    near = its_own or near  # "knee length, 15 cm slit behind" says nothing more of the length
    piece = text[start if comma < 0 else comma + 1 : end].strip(" .,!?")
    if comma >= 0 and piece == text[mention.start : mention.end]:
        near = [one for one in near if one[1] != "none"]  # "fitted to the thigh, 75 cm" measures no thigh
    if comma >= 0 and _JUST_LONG.fullmatch(piece, piece.find(text[mention.start : mention.end])):
        near = [one for one in near if one[1] != "godet_cm"]  # "with six godets, 75 cm long"
    if not near:
        alone = mention.is_length and len(_SAYING.findall(_ROUGHLY.sub("", piece))) <= 2
        if alone and kind in ("skirt", "dress", "top", "tunic") and mention.value >= 20:
            if _RELATIVE.match(text, mention.end) is None:
                name = "skirt_length_cm" if kind == "skirt" else "length_cm"
                return SpokenMeasure(mention, Claim(name, _exact(text, mention)))
        most = _CROTCH_CM + _BOUNDS["inseam_cm"][1]  # beyond, it is the wearer's height
        if alone and kind in ("trousers", "shorts") and _CROTCH_CM < mention.value <= most:
            return SpokenMeasure(mention, Claim("inseam_cm", round(_exact(text, mention) - _CROTCH_CM, 2)))
        return None
    _, claim, _, words_of = min(near)
    across = claim in ("neck_depth_cm", "back_depth_cm") and _ACROSS.match(text, mention.end)
    if across or claim == "none":
        return SpokenMeasure(mention, None) if mention.is_length else None
    value = _exact(text, mention)
    if not mention.is_length and (inches or value < _INCHES_OF_LENGTHS.get(claim, 0.0)):
        value = round(value * CM_PER_INCH, 2)
        mention = replace(mention, value=value, is_length=True)
    if claim == _OUTSEAM:
        claim = "inseam_cm"
        if mention.is_length or value > _INCHES_BELOW:
            value = round(value - _CROTCH_CM, 2)
    if not mention.is_length and claim == "inseam_cm" and value < _INCHES_BELOW and kind != "shorts":
        value = round(value * CM_PER_INCH, 2)
    value = all_around(claim, value, text[start:end])
    if claim in _LONGEST and value > _LONGEST[claim] and _HEM.search(text, start, end):
        claim = "hem_cm"  # no skirt is so long: "flare the hem to 320 cm"
    least, most = _BOUNDS.get(claim, _USUAL)
    beside = claim in _SMALL and -1 <= mention.start - words_of[1] <= 2
    if not least <= value <= most or (not mention.is_length and value < 12 and not beside):
        return None
    return SpokenMeasure(mention, Claim(claim, value), words_of)


def _exact(text: str, mention: Mention) -> float:
    before = text[max(0, mention.start - 16) : mention.start].rstrip()
    value = mention.value
    if _words("at_least", end=True).search(before):
        value *= _LEAST
    elif _words("at_most", end=True).search(before):
        value *= _MOST
    return round(value, 2)


@cache
def _measures() -> list[tuple[str, frozenset[str], re.Pattern[str]]]:
    found = []
    for row in read_table(_TABLE):
        if row.section != "measures":
            continue
        row.check_options("of")
        (claim,) = row.words
        if claim not in ("none", _OUTSEAM) and claim not in CLAIM_TYPES:
            row.wrong(f"there is no claim '{claim}'.")
        kinds = frozenset(row.options.get("of", ()))
        found.append((claim, kinds, _any_of(row.texts)))
    return found


@cache
def _counts() -> list[tuple[str, re.Pattern[str]]]:
    return [(row.words[0], _any_of(row.texts)) for row in read_table(_TABLE) if row.section == "counts"]


@lru_cache(maxsize=64)
def _words(section: str, *, end: bool = False) -> re.Pattern[str]:
    texts = [text for row in read_table(_TABLE) if row.section == section for text in row.texts]
    pattern = _any_of(texts)
    return re.compile(pattern.pattern + "$") if end else pattern


def _any_of(words: Sequence[str]) -> re.Pattern[str]:
    longest = sorted(map(re.escape, words), key=len, reverse=True)
    return re.compile(rf"(?<!\w)(?:{'|'.join(longest)})(?!\w)")


def same_number(measure: SpokenMeasure, value: object) -> bool:
    """Whether a number that something else read is the number of a measure."""
    return isinstance(value, float | int) and abs(measure.mention.value - value) < 0.05


def is_of_another(measure: SpokenMeasure, change: Change) -> bool:
    """Whether its number was read as that of something else: "slit in front, about 30 cm" is no length."""
    if not isinstance(change, Gain) or not change.claim.name.endswith("_cm") or measure.claim is None:
        return False
    return change.claim.name != measure.claim.name and same_number(measure, change.claim.value)

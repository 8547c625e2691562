"""What a text denies: "no sleeves", "not too short", "without a collar or a hood"."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from swifttailor.wording.lexicon.inflection import Language
from swifttailor.wording.lexicon.meanings import Meaning

_NEAR = 5
"""Words that may stand between a negation and what it denies."""
_OR = frozenset(["or", "nor", "oder", "noch", "ou", "ni", "o", "u"])
_ANY = frozenset(["any"])
"""Carries a denial on in a list: "no sleeves, any collar or any slit"."""
_AND = frozenset(["and", "&", "und", "et", "y", "e"])
_ALSO: Mapping[Language, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "it": (("né", "ne"), ("ed",)),
    "nl": (("of",), ("en",)),
    "pt": (("nem",), ()),
}
"""Words for "or" and "and" in one language, which mean something else in others."""
_WITHIN = ("no ", "without ")
"""How words of the tables begin that refuse something themselves."""
_LISTED = frozenset(["styles", "fits", "colors", "prints", "fabrics", "parts"])
_EXACT = frozenset(["mini", "midi", "maxi", "ankle", "knee", "calf"])
_GOES = frozenset("to with over under out in on from for anywhere straight dancing".split())
"""Behind "can go": where or with what a garment is worn."""
_NOES = frozenset(["no", "non", "nein", "nee", "não"])
"""What is said behind the name of what is not wanted."""
_ADJECTIVES = frozenset(
    ["styles", "fits", "lengths", "occasions", "colors", "shades", "prints", "fabrics", "sizes"]
)


class _Joints(NamedTuple):
    """Words that go on with a list."""

    ors: frozenset[str]
    ands: frozenset[str]


def denied_words(words: Sequence[Meaning], language: Language = "en") -> frozenset[int]:
    """Which words are denied, by their places. A negation ends with its phrase; "or" carries it on.

    Args:
        words: Of a text, in their order.
        language: Of the text.
    """
    ors, ands = _ALSO.get(language, ((), ()))
    joints = _Joints(_OR.union(ors), _AND.union(ands))
    found: set[int] = set()
    for k, word in enumerate(words):
        if word.category != "negations":
            if (
                word.found.word.startswith(_WITHIN)
                and (last := _goes_on_behind(words, k, joints)) is not None
            ):
                _deny_after(words, last, found, joints)
            continue
        if _is_answer(words, k):
            found.add(k - 1)
        elif word.entries[0].negates == "after":
            _deny_after(words, k, found, joints)
        else:
            before = _named_before(words, k)
            if before is not None and not _came_from(words, before, k):
                found.add(before)
    return frozenset(found)


def _goes_on_behind(words: Sequence[Meaning], k: int, joints: _Joints) -> int | None:
    """Behind which word a list goes on that begins with "no sleeves", a word of the tables; None without one.

    So it is in "no sleeves, collar or belt", and in "no collar or cuffs".
    """
    j = k + 1
    if j + 1 >= len(words) or words[k].found.gap == "stop":
        return None
    if words[j].found.word in joints.ors:
        return j if _is_listable(words[j + 1]) and not words[j + 1].found.word.startswith(_WITHIN) else None
    if words[k].found.gap != "pause":
        return None
    ends = _ends_with_or(words, j, joints)
    return k if ends and not words[k + 1].found.word.startswith(_WITHIN) else None


def _is_answer(words: Sequence[Meaning], k: int) -> bool:
    """Whether a negation answers what is named right before it: "sleeves yes, frills no"."""
    if words[k].found.word not in _NOES or k == 0 or words[k - 1].found.gap not in ("space", "hyphen"):
        return False
    ends = k + 1 == len(words) or words[k].found.gap in ("pause", "stop")
    return ends and not words[k - 1].holds_together and _can_be_had(words[k - 1])


def _named_before(words: Sequence[Meaning], k: int) -> int | None:
    """What stands before a negation such as "can go": the nearest word that is not an article or the like."""
    for j in range(k - 1, max(k - _NEAR, 0) - 1, -1):
        if words[j].found.gap in ("pause", "stop") or not words[j].entries:
            return None
        if not words[j].holds_together:
            return j
    return None


def _came_from(words: Sequence[Meaning], named: int, k: int) -> bool:
    """Whether "off" tells where a garment was seen: "that dress off the telly"; parts alone are taken off."""
    goes_on = k + 1 < len(words) and words[k].found.gap == "space"
    if goes_on and words[k].found.word == "can go" and words[k + 1].found.word in _GOES:
        return True  # "a jumpsuit you can go to work in"
    return words[k].found.word == "off" and goes_on and words[named].category in ("garments", "generic")


def _deny_after(words: Sequence[Meaning], k: int, found: set[int], joints: _Joints) -> None:
    """Denies the phrase behind a negation, and those that are listed with it."""
    start = _begin(words, k + 1, _NEAR, joints)
    first = True
    while start is not None:
        phrase = _phrase(words, start)
        named = phrase[0]
        bare = len(phrase) == 1 and (_can_be_had(words[named]) or _ends_with_or(words, named, joints))
        if (
            not first
            and not bare
            and words[start - 1].found.word not in joints.ors
            and words[start - 2].found.word not in joints.ors
        ):
            return
        found.update(_denied_of(words, phrase))
        behind = phrase[-1] + 1
        if behind >= len(words) or words[behind - 1].found.gap == "stop":
            return
        if words[behind].found.word in joints.ors or (
            words[behind].found.word in _ANY and words[behind - 1].found.gap == "pause"
        ):
            start = _begin(words, behind + 1, 2, joints)
        elif words[behind].found.word in joints.ands and bare:
            start = _listed(words, behind + 1)
        elif words[behind - 1].found.gap == "pause" and bare:
            start = _listed(words, behind)
            if start is not None and not _goes_on(words, start, joints):
                return
        else:
            return
        first = False


def _begin(words: Sequence[Meaning], k: int, near: int, joints: _Joints) -> int | None:
    """Where the phrase begins: behind articles and the like."""
    for j in range(k, min(k + near + 1, len(words))):
        if j > k - 1 and j > 0 and words[j - 1].found.gap == "stop":
            return None
        if words[j].category == "negations" or not words[j].entries:
            return None
        if words[j].category == "garments" and words[j - 1].found.gap == "pause":
            return None  # "nothing on top, a long dress" asks for the dress
        if j > k and words[j - 1].found.gap == "pause":
            return None  # "no budget, so a long skirt" asks for the skirt
        if j > k and words[j - 1].found.gap == "pause" and words[j].found.word in joints.ands:
            return None  # "not sad, and with sleeves" goes on to what is wanted
        if not words[j].holds_together:
            return j
    return None


def _listed(words: Sequence[Meaning], k: int) -> int | None:
    if k >= len(words) or words[k].holds_together or not words[k].entries:
        return None
    return k


def _goes_on(words: Sequence[Meaning], k: int, joints: _Joints) -> bool:
    """Whether a word is in the middle of a list: "ruffles, tiers and gathers"."""
    if _ends_with_or(words, k, joints):
        return True
    while k + 1 < len(words) and words[k].found.gap == "pause" and _can_be_had(words[k]):
        k += 1
    joined = joints.ors | joints.ands
    return k + 1 < len(words) and words[k].found.gap == "space" and words[k + 1].found.word in joined


def _phrase(words: Sequence[Meaning], start: int) -> list[int]:
    """Adjectives and their noun."""
    found = [start]
    while not words[found[-1]].is_noun and words[found[-1]].found.gap in ("space", "hyphen"):
        following = found[-1] + 1
        if following >= len(words):
            break
        word = words[following]
        if not (word.is_noun or word.category in _ADJECTIVES):
            break
        found.append(following)
    return found


def _denied_of(words: Sequence[Meaning], phrase: Sequence[int]) -> Sequence[int]:
    """Of "no wide straps", "wide" alone is denied; of "no straps", the straps."""
    if len(phrase) > 1 and words[phrase[-1]].category in ("garments", "parts", "generic"):
        return phrase[:-1]
    return phrase


def _ends_with_or(words: Sequence[Meaning], k: int, joints: _Joints) -> bool:
    """Whether a word is in a list of its like that ends with "or": "orange, brown or mustard".

    So it is in "skinny, flared or cropped", but not in "tight, midi or long", which tells what is wanted.
    """
    while k + 1 < len(words) and _is_listable(words[k]) and words[k].found.gap == "pause":
        k += 1
    ends = k + 2 < len(words) and _is_listable(words[k]) and words[k].found.gap == "space"
    return ends and words[k + 1].found.word in joints.ors and _is_listable(words[k + 2])


def _is_listable(word: Meaning) -> bool:
    """Whether a word may stand in a list of what is refused: no exact length may."""
    if word.category == "lengths":
        return " " not in word.found.word and word.found.word not in _EXACT
    return word.category in _LISTED


def _can_be_had(word: Meaning) -> bool:
    """Whether a word names something that a garment has or lacks, as "pockets" does."""
    if word.found.word.endswith("s") and word.category not in ("garments", "occasions"):
        return True
    return any(entry.cannot or entry.without or entry.category == "parts" for entry in word.entries)

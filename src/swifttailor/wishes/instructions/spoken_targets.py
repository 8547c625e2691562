"""Clauses of an instruction, and what the lexicon reads in them that an instruction can mean."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import lru_cache

from swifttailor.describing.claims import Claim
from swifttailor.wishes.instructions.change_words import target_words
from swifttailor.wishes.text.mentions import find_mentions
from swifttailor.wishes.text.unread import is_function_word
from swifttailor.wording.claim_kinds import fits_kind
from swifttailor.wording.lexicon import Implication, WordMark, WordReading
from swifttailor.wording.lexicon.inflection import Language

_JOINTS = (
    r"[.;:!?]+(?=\s|$)|\n+|,(?=\s)|\s[-+/]\s|\s(?:and(?! a half(?!\w))|but|then|und|aber|et|y|pero)\s"
    r"|\sso\s(?=it|that|can|could|i\b|she|he|they)|(?<=\bsame)\s(?:only|just|with)\s"
    r"|\s(?=(?:except|apart from|other than|save for|außer|bis auf|sauf|salvo|excepto"
    r"|tranne|behalve|exceto)\s)"
)
_ALSO_JOINTS: Mapping[Language, str] = {"it": "e|ed|ma", "nl": "en|maar", "pt": "e|mas"}
"""In one language only: "en" is no "and" in French and Spanish, and French "mais" is "more" in Portuguese."""
_WORD = re.compile(r"[^\W\d_]+(?:['’-][^\W\d_]+)*")
_SWAPPED = re.compile(
    r"(?<!\w)(?:swap|swop|exchange|trade|replace|switch|change|tausche?|ersetze?|remplacer?|cambia)\s+"
    r"(?P<old>(?:the|these|those|my|its|this|that|die|den|das|le|la|les|los|las)\s[^.;!?]+?)\s+(?:for|with|by|to|into|gegen|durch|par|por)(?!\w)"
    r"|(?<!\w)(?:sostituisci|vervang|troca|troque|substitua)\s+"
    r"(?P<swapped>(?:il|lo|la|i|gli|le|de|het|o|a|os|as)\s[^.;!?]+?)\s+(?:con|door|por)(?!\w)"
    r"|(?<!\w)(?:make|can|could|should|have|let)\s+"
    r"(?P<made>(?:the|these|those|my|its)\s[^.,;!?]+?)\s+(?:be\s+)?an?(?!\w)"
    r"(?!\s(?:(?:little|tiny|wee) )?(?:bit|little|lot|tad|touch|smidge\w*|shade|fraction|hair|notch|size"
    r"|couple|few|half|inch|cm|hand|finger|good|whole|full \w+ \w+er)(?!\w))"
    r"|(?<!\w)(?:turn|make|convert|transform)\s+(?P<turned>(?:(?:the|these|those|my|its)\s)?[^.,;!?]+?)\s+into(?!\w)"
    r"|(?<!\w)(?:instead of|in place of|rather than)\s+(?P<left>(?:the|these|those|my|its|an?)\s\w+(?: \w+)?)"
)
_LIKENESS = re.compile(r"(?<!\w)like (?:an? |the |some )?(?:\w+ )?$")
"""Before what a garment is to resemble and not to be: "baggy like a skater"."""
_IS_ONE = re.compile(
    r"(?<!\w)(?:this|it|that)(?:['’]?s| is| was| has become)(?: not|n['’]t)?"
    r"(?: (?:just|basically|really|still|more of|only|totally|such))? an? (?:\w+ )?$"
)
"""Before what is said to be there: "this is a sack"."""
_RATHER = re.compile(r",? (?:and )?(?:not|instead of|rather than|in place of) (?:an? |the )?(?P<old>[\w-]+)")
"""Behind what a garment is to become: "a dress, not a top"."""
_NAMES = {
    "top": ("top", "shirt", "blouse", "tee", "t-shirt", "jumper", "hoodie", "sweater"),
    "tunic": ("tunic", "top", "shirt"),
    "dress": ("dress", "gown", "frock"),
    "skirt": ("skirt",),
    "trousers": ("trousers", "pants", "jeans", "leggings"),
    "shorts": ("shorts",),
    "jumpsuit": ("jumpsuit", "romper", "overalls"),
    "playsuit": ("playsuit", "romper"),
}
_BESIDE_NUMBERS = frozenset(
    "long short wide high deep lang largo hoch tief lungo lunga lunghi lunghe comprido comprida longo "
    "longa".split()
)
_HALF_DONE = frozenset({"wrap"})
"""What cannot be made and goes with something that alone is no part of it: a V neck makes no wrap."""
_OF_A_PART = re.compile(
    r"(?<!\w)(?:skirt|trousers|pants|shorts|legs|bottom|bottoms|half|part|top|bodice|switch|change|swap|go)\s*$"
)
"""Before "to" or "into": a part of the garment is to become another, or something unsaid."""
_PARTS_OF = {"dress": ("skirt", "top"), "jumpsuit": ("trousers", "top"), "playsuit": ("shorts", "top")}


def meant(text: str, words: WordReading, kind: str) -> list[Implication]:
    """What the lexicon reads that an instruction can mean: details, and another kind of garment.

    Args:
        text: In lower case.
        words: By the lexicon.
        kind: Of the garment to change.
    """
    found = []
    for each in beside_no_numbers(text, words.implications):
        certain = each.certainty == "certain"
        unmade = any(entry.cannot for entry in each.mark.entries) and each.claim.name != "kind"
        if unmade and (not certain or any(_HALF_DONE.intersection(e.cannot) for e in each.mark.entries)):
            continue  # what goes with a detail that cannot be made is not asked for without it
        if each.said and each.certainty != "likely":
            peplum = each.claim.value == "peplum" and kind in ("top", "tunic")
            if fits_kind(each.claim.name, kind) or each.claim.name == "kind" or peplum:
                found.append(each)
        elif certain and not each.said and not _is_pointed_at(text, each.mark):
            found.append(each)
    found = [_short_legs(each, kind) for each in found]
    kinds = [
        i
        for i in found
        if i.claim.name != "kind" or _is_target(text, i.mark, str(i.claim.value), kind, words.language)
    ]
    if any(i.claim.name == "kind" for i in kinds):
        return kinds
    return [*kinds, *_after_arrow(text, words, kind)]


def beside_no_numbers(text: str, implied: Sequence[Implication]) -> list[Implication]:
    """Without what stands right behind a length: "60 cm long" says nothing but the number."""
    lengths = {m.end for m in find_mentions(text) if m.is_length}
    return [
        each
        for each in implied
        if len(text[: each.mark.start].rstrip(" -")) not in lengths
        or each.mark.word.lower() not in _BESIDE_NUMBERS
    ]


def given_away(text: str, implied: Sequence[Implication]) -> list[Implication]:
    """What is named only because it goes: the sleeves of "swap the long sleeves for short ones".

    Args:
        text: In lower case.
        implied: What the lexicon reads in the text.
    """
    spans = away(text)
    return [i for i in implied if any(a <= i.mark.start < b for a, b in spans)]


def away(text: str) -> list[tuple[int, int]]:
    """Where in a text stands what is to make way for something else: "turn the hood into a turtleneck"."""
    return [
        m.span(name)
        for m in _SWAPPED.finditer(text)
        for name in ("old", "swapped", "made", "turned", "left")
        if m[name] is not None
    ]


def _short_legs(each: Implication, kind: str) -> Implication:
    """Shorts as the lower part of a jumpsuit make a playsuit of it."""
    if each.claim == Claim("kind", "shorts") and kind == "jumpsuit":
        return replace(each, claim=Claim("kind", "playsuit"))
    return each


def _after_arrow(text: str, words: WordReading, kind: str) -> list[Implication]:
    """What a garment is to become, where its name could be a part of what is there: "dress -> top"."""
    for mark in words.marks:
        if mark.role in ("part", "second") and _leads_to(text, mark):
            for entry in mark.entries:
                for each in entry.implied:
                    if each.claim.name == "kind" and each.claim.value != kind:
                        return [Implication(each.claim, "certain", False, mark)]
    return []


def _is_pointed_at(text: str, mark: WordMark) -> bool:
    """Whether a garment is named that is there: "the dress"."""
    return (
        re.search(
            r"(?<!\w)(?:the|this|that|my|its|these|her|his)\s+(?:(?!(?:in)?to\b|as\b)\w+\s+)?$",
            text[: mark.start],
        )
        is not None
    )


def _is_target(text: str, mark: WordMark, value: str, kind: str, language: Language) -> bool:
    """Whether the garment is to become another: "into a skirt", "as trousers", or nothing but its name."""
    if (
        value == kind
        or _LIKENESS.search(text[: mark.start])
        or _IS_ONE.search(text[: mark.start])
        or (value in _PARTS_OF.get(kind, ()) and not _turns_into(text, mark))
    ):
        return False
    if (rather := _RATHER.match(text, mark.end)) is not None and rather["old"] in _NAMES.get(kind, ()):
        return True
    clause = next((text[a:b] for a, b in clauses_of(text, language) if a <= mark.start < b), text)
    named = [word for word in _WORD.findall(clause) if not is_function_word(word)]
    return _leads_to(text, mark) or (
        len(named) <= 1 and not re.search(r"(?<!\w)(?:the|this|my)(?!\w)", clause)
    )


def _turns_into(text: str, mark: WordMark) -> bool:
    """Whether a garment is to become what could be a part of it: "with a straight skirt" it has one."""
    said = r"(?<!\w)(?:into|to|as|->|als|zu|zu einem|zu einer|en)\s+(?:(?:an?|une?|una|some)\s+)?(?:\w+\s+)?$"
    found = re.search(said, text[: mark.start])
    return found is not None and _OF_A_PART.search(text[: found.start()]) is None


def _leads_to(text: str, mark: WordMark) -> bool:
    return re.search(rf"{target_words()}\s+(?:an?\s+|some\s+|\w+\s+)?$", text[: mark.start]) is not None


def clauses_of(text: str, language: Language = "en") -> list[tuple[int, int]]:
    """From where to where each clause of a text goes.

    Args:
        text: An instruction.
        language: Of the text.
    """
    found, start = [], 0
    for joint in _joint(language).finditer(text):
        found.append((start, joint.start()))
        start = joint.end()
    found.append((start, len(text)))
    return [(a, b) for a, b in found if _WORD.search(text, a, b) or any(c.isdigit() for c in text[a:b])]


@lru_cache(maxsize=16)
def _joint(language: Language) -> re.Pattern[str]:
    return re.compile(rf"{_JOINTS}|\s(?:{_ALSO_JOINTS.get(language, 'mais')})\s", re.IGNORECASE)

"""Which of its meanings a word has in a text: what it is said of decides, and what else is named."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

from swifttailor.wording.lexicon.conflicts import exclude
from swifttailor.wording.lexicon.entries import Entry
from swifttailor.wording.lexicon.inflection import Language
from swifttailor.wording.lexicon.marking import Found
from swifttailor.wording.lexicon.sizes_of_details import ADJECTIVES, little_behind, tells_how_far
from swifttailor.wording.lexicon.vocabulary import WORN, Sense, Vocabulary
from swifttailor.wording.word_tables import Dialect

Role = Literal["garment", "second", "theirs", "like", "part", "word", "astray"]
"""What a word is to the garment that the text asks for, which is ``garment`` itself.

second: another one. theirs: one that is there already, "over my dress". like: what it is like, as in
"sweater skirt". part: a part of it. astray: said of something that it means nothing of, as "huge" of a
collar. word: anything else.
"""
_JOINING = frozenset(["and", "or", "nor", "&", "und", "oder", "et", "ou", "ni", "y", "e", "o", "u"])
_ALSO_JOINING: Mapping[Language, frozenset[str]] = {
    "it": frozenset(["ed", "né"]),
    "nl": frozenset(["en", "of", "noch"]),
    "pt": frozenset(["nem"]),
}
"""In one language only: "en" and "of" are prepositions elsewhere."""
_ARTICLES = frozenset(
    ["the", "its", "his", "her", "my", "die", "den", "der", "das", "les", "la", "el", "los"]
)
_SIZELESS = frozenset(["function", "polite", "degrees", "comparisons", "numbers", "negations"])
"""Categories of words that hold texts together."""
_MINE = frozenset(["my", "her", "his", "their", "under", "over", "beneath", "underneath", "match"])
"""Words before a garment that is there already."""
_ONE_MORE = frozenset(["a", "an", "some"])
"""What between such a word and a garment says that it is to be made: "make her a blue dress"."""
_OWNERS = frozenset(["her", "his", "their"])
_WHOLE = frozenset(["dress", "jumpsuit", "playsuit"])
_PART_OF = {
    "skirt": _WHOLE,
    "trousers": frozenset(["jumpsuit"]),
    "shorts": frozenset(["playsuit"]),
    "top": _WHOLE,
}
"""Kinds that are a part of others: "a dress with a wide skirt"."""

_WHERE = frozenset(["to", "at", "above", "below", "past"])
"""What goes on to say where a part ends: "sleeves to the elbow" are sleeves."""
_HEMS = frozenset({"skirt_hem", "top_hem", "leg_hem"})
_REACH = 80
"""No word is said of one that stands further off: long texts take time in proportion to their length."""


@dataclass(frozen=True, slots=True)
class Meaning:
    """A word of a text with what it means there."""

    found: Found
    entries: tuple[Entry, ...]
    """Several hold together; none where the word is unknown."""
    role: Role = "word"
    target: int | None = None
    """Which word it is said of, by its place in the list; none where nothing is named."""
    guessed: bool = False
    """Whether nothing told this meaning from others."""
    part: str | None = None
    """The part of a garment that it names, or that its last word names: "bell sleeves"."""

    @property
    def category(self) -> str:
        """Of its entries; empty where it is unknown."""
        return self.entries[0].category if self.entries else ""

    @property
    def holds_together(self) -> bool:
        """Whether it says nothing of a garment itself."""
        return self.category in _SIZELESS

    @property
    def is_noun(self) -> bool:
        """Whether things can be said of it; nothing can be of what is not there, as of "no sleeves"."""
        if self.part is None and self.category not in ("garments", "accessories", "parts", "generic"):
            return False
        return not any(claim.value == "none" for entry in self.entries for claim in entry.claims("certain"))


def meanings(
    words: Sequence[Found],
    known: Vocabulary,
    *,
    kind: str | None = None,
    dialect: Dialect | None = None,
    denied: frozenset[int] = frozenset(),
) -> list[Meaning]:
    """The words of a text with their meanings.

    Args:
        words: In their order.
        known: The words of their language.
        kind: Of the garment that is spoken of, where that is known.
        dialect: Whose meanings come first: "pants" are trousers or underwear.
        denied: Places of words that are denied: no garment of them is asked for where another is named.
    """
    chosen = [_first_choice(word, dialect) for word in words]
    garments = [k for k, senses in enumerate(chosen) if senses and senses[0].entry.category == "garments"]
    certain = [k for k in garments if all(s.entry.category in WORN for s in words[k].senses)]
    for k in garments:
        others = tuple([s for s in words[k].senses if s.entry.category not in WORN])
        if others and (
            kind is not None or [c for c in certain if c != k] or garments[0] < k or _before_noun(words, k)
        ):
            said_of = [s.entry.of for s in others if s.entry.of]
            if len(said_of) < len(others) or _kinds(chosen, certain, kind) & frozenset().union(*said_of):
                chosen[k] = others
    result = [
        Meaning(word, tuple([s.entry for s in senses]), part=_part(word, senses, known))
        for word, senses in zip(words, chosen, strict=True)
    ]
    result = _with_roles(result, kind, denied)
    for k, meaning in enumerate(result):
        if meaning.role == "word" and any(sense.entry.of for sense in chosen[k]):
            result[k] = _said_of(result, k, chosen[k], kind, known)
    return result


def _part(word: Found, senses: tuple[Sense, ...], known: Vocabulary) -> str | None:
    if not senses or senses[0].entry.category in WORN or senses[0].entry.category in _SIZELESS:
        return None
    own = next((s.entry.part for s in senses if s.entry.part is not None), None)
    if own is not None or " " not in word.word:
        return own
    parts = word.word.split()
    far = next((n for n, each in enumerate(parts) if n and each in _WHERE), len(parts))
    return known.part(parts[far - 1])


def _first_choice(word: Found, dialect: Dialect | None) -> tuple[Sense, ...]:
    """What a word can mean: worn things first, and ambiguous meanings last, unless the dialect decides."""
    senses = word.senses
    if len(senses) < 2:
        return senses
    fitting = tuple([s for s in senses if dialect is None or s.dialect in (None, dialect)]) or senses
    spoken = tuple([s for s in fitting if dialect is not None and s.dialect == dialect])
    fitting = spoken or fitting
    worn = [s for s in fitting if s.entry.category in WORN]
    if worn:
        return (next((s for s in worn if not s.entry.ambiguous), worn[0]),)
    alone = [s for s in fitting if not s.entry.of]
    alone = [s for s in alone if not s.entry.ambiguous][:1] or alone[:1]
    return tuple([s for s in fitting if s.entry.of or s in alone])


def _before_noun(words: Sequence[Found], k: int) -> bool:
    """Whether a garment follows at once."""
    if k + 1 >= len(words) or words[k].gap in ("pause", "stop"):
        return False
    return any(s.entry.category == "garments" for s in words[k + 1].senses)


def _kinds(chosen: Sequence[tuple[Sense, ...]], garments: Sequence[int], kind: str | None) -> frozenset[str]:
    named = frozenset().union(*[s.entry.kinds for k in garments for s in chosen[k]])
    return named | ({kind} if kind is not None else frozenset())


def _with_roles(words: list[Meaning], kind: str | None, denied: frozenset[int]) -> list[Meaning]:
    """Finds the garment that is asked for, and what the others are to it."""
    named = [k for k, word in enumerate(words) if word.category in WORN]
    heads = [k for k in named if not _followed_by_garment(words, k)]
    garments = [k for k in heads if words[k].category == "garments"]
    free = [k for k in garments if not _is_theirs(words, k)] or garments
    free = [k for k in free if k not in denied] or free
    likened = [k for k in garments if _is_likened(words, k)]
    free = [k for k in free if k not in likened]
    main = next((k for k in free if words[k].entries[0].kinds), free[0] if free else None)
    if main is not None and kind is None:
        whole = next((k for k in free if _can_hold(words[k], words[main])), None)
        main = main if whole is None else whole
    for k in named:
        if k == main:
            role: Role = "garment"
        elif k not in heads or k in likened:
            role = "like"
        elif _is_theirs(words, k):
            role = "theirs"
        elif words[k].category == "accessories":
            role = "second"
        elif main is not None and not _is_worn_over(words[k]) and _can_hold(words[main], words[k]):
            role = "part"
        elif main is not None and words[k].entries[0].kinds & words[main].entries[0].kinds:
            role = "like"
        else:
            role = "second"
        words[k] = replace(words[k], role=role)
    return words


_LIKENS = frozenset(
    f"{word} {other}"
    for word in ("look", "looks", "looking", "looked", "pass", "passes", "mistaken")
    for other in ("like", "for", "as")
)
_LEGS = frozenset({"legs", "leg_hem", "leg_cuffs"})
_FAR = 5
"""Words that may stand between what is likened and what it is like."""


def _is_likened(words: Sequence[Meaning], k: int) -> bool:
    """Whether another garment looks like it: the skirt of "legs so wide that they look like a skirt"."""
    for j in range(k - 1, max(k - _FAR, 0), -1):
        if words[j].found.word in _LIKENS:
            return any(_is_worn_itself(word) for word in words[:j])
        if words[j].category in WORN or words[j].found.gap in ("pause", "stop"):
            return False
    return False


def _is_worn_itself(word: Meaning) -> bool:
    """Whether it names a garment, or what trousers alone have."""
    if word.category == "garments":
        return True
    return any(claim.name in _LEGS for entry in word.entries for claim in entry.claims("certain"))


_OVER = "outerwear.txt"
_KNITTED = ("cardigan", "shrug")


def _is_worn_over(word: Meaning) -> bool:
    """Whether it is a garment beside others, and no part of one: the jacket that a dress comes with."""
    return any(e.place[0] == _OVER or any(name.lower() in _KNITTED for name in e.words) for e in word.entries)


def _can_hold(whole: Meaning, part: Meaning) -> bool:
    kinds = whole.entries[0].kinds
    return any(kinds & _PART_OF.get(each, frozenset()) for each in part.entries[0].kinds)


_WANTED = frozenset({"needs", "wants", "requires", "wishes", "needed", "wanted"})
"""Verbs of persons who are spoken of: what stands behind them is nobody's yet."""
_STYLED = ("style", "styled", "type", "inspired", "look")
"""What makes of a garment's name a manner: a qipao style top."""


def _followed_by_garment(words: Sequence[Meaning], k: int) -> bool:
    after = k + 1
    if after < len(words) and words[after].found.word in _STYLED and words[k].found.gap != "pause":
        after += 1
    if after >= len(words) or any(words[j].found.gap in ("pause", "stop") for j in range(k, after)):
        return False
    return words[after].category == "garments"


def _is_theirs(words: Sequence[Meaning], k: int) -> bool:
    """Whether a garment is named as one that is there: "over my dress", but not "my son needs a dress"."""
    before = words[max(0, k - 3) : k]
    wanted = [j for j, w in enumerate(before, 1) if w.found.word in _WANTED]
    before = before[max(wanted, default=0) :]
    return any(
        w.found.word in _MINE
        and w.found.gap in ("space", "hyphen")
        and not (w.found.word in _OWNERS and any(b.found.word in _ONE_MORE for b in before[n + 1 :]))
        for n, w in enumerate(before)
    )


def _said_of(
    words: Sequence[Meaning], k: int, senses: tuple[Sense, ...], kind: str | None, known: Vocabulary
) -> Meaning:
    """The meaning of a word that depends on what it is said of."""
    little = little_behind(words, k)
    if little is not None and not _fitting(senses, _names(words[little])):
        return replace(words[k], entries=(senses[0].entry,), role="astray")
    if _ends_somewhere(senses) and tells_how_far(words, k):
        slit = _fitting(senses, frozenset({"slit"}))
        if not slit:
            return replace(words[k], entries=(senses[0].entry,), role="astray")
    for target in _targets(words, k, known):
        fitting = _fitting(senses, _names(words[target]))
        if fitting and not _is_otherwise(fitting, words[target]):
            return replace(words[k], entries=fitting, target=target, part=words[k].part or fitting[0].part)
    fitting = _fitting(senses, frozenset([kind])) if kind is not None else ()
    if fitting:
        return replace(words[k], entries=fitting)
    alone = tuple([s.entry for s in senses if not s.entry.of])
    if alone:
        return replace(words[k], entries=alone)
    usual = next(
        (f for each in ("dress", "top", "trousers") if (f := _fitting(senses, frozenset([each])))), None
    )
    return replace(words[k], entries=(usual[0] if usual else senses[0].entry,), guessed=True)


def _ends_somewhere(senses: Sequence[Sense]) -> bool:
    """Whether a word tells how far down a garment goes, whatever it is said of: "to the knee", "long"."""
    claims = [claim for sense in senses for claim in sense.entry.claims("certain")]
    return senses[0].entry.category == "lengths" and any(claim.name in _HEMS for claim in claims)


def _is_otherwise(entries: Sequence[Entry], word: Meaning) -> bool:
    """Whether a detail is another way by its own name: "very short, long sleeves" is no length of sleeves."""
    if word.category != "styles":
        return False
    own = [claim for entry in word.entries for claim in entry.claims("certain")]
    return any(exclude(a, b) for entry in entries for a in entry.claims("certain") for b in own)


def _names(word: Meaning) -> frozenset[str]:
    entry = word.entries[0]
    part = frozenset([word.part]) if word.part is not None else frozenset()
    color = frozenset(["color"]) if entry.category == "colors" else frozenset()
    return part | entry.kinds | color


def _fitting(senses: Sequence[Sense], names: frozenset[str | None]) -> tuple[Entry, ...]:
    return tuple([s.entry for s in senses if s.entry.of & names])


def _goes_on_with(word: Meaning, known: Vocabulary) -> bool:
    """Whether a list of adjectives goes on behind a comma, as in "long, wide sleeves"."""
    first = word.found.word.partition(" ")[0]
    return any(sense.entry.of for sense in known.find([first]))


def _list_goes_on(words: Sequence[Meaning], k: int, j: int, known: Vocabulary) -> bool:
    """Whether what stands before a comma is said of what comes behind it, too.

    In "long flowing, bell sleeves" it is not: no sleeve is called flowing, so both are said of the garment.
    """
    if not _goes_on_with(words[j], known):
        return False
    at = next((n for n in range(j, min(j + _REACH, len(words))) if words[n].is_noun), None)
    if (
        at is not None
        and words[k].category == "lengths"
        and any(w.category == "lengths" for w in words[j:at])
    ):
        return False  # "floor length, short puffed sleeves" tells of two things
    noun = None if at is None else words[at]
    beside = [[s for s in word.found.senses if s.entry.of] for word in words[k + 1 : j]]
    return noun is None or all(_fitting(senses, _names(noun)) for senses in beside if senses)


def _noun_before(words: Sequence[Meaning], k: int) -> int | None:
    """The noun that a word stands right behind, or behind words of degree: "sleeves really long"."""
    for j in range(k - 1, -1, -1):
        if words[j].found.gap in ("pause", "stop"):
            return None
        if words[j].category != "degrees":
            return j if words[j].is_noun and words[j].role in ("word", "part") else None
    return None


def _targets(words: Sequence[Meaning], k: int, known: Vocabulary) -> Iterator[int]:
    """What a word can be said of, the likeliest first: what it stands before, then what stands before it.

    In "sleeves long and the skirt shorter" it stands behind its noun; what is joined on is another matter.
    """
    seen = set()
    joining = _JOINING | _ALSO_JOINING.get(known.language, frozenset())
    own = _noun_before(words, k)
    if own is not None and k + 1 < len(words) and words[k + 1].found.word in joining:
        seen.add(own)
        yield own
    for j in range(k + 1, min(k + _REACH, len(words))):
        gap = words[j - 1].found.gap
        word = words[j]
        if gap == "stop" or (gap == "pause" and not _list_goes_on(words, k, j, known)):
            break
        if word.is_noun or word.category == "colors":
            seen.add(j)
            yield j
            if word.is_noun and word.role != "like":
                break
        elif word.category not in ADJECTIVES and word.category != "degrees":
            if word.found.word not in joining and word.found.word not in _ARTICLES:
                break
    for j in range(k - 1, max(k - _REACH, -1), -1):
        if words[j].found.gap in ("pause", "stop"):
            break
        if words[j].is_noun and j not in seen and words[j].role not in ("second", "theirs"):
            seen.add(j)
            yield j
            break
    garment = [j for j, word in enumerate(words) if word.role == "garment"]
    yield from garment
    for j in range(k - 1, max(k - _REACH, -1), -1):
        if words[j].found.gap == "stop":
            break
        if words[j].is_noun and j not in seen and words[j].role not in ("second", "theirs"):
            yield j

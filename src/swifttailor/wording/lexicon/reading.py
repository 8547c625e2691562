"""Reading a text by the lexicon alone: what its words imply, what cannot be made, and what nobody knows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

from swifttailor.describing.claims import Claim
from swifttailor.wording.claim_kinds import fits_kind, implied_kind
from swifttailor.wording.lexicon.beside_refusals import is_compared, is_said_beside
from swifttailor.wording.lexicon.colors import NamedColor, named_colors
from swifttailor.wording.lexicon.conflicts import SCALES, beyond, exclude
from swifttailor.wording.lexicon.covered_shoulders import with_covered_shoulders
from swifttailor.wording.lexicon.denials import denied_words
from swifttailor.wording.lexicon.entries import Certainty, Entry, NamedPrint
from swifttailor.wording.lexicon.inflection import Language
from swifttailor.wording.lexicon.long_tops import with_long_tops
from swifttailor.wording.lexicon.marking import find_words
from swifttailor.wording.lexicon.meanings import Meaning, Role, meanings
from swifttailor.wording.lexicon.odd_ones import odd_ones
from swifttailor.wording.lexicon.opposites_in_names import contradicting_pairs, without_closeness
from swifttailor.wording.lexicon.said_look import WHOLE, SaidLook
from swifttailor.wording.lexicon.said_looks import said_looks
from swifttailor.wording.lexicon.vocabulary import vocabulary
from swifttailor.wording.lexicon.worn_with import is_worn_with
from swifttailor.wording.word_tables import Dialect

SURENESS: Mapping[Certainty, float] = {"certain": 0.97, "usual": 0.85, "likely": 0.6}
"""How often a statement holds where a word implies it."""
_ORDER: tuple[Certainty, ...] = ("certain", "usual", "likely")
_NAMES: tuple[Role, ...] = ("garment", "like", "second")


_TOPS = frozenset(["top", "tunic"])
_LOWER = {"skirt": "skirt", "trousers": "legs", "shorts": "legs"}
"""Kinds without an upper part, and what they have."""
_MAXI = Claim("skirt_hem", "maxi")
_NOT_SHORT = frozenset(["knee", "below the knee", "midi"])
_LONG: Mapping[Language, str | tuple[str, ...]] = {"it": "lung", "nl": "lang", "pt": ("long", "compri")}
"""How words for long begin, where they are not like the English one."""
_WHOLE = {"dress": "dress", "jumpsuit": "playsuit"}
"""Kinds with an upper and a lower part, and what they are with short legs."""


@dataclass(frozen=True, slots=True)
class WordMark:
    """A word of a text, and the entries that it belongs to."""

    start: int
    end: int
    word: str
    """As the text has it."""
    entries: tuple[Entry, ...]
    """None where the word is unknown."""
    role: Role
    denied: bool = False
    part: str | None = None
    """The part of a garment that it names, or that its last word names: "bell sleeves"."""


@dataclass(frozen=True, slots=True)
class Implication:
    """What follows from a word of a text."""

    claim: Claim
    certainty: Certainty
    said: bool
    """Whether a word about the detail says so; otherwise the name of a garment implies it."""
    mark: WordMark


@dataclass(frozen=True, slots=True)
class Lack:
    """Something that cannot be made."""

    what: str
    """A key of `cannot_texts`."""
    said: bool
    """Whether the text asks for it; otherwise the name of a garment implies it."""
    mark: WordMark


@dataclass(frozen=True, slots=True)
class Contradiction:
    """Two words that cannot both be true."""

    first: WordMark
    second: WordMark


@dataclass(frozen=True, slots=True)
class WordReading:
    """What a text says, word by word."""

    language: Language
    marks: tuple[WordMark, ...]
    """All words in their order; each belongs to one mark."""
    implications: tuple[Implication, ...]
    """One a claim and value, in the order of the text."""
    never: tuple[Claim, ...]
    """What the text refuses."""
    lacks: tuple[Lack, ...]
    contradictions: tuple[Contradiction, ...]
    colors: tuple[NamedColor, ...]
    """Of the garment; those of its parts are in `looks`."""
    prints: tuple[NamedPrint, ...]
    cloths: tuple[str, ...]
    """Fabrics of `swifttailor.draping`."""
    sizes: tuple[str, ...]
    """As the text has them."""
    looks: tuple[SaidLook, ...] = ()
    """Of parts that look otherwise than the garment, and sheer cloths."""
    color_marks: tuple[WordMark, ...] = ()
    """The words of `colors`."""

    @property
    def unknown(self) -> tuple[str, ...]:
        """Words that are in no table."""
        return tuple([mark.word for mark in self.marks if not mark.entries])

    def certainty(self, claim: Claim) -> Certainty | None:
        """How surely a claim follows; None if it does not."""
        return next((each.certainty for each in self.implications if each.claim == claim), None)


def read_words(
    text: str, *, language: Language | None = None, kind: str | None = None, dialect: Dialect | None = None
) -> WordReading:
    """Reads a text.

    What words about details say wins over what the name of a garment implies: a sleeveless shirt dress has no
    sleeves. What is denied is not implied.

    Args:
        text: Of any length; the first 20,000 characters are read.
        language: Its language; found out when None.
        kind: Of the garment that an instruction is about.
        dialect: Whose meanings come first where British and American English differ.
    """
    return _reading(text, find_words(text, language)[0], kind, dialect)


@lru_cache(maxsize=16)
def _reading(text: str, language: Language, kind: str | None, dialect: Dialect | None) -> WordReading:
    """The same in a language that is known; a text is often read again when its slips are put right."""
    found = find_words(text, language)[1]
    words = meanings(found, vocabulary(language), kind=kind, dialect=dialect)
    denied = denied_words(words, language)
    if any(words[k].role == "garment" for k in denied):  # "no skirt but trousers": the trousers are asked for
        words = meanings(found, vocabulary(language), kind=kind, dialect=dialect, denied=denied)
    marks = [
        WordMark(
            w.found.start,
            w.found.end,
            text[w.found.start : w.found.end],
            w.entries,
            w.role,
            k in denied,
            w.part,
        )
        for k, w in enumerate(words)
    ]
    implied, never, of_names = [], [], set()
    kinds = _kinds_named(words)
    for word, mark in zip(words, marks, strict=True):
        if mark.denied:
            without, refused = _refused(mark)
            implied += without
            never += refused
            of_names |= set(refused) if any(e.category == "garments" for e in mark.entries) else set()
        else:
            meant = [] if word.role == "like" and is_compared(text, mark.start) else _implied(word, mark)
            implied += [one for one in meant if word.role != "like" or _has_place(one, kinds)]
    implied = _with_parts_behind(implied)
    implied = with_covered_shoulders(_with_its_collar(_exact_lengths(implied, language)), never, marks)
    # "Tight on top, but not like a ballgown" is tight on top.
    asked = frozenset().union(*(_kinds_of(mark, language) for mark in marks if not mark.denied))
    of_names &= {i.claim for i in implied if i.said and i.claim.name != "kind"} | {
        Claim("kind", kind) for kind in asked
    }
    never = [claim for claim in never if claim not in of_names]
    named = _names_mean(marks)  # "a mini skirt, but not too short" is still a mini skirt
    never = [claim for claim in dict.fromkeys(never) if claim not in named]
    never = [claim for claim in never if not is_said_beside(marks, claim)]
    pairs = contradicting_pairs(text, marks, implied)
    kept = _settled([i for i in without_closeness(implied, pairs) if i.claim not in never])
    if kind is None:
        kept = with_long_tops(_with_kind(kept, never), marks)
    kept = _fitting_kind(kept, kind)
    meant = [mark for mark in marks if not mark.denied]
    looks = said_looks(text, marks, language)
    elsewhere = {id(mark) for look in looks if look.part != WHOLE for mark in look.marks}
    dyed = [m for m in meant if any(e.category == "colors" and e.color for e in m.entries)]
    colors = zip(dyed, named_colors([(m.word, m.entries) for m in meant]), strict=True)
    colors = [(mark, color) for mark, color in colors if id(mark) not in elsewhere]
    return WordReading(
        language,
        tuple(marks),
        tuple(kept),
        tuple(never),
        _lacks(meant, text),
        tuple([Contradiction(*pair) for pair in pairs]),
        tuple([color for _, color in colors]),
        tuple([entry.print for mark in meant for entry in mark.entries if entry.print is not None]),
        tuple(
            dict.fromkeys(
                [
                    e.cloth
                    for m in meant
                    for e in m.entries
                    if e.cloth is not None and e.category == "fabrics" and id(m) not in elsewhere
                ]
            )
        ),
        tuple([mark.word for mark in meant if _is_size(mark)]),
        looks,
        tuple([mark for mark, _ in colors]),
    )


def _is_size(mark: WordMark) -> bool:
    return mark.role != "astray" and any("sizes" in entry.cannot for entry in mark.entries)


def _kinds_named(words: Sequence[Meaning]) -> frozenset[str]:
    """Kinds of the garment that is asked for; none where no word names one."""
    return frozenset().union(*[e.kinds for w in words if w.role == "garment" for e in w.entries])


def _has_place(one: Implication, kinds: frozenset[str]) -> bool:
    """Whether a garment can have what another that it is like implies: a qipao-style top has no slits."""
    return not kinds or any(fits_kind(one.claim.name, kind) for kind in kinds)


_HELD_BY = ("waistband", "rise")
"""What holds a skirt that is a garment of its own, and not that of a dress."""


def _implied(word: Meaning, mark: WordMark) -> list[Implication]:
    """What a word that is not denied implies."""
    if word.role in ("second", "theirs", "astray"):
        return []
    said = word.role not in _NAMES
    found = []
    for entry in word.entries:
        for each in entry.implied:
            if word.role in ("like", "part") and each.claim.name == "kind":
                continue
            if word.role == "part" and each.claim.name in _HELD_BY and each.certainty != "certain":
                continue
            certainty = each.certainty
            if word.role == "like" or word.guessed:
                certainty = "likely" if certainty == "likely" or word.guessed else "usual"
            found.append(Implication(each.claim, certainty, said, mark))
    return found


def _with_parts_behind(implied: Sequence[Implication]) -> list[Implication]:
    """Those that hold where a part of the garment is named as if it were one of its own.

    A satin skirt usually is a midi, and that of a gown is as long and wide as the gown is said to be.
    """
    whole = {i.claim.name for i in implied if i.mark.role == "garment" and i.claim.name == "skirt_hem"}
    said = [i for i in implied if i.said and i.certainty == "certain"]
    whole |= {i.claim.name for i in said if i.claim.name == "skirt"}
    return [
        i for i in implied if i.mark.role != "part" or i.certainty == "certain" or i.claim.name not in whole
    ]


def _kinds_of(mark: WordMark, language: Language) -> frozenset[str]:
    """The kinds of a garment that a word is, or that ends the name of a style: "one-sleeved dress"."""
    entries = list(mark.entries)
    if " " in mark.word:
        entries += [sense.entry for sense in vocabulary(language).find(mark.word.split()[-1:])]
    named = [entry.kinds for entry in entries if entry.category == "garments"]
    return frozenset().union(*named)


def _names_mean(marks: Sequence[WordMark]) -> frozenset[Claim]:
    """What the name of the garment that is asked for means by definition."""
    asked = [mark for mark in marks if mark.role == "garment" and not mark.denied]
    return frozenset([claim for mark in asked for entry in mark.entries for claim in entry.claims("certain")])


def _refused(mark: WordMark) -> tuple[list[Implication], list[Claim]]:
    """What follows from a word that is denied: what is asked for instead, and what is refused."""
    without = [Implication(claim, "certain", True, mark) for entry in mark.entries for claim in entry.without]
    refused = []
    for entry in mark.entries:
        for claim in entry.claims("certain"):
            if claim.name != "kind" or entry.category == "garments":
                refused += beyond(claim)
    asked = [i.claim for i in without]
    return without, [claim for claim in refused if claim not in asked]


def _exact_lengths(implied: Sequence[Implication], language: Language) -> list[Implication]:
    """Without "long" where the text says how long: a long coat to the knee ends at the knee."""
    exact = any(
        i.said and i.certainty == "certain" and i.claim.name == "skirt_hem" and i.claim.value in _NOT_SHORT
        for i in implied
    )
    long = _LONG.get(language, "long")
    return [i for i in implied if not (exact and i.claim == _MAXI and i.mark.word.lower().startswith(long))]


def _with_its_collar(implied: Sequence[Implication]) -> list[Implication]:
    """A collar of which no more is said is the one that the garment has by its name: of a bomber, a stand."""
    named = [i.claim for i in implied if not i.said and i.claim.name == "collar" and i.claim.value != "none"]
    return [replace(i, claim=named[0]) if named and _is_a_mere_collar(i) else i for i in implied]


def _is_a_mere_collar(implied: Implication) -> bool:
    parts = [entry for entry in implied.mark.entries if entry.part == "collar" and entry.category == "parts"]
    return implied.said and implied.certainty == "usual" and implied.claim.name == "collar" and bool(parts)


def _settled(implied: Sequence[Implication]) -> list[Implication]:
    """Leaves out what something better excludes: what is said, then what is surer, then what comes first.

    What a name means by definition is surer than what a detail usually goes with: of a mini dress with a
    straight skirt the hem is a mini dress's.
    """
    odd = odd_ones(implied)
    ranked = sorted(implied, key=lambda one: (one in odd, _rank(one)))
    kept: list[Implication] = []
    for each in ranked:
        if any(each.claim == other.claim for other in kept):
            continue
        if not any(_outdone(each, other) for other in kept if other.mark is not each.mark):
            kept.append(each)
    return sorted(kept, key=lambda i: i.mark.start)


def _rank(implied: Implication) -> tuple[int, int]:
    """The smaller, the more it counts."""
    order = _ORDER.index(implied.certainty)
    if implied.certainty == "certain":
        return (0 if implied.said else 1), order
    return (2 if implied.said and implied.certainty == "usual" else 3), order


def _outdone(each: Implication, better: Implication) -> bool:
    """Whether something better leaves no place for it: names say nothing of a length that is said."""
    if exclude(each.claim, better.claim):
        return True
    name = each.claim.name
    return better.said and not each.said and name == better.claim.name and name in SCALES


def _with_kind(kept: list[Implication], never: Sequence[Claim]) -> list[Implication]:
    """Adds the kind where details alone tell it: what has sleeves and a skirt is a dress."""
    firm = [i for i in kept if i.said and i.certainty != "likely" and i.claim.name != "kind"]
    said = [i for i in firm if not any(e.category == "fabrics" for e in i.mark.entries)]  # lycra is close
    named = next((i for i in kept if i.claim.name == "kind"), None)
    if named is not None:  # "a skirt, no darts" is a skirt
        said = [i for i in said if not i.mark.denied and i.claim.name != "bodice"]
    if not said or (named is not None and named.claim.value not in _LOWER):
        return kept
    lower = [Claim(_LOWER[str(named.claim.value)], "straight")] if named is not None else []
    told = implied_kind([*[i.claim for i in said], *lower])
    if not told or (named is not None and told[0] not in _WHOLE):
        return kept
    kind = _WHOLE[told[0]] if named is not None and named.claim.value == "shorts" else told[0]
    if Claim("kind", kind) in never:
        return kept
    source = next(i.mark for i in said) if named is None else named.mark
    return [*[i for i in kept if i is not named], Implication(Claim("kind", kind), "usual", False, source)]


def _fitting_kind(kept: Sequence[Implication], kind: str | None) -> list[Implication]:
    """Leaves out what names imply and garments of this kind cannot have: a spencer dress is not cropped."""
    kind = next((str(i.claim.value) for i in kept if i.claim.name == "kind"), kind)
    if kind is None:
        return list(kept)
    return [
        i
        for i in kept
        if i.said or (fits_kind(i.claim.name, kind) and (i.claim.name != "top_hem" or kind in _TOPS))
    ]


def _lacks(marks: Sequence[WordMark], text: str) -> tuple[Lack, ...]:
    found: dict[str, Lack] = {}
    for mark in marks:
        if mark.role == "astray":
            continue
        for entry in mark.entries if mark.role != "theirs" else ():
            for what in () if mark.role == "second" and entry.category == "garments" else entry.cannot:
                said = mark.role not in ("garment", "like")
                if what not in found or (said and not found[what].said):
                    found[what] = Lack(what, said, mark)
        beside = mark.role == "second" or (mark.role == "theirs" and is_worn_with(text[: mark.start]))
        if beside and "separate_pieces" not in found and mark.entries[0].category == "garments":
            found["separate_pieces"] = Lack("separate_pieces", True, mark)
    return tuple(found.values())

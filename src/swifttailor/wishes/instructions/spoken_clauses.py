"""Wishes of one instruction that exclude each other, what describes the garment, and what is made instead."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass, replace

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain, Step, subject_of
from swifttailor.wording.lexicon import WordMark, WordReading, exclude


@dataclass(frozen=True)
class SpokenClause:
    """A clause of an instruction, and what it asks for."""

    start: int
    end: int
    changes: tuple[Change, ...]
    left_over: tuple[str, ...]
    """Words that nothing accounts for."""


def without_what_is_so(found: Sequence[SpokenClause], is_so: Callable[[Claim], bool]) -> list[SpokenClause]:
    """Leaves out what is so already where something else is asked of the same thing."""
    changes = [change for clause in found for change in clause.changes]

    hooded = Gain(Claim("hood", "hood")) in changes

    def outdone(change: Change) -> bool:
        if hooded and change == Gain(Claim("collar", "none")):
            return True  # where there is a hood there is no collar to be seen
        if not isinstance(change, Gain) or not is_so(change.claim):
            return False
        name = change.claim.name
        new = [c for c in changes if isinstance(c, Gain) and c.claim.name == name and not is_so(c.claim)]
        # "Tiers for the circle skirt": a skirt could be both, but one is to take the place of the other.
        return any(_oppose(change, other) for other in changes) or (name in _ONE_OR_OTHER and bool(new))

    return [replace(c, changes=tuple([x for x in c.changes if not outdone(x)])) for c in found]


_ONE_OR_OTHER = frozenset({"skirt", "sleeve_shape"})


def clashes_of(
    found: Sequence[SpokenClause],
    words: WordReading,
    is_so: Callable[[Claim], bool],
    compared: Collection[tuple[int, int]] = (),
) -> list[tuple[str, str, str]]:
    """Pairs of wishes that exclude each other, in words, with the subject of each.

    Args:
        found: Of each clause.
        words: By the lexicon.
        is_so: Whether a claim is true of the garment.
        compared: Where words of change stand, which say what is to be otherwise: "I hate sleeves so long".
    """
    changes = list(dict.fromkeys([change for clause in found for change in clause.changes]))
    clashes = []
    for k, one in enumerate(changes):
        for other in changes[k + 1 :]:
            if _oppose(one, other):
                pair = _in_words(one), _in_words(other)
                clashes += [(*pair, subject_of(one)), (*pair, subject_of(other))]
    for pair in words.contradictions:
        if pair.first.word.lower() == pair.second.word.lower():
            continue  # one that is there, and what becomes of it
        if any(a <= mark.start < b for mark in (pair.first, pair.second) for a, b in compared):
            continue
        first, second = (_claims_of(mark, words) for mark in (pair.first, pair.second))
        opposite = {c for a in first for b in second if exclude(a, b) for c in (a, b)}
        said = [i.claim for i in words.implications if i.mark in (pair.first, pair.second)]
        if any(is_so(claim) for claim in said if claim in opposite or not opposite):
            continue  # what is there, and what it is to become
        for name in dict.fromkeys(claim.name for claim in (*first, *second)):
            clashes.append((pair.first.word, pair.second.word, name))
    return clashes


def _claims_of(mark: WordMark, words: WordReading) -> list[Claim]:
    """What a word says of the cut, though another word outdoes it; what the garment is says no such thing."""
    own = [claim for entry in mark.entries for claim in entry.claims("certain")]
    own += [i.claim for i in words.implications if i.mark is mark]
    return [claim for claim in dict.fromkeys(own) if claim.name != "kind"]


_GONE = {
    "collar": ("collar height",),
    "cuffs": ("cuff length",),
    "sleeves": ("sleeve length", "sleeve width", "sleeve end"),
    "hood": ("hood depth", "hood height"),
    "slit": ("front slit", "back slit", "left slit", "right slit"),
}


def _oppose(one: Change, other: Change) -> bool:
    if isinstance(one, Step) and isinstance(other, Step):
        return one.quantity == other.quantity and one.direction != other.direction
    if isinstance(one, Gain) and isinstance(other, Gain):
        return one.claim.name == other.claim.name and exclude(one.claim, other.claim)
    gain, step = (one, other) if isinstance(one, Gain) else (other, one)
    assert isinstance(gain, Gain) and isinstance(step, Step)
    return gain.claim.value == "none" and step.quantity in _GONE.get(gain.claim.name, ())


def _in_words(change: Change) -> str:
    if isinstance(change, Step):
        return f"{'more' if change.direction > 0 else 'less'} {change.quantity}"
    return f"{change.claim.name.replace('_', ' ')}: {change.claim.value}"


def other_than(never: Sequence[Claim], holds: Sequence[Claim], spoken: Iterable[str]) -> tuple[Gain, ...]:
    """What to make instead of what is refused and is so: no slit, no collar, plain sleeves.

    Args:
        never: What a text refuses.
        holds: Of these, what is true of the garment.
        spoken: Names of claims that something else is asked of.
    """
    told = set(spoken)
    found = []
    for claim in holds:
        if claim.name in told or claim not in never:
            continue
        instead = _INSTEAD.get(claim.name, {}).get(str(claim.value))
        if instead is not None:
            found.append(Gain(Claim(claim.name, instead)))
            told.add(claim.name)
    return tuple(found)


_INSTEAD = {
    "cuffs": dict.fromkeys(("band", "flounce", "band and flounce", "deep"), "none"),
    "leg_cuffs": dict.fromkeys(("band", "flounce", "band and flounce", "gathered", "deep"), "none"),
    "skirt": dict.fromkeys(("gathered", "tiered", "gathered tiers", "gored", "godets"), "a-line"),
    "bodice": {"darted": "undarted", "gathered": "undarted"},
    "sleeve_shape": dict.fromkeys(("balloon", "puffed", "bell", "wide"), "slim"),
    "collar": dict.fromkeys(("turtleneck", "stand", "lapel"), "none"),
    "hood": {"hood": "none"},
    "slit": dict.fromkeys(("left", "right", "front", "back"), "none"),
    "hem_shape": dict.fromkeys(("scalloped", "pointed", "high-low", "lower left", "lower right"), "level"),
    "neckline": dict.fromkeys(("v", "square", "boat", "trapezoid"), "round"),
    "fit": {"oversized": "easy", "loose": "easy", "close": "easy"},
    "shoulders": {"strapless": "both"},
    "sleeves": {"none": "short"},
    "skirt_hem": {"micro": "knee", "mini": "knee", "above the knee": "knee", "maxi": "midi", "floor": "midi"},
}
"""What is made where only the opposite is said."""

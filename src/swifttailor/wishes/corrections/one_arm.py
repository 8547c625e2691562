"""How long sleeves are is said of the arm that has the only one: "one shoulder, long sleeve"."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import replace

from swifttailor.describing.claims import CLAIM_TYPES, Claim, claims_of
from swifttailor.describing.differences import Change, Gain
from swifttailor.describing.facts import GarmentFacts
from swifttailor.wishes.reader import Wish
from swifttailor.wording.lexicon import WordMark, WordReading
from swifttailor.wording.lexicon.conflicts import SCALES

_LEFT, _RIGHT = Claim("sleeves", "left only"), Claim("sleeves", "right only")
_LENGTHS = frozenset(value for step in SCALES["sleeves"] for value in step)


def of_one_arm(found: Iterable[Wish]) -> tuple[Wish, ...]:
    """The same wishes, those about both sleeves as wishes about the only one there is.

    Beside a bare shoulder there is at most one sleeve. Which arm has it is left open where nothing tells.
    """
    found = tuple(found)
    side = _side([wish.change for wish in found])
    if side is None:
        return found
    only = Gain(_LEFT if side == "left" else _RIGHT)
    kept: dict[Change, Wish] = {}
    for wish in found:
        claim = wish.change.claim if isinstance(wish.change, Gain) else None
        if claim is None or claim.name != "sleeves" or claim.value not in _LENGTHS:
            kept.setdefault(wish.change, wish)
            continue
        for change in (only, Gain(Claim(f"{side}_sleeve", claim.value))):
            kept.setdefault(change, replace(wish, change=change))
    return tuple(kept.values())


_BESIDE = re.compile(
    r"(?<!\w)(?:one|single|only|left|right|other|missing|bare|uneven|unequal|asymmetric\w*|different|odd)"
    r"(?!\w)[^.;,]{0,40}?(?:sleeve|arm(?!hole)|shoulder)"
    r"|(?:sleeve|(?<!\w)arm(?!hole)|shoulder)[^.;,]{0,40}?(?<!\w)(?:one|single|only|left|right|other|missing|bare"
    r"|uneven|unequal|asymmetric\w*|different|odd)(?!\w)|(?<!\w)(?:one|single)(?:\W\w+){0,4}\W(?:sleeve|arm)",
    re.IGNORECASE,
)
_IN_ONE = re.compile(
    r"(?<!\w)in (?:one|a single)(?: piece)?(?: with)?(?!\w)|(?<!\w)one[ -]piece(?!\w)", re.IGNORECASE
)


def with_both_arms(text: str, found: Iterable[Wish]) -> tuple[Wish, ...]:
    """The same wishes, those about one arm as wishes about both, where no word of a text tells sides apart.

    A network takes "a kimono sleeve cut in one with the body" for the only one.

    Args:
        text: In English.
        found: What is read in it.
    """
    found = tuple(found)
    if _BESIDE.search(_IN_ONE.sub(" ", text)):
        return found
    both: dict[Change, Wish] = {}
    for wish in found:
        claim = wish.change.claim if isinstance(wish.change, Gain) else None
        if claim in (_LEFT, _RIGHT):
            continue
        if claim is not None and claim.name in ("left_sleeve", "right_sleeve"):
            wish = replace(wish, change=Gain(Claim("sleeves", claim.value)))
        both.setdefault(wish.change, wish)
    return tuple(both.values())


def without_guessed_length(found: Iterable[Wish], words: WordReading) -> tuple[Wish, ...]:
    """The same wishes without how long the only sleeve is, where no word can mean what a network says."""
    found = tuple(found)
    implied = {i.claim for i in words.implications}
    lengths = [i for i in words.implications if i.claim.name == "sleeves" and i.claim.value in _LENGTHS]
    said = {i.claim.value for i in lengths if i.said}
    open_to_guesses = not said and any(_category(mark) == "lengths" for mark in words.marks)
    if words.unknown or open_to_guesses or not {_LEFT, _RIGHT} & implied:
        return found
    own = said or {i.claim.value for i in lengths}
    return tuple([w for w in found if (length := _length_of(w)) is None or length in own])


def _length_of(wish: Wish) -> object:
    """How long a wish says that a sleeve is; None of all others."""
    claim = wish.change.claim if isinstance(wish.change, Gain) else None
    about_arms = claim is not None and claim.name in ("sleeves", "left_sleeve", "right_sleeve")
    return claim.value if claim is not None and about_arms and claim.value in _LENGTHS else None


def _category(mark: WordMark) -> str | None:
    return mark.entries[0].category if mark.entries else None


def of_two_arms(found: Iterable[Wish]) -> tuple[Wish, ...]:
    """The same wishes without what is said of both sleeves, where each has a length of its own."""
    found = tuple(found)
    claims = {w.change.claim.name: w.change.claim.value for w in found if isinstance(w.change, Gain)}
    left, right = (claims.get(f"{side}_sleeve") for side in ("left", "right"))
    if left is None or right is None or left == right:
        return found
    kept = [w for w in found if not (isinstance(w.change, Gain) and w.change.claim.name == "sleeves")]
    return (*kept, Wish(Gain(Claim("sleeves", "unequal")), 0.9))


def other_arm_kept(changes: Sequence[Change], facts: GarmentFacts) -> list[Change]:
    """That the other sleeve stays as it is, where an instruction is about one alone.

    Args:
        changes: What is asked for.
        facts: Of the garment, which may have one sleeve only.
    """
    names = {change.claim.name for change in changes if isinstance(change, Gain)}
    asked = names & {"left_sleeve", "right_sleeve"}
    if len(asked) != 1 or "sleeves" in names:
        return []
    other = "left_sleeve" if "right_sleeve" in asked else "right_sleeve"
    if facts.left_sleeve is None or facts.right_sleeve is None:
        return []
    values = [Claim(other, value) for value in CLAIM_TYPES[other].words]
    now = [claim for claim in values if claim.holds(facts)]
    if not now:
        return []
    now = claims_of(facts, [other]) or now
    lengths = [c.claim.value for c in changes if isinstance(c, Gain) and c.claim.name in asked]
    unequal = [] if now[0].value in lengths else [Gain(Claim("sleeves", "unequal"))]
    return [Gain(now[0]), *unequal]  # near the border of two lengths both would hold of equal sleeves


def _side(changes: Iterable[Change]) -> str | None:
    """The arm with the only sleeve; None where there are two, or none."""
    claims = {change.claim for change in changes if isinstance(change, Gain)}
    for side, only, bare in (("left", _LEFT, "bare right"), ("right", _RIGHT, "bare left")):
        if only in claims or Claim("shoulders", bare) in claims:
            return side
    return None

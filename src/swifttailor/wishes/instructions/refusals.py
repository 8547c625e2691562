"""What an instruction refuses, and what of it only says what is to be otherwise."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain, Step
from swifttailor.describing.facts import GarmentFacts
from swifttailor.wishes.instructions.change_words import find_changes
from swifttailor.wording.lexicon import WordReading

_DISLIKED = re.compile(
    r"(?<!\w)(?:hate|dislike|(?:don['’]?t|do not) (?:like|love)|can['’]?t stand)(?!\w)[^.,;!?]*"
)
"""What is disliked for being too wide is not to go: "I hate that the hood is so big"."""
_USUAL = frozenset({"collar", "cuffs", "hood"})
"""Parts that a name usually has and that go with it: a "high neck" is mostly a stand collar."""
_GATHERED = Claim("skirt", "gathered")
_ALL_OF_THEM = 1.25
_SMOOTH = frozenset({"straight", "pencil", "narrowing", "a-line"})
"""Shapes of skirts that are not gathered into the waist."""


def refused(words: WordReading) -> tuple[Claim, ...]:
    """What is refused; of a detail that means several things the first: not strapless may be sleeveless."""
    beside = {
        claim
        for mark in words.marks
        if mark.denied
        for entry in mark.entries
        if entry.category != "garments"
        for claim in entry.claims("certain")[1:]
    }
    usual = [
        claim
        for mark in words.marks
        if mark.denied
        for entry in mark.entries[:1]
        if entry.category != "garments"
        for claim in entry.claims("usual")[:1]
        if claim.name in _USUAL
    ]
    return tuple(dict.fromkeys([*[claim for claim in words.never if claim not in beside], *usual]))


def is_denied(change: Change, never: Collection[Claim]) -> bool:
    """Whether it is what is refused in another word for it: a high neckline of "no high neck"."""
    high = Claim("collar", "stand") in never or Claim("collar", "turtleneck") in never
    return high and change in (Gain(Claim("neck_depth", "high")), Step("neck depth", -1))


def compared_away(text: str, words: WordReading) -> frozenset[Claim]:
    """Refused by nothing but a word of change, which says what is to be otherwise: "not as wide"."""
    small = text.lower()
    spans = [(c.start, c.end) for c in find_changes(small)]
    spans += [m.span() for m in _DISLIKED.finditer(small) if find_changes(m[0])]
    return frozenset(
        claim
        for mark in words.marks
        if mark.denied and any(a <= mark.start < b for a, b in spans)
        for entry in mark.entries
        for claim in entry.claims()
    )


def is_moved_away(gain: Gain, told: Sequence[Change]) -> bool:
    """Whether a step leads away from what is refused already."""
    moved = {
        "fit": ("chest",), "neckline": ("neck depth", "neck width"), "skirt_hem": ("length",),
        "sleeve_shape": ("sleeve width", "sleeve end", "sleeve head"),
        "skirt": ("tier gathers", "tiers", "gores", "godets", "skirt hem", "skirt gathers"),
    }  # fmt: skip
    steps = {change.quantity for change in told if isinstance(change, Step)}
    return bool(steps.intersection(moved.get(gain.claim.name, ())))


def without_gathers(told: Sequence[Change], held: Collection[Claim], facts: GarmentFacts) -> list[Change]:
    """With a gathered skirt cut smooth, where its gathers are refused or it is to be of a shape without any.

    Args:
        told: What is asked for.
        held: What is refused and true of the garment.
        facts: Of the garment.
    """
    shapes = {c.claim.value for c in told if isinstance(c, Gain) and c.claim.name == "skirt"}
    away = [c for c in told if isinstance(c, Step) and (c.quantity, c.direction) == ("skirt gathers", -1)]
    if facts.skirt is None or not _GATHERED.holds(facts) or any(c.amount is not None for c in away):
        return list(told)
    refuses = _GATHERED in held and (bool(away) or bool(shapes))
    if not refuses and (away or not shapes or not shapes <= _SMOOTH):
        return list(told)
    # A little more than there is: what is left of gathers is not near enough.
    smooth = Step("skirt gathers", -1, round(_ALL_OF_THEM * (facts.skirt.gather - 1.0), 2))
    return [*[c for c in told if c not in away], smooth]

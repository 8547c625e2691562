"""Which half of the body words of a text are about: sleeves are of the upper, legs of the lower."""

from __future__ import annotations

from typing import Literal, get_args

from swifttailor.wording.claim_kinds import fits_kind
from swifttailor.wording.lexicon import Entry, WordMark
from swifttailor.wording.lexicon.inflection import Language
from swifttailor.wording.lexicon.tokens import words_of
from swifttailor.wording.lexicon.vocabulary import vocabulary

Half = Literal["upper", "lower"]
HALVES: tuple[Half, ...] = get_args(Half)
_ON = {"upper": ("top",), "lower": ("trousers", "skirt")}
_KINDS = {"upper": frozenset({"top", "tunic"}), "lower": frozenset({"skirt", "trousers", "shorts"})}
_PARTS = {
    "upper": frozenset(
        "sleeves left_sleeve right_sleeve sleeve_head neckline back_neckline collar hood cuffs bodice "
        "shoulders bust armholes straps peplum".split()
    ),
    "lower": frozenset("legs left_leg right_leg leg_cuffs skirt seat thigh crotch".split()),
}
_OF_SLEEVES = frozenset({"sleeve_shape", "sleeve_head", "cuffs", "straps", "shoulders"})
"""What is told of with sleeves: there are none on straps."""
_COAT = ("coat", "parka", "mac", "duster", "kurta", "kurti", "kameez", "ao dai tunic")
_BODYSUIT = ("bodysuit", "body suit")
"""Names of what is cut like a dress and worn over the lower garment, and of what goes into it."""


def half_named(mark: WordMark) -> Half | None:
    """The half that a garment is worn on; None of one that covers both, and where that is not clear."""
    kinds = frozenset().union(*[entry.kinds for entry in mark.entries])
    for half in HALVES:
        if kinds and kinds <= _KINDS[half]:
            return half
    words = [(entry.english or mark.word).lower() for entry in mark.entries]
    worn = {"dress": _COAT, "playsuit": _BODYSUIT}.get(next(iter(kinds), "") if len(kinds) == 1 else "")
    return "upper" if worn and all(word.rstrip("s").endswith(worn) for word in words) else None


def half_told(mark: WordMark, language: Language) -> Half | None:
    """The only half that a word about details can be said of, in any of its meanings; None where either."""
    parts = words_of(mark.word.lower(), language)
    entries = [sense.entry for sense in vocabulary(language).find(parts)] or list(mark.entries)
    entries = [entry for entry in entries if entry.category not in ("function", "sizes")]
    halves = set().union(*[_halves(entry) for entry in entries])
    if mark.part is not None and mark.part not in (*_PARTS["upper"], *_PARTS["lower"]):
        return None
    return halves.pop() if len(halves) == 1 else None


def subjects(mark: WordMark) -> set[str]:
    """What a word about details tells something of: of a collar nothing tells how long sleeves are."""
    names = {each.claim.name for entry in mark.entries for each in entry.implied}
    parts = {entry.part for entry in mark.entries} | {mark.part}
    return {"sleeves" if name in _OF_SLEEVES else name for name in (*names, *parts) if name}


def _halves(entry: Entry) -> set[Half]:
    told = {half for half in HALVES if entry.part in _PARTS[half]}
    if told:
        return told
    claims = [claim.name for claim in entry.claims("certain", "usual") if claim.name != "kind"]
    said_of = {half for half in HALVES if entry.of & (_KINDS[half] | _PARTS[half])}
    fitting = {half for half in HALVES if any(all(fits_kind(c, k) for c in claims) for k in _ON[half])}
    return said_of & fitting or said_of or fitting

"""What details tell of the kind of a garment that no word names, and bands called after another place."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes.reader import Wish
from swifttailor.wishes.text.accounting import subjects_spoken_of
from swifttailor.wording.claim_kinds import fits_kind, implied_kind
from swifttailor.wording.lexicon import WordReading, exclude

_NAMES = ("garment", "like", "second")
_SKIRT = frozenset({"skirt"})
_LOWER = frozenset({"skirt", "trousers", "shorts"})
_DRESS = frozenset({"dress"})
_NO_LEGS = frozenset({"dress", "skirt", "top", "tunic"})
_OF_LEGS = frozenset({"legs", "leg_hem", "leg_cuffs", "inseam_cm", "leg_width_cm", "leg_cuff_cm"})
_UPPER = frozenset("sleeves sleeve_shape cuffs neckline neck_depth shoulders collar hood bodice".split())
_UPPER_PARTS = frozenset({"sleeves", "neckline", "collar"})
_OF_A_BODICE = re.compile(r"bust|bodice|chest|brust|oberteil|poitrine|busto|pecho|peito", re.IGNORECASE)
"""What tells that darts are those of a bodice: skirts have darts, too."""
_WAISTBAND, _HEM_BAND = Claim("waistband", "waist"), Claim("waistband", "hem")


def skirts_of_dresses(text: str, words: WordReading) -> str:
    """A text that names a skirt and speaks of sleeves or a neckline, as one about a dress with such a skirt.

    Args:
        text: As it is read.
        words: By the lexicon.
    """
    named = [mark for mark in words.marks if mark.role == "garment"]
    if not named or any(mark.role in ("like", "second", "theirs") or mark.denied for mark in words.marks):
        return text
    skirts = all(entry.kinds == _SKIRT for mark in named for entry in mark.entries)
    said = [
        i.claim
        for i in words.implications
        if i.said
        and i.certainty == "certain"
        and not (i.claim.name == "bodice" and not _OF_A_BODICE.search(text[i.mark.start : i.mark.end]))
    ]
    upper = any(claim.name in _UPPER and claim.value != "none" for claim in said)
    upper |= any(m.part in _UPPER_PARTS and m.role == "word" for m in words.marks)
    return f"dress, {text}" if skirts and upper else text


def without_wrong_kind(
    found: Sequence[Wish], measured: Sequence[Claim], words: WordReading
) -> tuple[Wish, ...]:
    """Without a kind that a network guesses and that cannot have what is said: no top has gores.

    Args:
        found: What was understood of a text.
        measured: What its numbers say.
        words: By the lexicon; where one of them names a garment, nothing is left out.
    """
    if any(mark.role in _NAMES for mark in words.marks):
        return tuple(found)
    details = [*measured, *[i.claim for i in words.implications if i.said and i.certainty == "certain"]]
    guessed = {w.change.claim.value for w in found if isinstance(w.change, Gain) and _is_kind(w.change)}
    wrong = {k for k in guessed if any(not fits_kind(claim.name, str(k)) for claim in details)}
    if not wrong:
        return tuple(found)
    meant = next(iter(implied_kind(details)), None)
    return tuple([w for w in found if not isinstance(w.change, Gain) or _fits(w.change, wrong, meant)])


def within_the_name(
    found: Sequence[Wish], words: WordReading, stated: Collection[Claim] = ()
) -> tuple[Wish, ...]:
    """Without what a network reads against the name of the garment, where no word speaks of it.

    A coverall has sleeves unless somebody says otherwise, whose it ever was. Words that nobody knows may be
    about sleeves, too, unless they are names.

    Args:
        found: What is read.
        words: By the lexicon.
        stated: What is read by rules, in words that the lexicon may not know as they stand.
    """
    if any(not word[:1].isupper() for word in words.unknown):
        return tuple(found)
    meant = [i.claim for i in words.implications if not i.said and i.certainty != "likely"]
    implied, spoken = {i.claim for i in words.implications}, subjects_spoken_of(words)
    named = [mark for mark in words.marks if mark.role == "garment" and not mark.denied]
    against = {claim for mark in named for entry in mark.entries for claim in entry.against}
    return tuple(
        [
            wish
            for wish in found
            if not isinstance(wish.change, Gain)
            or wish.change.claim in implied
            or wish.change.claim in stated
            or wish.change.claim.name in spoken
            or not (wish.change.claim in against or any(exclude(wish.change.claim, other) for other in meant))
        ]
    )


def fitting_the_name(found: Sequence[Wish], words: WordReading) -> tuple[Wish, ...]:
    """Without what trousers, shorts and skirts cannot have, where such a name alone says what is asked for.

    A detail never changes the kind: running shorts with slits at the sides are no skirt, and tailored
    trousers no jumpsuit.
    """
    named = [
        entry.kinds
        for mark in words.marks
        if mark.role == "garment" and not mark.denied
        for entry in mark.entries
    ]
    kinds = frozenset().union(*named)
    if kinds and kinds <= _NO_LEGS:
        found = [w for w in found if not (isinstance(w.change, Gain) and w.change.claim.name in _OF_LEGS)]
    if kinds == _DRESS:  # where it ends is told by its skirt
        told = {i.claim for i in words.implications}
        found = [w for w in found if not _is_network_hem(w, told)]
    heard = {w.change.claim.value for w in found if isinstance(w.change, Gain) and _is_kind(w.change)}
    if len(kinds) != 1 or not kinds <= _LOWER or not heard <= kinds or not all(named):
        return tuple(found)
    (kind,) = kinds
    return tuple([w for w in found if not isinstance(w.change, Gain) or fits_kind(w.change.claim.name, kind)])


def with_one_band(found: Sequence[Wish], words: WordReading) -> tuple[Wish, ...]:
    """Without a band at the waist where that of a jacket's hem is called a waistband."""
    said = {i.claim for i in words.implications if i.said and i.claim.name == "waistband"}
    if _HEM_BAND not in said or _WAISTBAND in said:
        return tuple(found)
    return tuple([wish for wish in found if wish.change != Gain(_WAISTBAND)])


def _is_network_hem(wish: Wish, told: Collection[Claim]) -> bool:
    """Whether a network alone says where a top ends."""
    claim = wish.change.claim if isinstance(wish.change, Gain) else None
    return claim is not None and claim.name == "top_hem" and claim not in told


def _is_kind(gain: Gain) -> bool:
    return gain.claim.name == "kind"


def _fits(gain: Gain, wrong: set[str | float], meant: str | None) -> bool:
    if _is_kind(gain):
        return gain.claim.value not in wrong
    return meant is None or fits_kind(gain.claim.name, meant)

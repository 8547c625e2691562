"""Garments that are loose as a whole: a loose dress has neither a waist seam nor a narrow skirt."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain
from swifttailor.describing.facts import GarmentFacts
from swifttailor.wishes.reader import Wish
from swifttailor.wording.lexicon import SURENESS

_LOOSE = frozenset([Claim("fit", "loose"), Claim("fit", "oversized")])
_KINDS = frozenset({"dress", "tunic", "top"})
_SHAPED = frozenset({"waist_seam", "bodice", "waistband", "rise"})
"""A text that speaks of any of these says how it is shaped."""
_PLAIN_SKIRTS = frozenset({"straight", "a-line", "flared"})
_SEAMS = tuple([Claim("waist_seam", value) for value in ("empire", "natural", "dropped")])
_NARROW = (Claim("skirt", "pencil"), Claim("skirt", "narrowing"), Claim("hips", "close"))
UNLIKELY = 0.1


def is_loose_whole(claims: Iterable[Claim], kind: str | None) -> bool:
    """Whether a garment is asked for that stands away from the body all the way down.

    Args:
        claims: What is asked for, and what the name of the garment usually means.
        kind: Of the garment.
    """
    told = list(claims)
    names = {claim.name for claim in told}
    if kind not in _KINDS or not _LOOSE & set(told) or names & _SHAPED:
        return False
    return (
        all(c.value in _PLAIN_SKIRTS for c in told if c.name == "skirt")
        and Claim("hips", "close") not in told
    )


def of_loose_wholes(wishes: Sequence[Wish], kind: str | None) -> tuple[Wish, ...]:
    """What such a garment is not likely to show, to choose known patterns by."""
    meant = [w for w in wishes if w.certainty >= SURENESS["usual"] and isinstance(w.change, Gain)]
    told = [w.change.claim for w in meant if isinstance(w.change, Gain)]
    if not is_loose_whole(told, kind):
        return ()
    found = [*_SEAMS, Claim("bodice", "darted"), *_NARROW]
    return tuple([Wish(Gain(claim), UNLIKELY) for claim in found if claim not in told])


def loosened(said: Sequence[Change], facts: GarmentFacts) -> tuple[Change, ...]:
    """What is to be cut for it: no darts, room at the hips, no slit.

    Args:
        said: What is asked for or likely meant.
        facts: What the garment shows now.
    """
    claims = [wish.claim for wish in said if isinstance(wish, Gain)]
    names = {claim.name for claim in claims}
    if not is_loose_whole(claims, facts.kind):
        return ()
    wanted = []
    if facts.torso is not None and facts.torso.darts:
        wanted.append(Claim("bodice", "undarted"))
    if facts.kind == "dress" and facts.skirt is not None and not names & {"hips", "skirt"}:
        wanted.append(Claim("hips", "loose"))
    if facts.skirt is not None and facts.skirt.slits and not names & {"slit", "slit_cm", "slit_size"}:
        wanted.append(Claim("slit", "none"))
    return tuple([Gain(claim) for claim in wanted if not claim.holds(facts)])

"""Which of the wishes that were read are certain enough to cut for."""

from __future__ import annotations

from collections.abc import Sequence

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes.reader import SURE, Wish
from swifttailor.wording.lexicon import exclude

_NONE = "none"
_ON_A_SCALE = frozenset({"skirt_hem", "top_hem", "leg_hem", "sleeves", "fit", "neck_depth", "back_depth"})
"""What has one value alone, of which the next is another."""


def likely_wishes(found: Sequence[Wish]) -> tuple[Wish, ...]:
    """Wishes that are not sure, only likelier than not, where nothing else is read of the same thing.

    They are cut last, where that costs nothing that is asked for; left undone they are no fault.
    """
    claims = [w.change.claim for w in found if isinstance(w.change, Gain)]
    likely = [
        w
        for w in found
        if w.certainty < SURE and isinstance(w.change, Gain) and isinstance(w.change.claim.value, str)
    ]
    return tuple(w for w in likely if isinstance(w.change, Gain) and _is_alone(w.change.claim, claims))


def _is_alone(claim: Claim, claims: Sequence[Claim]) -> bool:
    """Whether nothing else is read of the same thing, but for what can be true together with it."""
    others = [other for other in claims if other.name == claim.name and other != claim]
    if claim.name in _ON_A_SCALE and next(other for other in claims if other.name == claim.name) != claim:
        return False
    if claim.name == "neckline" and any(other.name == "straps" for other in claims):
        return False  # what hangs on straps ends straight between them, unless a word says otherwise
    return claims.count(claim) == 1 and not any(exclude(claim, other) for other in others)


def sure_wishes(found: Sequence[Wish]) -> tuple[Wish, ...]:
    """Wishes that are certain enough to cut for, without those that contradict themselves.

    Who reads both that there is to be none of something and how it is to be has misunderstood.
    """
    values: dict[str, set[object]] = {}
    for wish in found:
        if isinstance(wish.change, Gain):
            values.setdefault(wish.change.claim.name, set()).add(wish.change.claim.value)
    confused = {name for name, said in values.items() if _NONE in said and len(said) > 1}
    return tuple(
        wish
        for wish in found
        if wish.certainty >= SURE
        and not (isinstance(wish.change, Gain) and wish.change.claim.name in confused)
    )

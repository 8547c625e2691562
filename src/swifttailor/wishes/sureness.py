"""Which of the wishes that were read are certain enough to cut for."""

from __future__ import annotations

from collections.abc import Sequence

from swifttailor.describing.differences import Gain
from swifttailor.wishes.reader import SURE, Wish

_NONE = "none"


def likely_wishes(found: Sequence[Wish]) -> tuple[Wish, ...]:
    """Wishes that are not sure, only likelier than not, where nothing else is read of the same thing.

    They are cut last, where that costs nothing that is asked for; left undone they are no fault.
    """
    spoken = [w.change.claim.name for w in found if isinstance(w.change, Gain)]
    likely = [
        w
        for w in found
        if w.certainty < SURE and isinstance(w.change, Gain) and isinstance(w.change.claim.value, str)
    ]
    return tuple(w for w in likely if isinstance(w.change, Gain) and spoken.count(w.change.claim.name) == 1)


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

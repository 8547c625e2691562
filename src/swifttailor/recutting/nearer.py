"""Steps towards what cannot be reached: trousers that cannot be cut wide can be cut wider."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from swifttailor.describing.differences import Change, Gain, Step, subject_of

_TOWARDS: Mapping[tuple[str, str], tuple[str, int]] = {
    ("fit", "close"): ("chest", -1),
    ("fit", "easy"): ("chest", -1),
    ("fit", "loose"): ("chest", 1),
    ("fit", "oversized"): ("chest", 1),
    ("legs", "wide"): ("leg end", 1),
    ("legs", "flared"): ("leg end", 1),
    ("legs", "tapered"): ("leg end", -1),
    ("legs", "slim"): ("leg end", -1),
    ("skirt", "pencil"): ("skirt hem", -1),
    ("skirt", "narrowing"): ("skirt hem", -1),
    ("skirt", "straight"): ("skirt hem", -1),
    ("skirt", "flared"): ("skirt hem", 1),
    ("skirt", "half circle"): ("skirt hem", 1),
    ("skirt", "three-quarter circle"): ("skirt hem", 1),
    ("skirt", "circle"): ("skirt hem", 1),
    ("skirt", "more than a circle"): ("skirt hem", 1),
    ("sleeve_shape", "wide"): ("sleeve width", 1),
    ("sleeve_shape", "balloon"): ("sleeve width", 1),
    ("sleeve_shape", "bell"): ("sleeve end", 1),
    ("sleeve_shape", "puffed"): ("sleeve head", 1),
    ("sleeve_shape", "slim"): ("sleeve width", -1),
    ("waist_seam", "empire"): ("bodice length", -1),
    ("waist_seam", "dropped"): ("bodice length", 1),
    ("neck_depth", "high"): ("neck depth", -1),
    ("neck_depth", "low"): ("neck depth", 1),
    ("neck_depth", "plunging"): ("neck depth", 1),
}


_PARTS, _LESS = (0.75, 0.5), (0.3, 0.15)
"""How much of a step is tried that cannot be done in full; still less where something is to shrink."""


def towards(open_wishes: Sequence[Change], asked: Sequence[Change]) -> list[Step]:
    """Steps that lead towards wishes that do not hold, where nothing else is asked of the same measure.

    Args:
        open_wishes: Wishes that no cut makes hold.
        asked: All wishes.
    """
    told = {subject_of(change) for change in asked}
    found = []
    for wish in open_wishes:
        if isinstance(wish, Step) and wish.amount is not None:
            parts = (*_PARTS, *_LESS) if wish.direction < 0 else _PARTS
            found += [Step(wish.quantity, wish.direction, round(part * wish.amount, 2)) for part in parts]
            continue
        way = _TOWARDS.get((wish.claim.name, str(wish.claim.value))) if isinstance(wish, Gain) else None
        if way is not None and way[0] not in told:
            found.append(Step(*way))
    return found

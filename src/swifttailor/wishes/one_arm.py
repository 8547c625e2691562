"""How long sleeves are is said of the arm that has the only one: "one shoulder, long sleeve"."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain
from swifttailor.wishes.reader import Wish
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


def of_two_arms(found: Iterable[Wish]) -> tuple[Wish, ...]:
    """The same wishes without what is said of both sleeves, where each has a length of its own."""
    found = tuple(found)
    claims = {w.change.claim.name: w.change.claim.value for w in found if isinstance(w.change, Gain)}
    left, right = (claims.get(f"{side}_sleeve") for side in ("left", "right"))
    if left is None or right is None or left == right:
        return found
    kept = [w for w in found if not (isinstance(w.change, Gain) and w.change.claim.name == "sleeves")]
    return (*kept, Wish(Gain(Claim("sleeves", "unequal")), 0.9))


def _side(changes: Iterable[Change]) -> str | None:
    """The arm with the only sleeve; None where there are two, or none."""
    claims = {change.claim for change in changes if isinstance(change, Gain)}
    for side, only, bare in (("left", _LEFT, "bare right"), ("right", _RIGHT, "bare left")):
        if only in claims or Claim("shoulders", bare) in claims:
            return side
    return None

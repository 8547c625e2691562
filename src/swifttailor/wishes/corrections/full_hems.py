"""Shapes of skirts that figures speak against: a hem of four metres is that of no straight skirt."""

from __future__ import annotations

from collections.abc import Iterable

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes.reader import Wish

_FULL_CM = 170.0
_CLOSE = frozenset({Claim("skirt", "straight"), Claim("skirt", "pencil"), Claim("skirt", "narrowing")})
_TIERED, _GATHERED = Claim("skirt", "tiered"), Claim("skirt", "gathered")


def shapes_by_figures(found: Iterable[Wish]) -> tuple[Wish, ...]:
    """Without close skirts where a hem is told to be full, and gathers where tiers are counted."""
    wishes = tuple(found)
    claims = {wish.change.claim for wish in wishes if isinstance(wish.change, Gain)}
    full = any(c.name == "hem_cm" and not isinstance(c.value, str) and c.value >= _FULL_CM for c in claims)
    gone = _CLOSE if full else frozenset()
    if _TIERED in claims and any(claim.name == "tiers" for claim in claims):
        gone |= {_GATHERED}
    return tuple([w for w in wishes if not isinstance(w.change, Gain) or w.change.claim not in gone])

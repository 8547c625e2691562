"""Named drafts of swimsuits with the neck and the back that are asked for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft

_LIKE_A_SWIMSUIT = {"stretch": 14.0, "sleeves": False, "armhole_drop": 2.0, "back_neck_depth": 14.0}
_SQUARE_NECK = {"neckline": "square", "neck_widening": 5.0, "neck_depth": 15.0}
_PLUNGING_NECK = {"neckline": "v", "neck_widening": 4.5, "neck_depth": 22.0}
_SCOOPED_NECK = {"neck_widening": 4.5, "neck_depth": 15.0}
_HIGH_NECK = {"neck_widening": 0.5, "neck_depth": 8.5, "strap_width": 5.0}
_HALTER = {"halter": True, "strap_width": 3.5}
_BACKS = {Claim("back_depth", "low"): 30.0, Claim("back_depth", "open"): 36.0}
"""Fall of backs that are seen to be low: those on straps run straight below the shoulder blades, cm."""
_ONE_PIECES = ("swimsuit", "bodysuit")
_HIGH_CM = 8.0
"""Fall of the front of a halter whose neck is high, cm."""
_HIGH_NECKS = frozenset(
    {
        Claim("neck_depth", "high"),
        Claim("collar", "stand"),
        Claim("neckline", "crew"),
        Claim("neckline", "round"),
    }
)
_TANK_STRAPS = Claim("straps", "wide")
_ON_TANK_STRAPS = {"sleeves": False, "strap_width": 4.5, "neck_widening": 3.0}
_TANK_NECK = {"neck_depth": 15.0}
_STRAPS = frozenset({Claim("straps", "narrow"), Claim("shoulders", "strapless")})


def swimsuit_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A swimsuit cut like a bodysuit, where a neck or a back is asked for that none on straps has.

    Args:
        draft: A swimsuit, as a table names it.
        claims: What is asked for, all of it.
    """
    depths = [cm for claim, cm in _BACKS.items() if claim in claims]
    back = {"back_neck_depth": max(depths)} if depths else {}
    if Claim("neckline", "square") in claims:
        neck = _SQUARE_NECK
    elif Claim("neck_depth", "plunging") in claims:
        neck = _PLUNGING_NECK
    elif not _HIGH_NECKS.isdisjoint(claims) and _STRAPS.isdisjoint(claims):
        neck = _HIGH_NECK
    elif (back or _TANK_STRAPS in claims) and _STRAPS.isdisjoint(claims):
        neck = _SCOOPED_NECK
    else:
        return draft
    return NamedDraft("bodysuit", tuple({**_LIKE_A_SWIMSUIT, **neck, **back}.items()))


def on_a_halter(drafts: Sequence[NamedDraft], claims: Sequence[Claim]) -> list[NamedDraft]:
    """Drafts of which a one-piece and a halter are one: a bodysuit with a halter neck has no legs.

    Args:
        drafts: What a text names.
        claims: What is asked for, all of it.
    """
    suits = [draft for draft in drafts if draft.name in _ONE_PIECES]
    if not suits or not any(draft.name == "halter-jumpsuit" for draft in drafts):
        return [*drafts]
    own = dict(suits[0].options) if suits[0].name == "swimsuit" else {}
    high = {} if _HIGH_NECKS.isdisjoint(claims) else {"neck_depth": _HIGH_CM}
    return [NamedDraft("swimsuit", tuple({**own, **_HALTER, **high}.items()))]


def on_tank_straps(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A bodysuit without sleeves whose straps are to be broad: they are no shoulders; others as they are.

    Args:
        draft: As a table names it.
        claims: What is asked for, all of it.
    """
    if draft.name != "bodysuit" or _TANK_STRAPS not in claims:
        return draft
    options = {**_TANK_NECK, **dict(draft.options), **_ON_TANK_STRAPS}
    return replace(draft, options=tuple(options.items()))

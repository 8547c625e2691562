"""What goes without saying: a T-shirt has no hood, trousers reach the feet."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain
from swifttailor.describing.facts import GarmentFacts

COVERED_BELOW_CROTCH_CM = 9.0
"""A skirt reaches at least this far below the crotch, however short it is asked for."""


@dataclass(frozen=True)
class _Usual:
    """What one thing is usually like, unless something is said about it."""

    kinds: frozenset[str]
    """Kinds of garments, as facts name them; any when empty."""
    unless: frozenset[str]
    """Names of claims: a text that speaks of any of these has said what is wanted."""
    accepted: tuple[str, ...]
    """Values of `name` that are usual; the first is cut if none holds."""
    name: str


def _usual(name: str, accepted: str, *, kinds: str = "", unless: str = "") -> _Usual:
    values = tuple(accepted.split(","))
    return _Usual(frozenset(kinds.split()), frozenset([name, *unless.split()]), values, name)


_LENGTHS = "length_cm skirt_length_cm inseam_cm leg_hem skirt_hem top_hem"
_USUAL = (
    _usual("hood", "none", kinds="top dress jumpsuit"),
    _usual("leg_hem", "full,ankle", kinds="trousers jumpsuit", unless=_LENGTHS),
    _usual(
        "skirt_hem", "knee,above the knee,below the knee,midi,maxi,mini", kinds="skirt dress", unless=_LENGTHS
    ),
    _usual("leg_cuffs", "none", kinds="trousers jumpsuit", unless="leg_cuff_cm"),
    _usual("slit", "none,back", kinds="skirt dress", unless="slit_size slit_cm"),
    _usual("top_hem", "hip,long", kinds="top", unless=f"{_LENGTHS} waistband"),
)
_ODD_SLITS = ("front", "left", "right")
"""Beside one behind, too, which is usual alone."""
_SHORT_LEGS = frozenset({"shorts", "playsuit"})
_UNEVEN = frozenset({"hem_shape", "sides", "slit_size"})
_SKIRTS = frozenset({"skirt", "dress"})


def unsaid_wishes(said: Sequence[Change], facts: GarmentFacts) -> tuple[Change, ...]:
    """What should hold for a garment although nobody asked for it.

    Args:
        said: What was asked for.
        facts: What the garment shows now; it decides which of several usual things is nearest.
    """
    claims = [wish.claim for wish in said if isinstance(wish, Gain)]
    names = {claim.name for claim in claims}
    short = any(c.name == "kind" and c.value in _SHORT_LEGS for c in claims)
    found: list[Gain] = []
    for usual in _USUAL:
        if (usual.kinds and facts.kind not in usual.kinds) or usual.unless & names:
            continue
        if (usual.name == "leg_hem" and short) or (usual.name == "slit" and facts.skirt is None):
            continue
        odd = usual.name == "slit" and any(Claim("slit", place).holds(facts) for place in _ODD_SLITS)
        if odd or not any(Claim(usual.name, value).holds(facts) for value in usual.accepted):
            found.append(Gain(Claim(usual.name, usual.accepted[0])))
    covering = _covering(names, facts)
    if covering is not None:
        found = [*(w for w in found if w.claim.name != "skirt_hem"), covering]
    return tuple(found)


def leaves_hem_unsaid(said: Sequence[Change]) -> bool:
    """Whether nothing is said about how a hem runs, so that it should be level."""
    return not any(isinstance(wish, Gain) and wish.claim.name in _UNEVEN for wish in said)


def _covering(names: set[str], facts: GarmentFacts) -> Gain | None:
    """The length of a skirt that covers, where it does not."""
    hem, skirt = facts.hem, facts.skirt
    if facts.kind not in _SKIRTS or hem is None or skirt is None or names & {"length_cm", "skirt_length_cm"}:
        return None
    wanted = facts.body.crotch - COVERED_BELOW_CROTCH_CM
    if hem.level <= wanted + 1.0:
        return None
    if "skirt_hem" not in names:
        return Gain(Claim("skirt_hem", "above the knee"))
    length = facts.length if facts.kind == "skirt" else skirt.length
    return Gain(Claim("skirt_length_cm", round(length + hem.level - wanted, 1)))

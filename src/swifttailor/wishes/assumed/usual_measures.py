"""Measures that garments usually have where nobody speaks of them, to choose known patterns by."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes.reader import Wish
from swifttailor.wording.lexicon import SURENESS

_UPPER = frozenset({"top", "tunic", "dress", "jumpsuit", "playsuit"})
_NECKS = frozenset(
    {"neckline", "left_neckline", "right_neckline", "neck_depth", "neck_depth_cm", "hood", "collar"}
    | {"back_neckline", "back_depth", "back_depth_cm", "straps"}
)
_STAND = Claim("collar", "stand")
_STANDING = frozenset([_STAND, Claim("collar", "turtleneck")])
_TIERED = frozenset([Claim("skirt", "tiered"), Claim("skirt", "gathered tiers")])
_CLOSE_BASE = frozenset([Claim("skirt", "fitted base"), Claim("skirt", "pencil"), Claim("hips", "close")])
_LOOSE = frozenset([Claim("waistband", "loose"), Claim("rise", "low"), Claim("rise", "mid")])
CLOSE_NECK: Mapping[str, tuple[float, float]] = {"neck width": (17.0, 1.5), "neck depth": (10.0, 3.0)}
"""Of what a collar stands on: middle and width of a distribution, cm."""
LOW_STAND: Mapping[str, tuple[float, float]] = {"collar height": (4.0, 1.0)}
"""Of a stand in place of the collar of a shirt; one that is asked for may be higher."""
FULL_GATHERS: Mapping[str, tuple[float, float]] = {"skirt gathers": (2.0, 0.2)}
"""Of a gathered skirt: what is gathered over what it is sewn to."""
FULL_TIERS: Mapping[str, tuple[float, float]] = {"base width": (145.0, 15.0)}
"""Of tiers: the lower edge of the first row. A close one makes a flounce at the hem of the rest."""
OPEN_NECK: Mapping[str, tuple[float, float]] = {
    "neck depth": (14.0, 4.0),
    "neck width": (20.5, 2.5),
    "back depth": (6.0, 4.0),
}
"""Of a neckline of which nobody speaks."""
AT_THE_WAIST: Mapping[str, tuple[float, float]] = {"waistband width": (84.3, 2.5)}
"""Of a band on the default body."""


def usual_measures(wishes: Iterable[Wish], kind: str | None) -> dict[str, tuple[float, float]]:
    """What measures should rather be.

    Args:
        wishes: What is asked for and what is likely.
        kind: Of the garment; None where it is not known.

    Returns:
        For each measure (`measure_labels`) its middle and the width of its distribution, cm or a ratio.
    """
    told = {w.change.claim: w.certainty for w in wishes if isinstance(w.change, Gain)}
    claims = set(told)
    names = {claim.name for claim in claims}
    found: dict[str, tuple[float, float]] = {}
    if claims & _STANDING and not names & {"neck_depth", "neck_depth_cm"}:
        found |= CLOSE_NECK
    if told.get(_STAND, 1.0) < SURENESS["certain"]:
        found |= LOW_STAND
    if Claim("skirt", "gathered") in claims:
        found |= FULL_GATHERS
    if claims & _TIERED and not claims & _CLOSE_BASE:
        found |= FULL_TIERS
    if kind in ("trousers", "shorts", "skirt") and "waistband" in names and not claims & _LOOSE:
        found |= AT_THE_WAIST
    return found


def usual_necks(wishes: Iterable[Wish], kind: str | None) -> Mapping[str, tuple[float, float]]:
    """What a neckline should rather measure of which nobody speaks; nothing where somebody does.

    Args:
        wishes: What is asked for and what is likely.
        kind: Of the garment; None where it is not known.
    """
    claims = [w.change.claim for w in wishes if isinstance(w.change, Gain)]
    bare = any(claim.name == "shoulders" and claim.value != "both" for claim in claims)
    spoken = bare or any(claim.name in _NECKS for claim in claims)
    return OPEN_NECK if kind in _UPPER and not spoken else {}

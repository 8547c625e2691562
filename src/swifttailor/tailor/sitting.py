"""How a garment will sit, by its measures: what stands off the body, and what does not go over it."""

from __future__ import annotations

from collections.abc import Sequence

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain
from swifttailor.describing.facts import GarmentFacts

CLOSE_NECK_CM, CLOSE_NECK_DEPTH_CM = 10.75, 16.0
"""Half the width of a neckline and its depth in front, at most, for a collar on it to stand at the neck."""
FALLS_OFF = "its waistband is wider than the hips"
"""What nobody wears, whatever else is as it was asked for."""
TOO_NARROW_CM = 4.0
"""So much narrower than the hips nothing goes over them."""
LOOSE_BAND_CM = 8.0
"""So much wider than the waist a band stands off, or slides down."""


def sits_badly(
    facts: GarmentFacts, said: Sequence[Change], *, cloth_stretch: float = 0.0, drafted: bool = False
) -> tuple[str, ...]:
    """What a customer would send back although all that was asked for is so.

    Args:
        facts: Of the garment.
        said: What is asked for or likely meant: what of this is spoken of is no fault.
        cloth_stretch: See `Pattern.cloth_stretch`.
        drafted: Whether it is a draft that the words name: a collar of such stands away only where it is to.

    Returns:
        Each in words; empty where nothing is.
    """
    claims = [wish.claim for wish in said if isinstance(wish, Gain)]
    names = {claim.name for claim in claims}
    found = []
    collar, neck, band, body = facts.collar, facts.front_neck, facts.waistband, facts.body
    if collar is not None and collar.kind == "stand" and neck is not None and not drafted:
        wide = neck.width > CLOSE_NECK_CM or neck.depth > CLOSE_NECK_DEPTH_CM
        if wide and not names & {"neck_depth", "neck_depth_cm"}:
            found.append("its collar stands away from the neck")
    lower = facts.trousers or facts.skirt
    hem = facts.hem
    # What covers the front alone, as an apron does, goes around no hips.
    reaches = hem is not None and hem.level < body.hips - 5.0 and hem.back < body.hips
    # Nor do hips that briefs leave bare at the sides.
    reaches = reaches and not (facts.trousers is not None and facts.trousers.thigh <= 0)
    gives = 1 + cloth_stretch
    if lower is not None and reaches and gives * lower.hips < body.hip_girth - TOO_NARROW_CM:
        found.append("it is narrower than the hips")
    if band is not None and facts.torso is None and band.upper > body.waist_girth + LOOSE_BAND_CM:
        if not names & {"rise", "waistband"} or _plain_band(claims):
            found.append("its waistband is wider than the waist")
        elif band.upper > body.hip_girth + LOOSE_BAND_CM and Claim("waistband", "loose") not in claims:
            found.append(FALLS_OFF)
    return tuple(found)


def _plain_band(claims: Sequence[object]) -> bool:
    """Whether nothing is said of a band but that there is one."""
    spoken = [c for c in claims if getattr(c, "name", "") in ("rise", "waistband")]
    return all(getattr(c, "value", "") in ("waist", "narrow", "wide", "high") for c in spoken)

"""One slit of several that is closed: "no slit in front" leaves the one behind."""

from __future__ import annotations

from collections.abc import Sequence

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.describing.facts import GarmentFacts
from swifttailor.wishes.reader import Wish

_NO_SLIT = Gain(Claim("slit", "none"))


def closed_alone(wishes: Sequence[Wish], refused: Sequence[Claim], facts: GarmentFacts) -> list[Wish]:
    """Puts the closing of single slits in place of that of all, where others are not spoken of.

    Args:
        wishes: What is heard.
        refused: What is refused.
        facts: Of the garment.
    """
    gone = {claim.value for claim in refused if claim.name == "slit"}
    slits = facts.skirt.slits if facts.skirt else ()
    of_these = [slit for slit in slits if slit.place in gone]
    if not of_these or len(of_these) == len(slits):
        return list(wishes)
    found = []
    for wish in wishes:
        if wish.change != _NO_SLIT:
            found.append(wish)
            continue
        found += [Wish(Step(f"{slit.place} slit", -1, slit.height), wish.certainty) for slit in of_these]
    return found

"""Drafts that are kept although they lack a detail: no other source knows their kind of garment.

Who asks for a jacket with cuffs wants a jacket. Known patterns and read designs have cuffs, and are not open
in front, have no lapels and no ribbed bands: a draft without the cuffs, and that said, is nearer.
"""

from __future__ import annotations

from swifttailor.describing.differences import Gain
from swifttailor.tailor.answer import Answer

OF_NO_OTHER_SOURCE = frozenset(
    {"blazer", "coat", "hooded-coat", "cape", "poncho", "robe", "kaftan", "cardigan", "hoodie", "sweatshirt"}
    | {"bomber-jacket", "denim-jacket", "waistcoat", "dungarees", "pinafore", "apron"}
)
"""Drafts whose openings, collars and bands make them the garment that they are."""
DETAILS = frozenset(
    {
        "cuffs",
        "cuff_cm",
        "waist_seam",
        "sleeve_shape",
        "armholes",
        "bodice",
        "neckline",
        "left_neckline",
        "right_neckline",
    }
    | {"neck_depth", "back_depth", "back_neckline", "hem_shape", "waistband", "straps", "rise"}
)
"""Names of claims that matter less than what the garment is."""
_SHIRT, _DETAILS_OF_SHIRTS = "shirt", frozenset({"bodice"})
"""Other sources know shirts, too, but none with its collar: to lack these alone is no reason for theirs."""


def keeps_its_kind(answer: Answer) -> bool:
    """Whether an answer is such a draft, sound, and lacks no more than details.

    Args:
        answer: Prepared to be sewn, as far as it can be.
    """
    verdict = answer.verdict
    if answer.drafted is None or answer.prepared is None or verdict.unsound or verdict.refused:
        return False
    lacking = [change.claim.name if isinstance(change, Gain) else "" for change in verdict.open]
    if answer.draft == _SHIRT:
        return bool(lacking) and _DETAILS_OF_SHIRTS.issuperset(lacking)
    return answer.draft in OF_NO_OTHER_SOURCE and bool(lacking) and DETAILS.issuperset(lacking)

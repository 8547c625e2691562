"""What is asked for because a picture shows it; words outrank pictures."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from swifttailor.describing.claims import CLAIM_TYPES, Claim
from swifttailor.describing.differences import Gain
from swifttailor.describing.dimensions import DIMENSIONS
from swifttailor.picture_reader.reading import Measure, PartReading
from swifttailor.wishes.reader import Wish
from swifttailor.wording.claim_kinds import fits_kind

LEAST_SEEN = 0.5
"""What is less sure is not asked for."""
LEAST_CUT = 0.7
"""What is less sure is not cut: what is cut wrongly takes a known pattern further from the garment than its
other statements bring it near."""
LEAST_CUT_OF_DRAFT = 0.97
"""The same of a draft whose design was read: it follows from all that was seen, and where one statement does
not hold of it, the others speak against that."""
_HALF = math.log(2)


def seen_wishes(part: PartReading) -> tuple[Wish, ...]:
    """What a garment should be to look like that in a picture, surest first.

    Of each claim the likeliest words; and of measures those that are likelier than not as near as a stated
    number has to be.
    """
    found: dict[str, Wish] = {}
    for statement in part.statements:  # surest first
        name = statement.claim.name
        if statement.certainty >= LEAST_SEEN and name not in found:
            found[name] = Wish(Gain(statement.claim), statement.certainty)
    for measure in part.measures:
        claim, certainty = _stated(measure)
        if claim is not None and certainty >= LEAST_SEEN:
            found[claim.name] = Wish(Gain(claim), certainty)
    return tuple(sorted(found.values(), key=lambda wish: -wish.certainty))


def _stated(measure: Measure) -> tuple[Claim | None, float]:
    """A measure as a claim, and how sure it is that it would be judged right."""
    how = DIMENSIONS[measure.name].stated
    if how is None or measure.value < max(how.least, CLAIM_TYPES[how.claim].least):
        return None, 0.0
    counted = DIMENSIONS[measure.name].unit == "pieces"
    value = round(measure.value) if counted else round(measure.value, 1)
    within = max(how.within, how.share * value, 0.5 if counted else 0.0)
    width = max(measure.off, 1e-6) / _HALF
    return Claim(how.claim, float(value)), measure.certainty * (1 - math.exp(-within / width))


def not_overruled(seen: Iterable[Wish], said: Sequence[Wish]) -> tuple[tuple[Wish, ...], tuple[Wish, ...]]:
    """What of a picture still counts beside words, and what does not.

    Words about a thing replace what the picture shows of it; and where they name a kind of garment, that kind
    has nothing of what it cannot have. Nothing is replaced where both say the same, or where the picture
    says that there is none of what that kind never has.
    """
    claims = [wish.change.claim for wish in said if isinstance(wish.change, Gain)]
    names = {claim.name for claim in claims}
    names |= {other for name in names for other in _SAME.get(name, ())}
    names |= {other for claim in claims for other in _WITHOUT.get(claim, ())}
    kinds = [str(claim.value) for claim in claims if claim.name == "kind"]
    kept, overruled = [], []
    for wish in seen:
        assert isinstance(wish.change, Gain)
        claim = wish.change.claim
        fits = all(fits_kind(claim.name, kind) for kind in kinds)
        if claim in claims or (not fits and claim.value == "none"):
            continue
        (kept if claim.name not in names and fits else overruled).append(wish)
    return tuple(kept), tuple(overruled)


def _same_thing() -> dict[str, frozenset[str]]:
    """Claims that speak of one thing, in words or in centimetres."""
    groups = (
        "sleeves sleeve_cm left_sleeve right_sleeve",
        "sleeve_shape sleeve_width_cm",
        "cuffs cuff_cm",
        "skirt_hem skirt_length_cm length_cm",
        "top_hem length_cm",
        "leg_hem inseam_cm",
        "legs leg_width_cm",
        "leg_cuffs leg_cuff_cm",
        "skirt hem_cm tiers gores godets godet_cm",
        "neckline left_neckline right_neckline",
        "neck_depth neck_depth_cm",
        "back_depth back_depth_cm",
        "waistband waistband_cm",
        "slit slit_size slit_cm",
        "collar collar_cm",
        "fit chest_cm",
    )
    same: dict[str, frozenset[str]] = {}
    for group in groups:
        names = frozenset(group.split())
        assert names <= CLAIM_TYPES.keys(), names - CLAIM_TYPES.keys()
        for name in names:
            same[name] = same.get(name, frozenset()) | names - {name}
    return same


_SAME = _same_thing()
_SLEEVES = frozenset("sleeve_shape sleeve_width_cm cuffs cuff_cm".split())
_NECK = frozenset("neckline left_neckline right_neckline neck_depth neck_depth_cm straps collar hood".split())
_WITHOUT = {
    Claim("sleeves", "none"): _SLEEVES,
    Claim("shoulders", "strapless"): _SLEEVES | _NECK | {"sleeves", "sleeve_cm", "armholes"},
    Claim("hood", "hood"): frozenset(["collar", "neckline"]),
}
"""What a garment of which this is said has not."""

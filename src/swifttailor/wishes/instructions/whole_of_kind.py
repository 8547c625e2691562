"""What the network for people's own words reads, as the garment that is to change can have it.

The network reads a text alone and is not told what garment it is about: of "a touch longer" it says that a
hem is to be longer, of shorts as of a skirt. What a garment lacks is read as what it has instead.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import prod

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain, Step, subject_of
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.describing.facts import GarmentFacts
from swifttailor.wording.claim_kinds import fits_kind

_INSTEAD: Mapping[str, tuple[str, ...]] = {
    "length": ("leg length",),
    "leg length": ("length",),
    "skirt hem": ("leg end", "top width"),
    "leg end": ("skirt hem",),
    "base width": ("thigh", "top width"),
    "thigh": ("skirt hem",),
    "top width": ("skirt hem",),
}
"""What a garment may have of which the same is said; the first that it has."""
_LEGS_OF_SKIRTS = {
    "micro": "very short", "mini": "mid-thigh", "above the knee": "thigh", "knee": "knee",
    "below the knee": "calf", "midi": "calf", "maxi": "ankle", "ankle": "ankle", "floor": "full",
}  # fmt: skip
_SKIRTS_OF_LEGS = {
    "very short": "micro", "mid-thigh": "mini", "thigh": "above the knee", "knee": "knee",
    "calf": "midi", "ankle": "ankle", "full": "floor",
}  # fmt: skip
_CLAIM_INSTEAD: Mapping[str, tuple[str, Mapping[str, str] | None]] = {
    "skirt_hem": ("leg_hem", _LEGS_OF_SKIRTS),
    "leg_hem": ("skirt_hem", _SKIRTS_OF_LEGS),
    "cuffs": ("leg_cuffs", None),
}
"""Claims of which other garments have the like, and their words for it; None where these are the same."""
_MAY_BE_ANOTHERS = frozenset(
    [
        *_INSTEAD,
        *[other for some in _INSTEAD.values() for other in some],
        *_CLAIM_INSTEAD,
        *[other for other, _ in _CLAIM_INSTEAD.values()],
    ]
)
"""What changes are about that may become others, or what others become."""


def with_hems_of_kind(told: Sequence[Change]) -> list[Change]:
    """Hems as the garment has them that is to be made: of "as a skirt to the ankle" that of the skirt.

    Args:
        told: What is asked for.
    """
    kinds = [str(c.claim.value) for c in told if isinstance(c, Gain) and c.claim.name == "kind"]
    found: list[Change] = []
    for change in told:
        name = change.claim.name if isinstance(change, Gain) else ""
        other, words = _CLAIM_INSTEAD.get(name, ("", None))
        if isinstance(change, Gain) and words and kinds and not fits_kind(name, kinds[0]):
            change = Gain(Claim(other, words[str(change.claim.value)]))
        found.append(change)
    return found


def of_kind(whole: Mapping[Change, float], kind: str, facts: GarmentFacts) -> dict[Change, float]:
    """How likely each wish is meant, about a garment of this kind; those that become the same count together.

    Args:
        whole: By the network, which does not know the garment.
        kind: What it is called.
        facts: Of it.
    """
    found: dict[Change, float] = {}
    joined: dict[Change, list[float]] = {}
    for change, chance in whole.items():
        if subject_of(change) not in _MAY_BE_ANOTHERS:
            found[change] = chance
            continue
        had = _as_had(change, kind, facts)
        if had in found:
            joined.setdefault(had, [found[had]]).append(chance)
        else:
            found[had] = chance
    return found | {change: 1 - prod(1 - chance for chance in chances) for change, chances in joined.items()}


def _as_had(change: Change, kind: str, facts: GarmentFacts) -> Change:
    if isinstance(change, Step):
        instead = _INSTEAD.get(change.quantity, ())
        if not instead or QUANTITIES[change.quantity].of(facts) is not None:
            return change
        for other in instead:
            if QUANTITIES[other].of(facts) is not None:
                return replace(change, quantity=other)
        return change
    name, words = _CLAIM_INSTEAD.get(change.claim.name, ("", None))
    if not name or fits_kind(change.claim.name, kind) or not fits_kind(name, kind):
        return change
    value = str(change.claim.value)
    return Gain(Claim(name, value if words is None else words.get(value, value)))

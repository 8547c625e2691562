"""What nobody asked to change: parts of a garment that wishes speak of, and what changed in others."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import cast

from swifttailor.describing.claims import claims_of
from swifttailor.describing.differences import Change, Gain, Step, find_differences, subject_of
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.describing.facts import GarmentFacts
from swifttailor.recutting.one_sided import asks_for_one_side

_PARTS = {
    "sleeves": "sleeves left_sleeve right_sleeve sleeve_shape cuffs sleeve_cm sleeve_width_cm cuff_cm "
    "sleeve_length sleeve_width sleeve_end sleeve_head sleeve_gathers cuff_length cuff_opening",
    "neck": "neckline left_neckline right_neckline neck_depth neck_depth_cm back_neckline back_depth "
    "back_depth_cm neck_width collar collar_cm collar_height hood hood_depth hood_height",
    "shoulders": "shoulders straps armholes",
    "bodice": "fit bodice chest chest_cm bodice_gathers top_width",
    "waist": "waist_seam waistband waistband_cm waistband_height waistband_width rise bodice_length",
    "hem": "skirt_hem top_hem leg_hem length length_cm skirt_length_cm inseam_cm leg_length hem_shape dip "
    "slit slit_size slit_cm slits front_slit back_slit left_slit right_slit",
    "skirt": "skirt hips hem_cm skirt_hem_width skirt_gathers tiers tier_gathers gores godets godet_cm "
    "godet_width godet_height base_width",
    "legs": "legs leg_width_cm leg_end thigh leg_cuffs leg_cuff_cm leg_cuff_length",
}
_PART_OF = {name: part for part, names in _PARTS.items() for name in names.split()}
_TOGETHER = {
    "sleeves": {"shoulders"},
    "neck": {"shoulders"},
    "shoulders": {"neck", "sleeves", "hem", "waist"},
    "bodice": {"shoulders", "sleeves", "waist", "skirt", "hem"},
    "waist": {"bodice", "skirt"},
    "hem": {"skirt", "legs", "waist"},
    "skirt": {"hem", "waist"},
    "legs": {"hem", "skirt"},
}
"""What cannot but change with a part: armholes are seen without sleeves, a hem widens with its length."""
_WITH_HEMS = frozenset({"kind", "top width"})
"""What cannot but change with a hem: fronts that overlap or flare are narrower higher up."""
KEPT_CM = 1.0
"""What is told to stay may move by so much, and what is cut back comes so near to what it was."""
_EVERYTHING = frozenset({"kind", "sides"})


@dataclass(frozen=True)
class Keep:
    """A measure that is to stay as it was; a change as `Step` is one, of nothing."""

    quantity: str
    direction: int = 0
    amount: float = 0.0
    within: float = math.inf
    """How far it may move, where that is less than what is seen."""

    def holds(self, before: GarmentFacts, after: GarmentFacts) -> bool:
        """Whether no difference is seen."""
        quantity = QUANTITIES[self.quantity]
        was, now = quantity.of(before), quantity.of(after)
        return was is None or now is None or not (quantity.seen(was, now) or abs(now - was) > self.within)


def part_of(subject: str) -> str | None:
    """The part of a garment that a claim or a quantity is about; None where it is about all of it."""
    if subject == "skirt hem":  # the quantity is its width, the claim `skirt_hem` where it ends
        return "skirt"
    return _PART_OF.get(subject.replace(" ", "_"))


def spoken_parts(wishes: Sequence[Change]) -> frozenset[str] | None:
    """The parts that wishes speak of, with those that hang on them; None where they are about everything.

    Args:
        wishes: What is asked for; that of one side alone speaks of the sides, too.
    """
    subjects = {subject_of(wish) for wish in wishes}
    if _EVERYTHING.intersection(subjects):
        return None
    parts = {part for name in subjects if (part := part_of(name)) is not None}
    sides = {"sides"} if asks_for_one_side(wishes) else set()
    return frozenset(sides.union(parts, *(_TOGETHER[part] for part in parts)))


def unasked(
    parts: frozenset[str] | None,
    before: GarmentFacts,
    after: GarmentFacts,
    kept: Collection[str] = frozenset(),
) -> tuple[Change, ...]:
    """What has visibly changed in parts that no wish speaks of.

    Args:
        parts: That wishes speak of (`spoken_parts`).
        before: What the pattern showed.
        after: What it shows now.
        kept: Subjects that may not change, whatever part they are of.
    """
    if parts is None and not kept:
        return ()
    gains, steps = find_differences(before, after)
    moved = [
        name for name in kept if name in QUANTITIES and not Keep(name, within=KEPT_CM).holds(before, after)
    ]
    steps = (*steps, *[Step(name, 1) for name in moved if all(s.quantity != name for s in steps)])
    return tuple(
        [
            change
            for change in (*gains, *steps)
            if subject_of(change) in kept
            or (parts is not None and not _may_change(subject_of(change), parts))
            or (subject_of(change) == "kind" and parts is not None and _has_other_halves(before, after))
        ]
    )


def _has_other_halves(before: GarmentFacts, after: GarmentFacts) -> bool:
    """Whether a bodice or legs came or went: no longer hem makes a dress of a jumpsuit."""
    halves = [(facts.torso is None, facts.trousers is None) for facts in (before, after)]
    return halves[0] != halves[1]


def _may_change(subject: str, parts: frozenset[str]) -> bool:
    if subject == "sides":
        return "sides" in parts
    return part_of(subject) in parts or (subject in _WITH_HEMS and "hem" in parts)


def undoing(changes: Sequence[Change], before: GarmentFacts) -> list[Change]:
    """Wishes that undo changes: measures as they were, and claims that were true."""
    found: list[Change] = []
    names = set()
    for change in changes:
        if isinstance(change, Gain):
            names.add(change.claim.name)
        else:
            found.append(cast(Change, Keep(change.quantity, within=KEPT_CM)))
    found += [
        Gain(claim) for claim in claims_of(before) if claim.name in names and isinstance(claim.value, str)
    ]
    return found

"""Figures beside words about the same thing: what is said in centimetres needs no vague word."""

from __future__ import annotations

from collections.abc import Sequence

from swifttailor.describing.claims import CLAIM_TYPES, claims_of
from swifttailor.describing.differences import Change, Gain, Step, subject_of
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.describing.facts import GarmentFacts
from swifttailor.recutting.unasked import part_of
from swifttailor.wishes.instructions.change_parts import is_unsaid

_FIGURES = {
    "waistband": ("waistband_cm",),
    "skirt_hem": ("skirt_length_cm", "length_cm"),
    "top_hem": ("length_cm",),
    "leg_hem": ("inseam_cm",),
    "sleeves": ("sleeve_cm",),
    "sleeve_shape": ("sleeve_width_cm",),
    "neck_depth": ("neck_depth_cm",),
    "back_depth": ("back_depth_cm",),
    "slit_size": ("slit_cm",),
    "legs": ("leg_width_cm",),
    "fit": ("chest_cm",),
}
"""Claims in words, and those that say the same in figures."""


_ENDS = {"skirt_hem": "length", "top_hem": "length", "leg_hem": "leg length", "sleeves": "sleeve length"}
"""Claims of where something ends, and its length."""


def without_steps_to(told: Sequence[Change]) -> list[Change]:
    """Without steps of what is stated in figures, of how much or by how much: "a narrower band, 2 cm"."""
    stated = {c.claim.name for c in told if isinstance(c, Gain) and not isinstance(c.claim.value, str)}

    by = {(c.quantity, c.direction) for c in told if isinstance(c, Step) and not is_unsaid(c)}

    def is_told(change: Change) -> bool:
        if isinstance(change, Step) and is_unsaid(change) and (change.quantity, change.direction) in by:
            return True
        how = QUANTITIES[change.quantity].stated if isinstance(change, Step) else None
        return how is not None and how.claim in stated

    return [change for change in told if not is_told(change)]


def without_vague_depth(told: Sequence[Change]) -> list[Change]:
    """Of a neckline that is 12 cm deep nobody says besides how deep it is."""
    names = {subject_of(change) for change in told}
    stated = {name for name in ("neck_depth", "back_depth") if f"{name}_cm" in names}
    return [change for change in told if subject_of(change) not in stated]


def by_the_number(told: Sequence[Change], facts: GarmentFacts) -> list[Change]:
    """Numbers that cannot be where a measure is to end, as by how much: "open it, 3 cm" of a neckline of 10.

    Args:
        told: What is asked for.
        facts: Of the garment.
    """
    found: list[Change] = []
    waiting = [c for c in told if isinstance(c, Step) and c.direction > 0]
    by: dict[Change, Step] = {}
    for change in told:
        if not isinstance(change, Gain) or isinstance(change.claim.value, str):
            continue
        measured = CLAIM_TYPES[change.claim.name].measure
        now = None if measured is None else measured.of(facts)
        for step in waiting:
            how = QUANTITIES[step.quantity].stated
            if how is None or how.claim != change.claim.name or not now or change.claim.value >= now:
                continue
            if step.amount in (None, change.claim.value):
                by[change] = Step(step.quantity, step.direction, change.claim.value)
    gone = {(step.quantity, step.direction) for step in by.values()}
    for change in told:
        if isinstance(change, Step) and change.amount is None and (change.quantity, change.direction) in gone:
            continue
        found.append(by.get(change, change))
    return list(dict.fromkeys(found))


def is_stated(change: Change, told: Sequence[Change]) -> bool:
    """Whether what is told says a change in figures already: a waistband of 6 cm is not to be "wide" besides.

    Args:
        change: What is read.
        told: What is asked for.
    """
    names = {c.claim.name for c in told if isinstance(c, Gain) and not isinstance(c.claim.value, str)}
    by = {c.quantity for c in told if isinstance(c, Step) and c.amount is not None}
    if isinstance(change, Gain) and _ENDS.get(change.claim.name) in by:
        return True  # "crop it by 5 cm": it is to end where that leads
    if isinstance(change, Step):
        how = QUANTITIES[change.quantity].stated
        return how is not None and how.claim in names
    return change.claim.value != "none" and bool(names.intersection(_FIGURES.get(change.claim.name, ())))


def is_counted(change: Change, told: Sequence[Change]) -> bool:
    """Whether the number of a step is another's already: of "shorten it by 5 cm" not of the sleeves, too.

    Args:
        change: What is read.
        told: What is asked for.
    """
    if not isinstance(change, Step) or change.amount is None:
        return False
    part = part_of(change.quantity)
    amounts = [c.amount for c in told if isinstance(c, Step) and part_of(c.quantity) != part]
    return any(amount is not None and abs(amount - change.amount) < 0.05 for amount in amounts)


def to_the_number(told: Sequence[Change], facts: GarmentFacts) -> list[Change]:
    """Figures that nearly hold, as steps to them: a leg opening of 60 cm is asked for, and 57 is near it.

    Args:
        told: What is asked for.
        facts: Of the garment.
    """
    found: list[Change] = []
    for change in told:
        step = None
        if (
            isinstance(change, Gain)
            and not isinstance(change.claim.value, str)
            and change.holds(facts, facts)
        ):
            quantity = _QUANTITY_OF.get(change.claim.name)
            now = None if quantity is None else QUANTITIES[quantity].of(facts)
            off = 0.0 if now is None else change.claim.value - now
            if quantity is not None and abs(off) >= LEAST_CM:
                step = Step(quantity, 1 if off > 0 else -1, round(abs(off), 2))
        found.append(change if step is None else step)
    return found


def to_the_word(told: Sequence[Change], facts: GarmentFacts) -> list[Step]:
    """Steps to what words for how long sleeves are mean, where these hold at their border alone.

    Sleeves of 22 cm may be called elbow-length by somebody who is content with them, but not by somebody who
    wants short ones lengthened to the elbow.

    Args:
        told: What is asked for.
        facts: Of the garment.
    """
    found: list[Step] = []
    now = QUANTITIES["sleeve length"].of(facts)
    called = {claim.value for claim in claims_of(facts, ["sleeves"])}
    for change in told:
        if not isinstance(change, Gain) or change.claim.name != "sleeves" or now is None or not called:
            continue
        share = _SLEEVES.get(str(change.claim.value))
        if share is not None and change.claim.value not in called and change.holds(facts, facts):
            off = share * facts.body.arm_length - now
            found.append(Step("sleeve length", 1 if off > 0 else -1, round(abs(off), 1)))
    return found


def of_one_arm(told: Sequence[Change], lengths: Sequence[float], facts: GarmentFacts) -> list[Change]:
    """What asks for one sleeve of another length, where that is far from the number that is said of it.

    One sleeve is cut to the lengths that there are words for; "2 cm shorter" is none of them.

    Args:
        told: What is asked for.
        lengths: In the text, cm.
        facts: Of the garment.
    """
    found: list[Change] = []
    for change in told:
        if not isinstance(change, Gain) or change.claim.name not in ("left_sleeve", "right_sleeve"):
            continue
        sleeve = facts.left_sleeve if change.claim.name == "left_sleeve" else facts.right_sleeve
        share = _SLEEVES.get(str(change.claim.value))
        if sleeve is None or share is None or change.holds(facts, facts):
            continue
        off = abs(share * facts.body.arm_length - sleeve.length)
        if lengths and not any(abs(off - length) <= 0.3 * off for length in lengths):
            found.append(change)
    return found


_SLEEVES = {"cap": 0.14, "short": 0.36, "elbow": 0.53, "three-quarter": 0.73, "long": 0.98, "extra-long": 1.2}
"""Parts of the arm's length that are meant by words."""
LEAST_CM = 1.0
"""What is nearer to a figure than this is as it is asked for."""
_QUANTITY_OF = {
    how.claim: name
    for name, quantity in QUANTITIES.items()
    if (how := quantity.stated) is not None
    and how.of is None
    and how.claim not in ("tiers", "gores", "godets")
}

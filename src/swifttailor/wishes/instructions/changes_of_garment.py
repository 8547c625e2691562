"""Changes as a garment may have them: what it can become, and what it has in place of what it lacks."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim, claims_of
from swifttailor.describing.differences import Change, Gain, Step
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.describing.facts import GarmentFacts
from swifttailor.recutting.clearer import is_clear
from swifttailor.wishes.instructions.change_parts import WAIST_CM
from swifttailor.wishes.instructions.spoken_amounts import share_of
from swifttailor.wishes.instructions.spoken_changes import SpokenChanges
from swifttailor.wording.claim_kinds import fits_kind

_ONLY_OF = {
    "top_hem": {"top", "tunic"},
    "rise": {"skirt", "trousers", "shorts"},
    "waist_seam": {"dress", "tunic", "jumpsuit", "playsuit"},
}
"""Kinds of which claims are that would make another garment of others: a dress that ends at the hip."""
_MADE = {
    "sleeve length": Claim("sleeves", "long"),
    "waistband height": Claim("waistband", "waist"),
    "collar height": Claim("collar", "stand"),
    "hood depth": Claim("hood", "hood"),
    "hood height": Claim("hood", "hood"),
    "cuff length": Claim("cuffs", "band"),
    "leg cuff length": Claim("leg_cuffs", "band"),
}
"""What has to be there for a measure to grow."""
_ENDS = {
    "skirt_hem": "length",
    "top_hem": "length",
    "leg_hem": "leg length",
    "sleeves": "sleeve length",
    "fit": "chest",
}
"""Claims of where something ends or how wide it is, and its measure."""
_LEGS_OF = {
    ("trousers", "shorts"): "mid-thigh",
    ("jumpsuit", "playsuit"): "mid-thigh",
    ("shorts", "trousers"): "full",
    ("playsuit", "jumpsuit"): "full",
}
"""Where the legs of a garment end that is to become another one with legs."""
_COUNTED = frozenset({"godets", "tiers"})
"""Where there are none, so many more are so many."""
_EXTREMES = {
    ("neck depth", -1): (Claim("neck_depth", "plunging"), 22.0),
    ("back depth", -1): (Claim("back_depth", "open"), 23.0),
}
"""Steps that lead away from what is extreme, and the measure in cm from which on it no longer is."""
_ELSE = {
    "top width": ("skirt hem", "chest"),
    "skirt hem": ("top width",),
    "waistband width": ("chest",),
    "cuff opening": ("sleeve end",),
}
"""What is meant where a garment has no such measure: of a tunic with a skirt the hem of that."""


def named_kind(facts: GarmentFacts) -> str:
    """What a garment is called: shorts are told from trousers."""
    return next((str(c.value) for c in claims_of(facts, ["kind"])), facts.kind)


def can_become(change: Change, facts: GarmentFacts, *, clearly: bool = False) -> bool:
    """Whether a garment is not so already, and has what is to grow or shrink.

    Args:
        change: What is read.
        facts: Of the garment.
        clearly: Whether what is so by a little may become so clearly.
    """
    if isinstance(change, Gain):
        name, kind = change.claim.name, named_kind(facts)
        fits = name == "sides" or (fits_kind(name, kind) and kind in _ONLY_OF.get(name, {kind}))
        return fits and not (is_clear(change, facts) if clearly else change.holds(facts, facts))
    return QUANTITIES[change.quantity].of(facts) is not None


def made_where_lacking(change: Change, facts: GarmentFacts) -> Change:
    """What a garment lacks is made before it can be larger: longer sleeves of a sleeveless dress."""
    if not isinstance(change, Step):
        return change
    if QUANTITIES[change.quantity].of(facts) is None:
        tighter = change.direction < 0 and change.quantity == "sleeve end"
        for other in ("cuff opening",) if tighter else _ELSE.get(change.quantity, ()):
            if QUANTITIES[other].of(facts) is not None:
                return replace(change, quantity=other)
    if change.direction > 0 and change.amount and change.quantity in _COUNTED:
        return (
            change if QUANTITIES[change.quantity].of(facts) else Gain(Claim(change.quantity, change.amount))
        )
    if change.direction < 0 or change.amount is not None:
        return change
    made = _MADE.get(change.quantity)
    lacks = made is not None and QUANTITIES[change.quantity].of(facts) is None
    return Gain(made) if made is not None and lacks and fits_kind(made.name, named_kind(facts)) else change


def in_usual_steps(change: Change, facts: GarmentFacts) -> Change:
    """A step of no stated size as large as people mean it: waists by little, what is too low until it is not.

    Args:
        change: What is asked for.
        facts: Of the garment.
    """
    if not isinstance(change, Step) or change.amount is not None:
        return change
    if change.quantity == "waistband width":
        return replace(change, amount=WAIST_CM)
    extreme = _EXTREMES.get((change.quantity, change.direction))
    now = QUANTITIES[change.quantity].of(facts)
    if extreme is None or now is None or not extreme[0].holds(facts):
        return change
    by = round(abs(now - extreme[1]), 1)
    return replace(change, amount=by) if by > 2 * QUANTITIES[change.quantity].least else change


def with_shares(text: str, spoken: SpokenChanges, facts: GarmentFacts) -> SpokenChanges:
    """Steps by a part of what the garment measures: "half as high"."""
    clauses = []
    for clause in spoken.clauses:
        share = share_of(text[clause.start : clause.end].lower())
        changes = [_by_share(c, share, facts) for c in clause.changes] if share else clause.changes
        clauses.append(replace(clause, changes=tuple(changes)))
    return replace(spoken, clauses=tuple(clauses))


def with_share(text: str, change: Change, facts: GarmentFacts) -> Change:
    """A step of what is counted by a part of how many there are: "12 gores are too many, halve them"."""
    share = share_of(text.lower())
    counted = isinstance(change, Step) and change.quantity in ("gores", *_COUNTED)
    if share is None or not counted:
        return change
    by = _by_share(change, share, facts)
    return replace(by, amount=float(round(by.amount))) if isinstance(by, Step) and by.amount else by


def _by_share(change: Change, share: float, facts: GarmentFacts) -> Change:
    if not isinstance(change, Step) or change.amount is not None:
        return change
    measure = QUANTITIES[change.quantity].of(facts)
    return change if measure is None else replace(change, amount=round(share * measure, 2))


def with_their_legs(told: Sequence[Change], facts: GarmentFacts) -> list[Change]:
    """Where legs are to end, in place of shorts of trousers, and the other way round: else they are the same.

    Args:
        told: What is asked for.
        facts: Of the garment.
    """
    if any(isinstance(c, Gain) and c.claim.name in ("leg_hem", "inseam_cm") for c in told):
        return list(told)
    found: list[Change] = []
    for change in told:
        ends = None
        if isinstance(change, Gain) and change.claim.name == "kind":
            ends = _LEGS_OF.get((named_kind(facts), str(change.claim.value)))
        found.append(change if ends is None else Gain(Claim("leg_hem", ends)))
    return found


def with_slits_that_are(told: Sequence[Change], facts: GarmentFacts) -> list[Change]:
    """A height that is asked for, of the slit that is there: no second one is cut to it.

    Args:
        told: What is asked for.
        facts: Of the garment.
    """
    places = [c.claim.value for c in told if isinstance(c, Gain) and c.claim.name == "slit"]
    quantity = f"{places[0]} slit" if len(places) == 1 else ""
    was = QUANTITIES[quantity].of(facts) if quantity in QUANTITIES else None
    if was is None:
        return list(told)
    found: list[Change] = []
    for change in told:
        high = change.claim if isinstance(change, Gain) and change.claim.name == "slit_cm" else None
        by = 0.0 if high is None else round(float(high.value) - was, 2)
        found.append(change if abs(by) < 1.0 else Step(quantity, 1 if by > 0 else -1, abs(by)))
    return found


def in_step_with_hems(told: Sequence[Change], said: Callable[[Change], bool]) -> list[Change]:
    """Without amounts that nobody said of a length, where it is said where the hem is to end.

    Args:
        told: What is asked for.
        said: Whether a text has the number of a change.
    """
    ends = {_ENDS[c.claim.name] for c in told if isinstance(c, Gain) and c.claim.name in _ENDS}
    return [
        replace(c, amount=None) if isinstance(c, Step) and c.quantity in ends and not said(c) else c
        for c in told
    ]

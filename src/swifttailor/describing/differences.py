"""What is visibly different between two garments: what became true, what grew or shrank."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.describing.claims import Claim, claims_of
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.describing.facts import GarmentFacts
from swifttailor.errors import InputError


@dataclass(frozen=True)
class Gain:
    """Something that can be said of the edited garment and not of the original."""

    claim: Claim

    def __hash__(self) -> int:
        # A text has hundreds of changes that may be meant; this is half the time of a dataclass's own.
        return hash((self.claim.name, self.claim.value))

    def holds(self, before: GarmentFacts, after: GarmentFacts) -> bool:
        """Whether an edited garment does what is asked."""
        return self.claim.holds(after)

    def to_json(self) -> dict[str, object]:
        """The change as plain JSON values."""
        return {"gain": self.claim.to_json()}


@dataclass(frozen=True)
class Step:
    """A measure that grows or shrinks."""

    quantity: str
    """A key of `QUANTITIES`."""
    direction: int
    """+1 or -1."""
    amount: float | None = None
    """By how much, where that is asked for: cm, positive."""

    def __post_init__(self) -> None:
        if self.quantity not in QUANTITIES:
            known = ", ".join(QUANTITIES)
            raise InputError(f"There is no quantity '{self.quantity}'. Known: {known}.")
        if self.direction not in (-1, 1):
            raise InputError(f"A step goes up (1) or down (-1), received {self.direction!r}.")

    def holds(self, before: GarmentFacts, after: GarmentFacts) -> bool:
        """Whether an edited garment does what is asked: the right way, by half of what is seen or more."""
        quantity = QUANTITIES[self.quantity]
        was, now = quantity.of(before), quantity.of(after)
        if was is not None and quantity.closes and self == Step(self.quantity, -1, was):
            return now is None
        if was is None or now is None:
            return False
        change = (now - was) * self.direction
        if self.amount is not None:
            within = max(quantity.least / 2, 0.25 * self.amount)
            return abs(change - self.amount) <= min(within, 0.5 * self.amount)
        return change >= quantity.least / 2

    def to_json(self) -> dict[str, object]:
        """The change as plain JSON values."""
        return {"step": self.quantity, "direction": self.direction, "amount": self.amount}


Change = Gain | Step


def subject_of(change: Change) -> str:
    """What a change is about: the name of its claim, or its quantity."""
    return change.claim.name if isinstance(change, Gain) else change.quantity


def find_differences(before: GarmentFacts, after: GarmentFacts) -> tuple[tuple[Gain, ...], tuple[Step, ...]]:
    """Finds what became true and what grew or shrank, as far as it is seen.

    Gains are claims that can safely be made of `after` and do not hold of `before` even leniently, so both
    garments are clearly on different sides of the border. The steps' amounts are those measured.
    """
    gains = tuple(Gain(c) for c in claims_of(after) if isinstance(c.value, str) and not c.holds(before))
    steps = []
    for name, quantity in QUANTITIES.items():
        was, now = quantity.of(before), quantity.of(after)
        if was is not None and now is not None and quantity.seen(was, now):
            steps.append(Step(name, 1 if now > was else -1, round(abs(now - was), 2)))
    return gains, tuple(steps)

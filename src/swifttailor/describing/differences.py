"""What is visibly different between two garments: what became true, what grew or shrank."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from swifttailor.describing.claims import Claim, claims_of
from swifttailor.describing.facts import Cuff, GarmentFacts, Place, Skirt, Sleeve
from swifttailor.errors import InputError

Getter = Callable[[GarmentFacts], float | None]


@dataclass(frozen=True)
class Quantity:
    """A measure that an edit can change."""

    about: str
    of: Getter
    """cm, pieces or a ratio; None where the garment has no such thing."""
    least: float
    """The smallest change that is seen."""
    share: float = 0.0
    """The same as a part of the measure; the larger counts."""
    in_cm: bool = True
    """Whether the change can be stated in cm."""

    def seen(self, before: float, after: float) -> bool:
        """Whether the difference of two measures is seen."""
        return abs(after - before) >= max(self.least, self.share * max(abs(before), abs(after)))


def _sleeves(of: Callable[[Sleeve], float | None]) -> Getter:
    def measure(facts: GarmentFacts) -> float | None:
        values = [of(s) for s in (facts.left_sleeve, facts.right_sleeve) if s]
        known = [v for v in values if v is not None]
        return sum(known) / len(known) if known and len(known) == len(values) else None

    return measure


def _cuff(of: Callable[[Cuff], float]) -> Getter:
    return _sleeves(lambda s: of(s.cuff) if s.cuff else None)


def _slit(place: Place) -> Getter:
    def height(facts: GarmentFacts) -> float | None:
        slits = [s.height for s in facts.skirt.slits if s.place == place] if facts.skirt else []
        return max(slits, default=None)

    return height


def _tiered(of: Callable[[Skirt], float]) -> Getter:
    return lambda f: of(f.skirt) if f.skirt and (f.skirt.tiers > 1 or f.skirt.godets) else None


def _top_width(facts: GarmentFacts) -> float | None:
    """Of a free lower edge of the bodice."""
    if facts.torso is None or facts.skirt or facts.trousers or facts.waistband:
        return None
    return facts.torso.lower_edge


def _armholes(facts: GarmentFacts) -> float | None:
    holes = [facts.torso.left_armhole, facts.torso.right_armhole] if facts.torso else []
    depths = [h.depth for h in holes if h]
    return sum(depths) / len(depths) if depths else None


def _shoulders(facts: GarmentFacts) -> float | None:
    if facts.torso is None or facts.torso.left_shoulder is None or facts.torso.right_shoulder is None:
        return None
    return (facts.torso.left_shoulder + facts.torso.right_shoulder) / 2


def _bodice_length(facts: GarmentFacts) -> float | None:
    """Down to the seam with what hangs from it."""
    if facts.torso is None or not (facts.skirt or facts.trousers or facts.waistband):
        return None
    return facts.top_level - facts.torso.lower_level


def _length(facts: GarmentFacts) -> float | None:
    return facts.length if facts.hem and facts.trousers is None else None


def _high_low(facts: GarmentFacts) -> float | None:
    return facts.hem.front - facts.hem.back if facts.hem and facts.trousers is None else None


QUANTITIES: Mapping[str, Quantity] = {
    "sleeve length": Quantity("from shoulder to the sleeve's end", _sleeves(lambda s: s.length), 3.0),
    "sleeve width": Quantity(
        "around the sleeve at the underarm", _sleeves(lambda s: s.upper_width), 4.0, 0.08
    ),
    "sleeve end": Quantity(
        "around the sleeve's lower end", _sleeves(lambda s: s.end_width if s.cuff is None else None), 4.0, 0.1
    ),
    "sleeve head": Quantity(
        "head of the sleeve over the armhole", _sleeves(lambda s: s.head_gather), 0.15, in_cm=False
    ),
    "sleeve gathers": Quantity(
        "sleeve end over cuff", _sleeves(lambda s: s.end_gather if s.cuff else None), 0.2, in_cm=False
    ),
    "cuff length": Quantity("length of the cuffs", _cuff(lambda c: c.length), 1.5, 0.15),
    "cuff opening": Quantity("around the cuff's free end", _cuff(lambda c: c.opening), 5.0, 0.15),
    "length": Quantity("from top to hem, garments without legs", _length, 3.5),
    "bodice length": Quantity("from shoulder to the seam below the bodice", _bodice_length, 4.0),
    "leg length": Quantity("crotch to hem", lambda f: f.trousers.inseam if f.trousers else None, 3.5),
    "leg end": Quantity(
        "around the end of the leg", lambda f: f.trousers.hem if f.trousers else None, 3.0, 0.06
    ),
    "thigh": Quantity("around the thigh", lambda f: f.trousers.thigh if f.trousers else None, 2.5, 0.04),
    "leg cuff length": Quantity(
        "length of the cuffs of the legs",
        lambda f: f.trousers.cuff.length if f.trousers and f.trousers.cuff else None,
        2.0,
        0.15,
    ),
    "waistband height": Quantity(
        "height of the band", lambda f: f.waistband.height if f.waistband else None, 1.5, 0.15
    ),
    "waistband width": Quantity(
        "around the band", lambda f: f.waistband.upper if f.waistband else None, 6.0, 0.06
    ),
    "collar height": Quantity("width of the collar", lambda f: f.collar.height if f.collar else None, 1.5),
    "hood depth": Quantity("face to back of the hood", lambda f: f.hood.depth if f.hood else None, 2.0),
    "hood height": Quantity("neck to crown of the hood", lambda f: f.hood.height if f.hood else None, 3.5),
    "neck depth": Quantity(
        "fall of the front neckline", lambda f: f.front_neck.depth if f.front_neck else None, 2.0, 0.08
    ),
    "neck width": Quantity(
        "width of the neckline", lambda f: 2 * f.front_neck.width if f.front_neck else None, 2.5, 0.1
    ),
    "back depth": Quantity(
        "fall of the back neckline", lambda f: f.back_neck.depth if f.back_neck else None, 2.5, 0.1
    ),
    "shoulders": Quantity("length of the shoulder seam", _shoulders, 2.0),
    "armholes": Quantity("depth of the armholes", _armholes, 3.0),
    "chest": Quantity("around the chest", lambda f: f.torso.chest if f.torso else None, 3.0, 0.03),
    "top width": Quantity("around the hem of a top", _top_width, 6.0, 0.06),
    "skirt hem": Quantity("around the hem of a skirt", lambda f: f.skirt.hem if f.skirt else None, 8.0, 0.08),
    "skirt gathers": Quantity(
        "skirt over waist", lambda f: f.skirt.gather if f.skirt else None, 0.12, in_cm=False
    ),
    "bodice gathers": Quantity(
        "bodice over waist", lambda f: f.torso.gather if f.torso else None, 0.15, in_cm=False
    ),
    "tier gathers": Quantity(
        "lower tiers over upper ones",
        lambda f: f.skirt.tier_gather if f.skirt and f.skirt.tiers > 1 else None,
        0.12,
        in_cm=False,
    ),
    "tiers": Quantity(
        "rows of a skirt", lambda f: float(f.skirt.tiers) if f.skirt else None, 1.0, in_cm=False
    ),
    "gores": Quantity(
        "panels around a skirt",
        lambda f: float(f.skirt.gores) if f.skirt and f.skirt.gores > 3 else None,
        1.0,
        in_cm=False,
    ),
    "godets": Quantity(
        "number of godets",
        lambda f: float(f.skirt.godets) if f.skirt and f.skirt.godets else None,
        1.0,
        in_cm=False,
    ),
    "godet width": Quantity(
        "width of the godets", lambda f: f.skirt.godet_width if f.skirt and f.skirt.godets else None, 4.0
    ),
    "godet height": Quantity(
        "height of the godets", lambda f: f.skirt.godet_height if f.skirt and f.skirt.godets else None, 4.0
    ),
    "front slit": Quantity("height of the slit in front", _slit("front"), 4.0),
    "back slit": Quantity("height of the slit behind", _slit("back"), 4.0),
    "left slit": Quantity("height of the slit on the left", _slit("left"), 4.0),
    "right slit": Quantity("height of the slit on the right", _slit("right"), 4.0),
    "base width": Quantity(
        "around the first row of a tiered or godet skirt", _tiered(lambda s: s.base_hem), 6.0, 0.06
    ),
    "dip": Quantity("front of the hem above its back", _high_low, 6.0),
}
"""By name; documented in docs/edits.md."""


@dataclass(frozen=True)
class Gain:
    """Something that can be said of the edited garment and not of the original."""

    claim: Claim

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
        if was is None or now is None:
            return False
        change = (now - was) * self.direction
        if self.amount is not None:
            return abs(change - self.amount) <= max(quantity.least / 2, 0.25 * self.amount)
        return change >= quantity.least / 2

    def to_json(self) -> dict[str, object]:
        """The change as plain JSON values."""
        return {"step": self.quantity, "direction": self.direction, "amount": self.amount}


Change = Gain | Step


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

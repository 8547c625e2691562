"""Claims with a number: lengths in cm, counts of pieces."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from swifttailor.describing.facts import GarmentFacts, Sleeve


@dataclass(frozen=True)
class Measure:
    """A number that can be stated about a garment."""

    about: str
    of: Callable[[GarmentFacts], float | None]
    """The measure, cm or pieces; None where the garment has no such thing."""
    within: float = 2.0
    """How far the stated number may be off, cm or pieces."""
    share: float = 0.06
    """The same as a part of the number; the larger counts."""
    least: float = 1.0
    """Smaller measures are not stated."""

    def holds(self, facts: GarmentFacts, stated: float) -> bool:
        """Whether a stated number is right."""
        value = self.of(facts)
        return value is not None and abs(value - stated) <= max(self.within, self.share * value) + 1e-9


def _count(about: str, of: Callable[[GarmentFacts], float | None], least: float) -> Measure:
    return Measure(about, of, within=0.0, share=0.0, least=least)


def _sleeve(of: Callable[[Sleeve], float]) -> Callable[[GarmentFacts], float | None]:
    """Of both sleeves, where they agree to 2 cm."""

    def measure(facts: GarmentFacts) -> float | None:
        if facts.left_sleeve is None or facts.right_sleeve is None:
            return None
        left, right = of(facts.left_sleeve), of(facts.right_sleeve)
        return (left + right) / 2 if abs(left - right) <= 2.0 else None

    return measure


def _skirt_length(facts: GarmentFacts) -> float | None:
    """From the waist edge to the hem: with the waistband for a skirt, from the seam for a dress."""
    if facts.kind == "skirt":
        return facts.length
    return facts.skirt.length if facts.skirt and facts.kind == "dress" else None


def _slit(facts: GarmentFacts) -> float | None:
    return max((s.height for s in facts.skirt.slits), default=None) if facts.skirt else None


MEASURE_CLAIMS: dict[str, Measure] = {
    "length_cm": Measure(
        "shoulder to hem of tops and dresses",
        lambda f: f.length if f.kind in ("top", "dress") else None,
        3.0,
        0.04,
    ),
    "skirt_length_cm": Measure(
        "waist to hem of skirts, waist seam to hem of dresses", _skirt_length, 3.0, 0.05
    ),
    "inseam_cm": Measure(
        "crotch to end of the legs", lambda f: f.trousers.inseam if f.trousers else None, 3.0, 0.05
    ),
    "sleeve_cm": Measure(
        "shoulder tip to the end of both sleeves, cuffs included", _sleeve(lambda s: s.length), 2.5
    ),
    "sleeve_width_cm": Measure(
        "around both sleeves at the underarm", _sleeve(lambda s: s.upper_width), 2.5, least=20.0
    ),
    "cuff_cm": Measure(
        "length of the cuffs of both sleeves",
        _sleeve(lambda s: s.cuff.length if s.cuff else -1.0),
        1.0,
        0.1,
        2.0,
    ),
    "leg_cuff_cm": Measure(
        "length of the cuffs of the legs",
        lambda f: f.trousers.cuff.length if f.trousers and f.trousers.cuff else None,
        1.0,
        0.1,
        2.0,
    ),
    "waistband_cm": Measure(
        "height of the band", lambda f: f.waistband.height if f.waistband else None, 1.0, 0.1, 2.0
    ),
    "neck_depth_cm": Measure(
        "fall of the front neckline from the shoulder",
        lambda f: f.front_neck.depth if f.front_neck else None,
        1.5,
        0.08,
    ),
    "back_depth_cm": Measure(
        "fall of the back neckline from the shoulder",
        lambda f: f.back_neck.depth if f.back_neck else None,
        1.5,
        0.08,
        4.0,
    ),
    "collar_cm": Measure(
        "width of the collar behind", lambda f: f.collar.height if f.collar else None, 1.0, 0.1
    ),
    "chest_cm": Measure("around the chest", lambda f: f.torso.chest if f.torso else None, 4.0, 0.04),
    "hem_cm": Measure("around the hem of a skirt", lambda f: f.skirt.hem if f.skirt else None, 8.0, 0.08),
    "leg_width_cm": Measure("around the end of a leg", lambda f: f.trousers.hem if f.trousers else None, 2.5),
    "slit_cm": Measure("height of the highest slit", _slit, 2.5, 0.08, 5.0),
    "godet_cm": Measure(
        "height of the godets",
        lambda f: f.skirt.godet_height if f.skirt and f.skirt.godets else None,
        2.5,
        0.1,
    ),
    "gores": _count("panels around a gored skirt", lambda f: float(f.skirt.gores) if f.skirt else None, 4.0),
    "tiers": _count(
        "rows of a tiered skirt, the first included", lambda f: float(f.skirt.tiers) if f.skirt else None, 2.0
    ),
    "godets": _count("godets", lambda f: float(f.skirt.godets) if f.skirt else None, 1.0),
}
"""By name."""

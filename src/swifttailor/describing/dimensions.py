"""Dimensions: what can be measured on a garment, in one table for claims, differences and levers.

How they are said stands in `swifttailor.wording`, what cuts them in `swifttailor.recutting.levers`; tests
hold both to this table.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import KW_ONLY, dataclass
from typing import Literal

from swifttailor.describing.facts import GarmentFacts, Place, Skirt, Sleeve
from swifttailor.describing.facts_paths import Measure, mean, mean_of_sleeves, sleeves_of
from swifttailor.describing.facts_paths import measure_at as at

Unit = Literal["cm", "pieces", "times"]
_ALIKE_CM = 2.0
"""Sleeves that differ by more have no length in common."""


@dataclass(frozen=True)
class Stated:
    """How a dimension is claimed with a number."""

    claim: str
    """Name of the claim."""
    within: float = 2.0
    """How far the stated number may be off, cm or pieces."""
    share: float = 0.06
    """The same as a part of the number; the larger counts."""
    least: float = 1.0
    """Smaller measures are not stated."""
    about: str = ""
    """What the number is of, where that is less than what the dimension is about."""
    of: Measure | None = None
    """What the number is compared with, where that is not the dimension."""


@dataclass(frozen=True)
class Dimension:
    """Something that can be measured on a garment."""

    name: str
    about: str
    of: Measure
    _: KW_ONLY
    unit: Unit = "cm"
    least: float = math.inf
    """The smallest change that is seen; infinite where nobody asks for more or less of it."""
    share: float = 0.0
    """The same as a part of the measure; the larger counts."""
    stated: Stated | None = None
    """How it is claimed with a number; None where it is not."""
    none_below: float = -math.inf
    """What is less is seen as this: a bodice that holds a gathered skirt is not gathered the less for it."""
    closes: bool = False
    """Of something that a garment need not have: it is gone where it shrinks to 0."""

    @property
    def in_cm(self) -> bool:
        """Whether a change can be stated in cm."""
        return self.unit == "cm"

    def seen(self, before: float, after: float) -> bool:
        """Whether the difference of two measures is seen."""
        before, after = max(before, self.none_below), max(after, self.none_below)
        return abs(after - before) >= max(self.least, self.share * max(abs(before), abs(after)))

    def stated_measure(self, facts: GarmentFacts) -> float | None:
        """What a stated number is compared with, cm or pieces; None where the garment has no such thing."""
        of = self.stated.of if self.stated else None
        return self.of(facts) if of is None else of(facts)

    def is_stated_right(self, facts: GarmentFacts, number: float) -> bool:
        """Whether a stated number is right."""
        value, how = self.stated_measure(facts), self.stated
        if value is None or how is None:
            return False
        return abs(value - number) <= max(how.within, how.share * value) + 1e-9


def _of_both(of: Callable[[Sleeve], float]) -> Measure:
    """Of both sleeves, where they are alike."""

    def measure(facts: GarmentFacts) -> float | None:
        values = [of(sleeve) for sleeve in sleeves_of(facts)]
        return mean(values) if len(values) == 2 and abs(values[0] - values[1]) <= _ALIKE_CM else None

    return measure


def slit_height(place: Place | None = None) -> Measure:
    """Of the highest slit, in one place or anywhere."""

    def height(facts: GarmentFacts) -> float | None:
        slits = facts.skirt.slits if facts.skirt else ()
        return max((s.height for s in slits if place in (None, s.place)), default=None)

    return height


def _where(applies: Callable[[Skirt], object], path: str) -> Measure:
    """A fact of skirts of some kind."""
    of = at(path)
    return lambda facts: of(facts) if facts.skirt and applies(facts.skirt) else None


def _top_width(facts: GarmentFacts) -> float | None:
    """Of a free lower edge of the bodice."""
    if facts.torso is None or facts.skirt or facts.trousers or facts.waistband:
        return None
    return facts.torso.lower_edge


def _armholes(facts: GarmentFacts) -> float | None:
    holes = [facts.torso.left_armhole, facts.torso.right_armhole] if facts.torso else []
    return mean([hole.depth for hole in holes if hole])


def shoulder_length(facts: GarmentFacts) -> float | None:
    """Mean length of both shoulder seams, cm; None where a shoulder is bare."""
    if facts.torso is None or facts.torso.left_shoulder is None or facts.torso.right_shoulder is None:
        return None
    return (facts.torso.left_shoulder + facts.torso.right_shoulder) / 2


def _bodice_length(facts: GarmentFacts) -> float | None:
    if facts.torso is None or not (facts.skirt or facts.trousers or facts.waistband):
        return None
    return facts.top_level - facts.torso.lower_level


def _skirt_length(facts: GarmentFacts) -> float | None:
    """With the waistband for a skirt, from the seam for a dress."""
    if facts.kind == "skirt":
        return facts.length
    return facts.skirt.length if facts.skirt and facts.kind == "dress" else None


def _dip(facts: GarmentFacts) -> float | None:
    return facts.hem.front - facts.hem.back if facts.hem and facts.trousers is None else None


def _pieces(claim: str, path: str, least: float) -> Stated:
    """A number that must be right."""
    return Stated(claim, 0.0, 0.0, least, of=at(path))


_TABLE = (
    Dimension(
        "sleeve length",
        "from shoulder to the sleeve's end",
        mean_of_sleeves(lambda s: s.length),
        least=3.0,
        stated=Stated(
            "sleeve_cm",
            about="shoulder tip to the end of both sleeves, cuffs included",
            of=_of_both(lambda s: s.length),
            within=2.5,
        ),
    ),
    Dimension(
        "sleeve width",
        "around the sleeve at the underarm",
        mean_of_sleeves(lambda s: s.upper_width),
        least=4.0,
        share=0.08,
        stated=Stated(
            "sleeve_width_cm",
            about="around both sleeves at the underarm",
            of=_of_both(lambda s: s.upper_width),
            within=2.5,
            least=20.0,
        ),
    ),
    Dimension(
        "sleeve end",
        "around the sleeve's lower end",
        mean_of_sleeves(lambda s: s.end_width if s.cuff is None else None),
        least=4.0,
        share=0.1,
    ),
    Dimension(
        "sleeve head",
        "head of the sleeve over the armhole",
        mean_of_sleeves(lambda s: s.head_gather),
        least=0.15,
        unit="times",
    ),
    Dimension(
        "sleeve gathers",
        "sleeve end over cuff",
        mean_of_sleeves(lambda s: s.end_gather if s.cuff else None),
        least=0.2,
        unit="times",
    ),
    Dimension(
        "cuff length",
        "length of the cuffs",
        mean_of_sleeves(lambda s: s.cuff.length if s.cuff else None),
        least=1.5,
        share=0.15,
        stated=Stated(
            "cuff_cm",
            about="length of the cuffs of both sleeves",
            of=_of_both(lambda s: s.cuff.length if s.cuff else -1.0),
            within=1.0,
            share=0.1,
            least=2.0,
        ),
    ),
    Dimension(
        "cuff opening",
        "around the cuff's free end",
        mean_of_sleeves(lambda s: s.cuff.opening if s.cuff else None),
        least=5.0,
        share=0.15,
    ),
    Dimension(
        "length",
        "from top to hem, garments without legs",
        lambda f: f.length if f.hem and f.trousers is None else None,
        least=3.5,
        stated=Stated(
            "length_cm",
            about="shoulder to hem of tops and dresses",
            of=lambda f: f.length if f.kind in ("top", "dress") else None,
            within=3.0,
            share=0.04,
        ),
    ),
    Dimension(
        "skirt length",
        "waist to hem of skirts, waist seam to hem of dresses",
        _skirt_length,
        stated=Stated("skirt_length_cm", 3.0, 0.05),
    ),
    Dimension("bodice length", "from shoulder to the seam below the bodice", _bodice_length, least=4.0),
    Dimension(
        "leg length",
        "crotch to end of the legs",
        at("trousers.inseam"),
        least=3.5,
        stated=Stated("inseam_cm", 3.0, 0.05),
    ),
    Dimension(
        "leg end",
        "around the end of a leg",
        at("trousers.hem"),
        least=3.0,
        share=0.06,
        stated=Stated("leg_width_cm", 2.5),
    ),
    Dimension("thigh", "around the thigh", at("trousers.thigh"), least=2.5, share=0.04),
    Dimension(
        "leg cuff length",
        "length of the cuffs of the legs",
        at("trousers.cuff.length"),
        least=2.0,
        share=0.15,
        stated=Stated("leg_cuff_cm", 1.0, 0.1, 2.0),
    ),
    Dimension(
        "waistband height",
        "height of the band",
        at("waistband.height"),
        least=1.5,
        share=0.15,
        stated=Stated("waistband_cm", 1.0, 0.1, 2.0),
    ),
    Dimension("waistband width", "around the band", at("waistband.upper"), least=6.0, share=0.06),
    Dimension(
        "collar height",
        "width of the collar behind",
        at("collar.height"),
        least=1.5,
        stated=Stated("collar_cm", 1.0, 0.1),
    ),
    Dimension("hood depth", "face to back of the hood", at("hood.depth"), least=2.0),
    Dimension("hood height", "neck to crown of the hood", at("hood.height"), least=3.5),
    Dimension(
        "neck depth",
        "fall of the front neckline from the shoulder",
        at("front_neck.depth"),
        least=2.0,
        share=0.08,
        stated=Stated("neck_depth_cm", 1.5, 0.08),
    ),
    Dimension(
        "neck width",
        "width of the neckline",
        lambda f: 2 * f.front_neck.width if f.front_neck else None,
        least=2.5,
        share=0.1,
    ),
    Dimension(
        "back depth",
        "fall of the back neckline from the shoulder",
        at("back_neck.depth"),
        least=2.5,
        share=0.1,
        stated=Stated("back_depth_cm", 1.5, 0.08, 4.0),
    ),
    Dimension("shoulders", "length of the shoulder seam", shoulder_length, least=2.0),
    Dimension("armholes", "depth of the armholes", _armholes, least=3.0),
    Dimension(
        "chest",
        "around the chest",
        at("torso.chest"),
        least=3.0,
        share=0.03,
        stated=Stated("chest_cm", 4.0, 0.04),
    ),
    Dimension("top width", "around the hem of a top", _top_width, least=6.0, share=0.06),
    Dimension(
        "skirt hem",
        "around the hem of a skirt",
        at("skirt.hem"),
        least=8.0,
        share=0.08,
        stated=Stated("hem_cm", 8.0, 0.08),
    ),
    Dimension("skirt gathers", "skirt over waist", at("skirt.gather"), least=0.12, unit="times"),
    Dimension(
        "bodice gathers",
        "bodice over waist",
        at("torso.gather"),
        least=0.15,
        unit="times",
        none_below=1.0,
    ),
    Dimension(
        "tier gathers",
        "lower tiers over upper ones",
        _where(lambda s: s.tiers > 1, "skirt.tier_gather"),
        least=0.12,
        unit="times",
    ),
    Dimension(
        "tiers",
        "rows of a tiered skirt, the first included",
        at("skirt.tiers"),
        least=1.0,
        unit="pieces",
        stated=_pieces("tiers", "skirt.tiers", 2.0),
    ),
    Dimension(
        "gores",
        "panels around a gored skirt",
        _where(lambda s: s.gores > 3, "skirt.gores"),
        least=1.0,
        unit="pieces",
        stated=_pieces("gores", "skirt.gores", 4.0),
    ),
    Dimension(
        "godets",
        "number of godets",
        _where(lambda s: s.godets, "skirt.godets"),
        least=1.0,
        unit="pieces",
        stated=_pieces("godets", "skirt.godets", 1.0),
    ),
    Dimension(
        "godet width", "width of the godets", _where(lambda s: s.godets, "skirt.godet_width"), least=4.0
    ),
    Dimension(
        "godet height",
        "height of the godets",
        _where(lambda s: s.godets, "skirt.godet_height"),
        least=4.0,
        stated=Stated("godet_cm", 2.5, 0.1),
    ),
    Dimension("front slit", "height of the slit in front", slit_height("front"), least=4.0, closes=True),
    Dimension("back slit", "height of the slit behind", slit_height("back"), least=4.0, closes=True),
    Dimension("left slit", "height of the slit on the left", slit_height("left"), least=4.0, closes=True),
    Dimension("right slit", "height of the slit on the right", slit_height("right"), least=4.0, closes=True),
    Dimension("slits", "height of the highest slit", slit_height(), stated=Stated("slit_cm", 2.5, 0.08, 5.0)),
    Dimension(
        "base width",
        "around the first row of a tiered or godet skirt",
        _where(lambda s: s.tiers > 1 or s.godets, "skirt.base_hem"),
        least=6.0,
        share=0.06,
    ),
    Dimension("dip", "front of the hem above its back", _dip, least=6.0),
)

DIMENSIONS: Mapping[str, Dimension] = {dimension.name: dimension for dimension in _TABLE}
"""All of them, by name."""
QUANTITIES: Mapping[str, Dimension] = {d.name: d for d in _TABLE if math.isfinite(d.least)}
"""Those that people ask more or less of, by name; documented in docs/edits.md."""
STATED: Mapping[str, Dimension] = {d.stated.claim: d for d in _TABLE if d.stated is not None}
"""Those that are claimed with a number, by the name of the claim; documented in docs/captions.md."""

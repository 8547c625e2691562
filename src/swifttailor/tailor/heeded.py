"""A design that was read in a picture or in words, changed where that is needed to do what words ask.

Cutting a draft to words bends the pattern of another design: a skirt that is gathered more than was asked
keeps its panels. Words are certain and what is read of a design is not, so the likeliest of the designs that
do what the words ask is nearer to the garment in the picture.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.describing.differences import Change, Gain
from swifttailor.errors import SwiftTailorError
from swifttailor.parameter_reader.agreement import Design
from swifttailor.parameter_reader.reader import ParameterReader
from swifttailor.parameter_reader.which_matter import matters
from swifttailor.pattern import Pattern, Severity, check_pattern
from swifttailor.programs import complete_design, make_pattern
from swifttailor.programs.read_parameter import ReadParameter
from swifttailor.tailor.reading import Wanted, facts_of

MOST_TRIED, MOST_CHANGED = 32, 3
"""So many other values are tried in each round, and in so many rounds one of them is taken."""
LEAST_SHARE = 1e-5
"""What is less likely counts as likely as this."""
PLACES = 8
"""Of a number so many values are tried, spread over its ranges."""
_ASYMMETRIC = "left.enable_asym"
_LENGTHS = ("length", "rise", "num_levels", "low_angle")
_NECK = ("collar.", "strapless")
_SLEEVE = ("sleeve.",)
_SLIT = ("_slit", ".cut.")
_SKIRT = ("meta.bottom", "skirt.")
_ABOUT: Mapping[str, tuple[str, ...]] = {
    **dict.fromkeys(("kind", "top_hem"), ("meta.", *_LENGTHS, "level")),
    **dict.fromkeys(("fit", "chest_cm"), ("shirt.", "meta.upper", "connecting_width")),
    **dict.fromkeys(("skirt_hem", "skirt_length_cm", "length_cm"), _LENGTHS),
    **dict.fromkeys(("leg_hem", "inseam_cm"), ("pants.length", "pants.rise", "pants.cuff.cuff_len")),
    "hem_shape": (
        "front_length",
        "low_angle",
        "meta.bottom",
        "levels-skirt.base",
        "levels-skirt.level",
        ".cut.",
    ),
    **dict.fromkeys(("slit", "slit_size", "slit_cm"), _SLIT),
    **dict.fromkeys(("neckline", "left_neckline", "right_neckline", "neck_depth", "neck_depth_cm"), _NECK),
    **dict.fromkeys(("back_neckline", "back_depth", "back_depth_cm", "straps"), _NECK),
    **dict.fromkeys(("collar", "hood", "collar_cm"), ("collar.component.", *_NECK)),
    **dict.fromkeys(("sides", "shoulders"), (*_SLEEVE, *_NECK)),
    **dict.fromkeys(("armholes", "sleeves", "left_sleeve", "right_sleeve", "sleeve_shape"), _SLEEVE),
    **dict.fromkeys(("cuffs", "sleeve_cm", "sleeve_width_cm", "cuff_cm"), _SLEEVE),
    "bodice": ("meta.upper", "shirt.flare", "shirt.width", "strapless"),
    **dict.fromkeys(("skirt", "hem_cm", "tiers", "gores", "godets", "godet_cm", "hips"), _SKIRT),
    **dict.fromkeys(("waist_seam", "rise"), ("rise", "shirt.length", "meta.", "waistband.")),
    **dict.fromkeys(("waistband", "waistband_cm"), ("meta.wb", "waistband.")),
    **dict.fromkeys(("legs", "leg_width_cm"), ("pants.width", "pants.flare", "meta.bottom")),
    **dict.fromkeys(("leg_cuffs", "leg_cuff_cm"), ("pants.cuff.",)),
}
"""Parts of names of the parameters that decide about a claim."""
_ONE_SIDED = frozenset(
    {
        *("sides", "shoulders", "neckline", "left_neckline", "right_neckline"),
        *("sleeves", "left_sleeve", "right_sleeve"),
    }
)
"""Claims that may ask for two sides that are not alike."""


def heeded(
    design: Design, pattern: Pattern, wanted: Wanted, reader: ParameterReader
) -> tuple[Design, Pattern]:
    """The likeliest design near one whose draft does more of what words ask for.

    Args:
        design: What was read.
        pattern: Its draft.
        wanted: With what its words ask for.
        reader: Who read it.

    Returns:
        The same where words ask for nothing that the draft does not do, or no other draft does more.
    """
    asked = [wish.change for wish in wanted.said]
    least = _open(pattern, asked)
    if not least:
        return design, pattern
    seen = None if wanted.part is None else wanted.part.design
    shares = reader.shares(wanted.sought, seen)
    for _ in range(MOST_CHANGED):
        names = frozenset(change.claim.name for change in least if isinstance(change, Gain))
        for change in _others(design, reader.parameters, shares, names)[:MOST_TRIED]:
            other = design | change
            drafted = _drafted(other)
            if drafted is None:
                continue
            left = _open(drafted, asked)
            if len(left) < len(least):
                design, pattern, least = other, drafted, left
                break
        else:
            break
        if not least:
            break
    return design, pattern


def _open(pattern: Pattern, asked: Sequence[Change]) -> list[Change]:
    """What of that which is asked for does not hold."""
    facts = facts_of(pattern)
    return [change for change in asked if facts is None or not change.holds(facts, facts)]


def _drafted(design: Design) -> Pattern | None:
    """Its draft; None where the programs refuse it or it has errors."""
    try:
        pattern = make_pattern(design).canonical()
    except SwiftTailorError:
        return None
    return None if any(found.severity is Severity.ERROR for found in check_pattern(pattern)) else pattern


def _others(
    design: Design,
    parameters: Sequence[ReadParameter],
    shares: Sequence[Floats],
    claims: Collection[str],
) -> list[dict[str, Any]]:
    """Other values of what decides about some claims, the likeliest first."""
    about = tuple({part for name in claims for part in _ABOUT.get(name, ())})
    found = list(_of_one(design, parameters, shares, about))
    if _ONE_SIDED.intersection(claims) and not design.get(_ASYMMETRIC, True):
        sided = design | {_ASYMMETRIC: True}
        found.append((0.0, {_ASYMMETRIC: True}))
        found += [
            (cost, change | {_ASYMMETRIC: True}) for cost, change in _of_one(sided, parameters, shares, about)
        ]
    return [change for _, change in sorted(found, key=lambda other: other[0])]


def _of_one(
    design: Design, parameters: Sequence[ReadParameter], shares: Sequence[Floats], about: Sequence[str]
) -> Iterator[tuple[float, dict[str, Any]]]:
    """Other values of one parameter, and how much less likely each is: a logarithm."""
    count = matters(complete_design(design))
    for one, share in zip(parameters, shares, strict=True):
        if one.name not in count or one.name not in design or not any(part in one.name for part in about):
            continue
        now = one.place_of(design[one.name])
        likely = np.log(np.maximum(share, LEAST_SHARE))
        last = len(share) - 1
        places = np.linspace(0, last, PLACES).round().astype(int) if one.is_number else range(last + 1)
        for k in places:
            if k != now:
                yield float(likely[now] - likely[k]), {one.name: one.values[k]}

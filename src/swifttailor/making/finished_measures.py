"""The measurements of the finished garment, as a tailor's table has them: taken on the flat panels."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from swifttailor.body import Body
from swifttailor.body.wearer import body_of
from swifttailor.describing import GarmentFacts
from swifttailor.describing.measuring import measure_facts
from swifttailor.describing.measuring.anatomy import Anatomy
from swifttailor.errors import InputError
from swifttailor.inches import CM_PER_INCH
from swifttailor.pattern import Pattern
from swifttailor.pattern.finding import Finding, Severity

_EIGHTHS = ("", "1/8", "1/4", "3/8", "1/2", "5/8", "3/4", "7/8")
_ALIKE_CM = 0.25
"""Sleeves that differ by less are told once."""


@dataclass(frozen=True)
class MeasuresColumn:
    """The measurements of one size."""

    size: str
    """Empty where there is but one."""
    cm: Mapping[str, float]


def finished_measures(pattern: Pattern) -> dict[str, float]:
    """Measures a garment as it comes off the table, seams closed and gathers drawn up, cm.

    Args:
        pattern: Where its file names no body, the default body says where waist and hips are.

    Returns:
        Names and cm, from top to bottom.

    Raises:
        InputError: No body has the measures that the pattern names.
    """
    body = body_of(pattern.drafted_for)
    facts = measure_facts(pattern, body.measurements)
    found: dict[str, float | None] = {}
    torso, band, skirt, legs = facts.torso, facts.waistband, facts.skirt, facts.trousers
    lower = skirt is not None or legs is not None
    if torso is not None:
        found["chest"] = torso.chest
        found["waist seam" if lower else "waist"] = _waist(facts) if lower else torso.waist
    elif lower:
        found["upper edge"] = _waist(facts) or _top_edge(pattern, body)
    if skirt is not None:
        found |= {"hips": skirt.hips, "hem": skirt.hem}
    elif legs is not None:
        found |= {"hips": legs.hips, "thigh": legs.thigh, "leg hem": legs.opening, "inside leg": legs.inseam}
    elif torso is not None:
        found["hem"] = band.lower if band is not None and band.at_hem else torso.lower_edge
    found["length"] = facts.length
    found |= _sleeves(facts)
    return {name: value for name, value in found.items() if value is not None and value > 0.0}


def in_inches(cm: float) -> str:
    """Inches to the nearest eighth: ``42 3/8``."""
    whole, eighths = divmod(round(cm / CM_PER_INCH * 8), 8)
    return f"{whole} {_EIGHTHS[eighths]}".strip()


def measure_names(columns: Sequence[MeasuresColumn]) -> list[str]:
    """The names of all that is measured in some size, in their order."""
    return list(dict.fromkeys(name for column in columns for name in column.cm))


def wearer_findings(pattern: Pattern) -> list[Finding]:
    """Says why a pattern is printed without its finished measurements, where no body has those it names."""
    try:
        body_of(pattern.drafted_for)
    except InputError as error:
        reason = str(error).rstrip(".")
        message = (
            "the measurements of the finished garment are left out. The pattern names its wearer, but "
            f"{reason[0].lower()}{reason[1:]}"
        )
        return [Finding("no-such-wearer", Severity.WARNING, message)]
    return []


def finished_column(pattern: Pattern, size: str = "") -> MeasuresColumn | None:
    """The measurements of one size; None where no body has the measures that the pattern's file names.

    Whoever prints a pattern needs the pattern; a file that names an impossible wearer is still printed, and
    `wearer_findings` says why they are left out.
    """
    try:
        return MeasuresColumn(size, finished_measures(pattern))
    except InputError:
        return None


def measures_table(columns: Sequence[MeasuresColumn], *, inches: bool) -> list[list[str]]:
    """Rows of words: names, then one column a size."""
    shown = in_inches if inches else (lambda cm: f"{cm:.1f}")
    return [
        [name, *(shown(column.cm[name]) if name in column.cm else "-" for column in columns)]
        for name in measure_names(columns)
    ]


def _waist(facts: GarmentFacts) -> float | None:
    """Around the band, or what a lower part is sewn to."""
    if facts.waistband is not None and not facts.waistband.at_hem:
        return facts.waistband.upper
    if facts.skirt is not None:
        return facts.skirt.upper
    return facts.torso.lower_edge / facts.torso.gather if facts.torso is not None else None


def _top_edge(pattern: Pattern, body: Body) -> float | None:
    """Around the upper edge of trousers without a band."""
    anatomy = Anatomy.of(pattern.canonical(), body.measurements)
    return None if anatomy.top is None else sum(map(anatomy.edge_length, anatomy.top.edges))


def _sleeves(facts: GarmentFacts) -> dict[str, float]:
    """Length and widths of both sleeves; apart where they differ."""
    taken = {
        side: {"sleeve length": one.length, "sleeve width": one.upper_width, "sleeve opening": one.opening}
        for side, one in (("left", facts.left_sleeve), ("right", facts.right_sleeve))
        if one is not None
    }
    if len(taken) == 2:
        left, right = taken.values()
        if all(abs(left[name] - right[name]) < _ALIKE_CM for name in left):
            return {name: (left[name] + right[name]) / 2 for name in left}
    return {f"{name}, {side}": value for side, own in taken.items() for name, value in own.items()}

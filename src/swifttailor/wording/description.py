"""A pattern described: what is measured on it, what can be said of it, and a text that says so."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.body import BodyMeasurements
from swifttailor.describing import Claim, GarmentFacts, claims_of, measure_facts
from swifttailor.pattern import Pattern
from swifttailor.wording.captions import write_caption


@dataclass(frozen=True, eq=False)
class Description:
    """What a pattern shows."""

    facts: GarmentFacts
    """Measures in cm, by part of the garment."""
    claims: tuple[Claim, ...]
    """Everything that can safely be said of it, such as ``Claim("sleeves", "long")``; docs/captions.md."""
    caption: str
    """Some of it, in English."""

    def __str__(self) -> str:
        return self.caption


def describe(
    pattern: Pattern, *, seed: int = 0, style: str | None = None, body: BodyMeasurements | None = None
) -> Description:
    """Describes a pattern.

    Args:
        pattern: Any pattern placed around a body.
        seed: Decides style, words, order, dialect and units of the caption.
        style: Of the caption, one of `captions.STYLES`; chosen by the seed when None.
        body: Who the pattern is made for; the default body when None.

    Raises:
        InputError: There is no such style.
        PatternError: The pattern cannot be measured.
    """
    facts = measure_facts(pattern, body)
    return Description(facts, claims_of(facts), write_caption(facts, seed, style=style).text)

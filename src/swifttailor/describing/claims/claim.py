"""Claims: statements about a garment that can be recomputed from a pattern."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field

from swifttailor.describing.claims.hems import HEM_CLAIMS
from swifttailor.describing.claims.judgement import CLAIMING, HOLDING, Predicate
from swifttailor.describing.claims.lower import LOWER_CLAIMS
from swifttailor.describing.claims.sleeves import SLEEVE_CLAIMS
from swifttailor.describing.claims.upper import UPPER_CLAIMS
from swifttailor.describing.claims.whole import WHOLE_CLAIMS
from swifttailor.describing.dimensions import STATED, Dimension
from swifttailor.describing.facts import GarmentFacts
from swifttailor.errors import InputError

Value = str | float


@dataclass(frozen=True)
class ClaimType:
    """One thing that can be said about garments: a choice of words, or a measure in cm or pieces."""

    name: str
    about: str
    """What it is about, for documentation."""
    words: Mapping[str, Predicate] = field(default_factory=dict)
    """Values that can be claimed and when they are true; several may be true at once."""
    measure: Dimension | None = None
    """For a number: what it is the measure of."""
    least: float = 0.0
    """For a number: smaller ones are not claimed."""


def _types() -> Iterator[ClaimType]:
    for group in (WHOLE_CLAIMS, HEM_CLAIMS, UPPER_CLAIMS, SLEEVE_CLAIMS, LOWER_CLAIMS):
        for name, (about, words) in group.items():
            yield ClaimType(name, about, words=words)
    for name, dimension in STATED.items():
        assert dimension.stated is not None
        about = dimension.stated.about or dimension.about
        yield ClaimType(name, about, measure=dimension, least=dimension.stated.least)


CLAIM_TYPES: Mapping[str, ClaimType] = {t.name: t for t in _types()}
"""All claims there are, by name. The set is documented in docs/captions.md; names and values are stable."""


@dataclass(frozen=True, order=True)
class Claim:
    """A statement such as ``Claim("sleeves", "long")`` or ``Claim("sleeve_cm", 58.0)``."""

    name: str
    """A key of `CLAIM_TYPES`."""
    value: Value

    def __post_init__(self) -> None:
        kind = CLAIM_TYPES.get(self.name)
        if kind is None:
            raise InputError(f"There is no claim '{self.name}'. Known: {', '.join(CLAIM_TYPES)}.")
        if kind.measure is not None:
            if isinstance(self.value, str) or not 0.0 <= self.value < 1e5:
                raise InputError(f"The claim '{self.name}' takes a number from 0, received {self.value!r}.")
            object.__setattr__(self, "value", float(self.value))
        elif self.value not in kind.words:
            known = ", ".join(kind.words)
            raise InputError(f"The claim '{self.name}' has no value {self.value!r}. Known: {known}.")

    def holds(self, facts: GarmentFacts) -> bool:
        """Whether the statement is true of a garment, borderline cases included."""
        kind = CLAIM_TYPES[self.name]
        if kind.measure is not None:
            return kind.measure.is_stated_right(facts, float(self.value))
        return kind.words[str(self.value)](facts, HOLDING)

    def to_json(self) -> dict[str, Value]:
        """The claim as plain JSON values; ``Claim(**values)`` reads it back."""
        return {"name": self.name, "value": self.value}


def claims_of(facts: GarmentFacts, names: Collection[str] | None = None) -> tuple[Claim, ...]:
    """All claims that can safely be made about a garment, in the order of `CLAIM_TYPES`.

    Args:
        facts: Of the garment.
        names: Of the claims that are asked for; all of them when None.
    """
    made = []
    for kind in CLAIM_TYPES.values():
        if names is not None and kind.name not in names:
            continue
        if kind.measure is not None:
            value = kind.measure.stated_measure(facts)
            if value is not None and value >= kind.least:
                made.append(Claim(kind.name, round(value, 1)))
        else:
            made += [Claim(kind.name, word) for word, test in kind.words.items() if test(facts, CLAIMING)]
    return tuple(made)

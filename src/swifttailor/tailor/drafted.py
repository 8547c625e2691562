"""Drafts of ours, as a source of candidates beside known patterns and the writer."""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from swifttailor.errors import InputError
from swifttailor.pattern import Pattern
from swifttailor.pattern.drafts.draft_kinds import DRAFT_KINDS
from swifttailor.pattern.drafts.draft_names import ARMHOLE, NamedDraft
from swifttailor.pattern.drafts.measurements import DraftMeasurements, Measurements
from swifttailor.pattern_maker.maker import WrittenPattern
from swifttailor.tailor.known import LEAST_CLOSE
from swifttailor.tailor.reading import Wanted

VARIED = frozenset({"length", "flare", "neck_depth", "neck_widening", "sleeve_length", "dip"})
"""Options that differ from seed to seed."""
SHARE = 0.25
"""How far at most, towards either end of what an option accepts."""
_SLEEVE_END, _THICKER = "sleeve_end", 1.1
"""An option that is told for usual arms, and times the armhole from which arms are thicker."""
_NARROWS_CM, _WIDE_CM = -9.0, 30.0
"""By how much hems of such legs are narrower than the knee, and room of wide ones, cm."""
_NOT_DRAFTED = (
    "Garments begin from a draft where the lexicon names one, and in this text it does not: choose another "
    "--source. swifttailor draft --list names all drafts."
)


@dataclass(frozen=True)
class DraftCandidate:
    """A garment that words name and a draft shows."""

    draft: NamedDraft
    seed: int
    plain: bool
    """Whether every option is as the words' table has it, or the draft by itself."""

    @property
    def name(self) -> str:
        """Of the draft."""
        return self.draft.name

    def take(self) -> WrittenPattern:
        """The pattern, for the default body."""
        return WrittenPattern(self.made_for(None))

    def made_for(self, measurements: Measurements | None) -> Pattern:
        """The pattern for a body; the default body when None."""
        from swifttailor.pattern.drafts import draft

        options: dict[str, Any] = {**dict(self.draft.options), **self._ends_for(measurements)}
        if not self.plain:
            options |= self._varied(options)
        return draft(self.name, measurements=measurements, **self._accepted(options))

    @property
    def narrows_or_is_wide(self) -> bool:
        """Whether its legs narrow to the hem, or are wide, which legs refitted to large bodies hardly are."""
        from swifttailor.pattern.drafts import find_draft

        options: dict[str, Any] = {field.name: field.default for field in find_draft(self.name).options}
        options |= dict(self.draft.options)
        return float(options["flare"]) <= _NARROWS_CM or float(options["leg_ease"]) >= _WIDE_CM

    def as_long_on(self, measurements: Measurements) -> Pattern:
        """The pattern of legs for a large body, which end as high in proportion as usual."""
        from swifttailor.pattern.drafts import draft, find_draft
        from swifttailor.pattern.drafts.figure import Figure
        from swifttailor.pattern.drafts.measurements import DraftMeasurements

        options: dict[str, Any] = dict(self.draft.options)
        if not self.plain:
            options |= self._varied(options)
        own = {field.name: field.default for field in find_draft(self.name).options}
        taller = Figure.of(measurements).waist_y / Figure.of(DraftMeasurements()).waist_y
        options["length"] = round(taller * float(options.get("length", own["length"])), 1)
        return draft(self.name, measurements=measurements, **self._accepted(options))

    @property
    def has_wings(self) -> bool:
        """Whether its sleeves are cut in one with the body, so that it must be drafted anew for each body."""
        return dict(self.draft.options).get(ARMHOLE) == "cut-in-one"

    def _ends_for(self, measurements: Measurements | None) -> dict[str, float]:
        """Ends of sleeves that are wider for arms thicker than usual, as the sleeve is above them."""
        from swifttailor.pattern.drafts import find_draft

        usual = DraftMeasurements().armscye_depth
        thicker = 1.0 if measurements is None else measurements.armscye_depth / usual
        ends = [field for field in find_draft(self.name).options if field.name == _SLEEVE_END]
        if thicker <= _THICKER or not ends or DRAFT_KINDS[self.name] != "top":
            return {}
        return {_SLEEVE_END: thicker * float(dict(self.draft.options).get(_SLEEVE_END, ends[0].default))}

    def _accepted(self, options: dict[str, Any]) -> dict[str, Any]:
        """Options within what the draft accepts: what words ask for together may be more than it can be."""
        from swifttailor.pattern.drafts import find_draft

        within = dict(options)
        for field in find_draft(self.name).options:
            low, high, asked = field.option.low, field.option.high, options.get(field.name)
            if low is not None and high is not None and isinstance(asked, int | float):
                within[field.name] = min(max(asked, low), high)
        return within

    def _varied(self, options: dict[str, Any]) -> dict[str, float]:
        from swifttailor.pattern.drafts import find_draft

        chance = random.Random(self.seed)
        chosen = {}
        for field in find_draft(self.name).options:
            low, high = field.option.low, field.option.high
            if field.name not in VARIED or low is None or high is None:
                continue
            end, usual = chance.choice([low, high]), float(options.get(field.name, field.default))
            value = usual + SHARE * chance.random() * (end - usual)
            chosen[field.name] = round(value, 1)
        return chosen


MOST_DRAFTS = 2
"""Drafts that are tried for a garment: what the first cannot be cut to, the next may be."""


def draft_candidates(samples: Sequence[tuple[Wanted, int]]) -> list[tuple[DraftCandidate, ...]]:
    """The drafts that each sample begins from; none where words name none, or only others are asked for.

    Every fourth seed, 0 among them, has the draft with its defaults; others vary it.

    Raises:
        InputError: Only drafts are asked for, and none is named.
    """
    found: list[tuple[DraftCandidate, ...]] = []
    for wanted, seed in samples:
        order = wanted.order
        may_be = order.source in ("both", "drafts") and order.edit is None and order.alter
        named = wanted.heard.drafts if may_be and wanted.part is None else ()
        if order.source == "drafts" and not named:
            raise InputError(_NOT_DRAFTED)
        plain = order.temperature == 0 or seed % LEAST_CLOSE == 0
        found.append(tuple([DraftCandidate(draft, seed, plain) for draft in named[:MOST_DRAFTS]]))
    return found

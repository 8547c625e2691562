"""What is sought: what a picture shows, what words ask for, or both."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.describing.claims import CLAIM_TYPES, Claim
from swifttailor.describing.differences import Gain
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.pattern_library.truth_table import scaled
from swifttailor.picture_reader.labels import BOX, measure_labels, statement_labels
from swifttailor.picture_reader.truth import TRUE, UNCLEAR, Truth
from swifttailor.picture_reader.units import MEASURE_CM

if TYPE_CHECKING:
    from swifttailor.picture_reader.reading import PartReading
    from swifttailor.wishes.reader import Wish

SURE = 0.98
"""No statement of a picture, and none that is simply true, is surer: readers err."""
ASKED = 0.999
"""What words ask for with certainty."""
WORDS, BESIDE_PICTURE = 4.0, 1.0
"""A statement of words alone counts as much as so many of a picture, and beside a picture: what words ask for
is cut in any case, and the picture tells more of the rest the less is given up for it."""
USUAL = 8.0
"""What a measure usually is counts as much as so many measures of a picture: it is one of few."""
GENTLY = 2.0
"""The same of what can be cut as well."""
FORESEEN, FORESEEN_BESIDE_PICTURE = 2.0, 1.0
"""What a network foresees of panels from words counts as much as so many readings of a picture."""
_SUREST_ODDS = 4.6
"""Of a panel that is foreseen, as a logarithm: 99 %."""
UNTOLD, UNTOLD_PANEL, UNTOLD_MEASURE = 0.02, 0.02, 0.02
"""Probability of what a reading leaves out (`said.LEAST_CERTAINTY`)."""
EXACT = 0.05
"""Width of a measure that is true, `scaled`."""
_HALF = float(np.log(2))


@dataclass(frozen=True, eq=False)
class Sought:
    """Probabilities of what may be true of a garment, and how much each counts: 0 where nothing is known."""

    statements: NDArray[np.float32]
    """(S,) probability of each statement."""
    said: NDArray[np.float32]
    """(S,) how much it counts."""
    has: NDArray[np.float32]
    """(M,) probability that there is such a thing to measure."""
    measured: NDArray[np.float32]
    """(M, 2) middle and width of a Laplace distribution of the `scaled` measure."""
    measures: NDArray[np.float32]
    """(M,) how much it counts."""
    panels: NDArray[np.float32]
    """(P,) probability of each panel name."""
    named: NDArray[np.float32]
    """(P,) how much it counts."""
    boxes: NDArray[np.float32]
    """(P, 5) `BOX`, cm."""
    placed: NDArray[np.float32]
    """(P,) how much it counts."""

    @staticmethod
    def nothing() -> Sought:
        """Whatever."""
        statements, measures, panels = (len(n) for n in (statement_labels(), measure_labels(), PANEL_NAMES))
        return Sought(
            *(_filled(statements, v) for v in (0.5, 0.0)),
            _filled(measures, 0.5),
            np.tile(np.array([0.0, 1.0], np.float32), (measures, 1)),
            _filled(measures, 0.0),
            *(_filled(panels, v) for v in (0.5, 0.0)),
            np.zeros((panels, len(BOX)), np.float32),
            _filled(panels, 0.0),
        )

    @staticmethod
    def of_reading(reading: PartReading) -> Sought:
        """What a picture shows of one part of the body; what was not told is unlikely."""
        found = Sought.nothing()
        found.statements[:], found.said[:] = UNTOLD, 1.0
        for statement in reading.statements:
            number = _statement_numbers()[statement.claim.name, str(statement.claim.value)]
            found.statements[number] = min(statement.certainty, SURE)
        found.has[:], found.measures[:] = UNTOLD_MEASURE, 1.0
        for measure in reading.measures:
            number = _measure_numbers()[measure.name]
            found.has[number] = min(measure.certainty, SURE)
            found.measured[number] = scaled(measure.value), _scaled_width(measure.value, measure.off / _HALF)
        found.panels[:], found.named[:] = UNTOLD_PANEL, 1.0
        for panel in reading.panels:
            number = _panel_numbers()[panel.name]
            found.panels[number] = min(panel.certainty, SURE)
            found.boxes[number], found.placed[number] = panel.box, panel.certainty
        return found

    @staticmethod
    def of_words(wishes: Iterable[Wish]) -> Sought:
        """What words ask for; of what they do not speak nothing is known. Steps (`Step`) are passed over."""
        found = Sought.nothing()
        for wish in wishes:
            if isinstance(wish.change, Gain):
                found._ask(wish.change.claim, wish.certainty)
        return found

    @staticmethod
    def of_claims(claims: Iterable[Claim]) -> Sought:
        """The same, of what is asked for with certainty."""
        found = Sought.nothing()
        for claim in claims:
            found._ask(claim, 1.0)
        return found

    @staticmethod
    def of_truth(truth: Truth) -> Sought:
        """All that is true of a pattern, as if it had been read without a mistake."""
        found = Sought.nothing()
        found.statements[:] = np.where(truth.statements == TRUE, SURE, 1 - SURE)
        found.said[:] = truth.statements != UNCLEAR
        known = np.isfinite(truth.measures)
        found.has[:], found.measures[:] = np.where(known, SURE, 1 - SURE), 1.0
        found.measured[known, 0], found.measured[known, 1] = scaled(truth.measures[known]), EXACT
        found.panels[:], found.named[:] = np.where(truth.panels > 0, SURE, 1 - SURE), 1.0
        found.boxes[:], found.placed[:] = truth.boxes, truth.panels
        return found

    @staticmethod
    def of(
        reading: PartReading | None,
        wishes: Sequence[Wish] = (),
        never: Iterable[Claim] = (),
        foreseen: NDArray[np.float64] | None = None,
    ) -> Sought:
        """What a picture shows, and what words ask for and refuse; words outrank it.

        Args:
            reading: Of the picture; None where there are words alone.
            wishes: What words ask for.
            never: What they refuse.
            foreseen: Odds of panels from the words (`PanelForesight.odds`).
        """
        asked = Sought.of_words(wishes)
        for claim in never:
            asked._refuse(claim)
        if reading is None:
            return asked.with_panels(foreseen, FORESEEN)
        share = BESIDE_PICTURE / WORDS
        beside = replace(asked, said=asked.said * share, measures=asked.measures * share)
        return Sought.of_reading(reading).outranked_by(beside).with_panels(foreseen, FORESEEN_BESIDE_PICTURE)

    def with_panels(self, odds: NDArray[np.float64] | None, weight: float) -> Sought:
        """The same, and what else is known of which panels there are: both count, as if independent.

        Args:
            odds: (P,) of each panel, as a logarithm; nothing is added when None.
            weight: How much they count.
        """
        if odds is None:
            return self
        own = np.log(self.panels / (1 - self.panels)) * self.named
        counts = self.named + np.float32(weight)
        both = (own + np.clip(odds, -_SUREST_ODDS, _SUREST_ODDS) * weight) / counts
        return replace(self, panels=(1 / (1 + np.exp(-both))).astype(np.float32), named=counts)

    def with_measures(self, usual: Mapping[str, tuple[float, float]], counts: float = USUAL) -> Sought:
        """The same, and of measures that nothing is known of what they usually are.

        Args:
            usual: Middle and width of each.
            counts: As much as so many measures of a picture.
        """
        if not usual:
            return self
        has, measured, measures = self.has.copy(), self.measured.copy(), self.measures.copy()
        for name, (middle, width) in usual.items():
            number = _measure_numbers()[name]
            if measures[number] == 0:
                has[number], measures[number] = SURE, counts
                measured[number] = scaled(middle), _scaled_width(middle, width)
        return replace(self, has=has, measured=measured, measures=measures)

    def outranked_by(self, words: Sought) -> Sought:
        """The same, but of each claim and measure that words speak of what words say."""
        claims = _claim_numbers()
        spoken = np.isin(claims, np.unique(claims[words.said > 0]))
        measured = words.measures > 0
        return replace(
            self,
            statements=np.where(spoken, words.statements, self.statements),
            said=np.where(spoken, words.said, self.said),
            has=np.where(measured, words.has, self.has),
            measured=np.where(measured[:, None], words.measured, self.measured),
            measures=np.where(measured, words.measures, self.measures),
        )

    def only(self, *, statements: bool, measures: bool, panels: bool, boxes: bool) -> Sought:
        """The same without some of it."""
        return replace(
            self,
            said=self.said * statements,
            measures=self.measures * measures,
            named=self.named * panels,
            placed=self.placed * boxes,
        )

    @property
    def is_empty(self) -> bool:
        """Whether nothing is known of what is sought."""
        return not any(w.any() for w in (self.said, self.measures, self.named, self.placed))

    def _refuse(self, claim: Claim) -> None:
        number = _statement_numbers().get((claim.name, str(claim.value)))
        if number is not None and self.said[number] == 0:
            self.statements[number], self.said[number] = 1 - ASKED, WORDS

    def _ask(self, claim: Claim, certainty: float) -> None:
        dimension = CLAIM_TYPES[claim.name].measure
        if dimension is None:
            number = _statement_numbers()[claim.name, str(claim.value)]
            self.statements[number], self.said[number] = min(certainty, ASKED), WORDS
            return
        assert dimension.stated is not None
        number, value = _measure_numbers()[dimension.name], float(claim.value)
        off = max(dimension.stated.within, dimension.stated.share * value)
        self.has[number], self.measures[number] = min(certainty, ASKED), WORDS
        self.measured[number] = scaled(value), _scaled_width(value, off)


def _scaled_width(value: float, width: float) -> float:
    """A width in cm at some value, `scaled`."""
    return max(width / float(np.hypot(value, MEASURE_CM)), EXACT / 5)


def _filled(count: int, value: float) -> NDArray[np.float32]:
    return np.full(count, value, np.float32)


@cache
def _statement_numbers() -> dict[tuple[str, str], int]:
    return {label: k for k, label in enumerate(statement_labels())}


@cache
def _claim_numbers() -> NDArray[Any]:
    """(S,) number of the claim of each statement."""
    names = [claim for claim, _ in statement_labels()]
    return np.array([names.index(name) for name in names])


@cache
def _measure_numbers() -> dict[str, int]:
    return {name: k for k, name in enumerate(measure_labels())}


@cache
def _panel_numbers() -> dict[str, int]:
    return {name: k for k, name in enumerate(PANEL_NAMES)}

"""What is true of a garment, as the numbers that a picture reader is to say."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swifttailor.describing.claims import CLAIM_TYPES
from swifttailor.describing.claims.judgement import CLAIMING, HOLDING
from swifttailor.describing.dimensions import DIMENSIONS
from swifttailor.describing.facts import GarmentFacts
from swifttailor.pattern import Pattern
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.picture_reader.labels import BOX, PARTS, measure_labels, statement_labels

FALSE, TRUE, UNCLEAR = 0, 1, 2
_NUMBER = {name: k for k, name in enumerate(PANEL_NAMES)}


@dataclass(frozen=True, eq=False)
class Truth:
    """What a picture of a garment shows, whether it can be seen in it or not."""

    part: int
    """Of `PARTS`."""
    statements: NDArray[np.uint8]
    """(S,) `FALSE`, `TRUE`, or `UNCLEAR` on the border between both."""
    measures: NDArray[np.float32]
    """(M,) cm, pieces or ratios; NaN where the garment has no such thing."""
    panels: NDArray[np.uint8]
    """(P,) 1 for panel names that the pattern has."""
    boxes: NDArray[np.float32]
    """(P, 5) `BOX` of each; zeros for panels that it has not."""

    @staticmethod
    def of(pattern: Pattern, facts: GarmentFacts) -> Truth:
        """Of a pattern and what was measured on it."""
        statements = [_judged(claim, word, facts) for claim, word in statement_labels()]
        found = [DIMENSIONS[name].stated_measure(facts) for name in measure_labels()]
        measures = [np.nan if value is None else value for value in found]
        panels = np.zeros(len(PANEL_NAMES), np.uint8)
        boxes = np.zeros((len(PANEL_NAMES), len(BOX)), np.float32)
        for panel in pattern.panels:
            number = _NUMBER.get(panel.name)
            if number is not None:
                low, high = panel.bounding_box()
                middle = panel.to_world(((low + high) / 2)[None])[0]
                panels[number], boxes[number] = 1, (*middle, *(high - low))
        part = PARTS.index("upper" if facts.torso is not None else "lower")
        return Truth(part, np.array(statements, np.uint8), np.array(measures, np.float32), panels, boxes)


def _judged(claim: str, word: str, facts: GarmentFacts) -> int:
    test = CLAIM_TYPES[claim].words[word]
    if test(facts, CLAIMING):
        return TRUE
    return UNCLEAR if test(facts, HOLDING) else FALSE

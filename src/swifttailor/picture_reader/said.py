"""What the answers of a picture reader's network say."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.describing.claims import CLAIM_TYPES, Claim
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.picture_reader.labels import measure_labels, statement_labels
from swifttailor.picture_reader.reading import Measure, SeenPanel, Statement
from swifttailor.picture_reader.units import BOX_CM, MEASURE_CM, NARROWEST, WIDEST

LEAST_PRESENT = 0.5
LEAST_CERTAINTY = 0.03
"""What is less sure is not told; what is hardly likely still tells known patterns apart."""
_HALF = float(np.log(2))
"""Median distance from the middle of a Laplace distribution, in its width."""


def certainties(logits: NDArray[Any]) -> NDArray[np.float64]:
    """How sure each of some things is of which one is so, 0 to 1."""
    raised = np.exp(logits.astype(np.float64) - logits.max())
    return raised / raised.sum()


def parts_present(answers: dict[str, Any]) -> list[int]:
    """Numbers of the parts on which anything is worn."""
    return [int(k) for k in np.flatnonzero(share_of(answers["present"]) >= LEAST_PRESENT)]


def statements_said(logits: NDArray[Any]) -> tuple[Statement, ...]:
    """The statements of a part, the surest first."""
    certain = share_of(logits)
    found = [
        Statement(Claim(claim, word), float(certain[k]))
        for k, (claim, word) in enumerate(statement_labels())
        if certain[k] >= LEAST_CERTAINTY and word in CLAIM_TYPES[claim].words
    ]
    return tuple(sorted(found, key=lambda s: -s.certainty))


def measures_said(has: NDArray[Any], measured: NDArray[Any]) -> tuple[Measure, ...]:
    """The measures of a part, cm."""
    certain = share_of(has)
    found = []
    for k, name in enumerate(measure_labels()):
        if certain[k] >= LEAST_CERTAINTY:
            middle, width = float(measured[k, 0]), float(np.exp(np.clip(measured[k, 1], NARROWEST, WIDEST)))
            value = MEASURE_CM * np.sinh(middle)
            off = MEASURE_CM * (np.sinh(middle + _HALF * width) - np.sinh(middle - _HALF * width)) / 2
            found.append(Measure(name, float(value), float(off), float(certain[k])))
    return tuple(found)


def panels_said(logits: NDArray[Any], boxes: NDArray[Any]) -> tuple[SeenPanel, ...]:
    """The panels of a part, the surest first."""
    certain = share_of(logits)
    found = []
    for k in np.flatnonzero(certain >= LEAST_CERTAINTY):
        x, y, z, width, height = (float(v) * BOX_CM for v in boxes[k])
        found.append(SeenPanel(PANEL_NAMES[k], float(certain[k]), (x, y, z, width, height)))
    return tuple(sorted(found, key=lambda panel: -panel.certainty))


def share_of(logits: NDArray[Any]) -> NDArray[Any]:
    """How sure each of some things is that do not exclude each other, 0 to 1."""
    return 1 / (1 + np.exp(-np.clip(logits.astype(np.float64), -60, 60)))

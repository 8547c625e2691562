"""How well a pattern fits what is sought, one number after the other: the formulas without their vectors."""

from __future__ import annotations

import math

from swifttailor.pattern_library.nearest import BOX_CM, MOST_OFF, NARROWEST_MEASURE, Weights
from swifttailor.pattern_library.sought import Sought
from swifttailor.picture_reader.truth import FALSE, TRUE, Truth
from swifttailor.picture_reader.units import MEASURE_CM


def plain_fit(truth: Truth, sought: Sought, weights: Weights) -> float:
    return (
        weights.statements * _statements(truth, sought)
        + weights.measures * _measures(truth, sought)
        + weights.panels * _panels(truth, sought)
        + weights.boxes * _boxes(truth, sought)
    )


def _statements(truth: Truth, sought: Sought) -> float:
    total = 0.0
    for value, p, counts in zip(truth.statements, sought.statements, sought.said, strict=True):
        for_it, against = math.log(p), math.log(1 - p)
        total += counts * (for_it if value == TRUE else against if value == FALSE else (for_it + against) / 2)
    return total


def _measures(truth: Truth, sought: Sought) -> float:
    total = 0.0
    for k, value in enumerate(truth.measures):
        p, counts, (middle, width) = sought.has[k], sought.measures[k], sought.measured[k]
        if math.isnan(value):
            total += counts * math.log(1 - p)
        else:
            off = abs(math.asinh(value / MEASURE_CM) - middle) / max(width, NARROWEST_MEASURE)
            total += counts * (math.log(p) - p * min(off, MOST_OFF))
    return total


def _panels(truth: Truth, sought: Sought) -> float:
    return sum(
        counts * math.log(p if has else 1 - p)
        for has, p, counts in zip(truth.panels, sought.panels, sought.named, strict=True)
    )


def _boxes(truth: Truth, sought: Sought) -> float:
    total = 0.0
    for k, has in enumerate(truth.panels):
        off = MOST_OFF
        if has:
            parts = [abs(a - b) / w for a, b, w in zip(truth.boxes[k], sought.boxes[k], BOX_CM, strict=True)]
            off = min(sum(parts) / len(parts), MOST_OFF)
        total -= sought.placed[k] * off
    return total

"""What a picture shows of a garment's design parameters, to be read by people."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.errors import SwiftTailorError
from swifttailor.parameter_reader.which_matter import matters
from swifttailor.picture_reader.seen_design import SeenDesign
from swifttailor.programs import complete_design
from swifttailor.programs.read_parameter import ReadParameter

_QUANTILES = 0.25, 0.5, 0.75
"""Between the first and the last of these a number lies as likely as not."""


@dataclass(frozen=True)
class ToldParameter:
    """The likeliest value of a parameter."""

    name: str
    value: Any
    """Of a number the median."""
    certainty: float | None
    """Of a choice."""
    between: tuple[float, float] | None = None
    """Where a number lies as likely as not."""

    def to_json(self) -> dict[str, Any]:
        """For a report."""
        if self.between is not None:
            return {"name": self.name, "value": self.value, "between": list(self.between)}
        assert self.certainty is not None
        return {"name": self.name, "value": self.value, "certainty": round(self.certainty, 3)}

    def line(self) -> str:
        """The same in words."""
        if self.between is not None:
            low, high = self.between
            return f"{self.name}: {self.value:.2f}, between {low:.2f} and {high:.2f}"
        return f"{self.name}: {'none' if self.value is None else self.value} ({self.certainty:.0%})"


def told_design(seen: SeenDesign) -> list[ToldParameter]:
    """The parameters that matter for the likeliest design, in their order.

    Args:
        seen: By a picture reader that reads them.
    """
    likeliest = [_told(one, shares) for one, shares in zip(seen.parameters, seen.shares, strict=True)]
    names = _that_matter({one.name: one.value for one in likeliest})
    return [one for one in likeliest if one.name in names]


def _told(parameter: ReadParameter, shares: Floats) -> ToldParameter:
    if not parameter.is_number:
        k = int(shares.argmax())
        return ToldParameter(parameter.name, parameter.values[k], float(shares[k]))
    cumulative, last = np.cumsum(shares), len(shares) - 1
    places = (min(int(np.searchsorted(cumulative, quantile)), last) for quantile in _QUANTILES)
    low, middle, high = (parameter.values[k] for k in places)
    return ToldParameter(parameter.name, middle, None, (low, high))


def _that_matter(values: dict[str, Any]) -> frozenset[str]:
    try:
        return matters(complete_design(values))
    except SwiftTailorError:  # values that no program accepts: all are told
        return frozenset(values)

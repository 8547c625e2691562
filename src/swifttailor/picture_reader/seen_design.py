"""Design parameters as pictures show them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats
from swifttailor.programs.read_parameter import ReadParameter

IN_CARD = "design_parameters"
"""Where the card of a training has what `ReadParameter.to_json` says of those that the network reads."""
NEAR_IN_CARD = "near_designs"
"""Where it says whether the network has learnt to read them in close-ups, too."""
_LEAST = 1e-6


@dataclass(frozen=True, eq=False)
class SeenDesign:
    """How likely each value of each design parameter is, where it matters."""

    parameters: tuple[ReadParameter, ...]
    shares: tuple[Floats, ...]
    """For each of them (values,); they add up to 1."""

    @staticmethod
    def of_logits(parameters: tuple[ReadParameter, ...], logits: NDArray[Any]) -> SeenDesign:
        """Of what a network says.

        Args:
            parameters: D of them.
            logits: (D, V); those beyond the values of a parameter do not count.
        """
        rows = zip(parameters, logits.astype(np.float64), strict=True)
        return SeenDesign(parameters, tuple(_shares(row[: len(one.values)]) for one, row in rows))

    def middles(self) -> dict[str, float]:
        """Of each number the place of its mean among its ranges, from 0."""
        rows = zip(self.parameters, self.shares, strict=True)
        return {one.name: float(np.arange(len(row)) @ row) for one, row in rows if one.is_number}

    @property
    def certainty(self) -> float:
        """How sure the likeliest values are, in the mean of the parameters."""
        return float(np.mean([row.max() for row in self.shares]))

    @staticmethod
    def together(seen: Sequence[SeenDesign]) -> SeenDesign:
        """Of several pictures of one garment, each counting as much as the others."""
        columns = zip(*(one.shares for one in seen), strict=True)
        return SeenDesign(seen[0].parameters, tuple(mixed(column) for column in columns))


def mixed(shares: Sequence[Floats], weights: Sequence[float] | None = None) -> Floats:
    """What several say of the values of one parameter: their geometric mean.

    Args:
        shares: Each (values,), adding up to 1.
        weights: How much each counts; as much as the others when None.
    """
    return _shares(np.average([np.log(np.maximum(one, _LEAST)) for one in shares], axis=0, weights=weights))


def _shares(logits: Floats) -> Floats:
    raised = np.exp(logits - logits.max())
    return raised / raised.sum()

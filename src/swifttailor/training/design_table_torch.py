"""What is true of the design parameters of garments, as a network is told it. It loads torch."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import torch
from torch import Tensor

from swifttailor.parameter_reader.placed_designs import PlacedDesigns, nearly_right
from swifttailor.picture_reader.close_designs import ASYMMETRIC

UNKNOWN = 0.25
"""What a parameter counts of a garment that was photographed: no design is known, and none is to be said."""


class DesignTable:
    """Of all garments of a training."""

    def __init__(
        self, ids: Sequence[str], designs: PlacedDesigns | None, device: torch.device | None = None
    ) -> None:
        """Looks them up.

        Args:
            ids: Of the garments.
            designs: That are known; none when None.
            device: Where answers are made.
        """
        most = max(designs.values) if designs else 0
        count = len(designs.parameters) if designs else 0
        right = np.zeros((count, most, most), np.float32)
        places, matter = np.zeros((len(ids), 0), np.uint8), np.zeros((len(ids), 0), bool)
        if designs:
            places, matter = designs.of_ids(ids)
            for k, one in enumerate(designs.parameters):
                values = len(one.values)
                right[k, :values, :values] = nearly_right(values, is_number=one.is_number)
        self._right = torch.from_numpy(right).to(device)
        self._places = torch.from_numpy(places).to(device)
        self._matter = torch.from_numpy(matter).to(device)
        self._any = torch.zeros(count, most, device=device)
        for k, one in enumerate(designs.parameters if designs else ()):
            self._any[k, : len(one.values)] = UNKNOWN / len(one.values)
        self._each = torch.arange(count, device=device)
        self.names = tuple(one.name for one in designs.parameters) if designs else ()
        self.asymmetric = torch.zeros(len(ids), dtype=torch.bool, device=device)
        if designs and ASYMMETRIC in self.names:
            k = self.names.index(ASYMMETRIC)
            values = torch.tensor([value is True for value in designs.parameters[k].values], device=device)
            self.asymmetric = values[self._places[:, k].long()] & self._matter[:, k]
        """(N,) whether the left side of each garment has parameters of its own."""

    def answers(self, garments: Tensor, told: Tensor) -> Tensor:
        """How right each value of each parameter is.

        Args:
            garments: (...) their numbers.
            told: (..., parameters) what is told of them.

        Returns:
            (..., parameters, values); zeros where a garment does not follow from a parameter.
        """
        right = self._right[self._each, self._places[garments].long()]
        return right * (self._matter[garments] & told)[..., None]

    def unknown(self, garments: Tensor) -> Tensor:
        """The same of photographed garments (...): all values alike, which counts less."""
        return self._any.expand(*garments.shape, *self._any.shape)

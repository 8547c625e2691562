"""The pictures that were drawn last, to be shown again in other company. It loads torch."""

from __future__ import annotations

from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from swifttailor.data.pictures.blocks import Block

_LARGE = ("pixels", "masks", "places", "cells")
"""Columns of a block that are kept on the device; the others are numbers, which decide what is told."""


class PicturePool:
    """So many pictures, of which new ones push out the oldest."""

    def __init__(self, size: int, device: torch.device) -> None:
        """Empty.

        Args:
            size: Pictures, a multiple of those of a block.
            device: That keeps them.
        """
        self.size, self.added = size, 0
        self._device, self._filled, self._at = device, 0, 0
        self._columns: dict[str, Tensor] = {}

    def __len__(self) -> int:
        return self._filled

    def add(self, block: Block) -> None:
        """Takes in a block."""
        count = len(block.pixels)
        for name, value in vars(block).items():
            new = torch.from_numpy(value)
            if name not in self._columns:
                place = self._device if name in _LARGE else torch.device("cpu")
                self._columns[name] = new.new_empty((self.size, *new.shape[1:]), device=place)
            self._columns[name][self._at : self._at + count] = new.to(self._columns[name].device)
        self._at = (self._at + count) % self.size
        self._filled = min(self._filled + count, self.size)
        self.added += 1

    def take(self, chosen: NDArray[np.int64]) -> dict[str, Tensor]:
        """Columns of a block, of the pictures of some places."""
        here = torch.from_numpy(chosen)
        there: Any = here.to(self._device)
        return {name: v[there if name in _LARGE else here] for name, v in self._columns.items()}

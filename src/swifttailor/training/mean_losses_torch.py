"""The mean of the losses over the steps between two lines of the record."""

from __future__ import annotations

from typing import Any

from torch import Tensor


class MeanLosses:
    """Sums on the device, read when asked for."""

    def __init__(self) -> None:
        self._sums: dict[str, Tensor] = {}
        self._count = 0

    def add(self, losses: dict[str, Tensor]) -> None:
        """Takes in the losses of a step."""
        for name, value in losses.items():
            self._sums[name] = self._sums[name] + value.detach() if self._count else value.detach()
        self._count += 1

    def take(self) -> dict[str, float]:
        """The means since the last call; the next ones begin anew."""
        means = {name: float(total) / self._count for name, total in self._sums.items()}
        self._count = 0
        return means

    def state(self) -> dict[str, Any]:
        """For a checkpoint."""
        return {"sums": dict(self._sums), "count": self._count}

    def restore(self, state: dict[str, Any]) -> None:
        """Goes on from a checkpoint."""
        self._sums, self._count = dict(state["sums"]), int(state["count"])

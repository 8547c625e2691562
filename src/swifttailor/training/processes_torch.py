"""One process or several, a GPU each: what differs between them, by accelerate."""

from __future__ import annotations

import atexit
import contextlib
import os
from collections.abc import Generator
from dataclasses import dataclass
from typing import Any

import torch
from torch import nn

from swifttailor.errors import MissingExtraError


@dataclass(frozen=True, eq=False)
class Processes:
    """This process among those of a training."""

    rank: int
    count: int
    device: torch.device
    _accelerator: Any = None

    @staticmethod
    def start() -> Processes:
        """The only process, unless ``accelerate launch`` or ``torchrun`` has started several.

        Raises:
            MissingExtraError: There are several and accelerate is missing.
        """
        count = int(os.environ.get("WORLD_SIZE", "1"))
        if count == 1:
            return Processes(0, 1, torch.device("cuda" if torch.cuda.is_available() else "cpu"))
        try:
            from accelerate import Accelerator
        except ImportError:
            raise MissingExtraError("accelerate", "train", "Training in several processes") from None
        accelerator = Accelerator(cpu=not torch.cuda.is_available())
        device = accelerator.device
        if device.type == "cpu":
            device = torch.device("cpu")  # checkpoints cannot be read onto accelerate's "cpu:0"
        return Processes(accelerator.process_index, accelerator.num_processes, device, accelerator)

    @property
    def is_first(self) -> bool:
        """Whether this process writes the files."""
        return self.rank == 0

    def share(self, network: nn.Module) -> nn.Module:
        """The network as it is trained: with several processes its gradients are averaged over them."""
        return network if self._accelerator is None else self._accelerator.prepare_model(network)

    def agree(self, seconds: float) -> float:
        """The first process's clock, so that all stop at the same step."""
        if self._accelerator is None:
            return seconds
        clock = torch.tensor([seconds], dtype=torch.float64, device=self.device)
        torch.distributed.broadcast(clock, 0)
        return float(clock)

    @contextlib.contextmanager
    def first_goes_ahead(self) -> Generator[None]:
        """The first process does what follows, then the others, which find the files it has written."""
        if not self.is_first:
            self.wait()
        yield
        if self.is_first:
            self.wait()

    def wait(self) -> None:
        """Until all processes are here."""
        if self._accelerator is not None:
            self._accelerator.wait_for_everyone()

    def finish(self) -> None:
        """Says that all went well: the processes part from one another before Python ends.

        Left to the end of Python, the threads that connect them now and then abort the process
        (pytorch/pytorch#179291). After an error nobody waits for the others, who may never come.
        """
        if self._accelerator is not None:
            self.wait()
            atexit.unregister(_part)  # a second training of the same processes needs them connected
            atexit.register(_part)


def _part() -> None:
    if torch.distributed.is_initialized():
        torch.distributed.destroy_process_group()

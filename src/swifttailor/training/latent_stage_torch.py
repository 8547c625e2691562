"""One stage of the training of a latent diffusion: it ends with its time, and goes on where it was."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import torch
from torch import Tensor, nn

from swifttailor.errors import InputError
from swifttailor.training.checkpoint_torch import MovingAverage, read_checkpoint, write_checkpoint
from swifttailor.training.run_record import CHECKPOINT
from swifttailor.training.schedule import Schedule

_STATE = ("step", "seconds", "network", "optimizer", "average", "chance", "torch", "stage")


@dataclass(frozen=True, kw_only=True)
class StageConfig:
    """How a stage is optimised."""

    minutes: float
    """Of a processor; the cosine of the learning rate ends with them."""
    batch_size: int
    learning_rate: float
    weight_decay: float
    ema: float
    """Decay of the moving average of the weights, which is what is kept."""
    steps: int = 1_000_000
    """At most so many."""
    warmup_steps: int = 100
    clip: float = 1.0
    seed: int = 0
    log_every: int = 100
    save_minutes: float = 3.0


class Stage:
    """Trains one network."""

    def __init__(self, name: str, network: nn.Module, config: StageConfig, folder: Path) -> None:
        """At its beginning, or where the checkpoint of the folder was.

        Args:
            name: For what is said.
            network: Takes the weights of the checkpoint.
            config: How.
            folder: Of this stage, for its checkpoint.

        Raises:
            InputError: The checkpoint is damaged, or of a stage with other settings.
        """
        self.name, self.network, self.config, self.folder = name, network, config, folder
        self.chance = torch.Generator().manual_seed(config.seed)
        self.optimizer = torch.optim.AdamW(
            network.parameters(), config.learning_rate, betas=(0.9, 0.98), weight_decay=config.weight_decay
        )
        self.average = MovingAverage(network.state_dict(), config.ema)
        self.schedule = Schedule(config.steps, config.warmup_steps, 0.01, 60 * config.minutes)
        self.step, self.seconds = 0, 0.0
        if (folder / CHECKPOINT).is_file():
            self._go_on()

    @property
    def is_over(self) -> bool:
        """Whether its time or its steps are used up."""
        return self.schedule.progress(self.step, self.seconds) >= 1.0

    def run(self, loss_of: Callable[[torch.Generator], Tensor]) -> None:
        """Trains to the end, and leaves the moving average in the network.

        Args:
            loss_of: The loss of the next batch, drawn with this generator.
        """
        saved, total, count = self.seconds, 0.0, 0
        self.network.train()
        while not self.is_over:
            total, count = total + self.take(loss_of), count + 1
            if self.step % self.config.log_every == 0 or self.is_over:
                sys.stderr.write(
                    f"{self.name}: step {self.step}, {self.seconds / 60:.1f} of {self.config.minutes:g} "
                    f"minutes, loss {total / count:.4f}\n"
                )
                total, count = 0.0, 0
            if self.seconds - saved > 60 * self.config.save_minutes or self.is_over:
                self.save()
                saved = self.seconds
        self.network.load_state_dict(self.average.values)
        self.network.eval()

    def take(self, loss_of: Callable[[torch.Generator], Tensor]) -> float:
        """Takes one step, and says the loss before it.

        Args:
            loss_of: See `run`.
        """
        began = time.process_time()
        rate = self.config.learning_rate * self.schedule.rate(self.step, self.seconds)
        for group in self.optimizer.param_groups:
            group["lr"] = rate
        loss = loss_of(self.chance)
        self.optimizer.zero_grad()
        loss.backward()
        nn.utils.clip_grad_norm_(self.network.parameters(), self.config.clip)
        self.optimizer.step()
        self.average.update(self.network.state_dict(), self.step)
        self.step += 1
        self.seconds += time.process_time() - began
        return float(loss.detach())

    def save(self) -> None:
        """Writes the checkpoint."""
        self.folder.mkdir(parents=True, exist_ok=True)
        write_checkpoint(
            self.folder,
            {
                "step": self.step,
                "seconds": self.seconds,
                "network": self.network.state_dict(),
                "optimizer": self.optimizer.state_dict(),
                "average": self.average.values,
                "chance": self.chance.get_state(),
                "torch": torch.get_rng_state(),
                "stage": self._settled(),
            },
        )

    def _go_on(self) -> None:
        state = read_checkpoint(self.folder, torch.device("cpu"), _STATE)
        if state["stage"] != self._settled():
            raise InputError(
                f"'{self.folder / CHECKPOINT}' was trained with other settings: {state['stage']}. Give those "
                "again, or another folder."
            )
        self.network.load_state_dict(state["network"])
        self.optimizer.load_state_dict(state["optimizer"])
        self.average.values = state["average"]
        self.chance.set_state(state["chance"])
        torch.set_rng_state(state["torch"])
        self.step, self.seconds = state["step"], state["seconds"]

    def _settled(self) -> dict[str, Any]:
        """What must not change on the way; a stage may be given more time."""
        free = ("minutes", "steps", "log_every", "save_minutes")
        shape = {name: list(weight.shape) for name, weight in self.network.state_dict().items()}
        return {k: v for k, v in asdict(self.config).items() if k not in free} | {"shape": shape}

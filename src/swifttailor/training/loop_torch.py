"""The loop of every training. Import this in the function that needs it: it loads torch.

A `Task` says what is learnt; the loop does the rest: learning rate, gradients, moving average, measurements,
checkpoints, and going on exactly where an interrupted training stood.
"""

from __future__ import annotations

import contextlib
import math
import os
import time
from abc import ABC, abstractmethod
from collections.abc import Callable, Generator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypedDict, Unpack

import torch
from torch import Tensor, nn

from swifttailor.errors import InputError, SimulationError
from swifttailor.training.checkpoint_torch import MovingAverage, read_checkpoint, write_checkpoint
from swifttailor.training.compilation_torch import not_compiled
from swifttailor.training.config_file import config_values
from swifttailor.training.loop_config import LoopConfig
from swifttailor.training.master_weights_torch import MasterWeights, parameter_groups
from swifttailor.training.mean_losses_torch import MeanLosses
from swifttailor.training.muon_torch import Muon, inner_matrices
from swifttailor.training.processes_torch import Processes
from swifttailor.training.run_record import WEIGHTS, RunRecord, command, file_checksums, versions
from swifttailor.training.schedule import Schedule
from swifttailor.training.sharding_torch import split_like, split_state, whole

Report = Callable[[str], None]
BETAS = (0.9, 0.99)
STATE = ("network", "optimizer", "average", "losses", "step", "seconds")
"""What a checkpoint holds."""


class Task(ABC):
    """What is learnt."""

    weights: MasterWeights
    samples: str
    """What it learns from, in the plural: garments, texts."""
    precision = "float32"
    """For the card."""

    @abstractmethod
    def losses(self, trained: nn.Module, step: int) -> dict[str, Tensor]:
        """The losses of an optimiser step, ``total`` the one to descend; `trained` is the network to call."""

    def rate_factor(self, name: str) -> float:
        """Factor on the learning rate of a weight."""
        return 1.0

    @abstractmethod
    def validate(self) -> dict[str, Any]:
        """How good the network is; called with the averaged weights in it."""

    @abstractmethod
    def result_text(self, result: dict[str, Any]) -> str:
        """The same in one line."""

    def illustrate(self, step: int) -> None:  # noqa: B027  numbers may say it all
        """Leaves pictures behind; called with the averaged weights in the network."""

    @abstractmethod
    def card(self) -> dict[str, Any]:
        """What the card says beyond the training: model, data."""


class RunOptions(TypedDict, total=False):
    """How a training is run, whichever network it trains."""

    resume: bool
    """From the checkpoint. On a CPU the result is that of an uninterrupted training, bit for bit, unless
    `max_minutes` is given, or pictures are kept in a pool."""
    max_minutes: float | None
    """Of training; the schedule is fitted to it. Counts what an interrupted training has used."""
    stop_after: int | None
    """Interrupt after this many steps, a checkpoint written."""
    threads: int | None
    """Processor cores to train on; torch's choice when None."""
    report: Report | None
    """Called with lines to show, in the first of several processes."""


@dataclass(frozen=True)
class Loop:
    """How a task is trained; `start` makes one."""

    config: LoopConfig
    out: Path
    processes: Processes
    record: RunRecord
    report: Report
    resume: bool
    max_minutes: float | None
    stop_after: int | None

    @staticmethod
    def start(config: LoopConfig, out: Path, **options: Unpack[RunOptions]) -> Loop:
        """Starts the processes and the record of a run.

        Args:
            config: Everything that decides the result.
            out: Folder of the run.
            options: How it is run.

        Raises:
            InputError: `out` holds a training already, or none to resume.
            MissingExtraError: There are several processes and accelerate is missing.
        """
        threads, report = options.get("threads"), options.get("report")
        if threads is not None:
            torch.set_num_threads(threads)
        processes, record = Processes.start(), RunRecord(out)
        resume = options.get("resume", False)
        if processes.is_first:
            record.start(config_values(config), resume=resume)
        if report is None or not processes.is_first:
            report = say_nothing
        ends = options.get("max_minutes"), options.get("stop_after")
        return Loop(config, out, processes, record, report, resume, *ends)

    def run(self, task: Task) -> dict[str, Any]:
        """Trains to the end of the steps or the time.

        Returns:
            The card: what was trained on what, and how good it is.

        Raises:
            InputError: There is no checkpoint, a file cannot be written, or weights cannot be split.
            SimulationError: The loss is no number any more.
        """
        try:
            return self._run(task)
        finally:
            self.record.end()

    def _run(self, task: Task) -> dict[str, Any]:
        config, processes, weights = self.config, self.processes, task.weights
        max_minutes, stop_after = self.max_minutes, self.stop_after
        versions()  # before anybody changes the checkout
        optimizer = _optimizer(task, config)
        optimised = [p for group in optimizer.param_groups for p in group["params"]]
        average = MovingAverage(weights.state_dict(), config.ema)
        means = MeanLosses()
        step, seconds = 0, 0.0
        if self.resume:
            state = read_checkpoint(self.out, processes.device, STATE)
            weights.load_state_dict(split_like(state["network"], average.values))
            optimizer.load_state_dict(split_state(state["optimizer"], optimised))
            average.values = split_like(state["average"], average.values)
            means.restore(state["losses"])
            step, seconds = state["step"], state["seconds"]
            if processes.is_first:
                self.record.forget_after(step)
        sharded = weights.are_sharded
        trained = weights.network if sharded else processes.share(weights.network)
        schedule = Schedule(
            config.steps, config.warmup_steps, config.final_rate, max_minutes and max_minutes * 60
        )
        first_step, began, card = step, time.monotonic() - seconds, {}
        trained.train()
        while schedule.progress(step, seconds) < 1 and (stop_after is None or step - first_step < stop_after):
            rate = schedule.rate(step, seconds)
            for group in optimizer.param_groups:
                group["lr"] = config.learning_rate * group["factor"] * rate
            losses = task.losses(trained, step)
            losses["total"].backward()
            means.add(losses)
            weights.take_gradients()
            norm = torch.nn.utils.clip_grad_norm_(optimised, config.clip)
            optimizer.step()
            optimizer.zero_grad(set_to_none=True)
            weights.give_weights()
            average.update(weights.state_dict(), step)
            step += 1
            seconds = processes.agree(time.monotonic() - began)
            ends = schedule.progress(step, seconds) >= 1
            if step % config.log_every == 0 or ends:
                line = {"step": step, "seconds": round(seconds, 1), "rate": config.learning_rate * rate}
                line |= means.take()
                line["gradient_norm"] = float(whole(norm, keep=True))
                if not math.isfinite(line["total"]):
                    raise SimulationError(
                        f"The loss is {line['total']} at step {step}. Resume from the checkpoint with a "
                        "smaller learning_rate, or with precision=float32."
                    )
                if processes.is_first:
                    self.record.add(line)
                    self.report(_line_text(line, step * config.batch_size, seconds, task.samples))
            if step % config.validate_every == 0 or ends or step - first_step == stop_after:
                # All take part where each has a part of the network.
                if processes.is_first or sharded:
                    with averaged(weights, average), not_compiled():
                        result = task.validate()
                        if processes.is_first:
                            self.record.add(
                                {"step": step, "seconds": round(seconds, 1), "validation": result}
                            )
                            self.report(f"step {step}: {task.result_text(result)}")
                            task.illustrate(step)
                    state = {
                        "network": weights.state_dict(),
                        "optimizer": optimizer.state_dict(),
                        "average": average.values,
                        "losses": means.state(),
                        "step": step,
                        "seconds": seconds,
                    }
                    state = whole(state, keep=processes.is_first)
                    if processes.is_first:
                        write_checkpoint(self.out, state)
                        _save_weights(state["average"], self.out)
                        card = self._card(task, step, seconds, result)
                        self.record.write_card(card)
                    trained.train()
                processes.wait()
        processes.finish()
        self.report(f"{step} steps in {seconds / 60:.1f} minutes. The weights are in '{self.out / WEIGHTS}'.")
        return card or self._card(task, step, seconds, {})

    def _card(self, task: Task, step: int, seconds: float, result: dict[str, Any]) -> dict[str, Any]:
        device = self.processes.device
        name = torch.cuda.get_device_name(device) if device.type == "cuda" else f"{os.cpu_count()} cores"
        about, begun = task.card(), self.config.start
        return {
            "model": about.pop("model"),
            "parameters": sum(p.numel() for p in task.weights.named.values()),
            "config": config_values(self.config),
            **about,
            **({"start": file_checksums([Path(begun)])} if begun else {}),
            "command": command(),
            "training": {
                "steps": step,
                f"{task.samples}_seen": step * self.config.batch_size,
                "minutes": round(seconds / 60, 2),
                "device": f"{device.type}, {name}",
                "processes": self.processes.count,
                "threads": torch.get_num_threads(),
                "precision": task.precision,
            },
            "validation": result,
            "versions": versions(),
        }


def _optimizer(task: Task, config: LoopConfig) -> torch.optim.AdamW:
    weights, muon = task.weights, config.optimizer == "muon"
    if muon and weights.are_sharded:
        raise InputError(
            "optimizer=muon needs whole matrices, and shard=true splits them over the processes. Choose "
            "optimizer=adamw or shard=false."
        )
    matrices = inner_matrices(weights.network) if muon else ()
    groups = parameter_groups(weights, config.weight_decay, task.rate_factor, matrices)
    return (Muon if muon else torch.optim.AdamW)(groups, betas=BETAS, fused=not weights.are_sharded)


@contextlib.contextmanager
def averaged(weights: MasterWeights, average: MovingAverage) -> Generator[None]:
    """The network with the averaged weights, for as long as this lasts."""
    own = {name: value.detach().clone() for name, value in weights.state_dict().items()}
    weights.load_state_dict(average.values)
    weights.network.eval()
    try:
        yield
    finally:
        weights.load_state_dict(own)


def say_nothing(text: str) -> None:
    """For the processes that are not the first."""


def _save_weights(values: dict[str, Tensor], out: Path) -> None:
    from safetensors.torch import save

    from swifttailor.data.shard_file import write_durably

    write_durably(out / WEIGHTS, save({k: v.contiguous().cpu() for k, v in values.items()}))


def _line_text(line: dict[str, Any], seen: int, seconds: float, samples: str) -> str:
    parts = [f"{k} {v:.4g}" for k, v in line.items() if k not in ("step", "seconds", "rate")]
    return f"step {line['step']} ({seen / max(seconds, 1e-9):.1f} {samples}/s): {', '.join(parts)}"

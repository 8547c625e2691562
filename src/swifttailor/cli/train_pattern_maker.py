"""``swifttailor train pattern-maker``: from patterns to weights."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from swifttailor.cli.option_checks import MAX_WORKERS, in_range
from swifttailor.cli.postponed_imports import tyro
from swifttailor.cli.training import TrainingOnPatterns


@dataclass(frozen=True, kw_only=True)
class TrainPatternMaker(TrainingOnPatterns):
    """Train the network that writes patterns from text, pictures and other patterns (paper, Sec. 4.1).

    Writes weights.safetensors, card.json, metrics.jsonl, and a checkpoint to go on from. The patterns need no
    drapes; captions and instructions are written while it trains. Uses a GPU where there is one; for several,
    put accelerate launch -m before the command.
    """

    validation: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE...")] = ()
    """Patterns to validate with; without any, one of fifty is held out."""
    data: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="DIR...")] = ()
    """Data sets with renders of some of these patterns, for tasks with pictures (swifttailor data render)."""
    set: Annotated[tuple[str, ...], tyro.conf.arg(metavar="FIELD=VALUE")] = ()
    """Values to change in the configuration, for instance: --set steps=5000 tasks.edit=0.5"""
    loaders: Annotated[int, tyro.conf.arg(metavar="N")] = 0
    """Processes that make batches ahead; worth it on a GPU."""

    def run(self) -> int:
        """Trains, prints how it goes, and returns the exit code.

        Raises:
            SwiftTailorError: Something cannot be used.
        """
        from swifttailor.training.maker_config import read_config

        in_range("--loaders", self.loaders, 0, MAX_WORKERS)
        config = self.checked_config(read_config)
        from swifttailor.training.maker_loop_torch import train

        train(config, **self.arguments())
        return 0

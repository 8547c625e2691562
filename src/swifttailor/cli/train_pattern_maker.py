"""``swifttailor train pattern-maker``: from patterns to weights."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import tyro

from swifttailor.cli.option_checks import (
    MAX_WORKERS,
    in_range,
    require_max_minutes,
    require_threads,
    require_writable_folder,
)
from swifttailor.cli.progress import print_line


@dataclass(frozen=True, kw_only=True)
class TrainPatternMaker:
    """Train the network that writes patterns from text, pictures and other patterns (paper, Sec. 4.1).

    Writes weights.safetensors, card.json, metrics.jsonl, and a checkpoint to go on from. The patterns need no
    drapes; captions and instructions are written while it trains. Uses a GPU where there is one; for several,
    put accelerate launch -m before the command.
    """

    patterns: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE...")]
    """Patterns to train on: .jsonl, .jsonl.gz or folders of .json files."""
    out: Annotated[Path, tyro.conf.arg(metavar="RUN")]
    """Folder of the run; created when missing."""
    validation: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE...")] = ()
    """Patterns to validate with; without any, one of fifty is held out."""
    apart: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE...")] = ()
    """Patterns that must not be learnt from, such as those of a test: equal ones are left out, whatever their
    ids."""
    data: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="DIR...")] = ()
    """Data sets with renders of some of these patterns, for tasks with pictures (swifttailor data render)."""
    edits: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Edited versions of some of these patterns, each with the id of its base; others are made by
    recutting."""
    config: Annotated[str, tyro.conf.arg(metavar="NAME")] = "small"
    """small, paper, or a JSON file like the config.json of a run."""
    set: Annotated[tuple[str, ...], tyro.conf.arg(metavar="FIELD=VALUE")] = ()
    """Values to change in the configuration, for instance: --set steps=5000 tasks.edit=0.5"""
    resume: tyro.conf.FlagCreatePairsOff[bool] = False
    """Resume from the checkpoint in RUN, with the same configuration."""
    max_minutes: Annotated[float | None, tyro.conf.arg(metavar="M")] = None
    """End the training after this many minutes; the learning rate decays to match."""
    cache: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None
    """Where to keep what is measured on the patterns. Default: RUN/cache."""
    workers: Annotated[int, tyro.conf.arg(metavar="N")] = 1
    """Processes that measure the patterns (0.15 s each, once)."""
    loaders: Annotated[int, tyro.conf.arg(metavar="N")] = 0
    """Processes that make batches ahead; worth it on a GPU."""
    threads: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """CPU cores to train on, without a GPU. Default: torch decides."""

    def run(self) -> int:
        """Trains, prints how it goes, and returns the exit code.

        Raises:
            SwiftTailorError: Something cannot be used.
        """
        from swifttailor.training.extra import require_training_packages
        from swifttailor.training.maker_config import read_config

        require_max_minutes(self.max_minutes)
        in_range("--workers", self.workers, 1, MAX_WORKERS)
        in_range("--loaders", self.loaders, 0, MAX_WORKERS)
        require_threads(self.threads)
        config = read_config(self.config, self.set)
        require_writable_folder(self.out)
        require_training_packages("Training")
        from swifttailor.training.maker_loop_torch import train

        train(
            config,
            self.patterns,
            self.out,
            validation=self.validation,
            apart=self.apart,
            data=self.data,
            edits=self.edits,
            resume=self.resume,
            cache=self.cache,
            workers=self.workers,
            loaders=self.loaders,
            max_minutes=self.max_minutes,
            threads=self.threads,
            report=print_line,
        )
        return 0

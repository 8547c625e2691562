"""``swifttailor train wish-reader``: from patterns to weights."""

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
class TrainWishReader:
    """Train the network that reads what texts ask for.

    Writes weights.safetensors, card.json, metrics.jsonl, and a checkpoint to go on from. Captions and
    instructions are written while it trains. Half an hour on one processor core is enough.
    """

    patterns: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE...")]
    """Patterns to write texts of: .jsonl, .jsonl.gz or folders of .json files."""
    validation: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE...")]
    """Patterns to validate with."""
    out: Annotated[Path, tyro.conf.arg(metavar="RUN")]
    """Folder of the run; created when missing."""
    apart: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE...")] = ()
    """Patterns that must not be learnt from, such as those of a test: equal ones are left out, whatever their
    ids."""
    edits: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Edited versions of some of these patterns, each with the id of its base; others are made by
    recutting."""
    config: Annotated[str, tyro.conf.arg(metavar="NAME")] = "small"
    """small, or a JSON file like the config.json of a run."""
    set: Annotated[tuple[str, ...], tyro.conf.arg(metavar="FIELD=VALUE")] = ()
    """Values to change in the configuration, for instance: --set steps=2000 typos=0.1"""
    resume: tyro.conf.FlagCreatePairsOff[bool] = False
    """Resume from the checkpoint in RUN, with the same configuration."""
    max_minutes: Annotated[float | None, tyro.conf.arg(metavar="M")] = None
    """End the training after this many minutes; the learning rate decays to match."""
    cache: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None
    """Where to keep what is measured on the patterns. Default: RUN/cache. PatternMaker's is the same."""
    workers: Annotated[int, tyro.conf.arg(metavar="N")] = 1
    """Processes that measure the patterns (0.15 s each, once)."""
    threads: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """CPU cores to train on, without a GPU. Default: torch decides."""

    def run(self) -> int:
        """Trains, prints how it goes, and returns the exit code.

        Raises:
            SwiftTailorError: Something cannot be used.
        """
        from swifttailor.training.extra import require_training_packages
        from swifttailor.training.wish_config import read_config

        require_max_minutes(self.max_minutes)
        in_range("--workers", self.workers, 1, MAX_WORKERS)
        require_threads(self.threads)
        config = read_config(self.config, self.set)
        require_writable_folder(self.out)
        require_training_packages("Training")
        from swifttailor.training.wish_loop_torch import train

        train(
            config,
            self.patterns,
            self.out,
            validation=self.validation,
            apart=self.apart,
            edits=self.edits,
            resume=self.resume,
            cache=self.cache,
            workers=self.workers,
            max_minutes=self.max_minutes,
            threads=self.threads,
            report=print_line,
        )
        return 0

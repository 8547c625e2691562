"""``swifttailor train garment-sewer``: from a data set to weights."""

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
class TrainGarmentSewer:
    """Train the network that predicts how patterns drape (paper, Sec. 4.3).

    Writes weights.safetensors, card.json, metrics.jsonl, pictures of validation garments, and a checkpoint to
    go on from. Uses a GPU where there is one; for several, put accelerate launch -m before the command.
    """

    data: Annotated[Path, tyro.conf.arg(metavar="DIR")]
    """Folder with the splits train and validation, from swifttailor data build."""
    out: Annotated[Path, tyro.conf.arg(metavar="RUN")]
    """Folder of the run; created when missing."""
    config: Annotated[str, tyro.conf.arg(metavar="NAME")] = "small"
    """small, paper, or a JSON file like the config.json of a run."""
    set: Annotated[tuple[str, ...], tyro.conf.arg(metavar="FIELD=VALUE")] = ()
    """Values to change in the configuration, for instance: --set steps=5000 losses.strain=1
    conditioning.prior=placed"""
    resume: tyro.conf.FlagCreatePairsOff[bool] = False
    """Resume from the checkpoint in RUN, with the same configuration."""
    max_minutes: Annotated[float | None, tyro.conf.arg(metavar="M")] = None
    """End the training after this many minutes; the learning rate decays to match."""
    cache: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None
    """Where to keep the images drawn from the data. Default: DIR/cache of the data."""
    workers: Annotated[int, tyro.conf.arg(metavar="N")] = 1
    """Processes that draw these images."""
    threads: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """CPU cores to train on, without a GPU. Default: torch decides."""

    def run(self) -> int:
        """Trains, prints how it goes, and returns the exit code.

        Raises:
            SwiftTailorError: Something cannot be used.
        """
        from swifttailor.training.extra import require_training_packages
        from swifttailor.training.sewer_config import read_config

        require_max_minutes(self.max_minutes)
        in_range("--workers", self.workers, 1, MAX_WORKERS)
        require_threads(self.threads)
        config = read_config(self.config, self.set)
        require_writable_folder(self.out)
        require_training_packages("Training")
        from swifttailor.training.sewer_loop_torch import train

        train(
            config,
            self.data,
            self.out,
            resume=self.resume,
            cache=self.cache,
            workers=self.workers,
            max_minutes=self.max_minutes,
            threads=self.threads,
            report=print_line,
        )
        return 0

"""What the commands that train a network have in common: options and checks."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, ClassVar, TypeVar

from swifttailor.cli.option_checks import (
    MAX_WORKERS,
    in_range,
    require_max_minutes,
    require_threads,
    require_writable_folder,
)
from swifttailor.cli.postponed_imports import tyro
from swifttailor.cli.progress import print_line

Config = TypeVar("Config")


@dataclass(frozen=True, kw_only=True)
class Training:
    """Options of every training."""

    out: Annotated[Path, tyro.conf.arg(metavar="RUN")] = Path("run")
    """Folder of the run; created when missing."""
    config: Annotated[str, tyro.conf.arg(metavar="NAME")] = "small"
    """small, paper, one of the other names in the guides, or a JSON file like the config.json of a run."""
    set: Annotated[tuple[str, ...], tyro.conf.arg(metavar="FIELD=VALUE")] = ()
    """Values to change in the configuration."""
    resume: tyro.conf.FlagCreatePairsOff[bool] = False
    """Resume from the checkpoint in RUN, with the same configuration."""
    max_minutes: Annotated[float | None, tyro.conf.arg(metavar="M")] = None
    """End the training after this many minutes; the learning rate decays to match."""
    cache: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None
    """Where to keep what is made from the data once."""
    workers: Annotated[int, tyro.conf.arg(metavar="N")] = 1
    """Processes that make it."""
    threads: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """CPU cores to train on, without a GPU. Default: torch decides."""
    fewest_workers: ClassVar[int] = 1

    def checked_config(self, read_config: Callable[[str, Sequence[str]], Config]) -> Config:
        """The configuration; refuses what cannot work before anything is loaded.

        Args:
            read_config: Of the network.

        Raises:
            SwiftTailorError: An option is out of range, RUN cannot be written, or a package is missing.
        """
        from swifttailor.training.extra import require_training_packages

        require_max_minutes(self.max_minutes)
        in_range("--workers", self.workers, self.fewest_workers, MAX_WORKERS)
        require_threads(self.threads)
        config = read_config(self.config, self.set)
        require_writable_folder(self.out)
        require_training_packages("Training")
        return config

    def arguments(self) -> dict[str, Any]:
        """What a network's function `train` takes beside the configuration: the options by their names."""
        options = {name: value for name, value in vars(self).items() if name not in ("config", "set")}
        return options | {"report": print_line}


@dataclass(frozen=True, kw_only=True)
class TrainingOnPatterns(Training):
    """Options of the trainings that need no drapes."""

    patterns: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE...")]
    """Patterns to train on: .jsonl, .jsonl.gz or folders of .json files."""
    apart: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE...")] = ()
    """Patterns that must not be learnt from, such as those of a test: equal ones are left out, whatever their
    ids."""
    edits: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Edited versions of some of these patterns, each with the id of its base; others are made by
    recutting."""
    cache: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None
    """Where to keep what is measured on the patterns, for PatternMaker and the wish reader alike. Default:
    RUN/cache."""
    workers: Annotated[int, tyro.conf.arg(metavar="N")] = 1
    """Processes that measure the patterns (0.15 s each, once)."""

"""``swifttailor train wish-reader``: from patterns to weights."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from swifttailor.cli.postponed_imports import tyro
from swifttailor.cli.training import TrainingOnPatterns


@dataclass(frozen=True, kw_only=True)
class TrainWishReader(TrainingOnPatterns):
    """Train the network that reads what texts ask for.

    Writes weights.safetensors, card.json, metrics.jsonl, and a checkpoint to go on from. Captions and
    instructions are written while it trains. Half an hour on one processor core is enough.
    """

    validation: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE...")]
    """Patterns to validate with."""
    spoken: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE...")] = ()
    """Texts in people's own words with what they ask for, such as runs/spoken/*.jsonl."""
    config: Annotated[str, tyro.conf.arg(metavar="NAME")] = "small"
    """small, spoken, or a JSON file like the config.json of a run."""
    set: Annotated[tuple[str, ...], tyro.conf.arg(metavar="FIELD=VALUE")] = ()
    """Values to change in the configuration, for instance: --set steps=2000 typos=0.1"""

    def run(self) -> int:
        """Trains, prints how it goes, and returns the exit code.

        Raises:
            SwiftTailorError: Something cannot be used.
        """
        from swifttailor.training.wish_config import read_config

        config = self.checked_config(read_config)
        from swifttailor.training.wish_loop_torch import train

        train(config, **self.arguments())
        return 0

"""``swifttailor train garment-sewer``: from a data set to weights."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from swifttailor.cli.postponed_imports import tyro
from swifttailor.cli.training import Training


@dataclass(frozen=True, kw_only=True)
class TrainGarmentSewer(Training):
    """Train the network that predicts how patterns drape (paper, Sec. 4.3).

    Writes weights.safetensors, card.json, metrics.jsonl, pictures of validation garments, and a checkpoint to
    go on from. Uses a GPU where there is one; for several, put accelerate launch -m before the command.
    """

    data: Annotated[Path, tyro.conf.arg(metavar="DIR")]
    """Folder with the splits train and validation, from swifttailor data build."""
    set: Annotated[tuple[str, ...], tyro.conf.arg(metavar="FIELD=VALUE")] = ()
    """Values to change in the configuration, for instance: --set steps=5000 losses.strain=1
    conditioning.prior=placed"""
    cache: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None
    """Where to keep the images drawn from the data. Default: DIR/cache of the data."""
    workers: Annotated[int, tyro.conf.arg(metavar="N")] = 1
    """Processes that draw these images."""

    def run(self) -> int:
        """Trains, prints how it goes, and returns the exit code.

        Raises:
            SwiftTailorError: Something cannot be used.
        """
        from swifttailor.training.sewer_config import read_config

        config = self.checked_config(read_config)
        from swifttailor.training.sewer_loop_torch import train

        train(config, **self.arguments())
        return 0

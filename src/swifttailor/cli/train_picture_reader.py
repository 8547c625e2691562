"""``swifttailor train picture-reader``: from sewn garments to weights."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, ClassVar

import tyro

from swifttailor.cli.training import Training


@dataclass(frozen=True, kw_only=True)
class TrainPictureReader(Training):
    """Train the network that reads what pictures show.

    Writes weights.safetensors, card.json, metrics.jsonl, and a checkpoint to go on from. Pictures are drawn
    while it trains, never the same twice, from garments that GarmentSewer has sewn:
    swifttailor data build --engine network.
    """

    data: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="DIR...")]
    """Folders of splits to draw, such as DATA/train."""
    validation: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="DIR...")]
    """Folders of splits to validate with."""
    apart: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="DIR...")] = ()
    """Folders of splits that must not be learnt from, such as DATA/test: equal patterns are left out. What is
    validated with is left out as well."""
    designs: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Designs of the garments, of scripts/place_designs.py: the network learns to say design parameters as
    well."""
    photographs: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="DIR...")] = ()
    """Folders of photographs of clothes of which some claims are known (docs/picture-reader.md): with
    images.csv, its columns image and label, and images/IMAGE.jpg, as the clothing dataset is laid out; or
    with garments.jsonl, which says what is worn in each."""
    config: Annotated[str, tyro.conf.arg(metavar="NAME")] = "small"
    """small, or a JSON file like the config.json of a run."""
    set: Annotated[tuple[str, ...], tyro.conf.arg(metavar="FIELD=VALUE")] = ()
    """Values to change in the configuration, for instance: --set steps=5000 network.image_size=128"""
    cache: tyro.conf.Suppress[Path | None] = None
    workers: Annotated[int, tyro.conf.arg(metavar="N")] = 1
    """Processes that draw pictures; 0 draws between the steps."""
    fewest_workers: ClassVar[int] = 0

    def run(self) -> int:
        """Trains, prints how it goes, and returns the exit code.

        Raises:
            SwiftTailorError: Something cannot be used.
        """
        from swifttailor.training.picture_config import read_config

        config = self.checked_config(read_config)
        from swifttailor.training.picture_loop_torch import train

        train(config, **self._arguments())
        return 0

    def _arguments(self) -> dict[str, Any]:
        given = self.arguments()
        given["garments"] = given.pop("data")
        return {name: value for name, value in given.items() if name != "cache"}

"""How a GarmentSewer is trained: everything that decides what comes out, in one JSON file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from swifttailor.errors import InputError
from swifttailor.garment_sewer.conditioning import PER_PANEL, SEMANTIC, Conditioning
from swifttailor.garment_sewer.losses import PAPER_LOSSES, LossWeights
from swifttailor.garment_sewer.network_config import PAPER_NETWORK, SMALL_DPT, SMALL_NETWORK, NetworkConfig
from swifttailor.training.config_file import read_config_of, require
from swifttailor.training.loop_config import LoopConfig


@dataclass(frozen=True)
class SewerConfig(LoopConfig):
    """Network, conditioning, losses, and how they are optimised."""

    batch_size: int = 8
    learning_rate: float = 1e-3

    network: NetworkConfig = SMALL_NETWORK
    conditioning: Conditioning = field(default_factory=Conditioning)
    losses: LossWeights = field(default_factory=LossWeights)

    encoder_rate: float = 1.0
    """Factor on the learning rate of the vision transformer; below 1 where it is pretrained."""

    mirror: float = 0.5
    """Share of the garments that are shown mirrored left to right."""
    repack: float = 0.5
    """Share of the garments whose panels are packed in another order, where that fits; of those with a cell
    for each panel, the share whose panels change cells."""
    layouts: int = 1
    """Images drawn of each garment: the first as at use, others up to a quarter coarser, which leaves room to
    repack. Panels in cells of their own have one."""

    training_garments: int = 0
    """How many of the training split are learnt from, drawn by the seed; 0 for all. For curves over the size
    of the data."""
    validation_garments: int = 64
    """How many of the validation split are looked at; the same ones every time."""
    pictures: int = 4
    """Garments drawn at each validation, beside their drapes."""

    def __post_init__(self) -> None:
        super().__post_init__()
        require(self, "layouts", self.layouts >= 1, "at least 1")
        for name in ("pictures", "training_garments", "validation_garments"):
            require(self, name, getattr(self, name) >= 0, "0 or more")
        require(self, "encoder_rate", self.encoder_rate > 0, "above 0")
        for name in ("mirror", "repack"):
            require(self, name, 0 <= getattr(self, name) <= 1, "0 to 1")
        one = self.conditioning.layout == "packed" or self.layouts == 1
        require(self, "layouts", one, "with conditioning.layout per_panel only 1")
        if self.network.output == "displacement" and self.conditioning.prior == "none":
            raise InputError(
                "network.output is 'displacement' and there is no prior to displace. Choose "
                "conditioning.prior placed or sewn, or network.output absolute."
            )


CONFIGS: dict[str, SewerConfig] = {
    "small": SewerConfig(),
    "small-dpt": SewerConfig(network=SMALL_DPT),
    "paper": SewerConfig(
        network=PAPER_NETWORK,
        conditioning=Conditioning("none", SEMANTIC),
        losses=PAPER_LOSSES,
        steps=100_000,
        batch_size=32,
        optimizer="adamw",
        learning_rate=1e-4,
        warmup_steps=1000,
        mirror=0.0,
        repack=0.0,
    ),
    "per-panel": SewerConfig(conditioning=Conditioning(channels=PER_PANEL, layout="per_panel")),
}
"""Named configurations. What the paper does not give (steps, batch, rate) is ours in `paper`."""


def read_config(name: str, overrides: Sequence[str] = ()) -> SewerConfig:
    """One of these, or one from a JSON file that says what differs from ``small``: see `read_config_of`."""
    return read_config_of(CONFIGS, name, overrides)

"""How a GarmentSewer is trained: everything that decides what comes out, in one JSON file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from swifttailor.errors import InputError
from swifttailor.garment_sewer.conditioning import SEMANTIC, Conditioning
from swifttailor.garment_sewer.losses import PAPER_LOSSES, LossWeights
from swifttailor.garment_sewer.network_config import PAPER_NETWORK, NetworkConfig
from swifttailor.training.config_file import changed_config, config_values, read_config_of, require

__all__ = ["CONFIGS", "SewerConfig", "config_from", "config_values", "read_config"]


@dataclass(frozen=True)
class SewerConfig:
    """Network, conditioning, losses, and how they are optimised."""

    network: NetworkConfig = field(default_factory=NetworkConfig)
    conditioning: Conditioning = field(default_factory=Conditioning)
    losses: LossWeights = field(default_factory=LossWeights)

    steps: int = 20_000
    """Optimiser steps; the cosine ends there, or when the given time is over."""
    batch_size: int = 16
    """Garments to a step, on all devices together."""
    learning_rate: float = 6e-4
    """At its height."""
    encoder_rate: float = 1.0
    """Factor on the learning rate of the vision transformer; below 1 where it is pretrained."""
    warmup_steps: int = 200
    final_rate: float = 0.01
    """Share of the learning rate that the cosine ends with."""
    weight_decay: float = 0.05
    clip: float = 1.0
    """Largest norm of the gradient."""
    ema: float = 0.999
    """Decay of the moving average of the weights, which is what is kept in the end; less at first."""
    precision: Literal["auto", "float32", "bfloat16"] = "auto"
    """Of the network's layers; weights and losses are float32 always. auto: bfloat16 where the chip has
    it."""
    seed: int = 0

    mirror: float = 0.5
    """Share of the garments that are shown mirrored left to right."""
    repack: float = 0.5
    """Share of the garments whose panels are packed in another order, where that fits."""
    layouts: int = 1
    """Images drawn of each garment: the first as at use, others up to a quarter coarser, which leaves room to
    repack."""

    log_every: int = 50
    validate_every: int = 500
    """Steps; a checkpoint is written then too."""
    validation_garments: int = 64
    """How many of the validation split are looked at; the same ones every time."""
    pictures: int = 4
    """Garments drawn at each validation, beside their drapes."""

    def __post_init__(self) -> None:
        for name in ("steps", "batch_size", "layouts", "log_every", "validate_every"):
            require(self, name, getattr(self, name) >= 1, "at least 1")
        for name in ("warmup_steps", "seed", "pictures", "validation_garments"):
            require(self, name, getattr(self, name) >= 0, "0 or more")
        for name in ("learning_rate", "encoder_rate", "clip"):
            require(self, name, getattr(self, name) > 0, "above 0")
        require(self, "weight_decay", self.weight_decay >= 0, "0 or more")
        for name in ("mirror", "repack", "final_rate"):
            require(self, name, 0 <= getattr(self, name) <= 1, "0 to 1")
        require(self, "ema", 0 <= self.ema < 1, "0 or more and below 1")
        if self.precision not in ("auto", "float32", "bfloat16"):
            raise InputError(f"precision is {self.precision!r}; auto, float32 or bfloat16 is accepted.")
        if self.network.output == "displacement" and self.conditioning.prior == "none":
            raise InputError(
                "network.output is 'displacement' and there is no prior to displace. Choose "
                "conditioning.prior placed or sewn, or network.output absolute."
            )


CONFIGS: dict[str, SewerConfig] = {
    "small": SewerConfig(),
    "paper": SewerConfig(
        network=PAPER_NETWORK,
        conditioning=Conditioning("none", SEMANTIC),
        losses=PAPER_LOSSES,
        steps=100_000,
        batch_size=32,
        learning_rate=1e-4,
        warmup_steps=1000,
        mirror=0.0,
        repack=0.0,
    ),
}
"""Named configurations. What the paper does not give (steps, batch, rate) is ours in `paper`."""


def read_config(name: str, overrides: Sequence[str] = ()) -> SewerConfig:
    """A named configuration or one from a JSON file, with some values changed.

    Args:
        name: ``small``, ``paper``, or a file that holds (some of) the fields of `SewerConfig`, the others
            being those of ``small``.
        overrides: ``field=value`` or ``group.field=value``; values are JSON, or plain text.

    Raises:
        InputError: There is no such configuration, field or value.
    """
    return read_config_of(CONFIGS, name, overrides)


def config_from(value: Any) -> SewerConfig:
    """A configuration from what `config_values` gave; what is missing is as in ``small``.

    Raises:
        InputError: A field is unknown or a value out of range.
    """
    return changed_config(SewerConfig(), value)

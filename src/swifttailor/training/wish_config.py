"""How a wish reader is trained: everything that decides what comes out, in one JSON file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

from swifttailor.training.config_file import read_config_of, require
from swifttailor.training.loop_config import LoopConfig


@dataclass(frozen=True)
class ReaderSize:
    """The size of the network."""

    width: int = 128
    layers: int = 4
    heads: int = 4
    dropout: float = 0.0
    """Share of what is between the layers that is left out in training."""
    encoder: Literal["own", "minilm"] = "own"
    """`minilm`: the one that MiniLM is, which reads word pieces; its weights are `start`'s."""

    def __post_init__(self) -> None:
        for name in ("width", "layers", "heads"):
            require(self, name, getattr(self, name) >= 1, "at least 1")
        require(self, "dropout", 0 <= self.dropout < 1, "0 or more and below 1")
        require(self, "width", self.width % self.heads == 0, f"a multiple of heads ({self.heads})")


@dataclass(frozen=True)
class WishConfig(LoopConfig):
    """Network, texts, and how the network is optimised."""

    network: ReaderSize = field(default_factory=ReaderSize)

    steps: int = 5000
    batch_size: int = 64
    learning_rate: float = 1e-3
    final_rate: float = 0.0
    weight_decay: float = 0.01
    optimizer: Literal["adamw", "muon"] = "adamw"
    ema: float = 0.99
    precision: Literal["auto", "float32", "bfloat16"] = "float32"
    recuts: int = 1
    """Edits made of each pattern by recutting it, beside those of the file of edits."""
    own_words: float = 0.6
    """Share of the texts in people's own words, where there are any."""
    typos: float = 0.04
    """Share of the words that are misspelt."""
    validation_texts: int = 2000
    """Of the validation patterns; the same ones every time, without typing errors."""

    def __post_init__(self) -> None:
        super().__post_init__()
        require(self, "recuts", self.recuts >= 0, "0 or more")
        require(self, "own_words", 0 <= self.own_words <= 1, "0 to 1")
        require(self, "typos", 0 <= self.typos <= 1, "0 to 1")
        require(self, "validation_texts", self.validation_texts >= 1, "at least 1")
        require(self, "compiled", not self.compiled, "false")
        require(self, "precision", self.precision == "float32", "float32")


CONFIGS: dict[str, WishConfig] = {
    "small": WishConfig(),
    "spoken": WishConfig(
        network=ReaderSize(width=384, layers=6, heads=12, dropout=0.1, encoder="minilm"),
        steps=1600,
        learning_rate=3e-4,
        warmup_steps=100,
        weight_decay=0.05,
        own_words=0.85,
    ),
}
"""Named configurations. `spoken` learns from people's own words, too."""


def read_config(name: str, overrides: Sequence[str] = ()) -> WishConfig:
    """One of these, or one from a JSON file that says what differs from ``small``: see `read_config_of`."""
    return read_config_of(CONFIGS, name, overrides)

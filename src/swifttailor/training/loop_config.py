"""How any of the networks is optimised."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from swifttailor.training.config_file import require


@dataclass(frozen=True)
class LoopConfig:
    """What `loop_torch.Loop` reads; configurations of the networks add what is learnt from what."""

    steps: int = 20_000
    """Optimiser steps; the cosine ends there, or when the given time is over."""
    batch_size: int = 16
    """Samples to a step, on all devices together."""
    learning_rate: float = 6e-4
    """At its height."""
    warmup_steps: int = 200
    final_rate: float = 0.01
    """Share of the learning rate that the cosine ends with."""
    weight_decay: float = 0.05
    optimizer: Literal["adamw", "muon"] = "muon"
    """muon: for the matrices inside the network, the rest by AdamW. Weights that are split over several
    processes need adamw."""
    clip: float = 1.0
    """Largest norm of the gradient."""
    ema: float = 0.999
    """Decay of the moving average of the weights, which is what is kept in the end; less at first."""
    precision: Literal["auto", "float32", "bfloat16"] = "auto"
    """Of the layers; the weights that are optimised and the losses are float32 always. auto: bfloat16 where
    the chip has it."""
    compiled: bool = False
    """Whether layers are translated by torch.compile: some minutes at the beginning, then a third less time
    a step. Needs a C++ compiler, and is not for weights that are split over several processes."""
    start: str = ""
    """Weights to begin with, of another run (weights.safetensors) or a model file, for a network of the same
    shape; empty for random ones."""
    seed: int = 0
    log_every: int = 50
    validate_every: int = 500
    """Steps; a checkpoint is written then too."""

    def __post_init__(self) -> None:
        for name in ("steps", "batch_size", "log_every", "validate_every"):
            require(self, name, getattr(self, name) >= 1, "at least 1")
        for name in ("warmup_steps", "seed", "weight_decay"):
            require(self, name, getattr(self, name) >= 0, "0 or more")
        for name in ("learning_rate", "clip"):
            require(self, name, getattr(self, name) > 0, "above 0")
        require(self, "final_rate", 0 <= self.final_rate <= 1, "0 to 1")
        require(self, "ema", 0 <= self.ema < 1, "0 or more and below 1")
        require(self, "optimizer", self.optimizer in ("adamw", "muon"), "adamw or muon")
        precisions = ("auto", "float32", "bfloat16")
        require(self, "precision", self.precision in precisions, "auto, float32 or bfloat16")

"""The second stage of a latent diffusion: a denoiser, told what readers may say. It loads torch."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import torch
from torch import Tensor, nn
from torch.nn import functional as F

from swifttailor.latent_diffusion.network_torch import Denoiser, kept_and_noise
from swifttailor.training.told_torch import Told

WIDTH, BLOCKS, TOLD_TOKENS, DROPOUT = 192, 5, 2, 0.1
READ_SHARE = 1 / 3
"""Of a batch, where pictures were read."""
UNTOLD = 0.1
"""Share of a batch that is told nothing: guidance compares with it."""


class LatentDiffusion(nn.Module):
    """A denoiser and the latents that it learns to draw."""

    middle: Tensor
    unit: Tensor

    def __init__(self, latents: Tensor, told: Told, read: Sequence[tuple[int, np.ndarray]]) -> None:
        """With random weights.

        Args:
            latents: (N, LATENTS, WIDE) of the patterns that are learnt from.
            told: Of the same patterns.
            read: Number of a pattern and the features that were read of its picture.
        """
        super().__init__()
        # One spread for all: that of each number alone would blow up those that hardly vary.
        self.register_buffer("middle", latents.mean(0))
        self.register_buffer("unit", latents.std().clamp(min=1e-3))
        self.clean, self.told = (latents - self.middle) / self.unit, told
        self.read_of = torch.tensor([number for number, _ in read], dtype=torch.long)
        self.read = torch.from_numpy(np.array([features for _, features in read], np.float32))
        features = told.all_of(torch.arange(1)).shape[1]
        self.denoiser = Denoiser(features, width=WIDTH, blocks=BLOCKS, told=TOLD_TOKENS, dropout=DROPOUT)

    def loss(self, count: int, chance: torch.Generator) -> Tensor:
        """Mean squared error of the velocity of some patterns at some times.

        Args:
            count: Patterns.
            chance: Draws all of it.
        """
        rows = torch.randint(len(self.clean), (count,), generator=chance)
        features = self.told.by_chance(rows, chance)
        if len(self.read_of):
            some = torch.randint(len(self.read_of), (round(READ_SHARE * count),), generator=chance)
            rows = torch.cat([self.read_of[some], rows[len(some) :]])
            features = torch.cat([self.read[some], features[len(some) :]])
        features = features * (torch.rand(count, 1, generator=chance) >= UNTOLD)
        clean = self.clean[rows]
        noise = torch.randn(clean.shape, generator=chance)
        time = torch.rand(count, generator=chance)
        kept, added = (share[:, None, None] for share in kept_and_noise(time))
        velocity = self.denoiser(kept * clean + added * noise, time, features)
        return F.mse_loss(velocity, kept * noise - added * clean)

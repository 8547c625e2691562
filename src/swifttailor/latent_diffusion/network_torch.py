"""The auto-encoder of panel tensors, and the denoiser of its latents. It loads torch."""

from __future__ import annotations

import math

import torch
from torch import Tensor, nn
from torch.nn import functional as F

from swifttailor.latent_diffusion import tensor_layout as at

LATENTS, WIDE = 64, 6
"""Latents of a pattern, and numbers of each."""
GROUPS = 8
"""Tokens that the latents are grouped into: attention over each of them would cost eight times as much."""
LEVELS = 9
"""Values that each number of a latent may have, from -1 to 1."""
PANEL = at.EDGES * at.NUMBERS
_HEAD = 32


class Block(nn.Module):
    """Attention and a perceptron over tokens, modulated by a condition where there is one."""

    def __init__(self, width: int, *, modulated: bool = False) -> None:
        """With random weights; a modulated one begins as the identity.

        Args:
            width: Of a token; a multiple of 32.
            modulated: Whether it is told a condition.
        """
        super().__init__()
        self.heads = width // _HEAD
        self.norms = nn.ModuleList(nn.LayerNorm(width, elementwise_affine=not modulated) for _ in range(2))
        self.mixed, self.out = nn.Linear(width, 3 * width), nn.Linear(width, width)
        self.wider, self.narrower = nn.Linear(width, 4 * width), nn.Linear(4 * width, width)
        self.modulation = nn.Linear(width, 6 * width) if modulated else None
        if self.modulation is not None:
            nn.init.zeros_(self.modulation.weight)
            nn.init.zeros_(self.modulation.bias)

    def forward(self, tokens: Tensor, seen: Tensor | None = None, condition: Tensor | None = None) -> Tensor:
        """One more layer.

        Args:
            tokens: (B, T, width).
            seen: (B, T) which tokens are looked at; all when None.
            condition: (B, width) of a modulated one.
        """
        if self.modulation is None or condition is None:
            tokens = tokens + self._attend(self.norms[0](tokens), seen)
            return tokens + self._perceptron(self.norms[1](tokens))
        shift, scale, gate, shift_2, scale_2, gate_2 = self.modulation(condition)[:, None].chunk(6, -1)
        tokens = tokens + gate * self._attend(self.norms[0](tokens) * (1 + scale) + shift, seen)
        return tokens + gate_2 * self._perceptron(self.norms[1](tokens) * (1 + scale_2) + shift_2)

    def _attend(self, tokens: Tensor, seen: Tensor | None) -> Tensor:
        query, key, value = (
            part.unflatten(-1, (self.heads, _HEAD)).transpose(1, 2)
            for part in self.mixed(tokens).chunk(3, -1)
        )
        mask = None if seen is None else seen[:, None, None]
        found = F.scaled_dot_product_attention(query, key, value, attn_mask=mask)
        return self.out(found.transpose(1, 2).flatten(2))

    def _perceptron(self, tokens: Tensor) -> Tensor:
        return self.narrower(F.gelu(self.wider(tokens)))


class PatternEncoder(nn.Module):
    """From the panels of a pattern to its latents."""

    def __init__(self, *, width: int, hidden: int, blocks: int) -> None:
        """With random weights.

        Args:
            width: Of a token, one for each panel.
            hidden: Of the perceptron that mixes the edges of a panel.
            blocks: Layers that mix panels.
        """
        super().__init__()
        self.panel = nn.Sequential(nn.Linear(PANEL, hidden), nn.GELU(), nn.Linear(hidden, width))
        self.slots = nn.Embedding(len(at.SLOTS), width)
        self.asking = nn.Parameter(0.02 * torch.randn(GROUPS, width))
        self.blocks = nn.ModuleList(Block(width) for _ in range(blocks))
        self.last = nn.Sequential(nn.LayerNorm(width), nn.Linear(width, LATENTS * WIDE // GROUPS))

    def forward(self, panels: Tensor, slots: Tensor, there: Tensor) -> Tensor:
        """(B, LATENTS, WIDE) between -1 and 1, not yet quantised.

        Args:
            panels: (B, P, EDGES, NUMBERS) in units of the network, 0 where nothing is.
            slots: (B, P) of the panels.
            there: (B, P) whether there is a panel.
        """
        tokens = self.panel(panels.flatten(2)) + self.slots(slots)
        tokens = torch.cat([self.asking.expand(len(panels), -1, -1), tokens], 1)
        seen = torch.cat([torch.ones_like(there[:, :1]).expand(-1, GROUPS), there], 1)
        for block in self.blocks:
            tokens = block(tokens, seen)
        return torch.tanh(self.last(tokens[:, :GROUPS])).reshape(-1, LATENTS, WIDE)


def quantised(latents: Tensor) -> Tensor:
    """Finite scalar quantisation: the nearest of `LEVELS` values, with the gradient of the identity."""
    half = (LEVELS - 1) / 2
    return latents + (torch.round(latents * half) / half - latents).detach()


class PatternDecoder(nn.Module):
    """From latents to panels."""

    def __init__(self, *, width: int, hidden: int, blocks: int) -> None:
        """With random weights.

        Args:
            width: Of a token, one for each panel.
            hidden: Of the perceptron that parts a panel into its edges.
            blocks: Layers that mix panels.
        """
        super().__init__()
        self.which = nn.Sequential(
            nn.Linear(LATENTS * WIDE, hidden), nn.GELU(), nn.Linear(hidden, len(at.SLOTS))
        )
        self.first = nn.Linear(LATENTS * WIDE // GROUPS, width)
        self.places = nn.Parameter(0.02 * torch.randn(GROUPS, width))
        self.slots = nn.Embedding(len(at.SLOTS), width)
        self.blocks = nn.ModuleList(Block(width) for _ in range(blocks))
        self.panel = nn.Sequential(
            nn.LayerNorm(width), nn.Linear(width, hidden), nn.GELU(), nn.Linear(hidden, PANEL)
        )

    def forward(self, latents: Tensor, slots: Tensor, there: Tensor) -> Tensor:
        """(B, P, EDGES, NUMBERS) in units of the network; of bits the logits.

        Args:
            latents: (B, LATENTS, WIDE), quantised.
            slots: (B, P) of panels that are answered.
            there: (B, P) which of these there are.
        """
        groups = self.first(latents.reshape(len(latents), GROUPS, -1)) + self.places
        tokens = torch.cat([groups, self.slots(slots)], 1)
        seen = torch.cat([torch.ones_like(there[:, :1]).expand(-1, GROUPS), there], 1)
        for block in self.blocks:
            tokens = block(tokens, seen)
        return self.panel(tokens[:, GROUPS:]).unflatten(-1, (at.EDGES, at.NUMBERS))

    def which_panels(self, latents: Tensor) -> Tensor:
        """(B, slots) logits of the panels that there are."""
        return self.which(latents.flatten(1))


class WholeDecoder(nn.Module):
    """The decoder as it is used: latents in, panel tensors out, in cm and probabilities."""

    middle: Tensor
    unit: Tensor
    every: Tensor
    latent_middle: Tensor
    latent_unit: Tensor

    def __init__(self, decoder: PatternDecoder, middle: Tensor, unit: Tensor) -> None:
        """Of a trained decoder, for latents as the encoder makes them.

        Args:
            decoder: Trained.
            middle: (slots, EDGES, continuous numbers) what 0 stands for.
            unit: (continuous numbers,) what 1 stands for.
        """
        super().__init__()
        self.decoder = decoder
        self.register_buffer("middle", middle)
        self.register_buffer("unit", unit)
        self.register_buffer("every", torch.arange(len(at.SLOTS)))
        self.register_buffer("latent_middle", torch.zeros(LATENTS, WIDE))
        self.register_buffer("latent_unit", torch.ones(()))

    def for_drawn(self, middle: Tensor, unit: Tensor) -> WholeDecoder:
        """The same for latents as a denoiser draws them.

        Args:
            middle: (LATENTS, WIDE) what their 0 stands for.
            unit: () what their 1 stands for.
        """
        other = WholeDecoder(self.decoder, self.middle, self.unit)
        other.latent_middle, other.latent_unit = middle, unit
        return other.eval()

    def forward(self, latents: Tensor) -> Tensor:
        """(B, LATENTS, WIDE) of any values to (B, slots, EDGES, NUMBERS)."""
        half = (LEVELS - 1) / 2
        latents = latents * self.latent_unit + self.latent_middle
        latents = torch.round(latents.clamp(-1, 1) * half) / half
        there = self.decoder.which_panels(latents) > 0
        slots = self.every.expand(len(latents), -1)
        found = self.decoder(latents, slots, there)
        numbers = found[..., at.CONTINUOUS] * self.unit + self.middle
        bits = torch.sigmoid(found[..., at.BITS])
        return torch.cat([numbers, bits], -1) * there[..., None, None]


class Denoiser(nn.Module):
    """A diffusion transformer: what was added to noisy latents, for what is known of a garment."""

    def __init__(self, features: int, *, width: int, blocks: int, told: int, dropout: float) -> None:
        """With random weights.

        Args:
            features: Numbers of what is known (`parameter_reader.features`).
            width: Of a token.
            blocks: Layers.
            told: Tokens that what is known becomes, beside its share in the modulation.
            dropout: Share of what is known that is left out on its way, in training.
        """
        super().__init__()
        self.width, self.told, self.features = width, told, features
        self.known = nn.Sequential(
            nn.Linear(features, 2 * width), nn.GELU(), nn.Dropout(dropout), nn.Linear(2 * width, width)
        )
        self.tokens = nn.Linear(width, told * width)
        self.time = nn.Sequential(nn.Linear(width, width), nn.GELU(), nn.Linear(width, width))
        self.first = nn.Linear(LATENTS * WIDE // GROUPS, width)
        self.places = nn.Parameter(0.02 * torch.randn(told + GROUPS, width))
        self.blocks = nn.ModuleList(Block(width, modulated=True) for _ in range(blocks))
        self.norm = nn.LayerNorm(width)
        self.last = nn.Linear(width, LATENTS * WIDE // GROUPS)
        nn.init.zeros_(self.last.weight)
        nn.init.zeros_(self.last.bias)

    def forward(self, noisy: Tensor, time: Tensor, features: Tensor) -> Tensor:
        """(B, LATENTS, WIDE) the velocity.

        Args:
            noisy: (B, LATENTS, WIDE).
            time: (B,) 0 without noise to 1.
            features: (B, features), all 0 where nothing is known.
        """
        rates = torch.exp(torch.arange(self.width // 2, device=time.device) * (-8.0 / (self.width // 2)))
        angles = 1000.0 * time[:, None] * rates
        known = self.known(features)
        condition = F.silu(self.time(torch.cat([torch.cos(angles), torch.sin(angles)], 1)) + known)
        told = self.tokens(known).unflatten(-1, (self.told, self.width))
        latents = self.first(noisy.reshape(len(noisy), GROUPS, -1))
        tokens = torch.cat([told, latents], 1) + self.places
        for block in self.blocks:
            tokens = block(tokens, None, condition)
        return self.last(self.norm(tokens[:, self.told :])).reshape(-1, LATENTS, WIDE)


def kept_and_noise(time: Tensor) -> tuple[Tensor, Tensor]:
    """Shares of latents and of noise at a time (B,), of the cosine schedule: their squares add up to 1."""
    return torch.cos(time * math.pi / 2), torch.sin(time * math.pi / 2)

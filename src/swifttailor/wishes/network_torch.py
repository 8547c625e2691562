"""The network that reads wishes: a small transformer over the tokens of a text. It loads torch."""

from __future__ import annotations

from dataclasses import dataclass

import torch
from torch import nn
from torch.nn import functional as F

from swifttailor.wishes.text.text_tokens import LONGEST


@dataclass(frozen=True)
class ReaderConfig:
    """Its size."""

    tokens: int
    """Of texts, those for numbers and padding included; the last is padding."""
    statements: int
    """Labels of what a text says."""
    numbers: int
    """Labels of what a number is."""
    width: int = 128
    layers: int = 4
    heads: int = 4
    dropout: float = 0.0
    """Share of what is between the layers that is left out in training."""


class WishNetwork(nn.Module):
    """Says of every token what it is evidence for; a text says what any of its tokens does.

    Evidence is summed as probabilities are (logsumexp), so that one word is enough.
    """

    def __init__(self, config: ReaderConfig) -> None:
        """With random weights.

        Args:
            config: Its size.
        """
        super().__init__()
        self.config = config
        self.embedding = nn.Embedding(config.tokens, config.width)
        self.places = nn.Embedding(LONGEST, config.width)
        self.layers = nn.ModuleList(
            _Layer(config.width, config.heads, config.dropout) for _ in range(config.layers)
        )
        self.dropout = nn.Dropout(config.dropout)
        self.norm = nn.LayerNorm(config.width)
        self.says = nn.Linear(config.width, config.statements)
        self.counts = nn.Linear(config.width, config.numbers + 1)
        for table in (self.embedding, self.places):
            nn.init.normal_(table.weight, std=0.1)
        # Few of the statements are made in any one text, and none by most tokens.
        nn.init.constant_(self.says.bias, -8.0)

    def forward(self, tokens: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor]:
        """Reads texts.

        Args:
            tokens: (B, N), padded at the end.

        Returns:
            Logits (B, statements) of what each text says, and (B, N, 1 + numbers) of what each token is if it
            is a number; 0 is none of all.
        """
        real = tokens != self.config.tokens - 1
        places = torch.arange(tokens.shape[1], device=tokens.device)
        x = self.dropout(self.embedding(tokens) + self.places(places))
        for layer in self.layers:
            x = layer(x, real)
        x = self.dropout(self.norm(x))
        said = self.says(x).masked_fill(~real[:, :, None], -30.0)
        return said.logsumexp(1), self.counts(x)


class _Layer(nn.Module):
    def __init__(self, width: int, heads: int, dropout: float) -> None:
        super().__init__()
        self.dropout = nn.Dropout(dropout)
        self.heads = heads
        self.first, self.second = nn.LayerNorm(width), nn.LayerNorm(width)
        self.given, self.made = nn.Linear(width, 3 * width), nn.Linear(width, width)
        self.up, self.down = nn.Linear(width, 4 * width), nn.Linear(4 * width, width)

    def forward(self, x: torch.Tensor, real: torch.Tensor) -> torch.Tensor:
        batch, length, width = x.shape
        parts = self.given(self.first(x)).view(batch, length, 3, self.heads, width // self.heads)
        query, key, value = parts.permute(2, 0, 3, 1, 4)
        scores = query @ key.transpose(-1, -2) * (width // self.heads) ** -0.5
        scores = scores.masked_fill(~real[:, None, None, :], -1e9)
        heard = (scores.softmax(-1) @ value).transpose(1, 2).reshape(batch, length, width)
        x = x + self.dropout(self.made(heard))
        return x + self.dropout(self.down(F.gelu(self.up(self.second(x)))))

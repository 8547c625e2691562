"""The network for people's own words: an encoder of sentences, and what it says of a text. It loads torch.

The encoder is BERT's (Devlin et al. 2019) as MiniLM has it (Wang et al. 2020), so that training goes on from
what it knows of English.
"""

from __future__ import annotations

import torch
from torch import nn
from torch.nn import functional as F

from swifttailor.wishes.network_torch import ReaderConfig
from swifttailor.wishes.text.text_tokens import LONGEST

_EPSILON = 1e-12
_FASTER = 8.0
"""Steps of what is learnt from nothing, in those of the encoder, which has only to be adapted."""


class SpokenNetwork(nn.Module):
    """Says of every token what it is evidence for; a text says what any of its tokens does."""

    def __init__(self, config: ReaderConfig) -> None:
        """With random weights.

        Args:
            config: Its size.
        """
        super().__init__()
        self.config = config
        self.embedding = nn.Embedding(config.tokens, config.width)
        self.places = nn.Embedding(LONGEST, config.width)
        self.embedded = nn.LayerNorm(config.width, _EPSILON)
        self.layers = nn.ModuleList(
            _Layer(config.width, config.heads, config.dropout) for _ in range(config.layers)
        )
        self.dropout = nn.Dropout(config.dropout)
        self.says = nn.Linear(config.width, config.statements)
        self.counts = nn.Linear(config.width, config.numbers + 1)
        for table in (self.embedding, self.places):
            nn.init.normal_(table.weight, std=0.02)
        # Few of the statements are made in any one text, and none by most tokens.
        nn.init.constant_(self.says.bias, -8.0 / _FASTER)

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
        x = self.dropout(self.embedded(self.embedding(tokens) + self.places(places)))
        for layer in self.layers:
            x = layer(x, real)
        said = (_FASTER * self.says(x)).masked_fill(~real[:, :, None], -30.0)
        return said.logsumexp(1), _FASTER * self.counts(x)


class _Layer(nn.Module):
    def __init__(self, width: int, heads: int, dropout: float) -> None:
        super().__init__()
        self.dropout = nn.Dropout(dropout)
        self.heads = heads
        self.given, self.made = nn.Linear(width, 3 * width), nn.Linear(width, width)
        self.first, self.second = nn.LayerNorm(width, _EPSILON), nn.LayerNorm(width, _EPSILON)
        self.up, self.down = nn.Linear(width, 4 * width), nn.Linear(4 * width, width)

    def forward(self, x: torch.Tensor, real: torch.Tensor) -> torch.Tensor:
        batch, length, width = x.shape
        parts = self.given(x).view(batch, length, 3, self.heads, width // self.heads)
        query, key, value = parts.permute(2, 0, 3, 1, 4)
        scores = query @ key.transpose(-1, -2) * (width // self.heads) ** -0.5
        scores = scores.masked_fill(~real[:, None, None, :], -1e9)
        heard = (scores.softmax(-1) @ value).transpose(1, 2).reshape(batch, length, width)
        x = self.first(x + self.dropout(self.made(heard)))
        return self.second(x + self.dropout(self.down(F.gelu(self.up(x)))))

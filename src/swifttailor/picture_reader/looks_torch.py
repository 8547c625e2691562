"""Questions that look at a map of what is seen, each with its own eyes. It loads torch."""

from __future__ import annotations

import torch
from torch import Tensor, nn
from torch.nn import functional as F


class Looks(nn.Module):
    """Every topic looks at the map with a question of its own."""

    def __init__(self, width: int, heads: int, questions: int) -> None:
        """With random weights.

        Args:
            width: Of the map and of what is found.
            heads: That each question is split into; a divisor of `width`.
            questions: How many.
        """
        super().__init__()
        self.heads = heads
        self.questions = nn.Parameter(torch.randn(questions, width) * 0.3)
        self.keys, self.values = nn.Linear(width, width), nn.Linear(width, width)
        self.found, self.whole = nn.Linear(width, width), nn.Linear(width, width)
        self.norm = nn.LayerNorm(width)
        self.up, self.down = nn.Linear(width, width), nn.Linear(width, width)

    def forward(self, tokens: Tensor, summary: Tensor) -> Tensor:
        """(B, questions, width) of tokens (B, n, width) and what all questions are told (B, width)."""
        batch, count, width = tokens.shape
        part = width // self.heads
        key = self.keys(tokens).view(batch, count, self.heads, part).permute(0, 2, 3, 1)
        value = self.values(tokens).view(batch, count, self.heads, part).transpose(1, 2)
        query = self.questions.view(-1, self.heads, part).transpose(0, 1)
        share = (query[None] @ key * part**-0.5).softmax(-1)
        found = (share @ value).transpose(1, 2).reshape(batch, -1, width)
        whole = self.whole(tokens.mean(1)) + summary
        x = self.found(found) + whole[:, None] + self.questions
        return x + self.down(F.gelu(self.up(self.norm(x))))

"""What says which value each design parameter of a garment has. It loads torch."""

from __future__ import annotations

import math
from collections.abc import Sequence

import torch
from torch import Tensor, nn

from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.picture_reader.labels import BOX, PARTS, measure_labels, statement_labels, topics
from swifttailor.picture_reader.looks_torch import Looks

OF_A_TOPIC, MIXED, DROPOUT = 8, 512, 0.2
NEVER = -1e4
"""Logit of a value that a parameter cannot have."""


class DesignHead(nn.Module):
    """Every parameter looks at the picture, and is told what has been said of the garment."""

    there: Tensor
    """(parameters, most values) whether a parameter has so many."""

    def __init__(self, width: int, heads: int, values: Sequence[int]) -> None:
        """With random weights.

        Args:
            width: Of the map that is looked at.
            heads: See `Looks`.
            values: How many each parameter may have.
        """
        super().__init__()
        count, most = len(values), max(values)
        self.looks = Looks(width, heads, len(PARTS) * count)
        self.each = nn.Linear(width, OF_A_TOPIC)
        statements, measures, panels = len(statement_labels()), len(measure_labels()), len(PANEL_NAMES)
        told = len(topics()) * OF_A_TOPIC + statements + 2 * measures + panels * (1 + len(BOX))
        self.mixed = nn.Sequential(
            nn.Linear(told, MIXED), nn.GELU(), nn.Dropout(DROPOUT), nn.Linear(MIXED, MIXED), nn.GELU()
        )
        self.told = nn.Linear(MIXED, width)
        self.norm = nn.LayerNorm(width)
        self.values = nn.Parameter(torch.randn(count, width, most) / math.sqrt(width))
        self.values_bias = nn.Parameter(torch.zeros(count, most))
        there = torch.arange(most) < torch.tensor(list(values))[:, None]
        self.register_buffer("there", there, persistent=False)

    def forward(self, tokens: Tensor, seen: Tensor, answers: Sequence[Tensor]) -> Tensor:
        """(B, 2, parameters, values) logits.

        Args:
            tokens: (B, width, h, w) map of the picture.
            seen: (B, 2 * topics, width) what each topic has seen.
            answers: Present, statements, has, measures, panels and boxes of a `Reading`, in this order.
        """
        batch, parts = len(tokens), len(PARTS)
        _, said, has, measures, panels, boxes = answers[:6]
        has, named = torch.sigmoid(has), torch.sigmoid(panels)
        rows = [
            self.each(seen).view(batch, parts, -1),
            torch.sigmoid(said),
            has,
            has * measures[..., 0],
            named,
            (named[..., None] * boxes).flatten(2),
        ]
        told = self.told(self.mixed(torch.cat(rows, 2)))
        looked = self.looks(tokens.flatten(2).transpose(1, 2), torch.zeros_like(told[:, 0]))
        x = self.norm(looked.view(batch, parts, -1, looked.shape[-1]) + told[:, :, None])
        logits = torch.einsum("bqpw,pwv->bqpv", x, self.values) + self.values_bias
        return torch.where(self.there, logits, NEVER)

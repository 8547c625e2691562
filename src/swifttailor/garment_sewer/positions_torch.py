"""The last layer of a GarmentSewer. Import where it is needed: it loads torch."""

from __future__ import annotations

import torch
import torch.nn.functional as F
from torch import Tensor, nn

OUTPUT_CM = 10.0
"""Centimetres per unit that the last layer gives."""
ORIGIN_CM = (0.0, 100.0, 0.0)
"""What absolute positions are measured from."""


def positions_from(features: Tensor, last: nn.Conv2d, prior: Tensor, output: str) -> Tensor:
    """Positions of features.

    Args:
        features: (B, C, H, W).
        last: From C channels to 3, a pixel at a time; computed in float32, since bfloat16 would round a metre
            to millimetres.
        prior: (B, 3, H, W) cm.
        output: ``displacement`` from the prior, or ``absolute``.

    Returns:
        (B, 3, H, W) float32 cm.
    """
    assert last.bias is not None
    with torch.autocast(features.device.type, enabled=False):
        offset = F.conv2d(features.float(), last.weight.float(), last.bias.float()) * OUTPUT_CM
        if output == "displacement":
            return prior.float() + offset
        return offset + torch.tensor(ORIGIN_CM, device=features.device)[:, None, None]

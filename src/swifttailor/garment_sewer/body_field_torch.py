"""The body's distance field on tensors, so that what is inside the body can be pushed out by learning."""

from __future__ import annotations

import numpy as np
import torch
import torch.nn.functional as F
from torch import Tensor

from swifttailor.body import DistanceField
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance


class BodyField:
    """`BodyDistance` as tensors on a device; differentiable.

    Outside the lattice the distance is the value at the nearest point of the lattice plus the way to it.
    """

    def __init__(self, body: BodyDistance, device: torch.device | str = "cpu") -> None:
        self._full = _Lattice(body.full, device)
        self._without_arms = _Lattice(body.without_arms, device)

    def distance(self, points: Tensor, ignores_arms: Tensor) -> Tensor:
        """Signed distance (B, H, W) in cm at points (B, 3, H, W)."""
        return torch.where(ignores_arms, self._without_arms(points), self._full(points))


class _Lattice:
    def __init__(self, field: DistanceField, device: torch.device | str) -> None:
        self.values = torch.tensor(np.asarray(field.values, np.float32), device=device)[None, None]
        self.origin = torch.tensor(field.origin, dtype=torch.float32, device=device)
        self.top = torch.tensor(field.values.shape, dtype=torch.float32, device=device) - 1
        self.spacing = field.spacing

    def __call__(self, points: Tensor) -> Tensor:
        place = (points.permute(0, 2, 3, 1) - self.origin) / self.spacing
        inside = torch.minimum(place.clamp(min=0.0), self.top)
        # grid_sample counts from -1 to 1 and takes the last axis first.
        grid = (2 * inside / self.top.clamp(min=1) - 1).flip(-1)[:, None]
        sampled = F.grid_sample(
            self.values.expand(len(points), -1, -1, -1, -1),
            grid,
            mode="bilinear",
            padding_mode="border",
            align_corners=True,
        )
        away = ((place - inside) ** 2).sum(dim=-1).clamp(min=1e-12).sqrt() * self.spacing
        return sampled[:, 0, 0] + torch.where((place == inside).all(dim=-1), 0.0, away)

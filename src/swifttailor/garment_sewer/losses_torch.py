"""The losses, on torch tensors; what they mean is said in `LossWeights`."""

from __future__ import annotations

from dataclasses import dataclass

import torch
import torch.nn.functional as F
from torch import Tensor

from swifttailor.garment_sewer.body_field_torch import BodyField
from swifttailor.garment_sewer.losses import LossWeights

# Steps (rows, columns) between neighbouring pixels; the two diagonals feel shear.
STRAIGHT = ((0, 1), (1, 0))
NEIGHBOURS = (*STRAIGHT, (1, 1), (1, -1))


@dataclass(frozen=True, eq=False)
class Truth:
    """What is known of a batch of B images besides the prediction; lengths in cm."""

    target: Tensor
    """(B, 3, H, W) positions in the drape."""
    occupancy: Tensor
    """(B, 1, H, W) 1 where there is a panel, else 0."""
    panel: Tensor
    """(B, H, W) panel index, -1 where there is none."""
    contour: Tensor
    """(B, H, W) whether a pixel stands for a point of the outline."""
    local: Tensor
    """(B, 2, H, W) panel-local position."""
    edge_distance: Tensor
    """(B, H, W) pixels to the nearest pixel of the contour."""
    ignores_arms: Tensor
    """(B, H, W) whether the pixel passes through the arms."""
    pairs: Tensor
    """(k, 2) flat indices into (B, H, W) of pixels sewn to each other."""
    sides: Tensor
    """(s, 2, m) flat indices into (B, H, W) of the pixels along both sides of each stitch; -1 fills up."""


def compute_losses(
    predicted: Tensor, truth: Truth, weights: LossWeights, body: BodyField | None = None
) -> dict[str, Tensor]:
    """All losses whose weight is not 0, unweighted, and their weighted sum as ``total``.

    Args:
        predicted: (B, 3, H, W) cm.
        truth: Of the same batch.
        weights: What to compute.
        body: Needed with `LossWeights.penetration`.
    """
    predicted = predicted.float() / weights.unit_cm
    target = truth.target / weights.unit_cm
    error = (predicted - target).abs().sum(dim=1)
    occupied = truth.panel >= 0
    losses = {"regression": _mean(error, occupied)}
    factors = {"regression": weights.regression}
    if weights.edge:
        losses["edge"] = _mean(error, occupied & (truth.edge_distance <= weights.edge_band))
        factors["edge"] = weights.regression * weights.edge
    if weights.stitching:
        losses["stitching"] = chamfer_of_stitches(predicted, truth.sides)
        factors["stitching"] = weights.stitching
    if weights.normals:
        losses["normals"] = normal_variation(predicted, truth.panel)
        factors["normals"] = weights.normals
    if weights.seam_pairs:
        losses["seam_pairs"] = seam_pair_error(predicted, target, truth.pairs)
        factors["seam_pairs"] = weights.seam_pairs
    if weights.gradient:
        losses["gradient"] = gradient_error(predicted, target, truth)
        factors["gradient"] = weights.gradient
    if weights.strain:
        rest = truth.local / weights.unit_cm
        losses["strain"] = excess_stretch(predicted, rest, truth, weights.strain_tolerance)
        factors["strain"] = weights.strain
    if weights.penetration:
        assert body is not None, "the penetration loss needs a body"
        distance = body.distance(predicted * weights.unit_cm, truth.ignores_arms)
        depth = F.relu(weights.clearance_cm - distance) / weights.unit_cm
        losses["penetration"] = _mean(depth, occupied)
        factors["penetration"] = weights.penetration
    losses["total"] = torch.stack([losses[name] * factor for name, factor in factors.items()]).sum()
    return losses


def chamfer_of_stitches(positions: Tensor, sides: Tensor) -> Tensor:
    """Mean over stitches of the squared Chamfer distance between their sides (paper, Eq. 3)."""
    if not sides.numel():
        return positions.sum() * 0.0
    valid = sides >= 0
    points = _gather(positions, sides.clamp(min=0))
    a, b = points[:, 0], points[:, 1]
    apart = ((a[:, :, None] - b[:, None, :]) ** 2).sum(dim=-1)
    apart = apart.masked_fill(~(valid[:, 0, :, None] & valid[:, 1, None, :]), torch.inf)
    total = positions.sum() * 0.0
    for side, nearest in ((0, apart.amin(dim=2)), (1, apart.amin(dim=1))):
        own = valid[:, side]
        nearest = torch.where(own, nearest, 0.0)
        total = total + (nearest.sum(dim=1) / own.sum(dim=1).clamp(min=1)).mean()
    return total


def seam_pair_error(predicted: Tensor, target: Tensor, pairs: Tensor) -> Tensor:
    """Mean over sewn pairs of the absolute error of the vector between them, summed over x, y and z."""
    if not pairs.numel():
        return predicted.sum() * 0.0
    p, q = _gather(predicted, pairs).unbind(dim=1)
    p0, q0 = _gather(target, pairs).unbind(dim=1)
    return ((p - q) - (p0 - q0)).abs().sum(dim=-1).mean()


def normal_variation(positions: Tensor, panel: Tensor) -> Tensor:
    """Mean absolute difference of neighbouring unit normals, summed over x, y and z.

    The normal at a pixel is that of the cell up and to the right of it, where all four pixels are of one
    panel.
    """
    x, p = positions, panel
    whole = (p[:, :-1, :-1] >= 0) & (p[:, :-1, :-1] == p[:, 1:, :-1])
    whole &= (p[:, :-1, :-1] == p[:, :-1, 1:]) & (p[:, :-1, :-1] == p[:, 1:, 1:])
    first = x[:, :, 1:, 1:] - x[:, :, :-1, :-1]
    second = x[:, :, 1:, :-1] - x[:, :, :-1, 1:]
    normals = F.normalize(torch.cross(first, second, dim=1), dim=1, eps=1e-12)
    total, count = positions.sum() * 0.0, torch.zeros((), device=x.device)
    for rows, columns in STRAIGHT:
        a, b = _shifted(normals, rows, columns)
        m, n = _shifted(whole, rows, columns)
        both = m & n
        total = total + torch.where(both, (a - b).abs().sum(dim=1), 0.0).sum()
        count = count + both.sum()
    return total / count.clamp(min=1)


def gradient_error(predicted: Tensor, target: Tensor, truth: Truth) -> Tensor:
    """Mean absolute error of the steps between neighbours, per pixel apart, summed over x, y and z."""
    total, count = predicted.sum() * 0.0, torch.zeros((), device=predicted.device)
    for rows, columns in NEIGHBOURS:
        joined = cloth_between(truth.panel, truth.contour, rows, columns)
        a, b = _shifted(predicted - target, rows, columns)
        step = (rows**2 + columns**2) ** 0.5
        total = total + torch.where(joined, (a - b).abs().sum(dim=1) / step, 0.0).sum()
        count = count + joined.sum()
    return total / count.clamp(min=1)


def excess_stretch(positions: Tensor, rest: Tensor, truth: Truth, tolerance: float) -> Tensor:
    """Length of neighbours' distances beyond (1 + tolerance) of the flat ones, over the latter's sum."""
    excess, whole = positions.sum() * 0.0, torch.zeros((), device=positions.device)
    for rows, columns in NEIGHBOURS:
        joined = cloth_between(truth.panel, truth.contour, rows, columns)
        a, b = _shifted(positions, rows, columns)
        u, v = _shifted(rest, rows, columns)
        flat = torch.where(joined, (u - v).norm(dim=1), 0.0)
        # The root of a square has no slope at zero; pairs that do not count would give NaN.
        length = (torch.where(joined[:, None], a - b, 1.0) ** 2).sum(dim=1).clamp(min=1e-16).sqrt()
        excess = excess + torch.where(joined, F.relu(length - (1 + tolerance) * flat), 0.0).sum()
        whole = whole + flat.sum()
    return excess / whole.clamp(min=1e-9)


def cloth_between(panel: Tensor, contour: Tensor, rows: int, columns: int) -> Tensor:
    """Whether a pixel and its neighbour are of one panel with cloth between them.

    Two pixels of the contour may lie on either side of a dart: they do not count.
    """
    p, q = _shifted(panel, rows, columns)
    c, d = _shifted(contour, rows, columns)
    return (p == q) & (p >= 0) & ~(c & d)


def _shifted(image: Tensor, rows: int, columns: int) -> tuple[Tensor, Tensor]:
    """An image (..., H, W) without its last rows and columns, and its neighbours that many steps further."""
    height, width = image.shape[-2:]
    if columns >= 0:
        return (
            image[..., : height - rows, : width - columns],
            image[..., rows:, columns:],
        )
    return image[..., : height - rows, -columns:], image[..., rows:, : width + columns]


def _gather(image: Tensor, index: Tensor) -> Tensor:
    """Values (..., 3) of an image (B, 3, H, W) at flat indices (...) into (B, H, W)."""
    return image.permute(0, 2, 3, 1).reshape(-1, 3)[index]


def _mean(values: Tensor, where: Tensor) -> Tensor:
    return torch.where(where, values, 0.0).sum() / where.sum().clamp(min=1)

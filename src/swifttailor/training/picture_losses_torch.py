"""How far a picture reader is off. Import this where it is needed: it loads torch."""

from __future__ import annotations

from functools import lru_cache

import torch
from torch import Tensor
from torch.nn import functional as F

from swifttailor.picture_reader.close_ups import WHOLE, told_by
from swifttailor.picture_reader.figures import FIGURES
from swifttailor.picture_reader.labels import VIEW
from swifttailor.picture_reader.network_torch import Reading
from swifttailor.picture_reader.panel_kinds import PANEL_KINDS
from swifttailor.picture_reader.units import NARROWEST, WIDEST
from swifttailor.training.picture_config import LossWeights
from swifttailor.training.picture_truth_torch import Answers, OfEach

_SMALL = ("cuff", "cuff flounce", "leg cuff", "leg cuff flounce", "collar", "waistband", "inset", "tier")
_KIND_WEIGHTS = [3.0 if kind in _SMALL else 1.0 for kind in PANEL_KINDS]
"""Kinds of panels that are small, or seldom there."""
_SIDE_ALONE = torch.tensor([name in ("sine", "cosine") for name in VIEW])
"""Of `VIEW`, what is known where the place is not: clothes are photographed with their fronts up."""
_NEAR = 0.2
"""Measures that are nearer than this, in the unit of `scaled`, hardly count any more."""


def reading_losses(reading: Reading, truth: Answers, weights: LossWeights) -> dict[str, Tensor]:
    """The losses of a batch, a picture; ``total`` is the weighted sum.

    Statements count where they are clear, everything but `present` where a garment is; boxes of panels that
    are there. ``widths`` is the likelihood of a Laplace distribution around each measure; the measures
    themselves have a loss of their own, for where widths are small the likelihood has gradients beside which
    all others vanish. Of a group nothing counts but that it is one, and of a picture in which the garment's
    place is unknown neither masks nor the view do, but for the side that is seen.
    """
    reading = Reading(*(value.float() for value in reading if value is not None))
    count = len(truth.present)
    each = _weights(weights.details, truth.present.device)
    several, one = (truth.figures == FIGURES.index(name) for name in ("several", "one"))
    said = truth.told & (truth.whole & ~several)[:, None]
    losses = {
        "figures": (F.cross_entropy(reading.figures, truth.figures, reduction="none") * truth.whole).sum(),
        "present": _cross_entropy(reading.present, truth.present, said),
        "statements": _cross_entropy(reading.statements, truth.statements, truth.clear * each.statements),
        "has": _cross_entropy(reading.has, truth.has, truth.measured * each.measures),
    }
    has = truth.has * truth.measured * each.measures
    value, width = reading.measures[..., 0], reading.measures[..., 1].clamp(NARROWEST, WIDEST)
    off = F.smooth_l1_loss(value, truth.measures, reduction="none", beta=_NEAR)
    losses["measures"] = (off * has).sum()
    likelihood = (value - truth.measures).abs().detach() * torch.exp(-width) + width
    losses["widths"] = (likelihood * has).sum()
    losses["panels"] = _cross_entropy(reading.panels, truth.panels, truth.named * each.panels)
    apart = F.smooth_l1_loss(reading.boxes, truth.boxes, reduction="none", beta=0.1).sum(-1)
    losses["boxes"] = (apart * truth.panels * truth.named * each.panels).sum()
    turned = F.smooth_l1_loss(reading.view, truth.view, reduction="none", beta=0.1)
    told = one[:, None] & (truth.placed[:, None] | _SIDE_ALONE.to(one.device))
    losses["view"] = (turned * told).sum()
    mask = F.binary_cross_entropy_with_logits(reading.masks, truth.masks, reduction="none")
    losses["masks"] = 10 * (mask.mean(dim=(1, 2, 3)) * (~several & truth.placed)).sum()
    known = truth.places.isfinite()
    off = F.smooth_l1_loss(reading.places, truth.places.nan_to_num(0.0), reduction="none", beta=0.05)
    cells = known[:, 0].sum(dim=(1, 2)).clamp_min(1)
    losses["places"] = 10 * ((off * known).sum(dim=(1, 2, 3)) / cells).sum()
    cloth = truth.kinds >= 0
    weight = torch.tensor(_KIND_WEIGHTS, device=cloth.device)
    kinds = F.cross_entropy(reading.kinds, truth.kinds.clamp_min(0), weight, reduction="none")
    cells = cloth.sum(dim=(1, 2)).clamp_min(1)
    losses["kinds"] = ((kinds * cloth).sum(dim=(1, 2)) / cells).sum()
    seams = F.binary_cross_entropy_with_logits(reading.seams[:, 0], truth.seams, reduction="none")
    losses["seams"] = ((seams * cloth).sum(dim=(1, 2)) / cells).sum()
    if reading.designs is not None:
        losses["designs"] = -(truth.designs * reading.designs.log_softmax(-1)).sum()
    losses = {name: value / count for name, value in losses.items()}
    factor = {"has": weights.measures, "widths": weights.measures} | vars(weights)
    losses["total"] = torch.stack([factor[name] * value for name, value in losses.items()]).sum()
    return losses


@lru_cache(maxsize=4)
def _weights(details: float, device: torch.device) -> OfEach:
    """Small things have small gradients, in which nothing is learnt beside all others."""
    near = (torch.from_numpy(table[:WHOLE].any(axis=0)).to(device) for table in told_by())
    return OfEach(*(torch.where(small, details, 1.0) for small in near))


def _cross_entropy(logits: Tensor, truth: Tensor, counts: Tensor) -> Tensor:
    each = F.binary_cross_entropy_with_logits(logits, truth, reduction="none")
    return (each * counts).sum()

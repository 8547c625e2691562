"""Norms over the batch that were folded away, made fit for training. Import where needed: it loads torch."""

from __future__ import annotations

from collections.abc import Callable

import torch
from torch import Tensor, nn

from swifttailor.networks.folded_norms_torch import foldable

_LEAST_VARIANCE = 1e-6
"""Of a channel that hardly changes: what a norm divides by stays away from 0."""


@torch.no_grad()
def settle_norms(network: nn.Module, show: Callable[[], object]) -> None:
    """Gives norms over the batch the means and variances of what they see; the network's answers stay.

    Norms that were folded come back without knowing what they normalise (`graph_weights`): as they are, a
    step of training, in which they go by the batch, would begin with another network than that of the file.

    Args:
        network: Changed in place.
        show: Runs the network on examples enough to tell mean and variance by.
    """
    norms = [network.get_submodule(name) for _, name, _, _ in foldable(network)]
    moments = [_Moments() for _ in norms]
    hooks = [n.register_forward_pre_hook(m.look) for n, m in zip(norms, moments, strict=True)]
    modes = {part: part.training for part in network.modules()}
    network.eval()
    try:
        show()
    finally:
        for hook in hooks:
            hook.remove()
        for part, mode in modes.items():
            part.training = mode
    for norm, seen in zip(norms, moments, strict=True):
        assert isinstance(norm, nn.BatchNorm2d)
        assert norm.running_mean is not None and norm.running_var is not None
        mean, variance = (value.to(norm.weight) for value in seen.mean_and_variance())
        # The same line through other points: slope * x + offset is what it was.
        slope = norm.weight / (norm.running_var + norm.eps).sqrt()
        norm.bias.add_(slope * (mean - norm.running_mean))
        norm.weight.copy_(slope * (variance + norm.eps).sqrt())
        norm.running_mean.copy_(mean)
        norm.running_var.copy_(variance)


class _Moments:
    """Sums over all values of each channel that a norm is given."""

    def __init__(self) -> None:
        self.count = 0
        self.sums: Tensor | None = None
        """(2, channels): of the values and of their squares."""

    def look(self, norm: nn.Module, given: tuple[Tensor, ...]) -> None:
        """Counts a batch (B, channels, H, W)."""
        values = given[0].detach().double()
        sums = torch.stack([values.sum((0, 2, 3)), (values**2).sum((0, 2, 3))])
        self.sums = sums if self.sums is None else self.sums + sums
        self.count += values.numel() // values.shape[1]

    def mean_and_variance(self) -> tuple[Tensor, Tensor]:
        """Of each channel."""
        assert self.sums is not None, "nothing was shown"
        mean, square = self.sums / self.count
        return mean, (square - mean**2).clamp(min=_LEAST_VARIANCE)

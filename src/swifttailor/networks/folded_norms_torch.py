"""Norms over the batch as part of the convolutions before them. Import where needed: it loads torch."""

from __future__ import annotations

from torch import nn
from torch.nn.utils.fusion import fuse_conv_bn_eval


def fold_norms(network: nn.Module) -> int:
    """Folds every `BatchNorm2d` right after a `Conv2d` in a `Sequential` into its weights, in place.

    Once trained, both are one linear map: the network computes the same as in evaluation mode before, up to
    rounding, and can no longer be trained.

    Returns:
        How many norms are gone.
    """
    folded = 0
    for part in network.modules():
        if not isinstance(part, nn.Sequential):
            continue
        for k in range(len(part) - 1):
            convolution, norm = part[k], part[k + 1]
            if isinstance(convolution, nn.Conv2d) and isinstance(norm, nn.BatchNorm2d):
                part[k] = fuse_conv_bn_eval(convolution.eval(), norm.eval())
                part[k + 1] = nn.Identity()
                folded += 1
    return folded

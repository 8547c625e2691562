"""Norms over the batch as part of the convolutions before them. Import where needed: it loads torch."""

from __future__ import annotations

import itertools
from collections.abc import Iterator

from torch import nn
from torch.nn.utils.fusion import fuse_conv_bn_eval

_CHAINS = ("ResNetConvLayer", "ResNetShortCut")
"""Modules of transformers that run their parts in the order in which they have them, as `Sequential` does."""


def fold_norms(network: nn.Module) -> int:
    """Folds every `BatchNorm2d` right after a `Conv2d` in a `Sequential` or its like, in place.

    Once trained, both are one linear map: the network computes the same as in evaluation mode before, up to
    rounding, and can no longer be trained.

    Returns:
        How many norms are gone.
    """
    pairs = [(c, n) for c, n, _, _ in foldable(network)]
    for at_convolution, at_norm in pairs:
        convolution, norm = network.get_submodule(at_convolution), network.get_submodule(at_norm)
        assert isinstance(convolution, nn.Conv2d) and isinstance(norm, nn.BatchNorm2d)
        network.set_submodule(at_convolution, fuse_conv_bn_eval(convolution.eval(), norm.eval()))
        network.set_submodule(at_norm, nn.Identity())
    return len(pairs)


def foldable(network: nn.Module) -> Iterator[tuple[str, str, int, float]]:
    """What `fold_norms` makes one: names of a convolution and the norm after it, with width and epsilon."""
    for name, part in network.named_modules():
        if not isinstance(part, nn.Sequential) and type(part).__name__ not in _CHAINS:
            continue
        inside = list(part.named_children())
        for (first, convolution), (second, norm) in itertools.pairwise(inside):
            if isinstance(convolution, nn.Conv2d) and isinstance(norm, nn.BatchNorm2d):
                prefix = f"{name}." if name else ""
                yield f"{prefix}{first}", f"{prefix}{second}", norm.num_features, norm.eps

"""Convolutions before a vision transformer. Import this in the function that needs it: it loads torch."""

from __future__ import annotations

from itertools import pairwise

from torch import Tensor, nn

_FIRST = 4
"""Pixels along each side that the first convolution takes together."""


class ConvolutionalStem(nn.Sequential):
    """What cuts a picture into patches, in several steps (Xiao et al. 2021), instead of one matrix.

    From random weights a vision transformer of our size is slow to find out that neighbouring pixels belong
    together; convolutions with norms over the batch know it.
    """

    def __init__(self, size: int, patch_size: int) -> None:
        """Makes one.

        Args:
            size: Channels of a patch.
            patch_size: Pixels along its sides, a power of 2 from 8 on.
        """
        steps = (patch_size // _FIRST).bit_length()
        widths = [max(size >> (steps - 1 - k), 8) for k in range(steps)]
        layers: list[nn.Module] = [_normed(3, widths[0], _FIRST), nn.GELU()]
        for before, width in pairwise(widths):
            layers += [_Block(before), _normed(before, width, 2), nn.GELU()]
        super().__init__(*layers, nn.Conv2d(widths[-1], size, 1))

    @property
    def weight(self) -> Tensor:
        """The first weights; transformers casts pictures to their type."""
        return next(self.parameters())


class _Block(nn.Module):
    def __init__(self, size: int) -> None:
        super().__init__()
        self.layers = nn.Sequential(_normed(size, size, 1), nn.GELU(), _normed(size, size, 1))
        self.activation = nn.GELU()

    def forward(self, input: Tensor) -> Tensor:
        return self.activation(input + self.layers(input))


def _normed(given: int, size: int, stride: int) -> nn.Sequential:
    kernel, padding = (stride, 0) if stride == _FIRST else (3, 1)
    return nn.Sequential(nn.Conv2d(given, size, kernel, stride, padding, bias=False), nn.BatchNorm2d(size))

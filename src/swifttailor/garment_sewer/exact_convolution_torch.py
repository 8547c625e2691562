"""A convolution in float32. Import where it is needed: it loads torch."""

from __future__ import annotations

from typing import Any

import torch
from torch import Tensor, nn


class ExactConvolution(nn.Conv2d):
    """A convolution in float32, whatever the rest is computed in.

    Positions of a metre in bfloat16 are 4 mm apart, and neighbouring pixels 5 to 20: the network would hardly
    see how the cloth that it is shown runs.
    """

    def forward(self, input: Tensor) -> Tensor:
        """As `torch.nn.Conv2d`; the result is of the type of the weights."""
        with torch.autocast(input.device.type, enabled=False):
            bias = None if self.bias is None else self.bias.float()
            out = self._conv_forward(input.float(), self.weight.float(), bias)
        return out.to(self.weight.dtype)


def exact_like(convolution: nn.Conv2d) -> ExactConvolution:
    """The same shape, with weights of its own."""
    kernel: Any = convolution.kernel_size
    stride: Any = convolution.stride
    return ExactConvolution(convolution.in_channels, convolution.out_channels, kernel, stride)

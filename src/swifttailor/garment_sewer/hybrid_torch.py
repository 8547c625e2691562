"""A dense prediction transformer on top of convolutions. Import where it is needed: it loads torch."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import torch
import torch.nn.functional as F
from torch import Tensor, nn
from transformers import DPTConfig
from transformers.models.dpt.modeling_dpt import DPTPreTrainedModel, DPTViTEncoder

from swifttailor.garment_sewer.exact_convolution_torch import ExactConvolution
from swifttailor.garment_sewer.positions_torch import positions_from

_BRANCH = 0.1
"""Size of what a layer of the transformer adds at first, where what it is given is of size 1."""
_BRANCH_ENDS = ("attention.output.dense", "o_proj", "mlp.fc2", "output.dense")


class HybridSewerNetwork(DPTPreTrainedModel):
    """DPT-Hybrid (Ranftl et al. 2021): convolutions make the tokens, and their finer features stay at hand.

    In DPT-Hybrid these are a ResNet's, and the decoder adds up features of four sizes, the finest of a
    quarter of the image. Here the encoder's features of every size down to the image's own are read by the
    decoder beside what comes from below (Ronneberger et al. 2015), and norms over the batch follow every
    convolution.
    """

    def __init__(self, config: DPTConfig) -> None:
        super().__init__(config)
        widths = [*config.convolutions, config.hidden_size]
        given: Any = config  # its types allow for what is not used here: None, and pairs of numbers
        self.first = nn.Sequential(
            ExactConvolution(given.num_channels, widths[0], 3, padding=1, bias=False),
            nn.BatchNorm2d(widths[0]),
            nn.GELU(),
        )
        steps = list(pairwise(widths))
        self.down = nn.ModuleList(
            nn.Sequential(_Convolution(fine, coarse, 2), _block(coarse, coarse)) for fine, coarse in steps
        )
        # What all tokens have in common is nothing to attend to.
        self.token_norm = nn.BatchNorm2d(config.hidden_size, affine=False)
        side = given.image_size // given.patch_size
        self.positions = nn.Parameter(torch.zeros(1, config.hidden_size, side, side))
        self.encoder = DPTViTEncoder(config)
        self.up = nn.ModuleList(_block(coarse + fine, fine) for fine, coarse in reversed(steps))
        self.last = nn.Conv2d(widths[0], 3, 1)
        self.post_init()
        _initialize(self)

    @property
    def lowered(self) -> list[nn.Module]:
        """What may compute in bfloat16."""
        return [self.down, self.encoder, self.up]

    def forward(self, conditioning: Tensor, occupancy: Tensor, prior: Tensor) -> Tensor:
        """Predicts positions; see `GarmentSewerNetwork.forward`."""
        features = [self.first(conditioning)]
        for step in self.down:
            features.append(step(features[-1]))
        x = self.token_norm(features.pop())
        # In other sizes than it was trained at; always, since a graph must hold for all of them.
        places = F.interpolate(self.positions, size=x.shape[-2:], mode="bilinear", align_corners=False)
        tokens = (x + places).flatten(2).transpose(1, 2)
        tokens = self.encoder(tokens.to(next(self.encoder.parameters()).dtype)).last_hidden_state
        x = tokens.transpose(1, 2).reshape(x.shape).to(x.dtype)
        for step in self.up:
            fine = features.pop()
            x = F.interpolate(x, scale_factor=2.0, mode="nearest")
            x = step(torch.cat([x, fine.to(x.dtype)], dim=1))
        return positions_from(x, self.last, prior, self.config.output)


def _initialize(network: HybridSewerNetwork) -> None:
    """Weights through which signals pass, as `network_torch` has them; the transformer begins with little."""
    for name, module in network.named_modules():
        if isinstance(module, nn.Conv2d):
            nn.init.normal_(module.weight, std=module.weight[0].numel() ** -0.5)
        elif isinstance(module, nn.Linear):
            nn.init.xavier_uniform_(module.weight)
            if name.endswith(_BRANCH_ENDS):
                module.weight.data *= _BRANCH
    nn.init.normal_(network.positions, std=0.02)
    # An untrained network predicts its prior, or one point, exactly.
    nn.init.zeros_(network.last.weight)
    assert network.last.bias is not None
    nn.init.zeros_(network.last.bias)


class _Convolution(nn.Sequential):
    def __init__(self, given: int, size: int, stride: int = 1) -> None:
        convolution = nn.Conv2d(given, size, 3, stride, padding=1, bias=False)
        super().__init__(convolution, nn.BatchNorm2d(size), nn.GELU())


def _block(given: int, size: int) -> nn.Sequential:
    return nn.Sequential(_Convolution(given, size), _Convolution(size, size))

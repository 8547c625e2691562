"""The network itself. Import this module in the function that needs it: it loads torch and transformers."""

from __future__ import annotations

from typing import Any, TypeAlias

import torch
import torch.nn.functional as F
from torch import Tensor, nn
from transformers import DPTConfig, DPTForDepthEstimation

from swifttailor.garment_sewer.exact_convolution_torch import exact_like
from swifttailor.garment_sewer.hybrid_torch import HybridSewerNetwork
from swifttailor.garment_sewer.network_config import NetworkConfig
from swifttailor.garment_sewer.positions_torch import positions_from

SewerNetwork: TypeAlias = "GarmentSewerNetwork | HybridSewerNetwork"

HEAD_SIZE = 32
"""Channels of the last stage, fixed in DPT."""


class GarmentSewerNetwork(DPTForDepthEstimation):
    """DPT with three signed outputs; keys of its weights are those of `DPTForDepthEstimation`.

    Beyond DPT it may carry the input to its last stage at full resolution, and keep that stage's convolutions
    from looking across the empty pixels between panels.
    """

    def __init__(self, config: DPTConfig) -> None:
        super().__init__(config)
        given: Any = config  # its types allow for what is not used here: None, and pairs of numbers
        head: Any = self.head.head
        head[4] = nn.Conv2d(HEAD_SIZE, 3, 1)
        head[5] = nn.Identity()
        if config.normalized:
            count = len(given.backbone_out_indices)
            self.state_norms = nn.ModuleList(_StateNorm(config.hidden_size) for _ in range(count))
            self.feature_norm = nn.LayerNorm(config.fusion_hidden_size)
        patches: Any = self.dpt.embeddings.patch_embeddings
        patches.projection = exact_like(patches.projection)
        # Zero weights: an untrained network predicts its prior, or one point, exactly.
        skip = config.input_skip
        if skip:
            self.input_skip = nn.Conv2d(given.num_channels, skip, 3, padding=1)
            self.input_merge = nn.Conv2d(HEAD_SIZE + skip, HEAD_SIZE, 1)
        self.post_init()
        _initialize(self)
        nn.init.zeros_(self.last.weight)
        nn.init.zeros_(head[4].bias)
        # DPT carries these along without using them: the first fusion has no second input, and the decoder
        # reads the layers before the last norm. Several processes would wait for their gradients.
        for unused in (self.dpt.layernorm, self.neck.fusion_stage.layers[0].residual_layer1):
            unused.requires_grad_(False)

    def forward(self, conditioning: Tensor, occupancy: Tensor, prior: Tensor) -> Tensor:
        """Predicts positions.

        Args:
            conditioning: (B, C, H, W).
            occupancy: (B, 1, H, W) 1 where there is a panel, else 0.
            prior: (B, 3, H, W) cm; not looked at for absolute output.

        Returns:
            (B, 3, H, W) float32 positions in cm. They mean nothing where there is no panel.
        """
        states = self.dpt(conditioning, output_hidden_states=True).hidden_states
        config: Any = self.config
        wanted = config.backbone_out_indices
        states = [s for k, s in enumerate(states[1:]) if k in wanted]
        if self.config.normalized:
            states = [norm(s) for norm, s in zip(self.state_norms, states, strict=True)]
        patch = config.patch_size
        height, width = conditioning.shape[-2] // patch, conditioning.shape[-1] // patch
        features = self.neck(states, height, width)[self.config.head_in_index]
        head: Any = self.head.head
        act = F.relu
        if self.config.normalized:
            act = F.gelu
            features = self.feature_norm(features.permute(0, 2, 3, 1).float()).permute(0, 3, 1, 2)
        x = F.interpolate(
            head[0](features), size=conditioning.shape[-2:], mode="bilinear", align_corners=True
        )
        mask = occupancy.to(x.dtype) if self.config.masked else None
        x = act(_masked(head[2], x, mask))
        if self.config.input_skip:
            with torch.autocast(x.device.type, enabled=False):
                seen = occupancy.float() if self.config.masked else None
                skip = act(_masked(self.input_skip, conditioning.float(), seen))
            x = x + act(self.input_merge(torch.cat([x, skip.to(x.dtype)], dim=1)))
        return positions_from(x, self.last, prior, self.config.output)

    @property
    def last(self) -> nn.Conv2d:
        """The layer that gives positions."""
        head: Any = self.head.head
        return head[4]

    @property
    def lowered(self) -> list[nn.Module]:
        """What may compute in bfloat16."""
        return [self.dpt, self.neck]


def _initialize(network: GarmentSewerNetwork) -> None:
    """Random weights through which signals pass undiminished (Glorot and Bengio 2010, He et al. 2015).

    transformers gives all weights a deviation of 0.02. A dozen convolutions of a few channels then leave
    nothing of what the transformer found, and the network learns from its last layers alone for a long time.
    """
    nn.init.normal_(network.dpt.embeddings.position_embeddings, std=0.02)
    for module in network.dpt.encoder.modules():
        if isinstance(module, nn.Linear):
            nn.init.xavier_uniform_(module.weight)
    for name, module in network.named_modules():
        if name.startswith("dpt.") or not isinstance(module, (nn.Conv2d, nn.ConvTranspose2d, nn.Linear)):
            continue
        spread = isinstance(module, nn.ConvTranspose2d)  # its kernels lie side by side, one input each
        fan = module.in_channels if spread else module.weight[0].numel()
        after_relu = ".convolution" in name or name == "input_merge"
        gain = 2.0**0.5 if after_relu else 1.0
        # What is added to a residual is small, so that four stages of them do not add up to much.
        factor = 0.5 if name.endswith("convolution2") else 1.0
        nn.init.normal_(module.weight, std=factor * gain / fan**0.5)


class _StateNorm(nn.BatchNorm1d):
    """Takes away what the transformer's tokens have in common, whatever the garment.

    It grows from layer to layer and step to step. The decoder would multiply it until nothing else is heard.
    """

    def __init__(self, size: int) -> None:
        super().__init__(size, affine=False)

    def forward(self, input: Tensor) -> Tensor:
        """(B, n, size) for (B, n, size)."""
        if self.training:
            return super().forward(input.flatten(0, 1)).view_as(input)
        mean, variance = self.running_mean, self.running_var
        assert mean is not None and variance is not None
        return (input - mean) * torch.rsqrt(variance + self.eps)


def _masked(convolution: nn.Conv2d, x: Tensor, mask: Tensor | None) -> Tensor:
    """A 3 x 3 convolution that sees the masked pixels only, and is made up for those it does not see.

    Partial convolution (Liu et al. 2018): the sum over the visible pixels times 9 over their number.
    """
    if mask is None:
        return convolution(x)
    weight, bias = convolution.weight, convolution.bias
    assert bias is not None
    ones = torch.ones((1, 1, 3, 3), device=x.device, dtype=mask.dtype)
    seen = F.conv2d(mask, ones, padding=1)
    summed = F.conv2d(x * mask, weight, padding=1)
    return summed * (9.0 / seen.clamp(min=1.0)) + bias[:, None, None]


def build_network(config: NetworkConfig, channels: int) -> SewerNetwork:
    """Makes a network, from random weights or from `config.pretrained`.

    Args:
        config: Its shape.
        channels: Of the conditioning image.

    Raises:
        InputError: The pretrained weights cannot be had or do not fit.
    """
    if config.convolutions:
        return HybridSewerNetwork(dpt_config(config, channels))
    network = GarmentSewerNetwork(dpt_config(config, channels))
    if config.pretrained:
        from swifttailor.garment_sewer.pretrained_torch import load_pretrained

        load_pretrained(network, config.pretrained)
    return network


def dpt_config(config: NetworkConfig, channels: int) -> DPTConfig:
    """The same shape in transformers' words."""
    finest = config.patch_size / 4
    factors = [finest / 2**k for k in range(4)]
    made = DPTConfig(
        hidden_size=config.hidden_size,
        num_hidden_layers=config.layers,
        num_attention_heads=config.heads,
        intermediate_size=4 * config.hidden_size,
        image_size=config.resolution,
        patch_size=config.patch_size,
        num_channels=channels,
        is_hybrid=False,
        backbone_config=None,
        layer_norm_eps=1e-6,
        hidden_dropout_prob=0.0,
        attention_probs_dropout_prob=0.0,
        backbone_out_indices=[config.layers - 1] if config.convolutions else out_layers(config.layers),
        readout_type=config.readout,
        reassemble_factors=[int(f) if f >= 1 else f for f in factors],
        neck_hidden_sizes=list(config.decoder_sizes),
        fusion_hidden_size=config.fusion_size,
        use_auxiliary_head=False,
    )
    made.convolutions = list(config.convolutions)
    made.output, made.input_skip, made.masked = config.output, config.input_skip, config.masked
    made.normalized = made.use_batch_norm_in_fusion_residual = config.normalized
    return made


def out_layers(layers: int) -> list[int]:
    """The layers that the decoder reads: 5, 11, 17 and 23 of 24, as DPT-Large."""
    return [round(layers * k / 4) - 1 for k in (1, 2, 3, 4)]

"""The network that reads pictures: a trunk of convolutions, and a look for every topic. It loads torch."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, NamedTuple

import torch
from torch import Tensor, nn
from torch.nn import functional as F

from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.picture_reader.design_head_torch import DesignHead
from swifttailor.picture_reader.figures import FIGURES
from swifttailor.picture_reader.labels import (
    BOX,
    MASK_STRIDE,
    PARTS,
    VIEW,
    measure_labels,
    panel_topic,
    statement_labels,
    topics,
)
from swifttailor.picture_reader.lite_trunk_torch import TRUNKS, LiteTrunk
from swifttailor.picture_reader.looks_torch import Looks
from swifttailor.picture_reader.panel_kinds import PANEL_KINDS, kinds_of_panels
from swifttailor.picture_reader.units import MEASURE_CM, VIEW_CM

STRIDE = 16
"""Pixels to a cell of the map that topics look at."""
GRID = 12
"""Cells along each side for which there are learnt places; between them for maps of another size."""


@dataclass(frozen=True)
class EyesConfig:
    """Its size."""

    image_size: int = 192
    """Pixels along each side of a picture."""
    embedding: int = 32
    stages: tuple[int, ...] = (32, 64, 160, 320)
    """Channels of the four stages of a ResNet of basic blocks (He et al. 2016)."""
    depths: tuple[int, ...] = (2, 2, 2, 2)
    width: int = 192
    """Of the map that topics look at."""
    heads: int = 6
    mask_width: int = 24
    trunk: Literal["resnet", "efficientnet-lite0", "efficientnet-lite2"] = "resnet"
    """Of the latter two, embedding, stages and depths are given."""
    design_values: tuple[int, ...] = ()
    """How many values each design parameter may have that is read; none are where it is empty."""


class Reading(NamedTuple):
    """What the network says of B pictures, of both `PARTS`."""

    present: Tensor
    """(B, 2) logits: whether anything is worn there."""
    statements: Tensor
    """(B, 2, S) logits."""
    has: Tensor
    """(B, 2, M) logits: whether the garment has what is measured."""
    measures: Tensor
    """(B, 2, M, 2) `scaled` measure, and the logarithm of how far off it may be."""
    panels: Tensor
    """(B, 2, P) logits."""
    boxes: Tensor
    """(B, 2, P, 5) `BOX` in units of `units.BOX_CM`."""
    view: Tensor
    """(B, 6) `VIEW`."""
    figures: Tensor
    """(B, 3) logits: how many people there are, by `FIGURES`."""
    masks: Tensor
    """(B, 2, h, w) logits: where in the picture the garment is, a cell every `MASK_STRIDE` pixels."""
    places: Tensor
    """(B, 3, h, w) where on the wearer as he stands each cell looks, metres; anything where nobody is."""
    kinds: Tensor
    """(B, K, h, w) logits: of which of `PANEL_KINDS` the panel in each cell is; anything where none is."""
    seams: Tensor
    """(B, 1, h, w) logits: whether two panels of one garment meet in it; anything where none is."""
    designs: Tensor | None = None
    """(B, 2, D, V) logits: which value each design parameter has, lowest where it has fewer."""


_DENSE = (len(PARTS), 3, len(PANEL_KINDS), 1)
"""Channels of masks, places, kinds and seams."""


class EyesNetwork(nn.Module):
    """Says of a picture what is worn, what can be said of it, its panels, and where it is."""

    def __init__(self, config: EyesConfig) -> None:
        """With random weights.

        Args:
            config: Its size.
        """
        super().__init__()
        self.config, self.frozen = config, 0
        channels: tuple[int, ...]
        if config.trunk in TRUNKS:
            lite = LiteTrunk(config.trunk, 3 + 3)
            self.embedder, self.stages, channels, self.spread = lite.embedder, lite.stages, lite.channels, 0.5
        else:
            self.embedder, self.stages = _resnet(config)
            channels, self.spread = config.stages, 0.25
        width = config.width
        self.lateral = nn.ModuleList(nn.Conv2d(c, width, 1) for c in channels[2:])
        self.smooth = nn.Sequential(nn.Conv2d(width, width, 3, padding=1), nn.BatchNorm2d(width), nn.ReLU())
        self.places = nn.Parameter(torch.randn(1, width, GRID, GRID) * 0.02)
        self.mask_lateral = nn.ModuleList(nn.Conv2d(c, config.mask_width, 1) for c in (*channels[:2], width))
        self.mask = nn.Sequential(
            nn.Conv2d(config.mask_width, config.mask_width, 3, padding=1),
            nn.BatchNorm2d(config.mask_width),
            nn.ReLU(),
            nn.Conv2d(config.mask_width, sum(_DENSE), 1),
        )
        self.told = nn.Sequential(nn.Conv2d(_Told.COUNT, width, 1), nn.ReLU(), nn.Conv2d(width, width, 1))
        self.summed = nn.Linear(2 * len(PARTS) * len(PANEL_KINDS), width)
        nn.init.zeros_(self.summed.weight)
        self.looks = Looks(width, config.heads, len(PARTS) * len(topics()))
        self.says = _Answers(width)
        if config.design_values:
            self.design = DesignHead(width, config.heads, config.design_values)

    def freeze(self, stages: int) -> None:
        """What is learnt from now on leaves the beginning as it is, norms over the batch included.

        Args:
            stages: Of the trunk's four, the first; with any, what comes before them, too.
        """
        self.frozen = stages
        for part in self._still():
            part.requires_grad_(False)
        self.train(self.training)

    def train(self, mode: bool = True) -> EyesNetwork:
        """As in torch, but what is frozen is never in training."""
        super().train(mode)
        for part in self._still():
            part.eval()
        return self

    def _still(self) -> list[nn.Module]:
        return [self.embedder, *self.stages[: self.frozen]] if self.frozen else []

    def trunk(self, pictures: Tensor, guess: Tensor) -> tuple[Tensor, Tensor, Tensor]:
        """Maps of pictures (B, 3, H, W), 0 to 1: of the first two stages, and (B, width, H/16, W/16)."""
        x = self.embedder(torch.cat([(pictures - 0.5) / self.spread, places_of(pictures, guess)], 1))
        first = self.stages[0](x)
        second = self.stages[1](first)
        third = self.stages[2](second)
        fourth = self.stages[3](third)
        deep = F.interpolate(self.lateral[1](fourth), scale_factor=2.0, mode="nearest")
        return first, second, self.smooth(self.lateral[0](third) + deep)

    def forward(self, pictures: Tensor, guess: Tensor) -> tuple[Tensor, ...]:
        """Reads pictures: what makes a `Reading`.

        Args:
            pictures: (B, 3, H, W) sRGB from 0 to 1, H and W as configured.
            guess: (B, 7) `labels.GUESS`.
        """
        first, second, third = self.trunk(pictures, guess)
        masks = self.mask_lateral[0](first)
        masks = masks + F.interpolate(self.mask_lateral[1](second), scale_factor=2.0, mode="nearest")
        masks = masks + F.interpolate(self.mask_lateral[2](third), scale_factor=4.0, mode="nearest")
        masks = self.mask(F.relu(masks))
        third = third + self.told(_Told.of(masks, STRIDE // MASK_STRIDE))
        places = self.places
        if third.shape[-2:] != places.shape[-2:]:
            places = F.interpolate(places, third.shape[-2:], mode="bilinear", align_corners=False)
        seen = self.looks((third + places).flatten(2).transpose(1, 2), self.summed(panels_of(masks)))
        answers = self.says(seen)
        said = *answers, *masks.split(_DENSE, 1)
        return (*said, self.design(third + places, seen, answers)) if self.config.design_values else said


def _resnet(config: EyesConfig) -> tuple[nn.Module, nn.ModuleList]:
    """Its stem, to a stride of 4, and its four stages."""
    from transformers import ResNetConfig, ResNetModel

    trunk = ResNetModel(
        ResNetConfig(
            num_channels=3 + 3,
            embedding_size=config.embedding,
            hidden_sizes=list(config.stages),
            depths=list(config.depths),
            layer_type="basic",
        )
    )
    for block in list(trunk.encoder.modules()):
        for name, layer in block.named_children():
            if isinstance(layer, nn.Conv2d) and layer.kernel_size == (1, 1) and layer.stride != (1, 1):
                setattr(block, name, _Skipping(layer))
    return trunk.embedder, trunk.encoder.stages


class _Skipping(nn.Conv2d):
    """A convolution of single pixels that passes over some, as one of fewer pixels.

    The gradient that oneDNN has for it ends the process on some processors (torch 2.15, AMD EPYC, channels
    last).
    """

    def __init__(self, layer: nn.Conv2d) -> None:
        down, across = layer.stride
        has_bias = layer.bias is not None
        super().__init__(layer.in_channels, layer.out_channels, 1, (down, across), bias=has_bias)
        self.load_state_dict(layer.state_dict())

    def forward(self, input: Tensor) -> Tensor:
        down, across = self.stride
        return F.conv2d(input[:, :, ::down, ::across], self.weight, self.bias)


def places_of(pictures: Tensor, guess: Tensor) -> Tensor:
    """Where on the wearer each pixel is: a hem ends at a level, wherever the camera was.

    Args:
        pictures: (B, 3, H, W).
        guess: (B, 7) `labels.GUESS`.

    Returns:
        (B, 3, H, W): level above that of `view`'s middle and distance from the wearer's axis, in metres, and
        whether they are known; zeros where they are not.
    """
    size_down, size_across = pictures.shape[-2:]
    known = guess[:, 6, None, None]
    cm = VIEW_CM * torch.exp(-guess[:, 3, None, None])  # to a side of the picture
    down = (torch.arange(size_down, device=pictures.device) + 0.5) / size_down - 0.5
    across = (torch.arange(size_across, device=pictures.device) + 0.5) / size_across - 0.5
    level = -(down[None, :, None] - guess[:, 5, None, None]) * cm
    aside = (across[None, None, :] - guess[:, 4, None, None]) * cm
    shape = (-1, size_down, size_across)
    found = [level.expand(shape) / 100, aside.expand(shape) / 100, torch.ones_like(pictures[:, 0])]
    return torch.stack([known * one.clamp(-3, 3) for one in found], 1)


class _Told:
    """What the cells under each token were said to show.

    Whose pixels, where on the wearer they are, which kind of panel is there, and whether panels meet.
    """

    WAVES = 2.0, 8.0, 24.0
    COUNT = len(PARTS) + 3 * 2 * len(WAVES) + 3 * len(PARTS) + len(PANEL_KINDS) + 1

    @staticmethod
    def of(masks: Tensor, cells: int) -> Tensor:
        """(B, COUNT, h / cells, w / cells) of masks, places, kinds and seams (B, sum(_DENSE), h, w)."""
        shares, at, kinds, seams = masks.split(_DENSE, 1)
        shares = torch.sigmoid(shares)
        anybody = shares.sum(1, keepdim=True).clamp(max=1.0)
        rows = [shares]
        rows += [anybody * wave(at * k) for k in _Told.WAVES for wave in (torch.sin, torch.cos)]
        rows += [shares[:, k : k + 1] * at for k in range(len(PARTS))]
        rows += [anybody * torch.softmax(kinds, 1), anybody * torch.sigmoid(seams)]
        return F.avg_pool2d(torch.cat(rows, 1), cells)


def panels_of(masks: Tensor) -> Tensor:
    """How much of a picture each kind of panel of each part takes, and how surely it is anywhere.

    Args:
        masks: (B, sum(_DENSE), h, w) logits.

    Returns:
        (B, 2 * 2 * K) from 0 to 1.
    """
    whose, _, kinds, _ = masks.split(_DENSE, 1)
    found = (torch.sigmoid(whose)[:, :, None] * torch.softmax(kinds, 1)[:, None]).flatten(1, 2)
    surest = F.avg_pool2d(found, (1, 3), 1, (0, 1)).amax(dim=(2, 3))
    return torch.cat([found.mean(dim=(2, 3)).sqrt(), surest], 1)


class _Answers(nn.Module):
    """From what each topic has seen to the outputs."""

    def __init__(self, width: int) -> None:
        super().__init__()
        names = topics()
        self.count = len(names)
        of_statement = [names.index(claim) for claim, _ in statement_labels()]
        of_measure = [names.index(name) for name in measure_labels()]
        self.register_buffer("of_statement", torch.tensor(of_statement), persistent=False)
        self.register_buffer("of_measure", torch.tensor(of_measure), persistent=False)
        of_kind = [names.index(panel_topic(kind)) for kind in PANEL_KINDS]
        of_panel = [of_kind[kind] for kind in kinds_of_panels()]
        self.register_buffer("of_panel", torch.tensor(of_panel), persistent=False)
        self.garment_at = names.index("garment")
        self.norm = nn.LayerNorm(width)
        self.statements = _Rows(len(PARTS) * len(of_statement), width, -2.0)
        self.measures = _Rows(len(PARTS) * len(of_measure) * 3, width)
        self.panels = nn.Parameter(torch.randn(len(PANEL_NAMES), width, 1 + len(BOX)) / math.sqrt(width))
        self.panels_bias = nn.Parameter(torch.zeros(len(PANEL_NAMES), 1 + len(BOX)))
        self.present, self.view = nn.Linear(width, 1), nn.Linear(2 * width, len(VIEW))
        self.figures = nn.Linear(2 * width, len(FIGURES))

    def forward(self, seen: Tensor) -> tuple[Tensor, ...]:
        batch, _, width = seen.shape
        parts = len(PARTS)
        x = self.norm(seen).view(batch, parts, self.count, width)
        said = self.statements(x[:, :, self.of_statement].reshape(batch, -1, width)).view(batch, parts, -1)
        at = x[:, :, self.of_measure].reshape(batch, -1, width)
        # How far off a measure may be is learnt of what is seen, and does not change what is looked at.
        at = torch.stack([at, at, at.detach()], 2)
        measured = self.measures(at.reshape(batch, -1, width)).view(batch, parts, -1, 3)
        panels = torch.einsum("bqpw,pwo->bqpo", x[:, :, self.of_panel], self.panels) + self.panels_bias
        garment = x[:, :, self.garment_at]
        return (
            self.present(garment)[..., 0],
            said,
            measured[..., 0],
            measured[..., 1:],
            panels[..., 0],
            panels[..., 1:],
            self.view(garment.flatten(1)),
            self.figures(garment.flatten(1)),
        )


class _Rows(nn.Module):
    """One output of each of n vectors."""

    def __init__(self, count: int, width: int, bias: float = 0.0) -> None:
        super().__init__()
        self.weight = nn.Parameter(torch.randn(count, width) / math.sqrt(width))
        self.bias = nn.Parameter(torch.full((count,), bias))

    def forward(self, x: Tensor) -> Tensor:
        """(B, n) of (B, n, width)."""
        return (x * self.weight).sum(-1) + self.bias


def scaled(measures: Tensor) -> Tensor:
    """Measures as the network predicts them: off by the centimetre where they are small, else by share."""
    return torch.asinh(measures / MEASURE_CM)

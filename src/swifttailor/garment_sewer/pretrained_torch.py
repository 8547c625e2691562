"""Weights of others to begin with: a DPT, or the encoder of a ViT."""

from __future__ import annotations

from typing import TYPE_CHECKING

import torch
import torch.nn.functional as F
from torch import Tensor

from swifttailor.errors import InputError

if TYPE_CHECKING:
    from swifttailor.garment_sewer.network_torch import GarmentSewerNetwork

_PATCHES = "dpt.embeddings.patch_embeddings.projection.weight"
_POSITIONS = "dpt.embeddings.position_embeddings"
_NOT_WANTED = (
    "head.head.4.",
    "auxiliary_head.",
    "pooler.",
    "classifier.",
    "neck.fusion_stage.layers.0.residual",
)
_LAYERS_OF_VIT = {
    "vit.": "dpt.",
    ".attention.q_proj.": ".attention.attention.query.",
    ".attention.k_proj.": ".attention.attention.key.",
    ".attention.v_proj.": ".attention.attention.value.",
    ".attention.o_proj.": ".attention.output.dense.",
    ".mlp.fc1.": ".intermediate.dense.",
    ".mlp.fc2.": ".output.dense.",
}


def load_pretrained(network: GarmentSewerNetwork, source: str) -> list[str]:
    """Puts weights into a network.

    The patch embedding of three colours becomes one of more channels: the first three begin like the colours,
    the others with zero. Position embeddings are resampled. The last layer is not taken: it predicts depth.

    Args:
        network: Changed in place.
        source: Folder or name of a DPT (``Intel/dpt-large``) or a ViT (``google/vit-large-patch16-224``) for
            transformers.

    Returns:
        Names of the weights that were not in the source and stay as they were.

    Raises:
        InputError: There is no such source, or it has another shape.
    """
    given = _read(source)
    own = network.state_dict()
    taken: dict[str, Tensor] = {}
    for name, value in given.items():
        if name not in own or any(part in name for part in _NOT_WANTED):
            continue
        if name == _PATCHES:
            value = _more_channels(value, own[name])
        elif name == _POSITIONS:
            value = _resampled(value, own[name])
        if value.shape != own[name].shape:
            raise InputError(
                f"The pretrained weights '{source}' do not fit: '{name}' has the shape {tuple(value.shape)}, "
                f"this network's {tuple(own[name].shape)}. Choose hidden_size, layers, decoder_sizes and "
                "fusion_size as the source has them, or leave network.pretrained empty."
            )
        taken[name] = value
    if not any(name.startswith("dpt.encoder.") for name in taken):
        raise InputError(f"The pretrained weights '{source}' hold no layer of a DPT or ViT encoder.")
    network.load_state_dict(taken, strict=False)
    return sorted(set(own) - set(taken))


def _read(source: str) -> dict[str, Tensor]:
    from transformers import AutoConfig, DPTForDepthEstimation, ViTModel

    try:
        kind = AutoConfig.from_pretrained(source).model_type
        if kind == "dpt":
            return DPTForDepthEstimation.from_pretrained(source).state_dict()
        if kind == "vit":
            model = ViTModel.from_pretrained(source, add_pooling_layer=False)
            return {_dpt_name(name): value for name, value in model.state_dict().items()}
    except (OSError, ValueError) as error:
        raise InputError(
            f"The pretrained weights '{source}' cannot be loaded: {error} Give the folder of a DPT or ViT."
        ) from error
    raise InputError(f"The pretrained weights '{source}' are of a '{kind}'; a dpt or a vit is accepted.")


def _dpt_name(name: str) -> str:
    name = name if name.startswith("vit.") else "vit." + name
    name = name.replace("vit.layers.", "vit.encoder.layer.").replace(
        "vit.encoder.layers.", "vit.encoder.layer."
    )
    for theirs, ours in _LAYERS_OF_VIT.items():
        name = name.replace(theirs, ours)
    return name


def _more_channels(weight: Tensor, own: Tensor) -> Tensor:
    made = torch.zeros_like(own)
    if weight.shape[2:] != own.shape[2:] or weight.shape[0] != own.shape[0]:
        return weight  # refused with a message that names it
    shared = min(weight.shape[1], own.shape[1])
    made[:, :shared] = weight[:, :shared]
    return made


def _resampled(positions: Tensor, own: Tensor) -> Tensor:
    if positions.shape[-1] != own.shape[-1]:
        return positions
    side, wanted = (round((p.shape[1] - 1) ** 0.5) for p in (positions, own))
    grid = positions[:, 1:].reshape(1, side, side, -1).permute(0, 3, 1, 2)
    grid = F.interpolate(grid, size=(wanted, wanted), mode="bicubic", align_corners=False)
    return torch.cat([positions[:, :1], grid.permute(0, 2, 3, 1).reshape(1, wanted * wanted, -1)], dim=1)

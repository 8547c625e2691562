"""Random weights to begin with. Import this in the function that needs it: it loads torch."""

from __future__ import annotations

from typing import Any

from torch import nn
from transformers import InternVLModel

EMBEDDING = 0.3
"""Deviation of the embeddings of tokens: of the size of what embedded numbers and looks add to them."""
VISION_BRANCH, VISION_POSITION = 0.05, 0.03
"""Size of what a layer of the vision transformer adds, and of its positions, where patches are of size 1: at
first the language model sees the patches themselves. With branches of size 1, 20,000 pictures taught it less
than a convolutional network learns from 6,000."""
_BRANCH_ENDS = ("o_proj", "down_proj", "projection_layer", "fc2")
"""Last matrices of what a layer adds to its input."""


def initialize(vlm: InternVLModel) -> None:
    """Weights through which signals pass (Glorot and Bengio 2010), for a network trained from scratch.

    transformers gives all of them a deviation of 0.02, and what a layer of the vision transformer finds a
    tenth: made to be loaded into, small networks begin with attention to everything alike and with layers
    that add next to nothing. Here what the layers of the language model add together is of the size of their
    input (Radford et al. 2019), and those of the vision transformer begin with less.
    """
    for part in (vlm.language_model, vlm.vision_tower, vlm.multi_modal_projector):
        layers = len(getattr(part, "layers", ())) or len(getattr(getattr(part, "encoder", None), "layer", ()))
        for name, module in part.named_modules():
            if isinstance(module, nn.Linear):
                nn.init.xavier_uniform_(module.weight)
                if layers and name.endswith(_BRANCH_ENDS):
                    module.weight.data /= (2 * layers) ** 0.5
            elif isinstance(module, nn.Conv2d):
                nn.init.normal_(module.weight, std=module.weight[0].numel() ** -0.5)
        for name, weight in part.named_parameters():
            if name.endswith(("lambda_1", "lambda_2")):
                nn.init.constant_(weight, VISION_BRANCH)
            elif name.endswith(("position_embeddings", "cls_token")):
                nn.init.normal_(weight, std=VISION_POSITION)
    embeddings: Any = vlm.get_input_embeddings()
    nn.init.normal_(embeddings.weight, std=EMBEDDING)

"""The shape of the network; no torch is needed to read or write it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from swifttailor.errors import InputError


@dataclass(frozen=True)
class NetworkConfig:
    """An InternVL: a vision transformer whose patches become tokens of a language model (Qwen2).

    The defaults are the small model, trained from scratch. With `pretrained`, the sizes up to `patch_size`
    and the tokens of text are those of that model.
    """

    hidden_size: int = 256
    layers: int = 6
    heads: int = 4
    key_value_heads: int = 2
    intermediate_size: int = 640
    vision_hidden_size: int = 192
    vision_layers: int = 6
    vision_heads: int = 3
    image_size: int = 128
    """Pixels along each side of a picture."""
    patch_size: int = 16
    """Four patches become one token."""
    early_convolutions: bool = True
    """Whether pictures become patches by several convolutions, or by one matrix as in InternVL."""
    longest_text: int = 192
    """Tokens of a text that are read; what is beyond is left out."""
    command_seen: bool = True
    """Whether the numbers of a token are predicted knowing which token it is. AIpparel predicts them from the
    state before it alone."""
    copying: bool = True
    """Whether the network is told what the pattern to edit, or the panel on the body's other side, has at the
    place that it writes, and may take that as it is (`counterpart`). AIpparel's writes it anew."""
    planning: bool = True
    """Whether it is told what it has foreseen, where there is nothing to repeat (`plan`)."""
    edits: Literal["whole", "outlines"] = "whole"
    """What a prompt tells of the pattern to edit: all of it, as AIpparel's, or the outlines of its panels
    (`prompt.outlines_of`); of outlines the network foresees what becomes different."""
    names: Literal["tokens", "text"] = "tokens"
    """Whether each of GarmentCode's names of panels is a token of its own, or is written in tokens of text,
    as in AIpparel (`name_text`)."""
    pretrained: str = ""
    """Folder or name of an InternVL for transformers to begin with; empty to begin with random weights."""
    lora_rank: int = 0
    """Rank of the changes to a pretrained language model (LoRA, Hu et al. 2022); 0 trains all of it."""
    vision_trained: bool = True
    """Whether the vision transformer and what joins it to the language model are trained."""

    def __post_init__(self) -> None:
        sizes = ("hidden_size", "layers", "heads", "key_value_heads", "intermediate_size", "longest_text")
        for name in (
            *sizes,
            "vision_hidden_size",
            "vision_layers",
            "vision_heads",
            "image_size",
            "patch_size",
        ):
            value = getattr(self, name)
            if not isinstance(value, int) or isinstance(value, bool) or value < 1:
                raise InputError(f"network.{name} is {value!r}; a whole number of at least 1 is accepted.")
        for size, heads in (("hidden_size", "heads"), ("vision_hidden_size", "vision_heads")):
            if getattr(self, size) % getattr(self, heads):
                raise InputError(
                    f"network.{size} is {getattr(self, size)}; a multiple of {heads} "
                    f"{getattr(self, heads)} is accepted."
                )
        if (self.hidden_size // self.heads) % 2 or self.heads % self.key_value_heads:
            raise InputError(
                f"network.heads is {self.heads} and key_value_heads {self.key_value_heads} for hidden_size "
                f"{self.hidden_size}; an even size for each head, and a divisor of heads, are accepted."
            )
        if self.image_size % (2 * self.patch_size):
            raise InputError(
                f"network.image_size is {self.image_size}; a multiple of {2 * self.patch_size}, twice the "
                "patch_size, is accepted."
            )
        if self.early_convolutions and (self.patch_size < 8 or self.patch_size & (self.patch_size - 1)):
            raise InputError(
                f"network.patch_size is {self.patch_size}; 8, 16, 32 are accepted with "
                "network.early_convolutions."
            )
        if self.early_convolutions and self.pretrained:
            raise InputError(
                "network.early_convolutions is true, and what is pretrained has none; set it to false."
            )
        if self.edits not in ("whole", "outlines"):
            raise InputError(f"network.edits is {self.edits!r}; whole or outlines is accepted.")
        if self.names not in ("tokens", "text"):
            raise InputError(f"network.names is {self.names!r}; tokens or text is accepted.")
        if self.names == "text" and self.copying:
            raise InputError(
                "network.names is text, and network.copying true: what is likely to be repeated is told in "
                "tokens of names. Set network.copying and network.planning to false."
            )
        if self.planning and not self.copying:
            raise InputError("network.planning is true without network.copying; set both or neither.")
        if self.lora_rank < 0 or (self.lora_rank and not self.pretrained):
            raise InputError(
                f"network.lora_rank is {self.lora_rank}; 0 is accepted, or more with network.pretrained."
            )

    @property
    def image_tokens(self) -> int:
        """Tokens that a picture takes."""
        return (self.image_size // self.patch_size // 2) ** 2


PAPER_NETWORK = NetworkConfig(
    image_size=448,
    patch_size=14,
    early_convolutions=False,
    longest_text=512,
    command_seen=False,
    copying=False,
    planning=False,
    names="text",
    pretrained="OpenGVLab/InternVL3-2B-hf",
)
"""The paper's: InternVL3-2B with AIpparel's tokens and heads."""

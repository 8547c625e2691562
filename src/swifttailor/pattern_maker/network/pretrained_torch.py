"""An InternVL of others to begin with, and its text tokens."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import torch
from transformers import AutoTokenizer, InternVLForConditionalGeneration, InternVLModel

from swifttailor.errors import InputError
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.pattern_maker.network.lora_torch import add_lora
from swifttailor.pattern_maker.network.network_config import NetworkConfig
from swifttailor.pattern_maker.tokens.name_text import NameText

TextTokens = Callable[[str], tuple[int, ...]]


def load_pretrained(config: NetworkConfig, text_size: int) -> InternVLModel:
    """The model of `config.pretrained`, in float32, trained whole or by LoRA.

    Args:
        config: Of the network.
        text_size: Tokens of text.

    Raises:
        InputError: There is no such model, or it has another shape.
    """
    source = config.pretrained
    try:
        whole = InternVLForConditionalGeneration.from_pretrained(source, dtype=torch.float32)
    except (OSError, ValueError) as error:
        raise InputError(
            f"The pretrained model '{source}' cannot be loaded: {error} Give the folder of an InternVL in "
            "transformers' format, or its name, such as OpenGVLab/InternVL3-2B-hf."
        ) from error
    vlm: Any = whole.model
    vision = vlm.config.vision_config
    sizes = (vision.image_size[0], vision.patch_size[0])
    if sizes != (config.image_size, config.patch_size):
        raise InputError(
            f"network.image_size and patch_size are {config.image_size} and {config.patch_size}; those of "
            f"'{source}' are {sizes[0]} and {sizes[1]}. Set them so."
        )
    known = vlm.get_input_embeddings().weight.shape[0]
    if text_size > known:
        raise InputError(
            f"The tokenizer of '{source}' has {text_size} tokens, its model knows {known}. Copy it again."
        )
    language: Any = vlm.language_model
    # The older name goes in transformers 6, the newer one is not in all of 5.
    getattr(language, "activation_checkpointing_enable", language.gradient_checkpointing_enable)()
    if config.lora_rank:
        vlm.language_model.requires_grad_(False)
        add_lora(vlm.language_model, config.lora_rank)
    return vlm


def load_text_tokens(config: NetworkConfig) -> tuple[int, TextTokens]:
    """How many text tokens the model of `config.pretrained` has, and what gives those of a text.

    Raises:
        InputError: There is no such tokenizer.
    """
    tokenizer = _load_tokenizer(config)

    def encode(text: str) -> tuple[int, ...]:
        given = tokenizer(text, add_special_tokens=False, truncation=True, max_length=config.longest_text)
        return tuple(given["input_ids"])

    return len(tokenizer), encode


def load_name_text(config: NetworkConfig) -> NameText:
    """The names of panels in the text tokens of the model of `config.pretrained`.

    Raises:
        InputError: There is no such tokenizer, or names do not come back from it as they were.
    """
    tokenizer = _load_tokenizer(config)
    spelled = tuple(tuple(tokenizer(name, add_special_tokens=False)["input_ids"]) for name in PANEL_NAMES)
    return NameText(spelled, lambda tokens: tokenizer.decode(list(tokens)))


def _load_tokenizer(config: NetworkConfig) -> Any:
    try:
        return AutoTokenizer.from_pretrained(config.pretrained)
    except (OSError, ValueError) as error:
        raise InputError(
            f"The tokenizer of '{config.pretrained}' cannot be loaded: {error} Give the model's whole folder."
        ) from error

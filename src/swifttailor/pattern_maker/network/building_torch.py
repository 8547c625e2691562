"""Makes networks of their configuration. Import this in the function that needs it: it loads torch."""

from __future__ import annotations

from typing import Any

from torch import nn
from transformers import InternVLConfig, InternVLModel, InternVLVisionConfig, Qwen2Config

from swifttailor.networks.text_tokenizer import TextTokenizer
from swifttailor.pattern_maker.network.initial_weights_torch import EMBEDDING, initialize
from swifttailor.pattern_maker.network.network_config import NetworkConfig
from swifttailor.pattern_maker.network.network_torch import PatternMakerNetwork
from swifttailor.pattern_maker.network.stem_torch import ConvolutionalStem
from swifttailor.pattern_maker.tokens.name_text import NameText

POSITIONS = 4096
"""Longest sequence of the small model."""


def build_network(config: NetworkConfig, text_size: int) -> PatternMakerNetwork:
    """Makes a network, from random weights or from `config.pretrained`.

    Args:
        config: Its shape.
        text_size: Tokens of text.

    Raises:
        InputError: The pretrained weights cannot be had or do not fit.
    """
    if config.pretrained:
        from swifttailor.pattern_maker.network.pretrained_torch import load_pretrained

        vlm = load_pretrained(config, text_size)
        text: Any = vlm.config.text_config
        embedding_std = text.initializer_range
    else:
        vlm = InternVLModel(vlm_config(config, text_size))
        if config.early_convolutions:
            patches: Any = vlm.vision_tower.embeddings.patch_embeddings
            patches.projection = ConvolutionalStem(config.vision_hidden_size, config.patch_size)
        use_fused_norms(vlm)
        initialize(vlm)
        embedding_std = EMBEDDING
    network = PatternMakerNetwork(
        vlm,
        text_size,
        command_seen=config.command_seen,
        copying=config.copying,
        planning=config.planning,
        names=name_text(config),
        embedding_std=embedding_std,
    )
    if not config.vision_trained:
        for part in (vlm.vision_tower, vlm.multi_modal_projector):
            part.requires_grad_(False)
    return network


def name_text(config: NetworkConfig) -> NameText | None:
    """The names of panels in the text tokens of a network; None where they are tokens of their own.

    Raises:
        InputError: The pretrained tokenizer cannot be had.
    """
    if config.names == "tokens":
        return None
    if config.pretrained:
        from swifttailor.pattern_maker.network.pretrained_torch import load_name_text

        return load_name_text(config)
    return NameText.of(TextTokenizer.shipped())


def vlm_config(config: NetworkConfig, text_size: int) -> InternVLConfig:
    """The same shape in transformers' words."""
    text = Qwen2Config(
        vocab_size=text_size,
        hidden_size=config.hidden_size,
        num_hidden_layers=config.layers,
        num_attention_heads=config.heads,
        num_key_value_heads=config.key_value_heads,
        intermediate_size=config.intermediate_size,
        max_position_embeddings=POSITIONS,
        bos_token_id=None,
        eos_token_id=None,
        pad_token_id=None,
    )
    vision = InternVLVisionConfig(
        hidden_size=config.vision_hidden_size,
        num_hidden_layers=config.vision_layers,
        num_attention_heads=config.vision_heads,
        intermediate_size=4 * config.vision_hidden_size,
        image_size=config.image_size,
        patch_size=config.patch_size,
        attention_bias=True,
    )
    return InternVLConfig(
        text_config=text,
        vision_config=vision,
        image_token_id=0,  # not looked at: pictures are put in place by `PatternMakerNetwork.embed`
        image_seq_length=config.image_tokens,
    )


def use_fused_norms(module: nn.Module) -> None:
    """Replaces transformers' RMSNorm by torch's, which does the same in one kernel."""
    children: Any = module.named_children()
    for name, child in children:
        if type(child).__name__ == "Qwen2RMSNorm":
            fused: Any = nn.RMSNorm(child.weight.shape[0], eps=child.variance_epsilon)
            fused.weight = child.weight
            setattr(module, name, fused)
        else:
            use_fused_norms(child)

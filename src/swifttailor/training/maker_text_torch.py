"""The text tokens of a network: the package's own, or those of the pretrained model it begins with."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from swifttailor.networks.text_tokenizer import TextTokenizer
from swifttailor.pattern_maker.network.building_torch import name_text
from swifttailor.pattern_maker.network.network_config import NetworkConfig
from swifttailor.pattern_maker.tokens.name_text import NameText


@dataclass(frozen=True)
class Text:
    """How a text becomes tokens."""

    size: int
    """Tokens that there are."""
    encode: Callable[[str], tuple[int, ...]]
    """Those of a text, cut to what the network reads."""
    names: NameText | None
    """The names of panels in them, where the network writes these as text."""


def open_text(config: NetworkConfig) -> Text:
    """The text tokens that belong to a network.

    Raises:
        InputError: The pretrained tokenizer cannot be had.
    """
    if config.pretrained:
        from swifttailor.pattern_maker.network.pretrained_torch import load_text_tokens

        return Text(*load_text_tokens(config), name_text(config))
    tokenizer, limit = TextTokenizer.shipped(), config.longest_text

    def encode(text: str) -> tuple[int, ...]:
        return tokenizer.encode(text, limit).tokens

    return Text(tokenizer.size, encode, name_text(config))

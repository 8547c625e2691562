"""A text as the network reads it: tokens, with one of its own for each number."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from swifttailor.networks.text_tokenizer import EncodedText
from swifttailor.wishes.text.mentions import Mention, find_mentions

LONGEST = 192
"""Tokens of a text that are read."""
LONGEST_TEXT = 20_000
DESCRIPTION, INSTRUCTION, LENGTH, COUNT, PADDING = range(5)
"""Tokens behind those of the text: what kind of text it is, numbers with a unit and without, and nothing."""
EXTRA_TOKENS = 5


class Tokenizer(Protocol):
    """What makes tokens of words."""

    @property
    def size(self) -> int:
        """Number of tokens."""
        ...

    def encode(self, text: str, limit: int) -> EncodedText:
        """At most `limit` tokens, of the beginning of a text."""
        ...


@dataclass(frozen=True, eq=False)
class ReadyText:
    """A text to be read."""

    tokens: NDArray[np.int64]
    """(n,), the first says whether it is an instruction."""
    mentions: tuple[Mention, ...]
    places: tuple[int, ...]
    """Where the mentions stand among the tokens."""


def text_tokens(text: str, tokenizer: Tokenizer, *, instruction: bool) -> ReadyText:
    """Prepares a text to be read.

    Args:
        text: Of any length; its beginning is read.
        tokenizer: Of the words.
        instruction: Whether it says how to change a garment, and not what garment it is.
    """
    first = tokenizer.size
    tokens = [first + (INSTRUCTION if instruction else DESCRIPTION)]
    mentions, places, last = [], [], 0

    def read(part: str) -> None:
        tokens.extend(tokenizer.encode(part, LONGEST).tokens)

    text = text[:LONGEST_TEXT]
    for mention in find_mentions(text):
        read(text[last : mention.start])
        last = mention.end
        if len(tokens) >= LONGEST:
            break
        mentions.append(mention)
        places.append(len(tokens))
        tokens.append(first + (LENGTH if mention.is_length else COUNT))
    read(text[last:])
    return ReadyText(np.array(tokens[:LONGEST], np.int64), tuple(mentions), tuple(places))

"""What the network is asked, as one sequence: picture, text, pattern to edit, all optional, then the answer.

::

    prompt := [<image> ...] [text] [<edit> pattern] <make>
    answer := pattern

One vocabulary numbers them all: the tokens of text first, then those of patterns (`vocabulary.TOKENS`), then
the four marks below. How many ``<image>`` there are, the network's shape says.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swifttailor.pattern_maker.token_sequence import TokenSequence
from swifttailor.pattern_maker.vocabulary import NUMBERS, SIZE

IMAGE, EDIT, MAKE, PAD = SIZE, SIZE + 1, SIZE + 2, SIZE + 3
"""Marks, counted like tokens of patterns."""
OWN_TOKENS = SIZE + 4
"""Tokens beyond those of text."""


@dataclass(frozen=True, eq=False)
class Sequence:
    """Tokens of the whole vocabulary, and the numbers that go with them."""

    tokens: NDArray[np.int64]
    """(n,) ids: of text below `text_size`, of patterns and marks from there."""
    numbers: NDArray[np.float32]
    """(n, 8) normalised, as in `TokenSequence`."""

    def __len__(self) -> int:
        return len(self.tokens)

    def __add__(self, other: Sequence) -> Sequence:
        return Sequence(
            np.concatenate([self.tokens, other.tokens]), np.concatenate([self.numbers, other.numbers])
        )


def pattern_part(sequence: TokenSequence, text_size: int) -> Sequence:
    """A pattern in the whole vocabulary."""
    return Sequence(sequence.tokens.astype(np.int64) + text_size, np.asarray(sequence.numbers))


def make_prompt(
    text: tuple[int, ...], text_size: int, *, image_tokens: int = 0, edit: TokenSequence | None = None
) -> Sequence:
    """The prompt, up to where the answer begins.

    Args:
        text: Tokens of the text; may be empty.
        text_size: Tokens of text that there are.
        image_tokens: Places for the picture; 0 without one.
        edit: Pattern to edit.
    """
    prompt = _plain([*[IMAGE + text_size] * image_tokens, *text])
    if edit is not None:
        prompt = prompt + _plain([EDIT + text_size]) + pattern_part(edit, text_size)
    return prompt + _plain([MAKE + text_size])


def _plain(tokens: list[int]) -> Sequence:
    return Sequence(np.array(tokens, np.int64), np.zeros((len(tokens), NUMBERS), np.float32))

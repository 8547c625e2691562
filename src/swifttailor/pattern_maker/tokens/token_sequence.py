"""A pattern as the network reads and writes it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swifttailor.errors import InputError
from swifttailor.pattern_maker.tokens.vocabulary import NUMBERS, SIZE, number_slots

LARGEST_NUMBER = 1000.0
"""About 300 m. The largest of the training split is 69."""


@dataclass(frozen=True, eq=False)
class TokenSequence:
    """Tokens and the numbers that go with them."""

    tokens: NDArray[np.int32]
    """(n,) ids of `vocabulary.TOKENS`."""
    numbers: NDArray[np.float32]
    """(n, 8) normalised; row k belongs to token k, and is 0 where that token has no number."""

    def __post_init__(self) -> None:
        tokens, numbers = np.array(self.tokens, np.int32), np.array(self.numbers, np.float32)
        if tokens.ndim != 1 or numbers.shape != (len(tokens), NUMBERS):
            raise InputError(
                f"A sequence has n tokens and (n, {NUMBERS}) numbers; got {tokens.shape} and {numbers.shape}."
            )
        if len(tokens) and not (0 <= tokens.min() and tokens.max() < SIZE):
            raise InputError(f"Tokens are from 0 to {SIZE - 1}; got {tokens.min()} to {tokens.max()}.")
        if not (np.abs(numbers) <= LARGEST_NUMBER).all():
            raise InputError(
                f"The numbers of a sequence are from {-LARGEST_NUMBER:g} to {LARGEST_NUMBER:g}; "
                f"got {numbers[~(np.abs(numbers) <= LARGEST_NUMBER)][0]}."
            )
        tokens.flags.writeable = numbers.flags.writeable = False
        object.__setattr__(self, "tokens", tokens)
        object.__setattr__(self, "numbers", numbers)

    def __len__(self) -> int:
        return len(self.tokens)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, TokenSequence):
            return NotImplemented
        return np.array_equal(self.tokens, other.tokens) and np.array_equal(self.numbers, other.numbers)

    def __hash__(self) -> int:
        return hash((self.tokens.tobytes(), (self.numbers + 0.0).tobytes()))  # -0.0 equals 0.0

    def number_mask(self) -> NDArray[np.bool_]:
        """(n, 8) which numbers mean something."""
        return NUMBER_MASK[self.tokens]


def _number_mask() -> NDArray[np.bool_]:
    mask = np.zeros((SIZE, NUMBERS), bool)
    for token in range(SIZE):
        for slot in number_slots(token):
            mask[token, slot] = True
    mask.flags.writeable = False
    return mask


NUMBER_MASK = _number_mask()
"""(tokens, 8) which numbers each token has."""


def padded_mask(count: int) -> NDArray[np.bool_]:
    """(count, 8) the same for so many outputs: those after the tokens of patterns have no numbers."""
    return np.concatenate([NUMBER_MASK, np.zeros((count - SIZE, NUMBERS), bool)])

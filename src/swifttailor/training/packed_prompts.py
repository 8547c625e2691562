"""Several prompts in one row of a batch: short ones take no more room than they need."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Longs, Singles
from swifttailor.pattern_maker.tokens.vocabulary import NUMBERS

ROW = 128
"""Tokens of a row; of the longest prompt, where that is more. Attention costs the square of it."""


@dataclass(frozen=True, eq=False)
class PackedPrompts:
    """Prompts one after the other in rows, in order."""

    tokens: Longs
    """(rows, length) ids; rows end with padding."""
    numbers: Singles
    """(rows, length, 8) that go with them."""
    positions: Longs
    """(rows, length) of each token in its prompt: they begin anew with each, and with each token of padding,
    by which transformers tells the sequences of a row apart."""
    ends: Longs
    """(prompts,) places of their last tokens in the flattened rows."""


def pack_prompts(prompts: Sequence[Longs], numbers: Sequence[Singles], pad: int) -> PackedPrompts:
    """Fills row after row.

    Args:
        prompts: (n,) ids of each.
        numbers: (n, 8) that go with them.
        pad: Id to fill up with.
    """
    length = max([ROW, *(len(p) for p in prompts)])
    places, row, used = [], 0, 0
    for prompt in prompts:
        if used + len(prompt) > length:
            row, used = row + 1, 0
        places.append(row * length + used)
        used += len(prompt)
    rows = row + 1 if prompts else 0
    tokens, positions = np.full(rows * length, pad, np.int64), np.zeros(rows * length, np.int64)
    packed = np.zeros((rows * length, NUMBERS), np.float32)
    for place, prompt, own in zip(places, prompts, numbers, strict=True):
        packed[place : place + len(prompt)] = own
        tokens[place : place + len(prompt)] = prompt
        positions[place : place + len(prompt)] = np.arange(len(prompt))
    ends = np.array([place + len(p) - 1 for place, p in zip(places, prompts, strict=True)], np.int64)
    shape = rows, length
    return PackedPrompts(
        tokens.reshape(shape), packed.reshape(*shape, NUMBERS), positions.reshape(shape), ends
    )

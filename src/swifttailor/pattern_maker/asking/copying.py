"""Repeating: what the network's leanings towards a counterpart mean."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from swifttailor.pattern_maker.tokens.token_sequence import NUMBER_MASK
from swifttailor.pattern_maker.tokens.vocabulary import MOVE, NUMBERS

LEANINGS = 2 + NUMBERS
"""What the network says of a counterpart: what its logit gains, the logit of taking its numbers, and what is
to be added to these."""
UNCHANGED = 0.02
"""Normalised units (0.5 cm): numbers nearer than this to the counterpart's are the counterpart's. What is not
asked to change stays exactly as it is."""
_CARRIES: NDArray[np.bool_] = np.any(NUMBER_MASK, axis=1)


def mix(
    written: NDArray[np.floating],
    copied: NDArray[np.floating],
    leanings: NDArray[np.floating],
    tokens: NDArray[np.integer],
    others: NDArray[np.integer],
) -> NDArray[np.floating]:
    """Numbers of tokens that have counterparts, or would.

    Args:
        written: (n, 8) what the network would write.
        copied: (n, 8) numbers of the counterparts.
        leanings: (n, `LEANINGS`).
        tokens: (n,) of patterns.
        others: (n,) their counterparts, negative for none.

    Returns:
        (n, 8), `written` where the counterpart is another kind of token.
    """
    same = np.all(NUMBER_MASK[tokens] == NUMBER_MASK[others], axis=1)
    same &= (others >= 0) & _CARRIES[tokens] & ((tokens == MOVE) == (others == MOVE))
    share = 1 / (1 + np.exp(-leanings[:, 1:2]))
    mixed = written + share * (copied + leanings[:, 2:] - written)
    near = (np.abs(mixed - copied) * NUMBER_MASK[tokens]).max(axis=1) < UNCHANGED
    mixed = np.where(near[:, None], copied, mixed * NUMBER_MASK[tokens])
    return np.where(same[:, None], mixed, written)

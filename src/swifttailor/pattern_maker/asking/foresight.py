"""What a network should know of a pattern before it begins to write it: the targets of the loss of foresight.

Which tokens there will be, and of every panel that will be there, where it stands and how large it is. All of
it can be read off the answer itself.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swifttailor.pattern_maker.tokens.normalization import POINT_SCALE, POINT_SHIFT
from swifttailor.pattern_maker.tokens.token_sequence import TokenSequence
from swifttailor.pattern_maker.tokens.vocabulary import (
    CLOSING_COMMANDS,
    COMMANDS,
    CURVES,
    END,
    MOVE,
    PANEL_TOKENS,
    QUATERNION,
    SIZE,
    TRANSLATION,
)

CORNERS = 8
"""So many corners of each panel, from its first edge's end on."""
PLACEMENT = slice(0, QUATERNION.stop)
BOX = slice(PLACEMENT.stop, PLACEMENT.stop + 4)
"""Least and largest coordinates of the corners."""
EDGES = slice(BOX.stop, BOX.stop + len(CURVES))
"""How many edges of each kind, over `MANY`."""
OUTLINE = slice(EDGES.stop, EDGES.stop + 2 * CORNERS)
PANEL_NUMBERS = OUTLINE.stop
FORESEEN = SIZE + len(PANEL_TOKENS) * PANEL_NUMBERS
"""All that is foreseen, as one row: a logit for each token, and the numbers of each panel."""
MANY = 8.0
"""Edges of a kind that count as one unit."""
_LARGEST = 8.0
"""In normalised units, about 2 m: the few flounces beyond would outweigh everything else."""


@dataclass(frozen=True, eq=False)
class Foresight:
    """What is to be foreseen of one pattern."""

    present: NDArray[np.float32]
    """(tokens of patterns,) 1 for those that it has."""
    numbers: NDArray[np.float32]
    """(75 panels, `PANEL_NUMBERS`) normalised as in `TokenSequence`."""
    known: NDArray[np.bool_]
    """The same shape: which of them mean something; none of a panel that the pattern lacks."""


def foresight_of(sequence: TokenSequence, old: TokenSequence | None = None) -> Foresight:
    """Reads the targets off a pattern's tokens and numbers.

    Args:
        sequence: The pattern.
        old: What it is an edited version of. The numbers of panels that were there are then those by which
            they change, so that a network need not say again what it was told.
    """
    tokens = sequence.tokens
    numbers = np.zeros((len(PANEL_TOKENS), PANEL_NUMBERS), np.float32)
    known = np.zeros(numbers.shape, bool)
    starts = np.flatnonzero((tokens >= PANEL_TOKENS.start) & (tokens < PANEL_TOKENS.stop))
    for start, end in zip(starts, [*starts[1:], len(tokens)], strict=True):
        panel = tokens[start] - PANEL_TOKENS.start
        _fill(tokens[start:end], sequence.numbers[start:end], numbers[panel], known[panel])
    numbers = np.clip(numbers, -_LARGEST, _LARGEST)
    if old is not None:
        before = foresight_of(old)
        numbers = np.where(known & before.known, numbers - before.numbers, numbers)
    present = (np.bincount(tokens, minlength=SIZE) > 0).astype(np.float32)
    return Foresight(present, numbers, known)


def _fill(
    tokens: NDArray[np.int32],
    rows: NDArray[np.float32],
    numbers: NDArray[np.float32],
    known: NDArray[np.bool_],
) -> None:
    """Writes the numbers of one panel."""
    placements = rows[tokens == MOVE]
    if len(placements):
        numbers[PLACEMENT] = placements[0, TRANSLATION.start : QUATERNION.stop]
        known[PLACEMENT] = True
    ends = rows[(tokens >= COMMANDS.start) & (tokens < COMMANDS.stop), END]
    first = (-np.asarray(POINT_SHIFT) / POINT_SCALE).astype(np.float32)
    corners = np.concatenate([first[None], ends])
    numbers[BOX] = np.concatenate([corners.min(axis=0), corners.max(axis=0)])
    kinds = tokens[(tokens >= COMMANDS.start) & (tokens < CLOSING_COMMANDS.stop)] - COMMANDS.start
    numbers[EDGES] = np.bincount(kinds % len(CURVES), minlength=len(CURVES)) / MANY
    known[BOX] = known[EDGES] = True
    some = ends[:CORNERS].ravel()
    numbers[OUTLINE][: len(some)] = some
    known[OUTLINE][: len(some)] = True

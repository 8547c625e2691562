"""What the network is asked, as one sequence: picture, text, pattern to edit, all optional, then the answer.

::

    prompt := [<image> ...] [text] [<edit> outlines] <make>
    answer := pattern
    outlines := (panel | <panel:NAME>)+, without stitches and labels

One vocabulary numbers them all: the tokens of text first, then those of patterns (`vocabulary.TOKENS`), then
the four marks below, and those around panels where names are text (`name_text`). How many ``<image>`` there
are, the network's shape says.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swifttailor.pattern.names import TWINS
from swifttailor.pattern_maker.tokens.name_text import FIRST_PIECE, PROMPT_MARKS, NameText
from swifttailor.pattern_maker.tokens.panel_tokens import SAME, are_alike, mirrored, panels_of
from swifttailor.pattern_maker.tokens.token_sequence import TokenSequence
from swifttailor.pattern_maker.tokens.vocabulary import (
    CLOSING_COMMANDS,
    COMMANDS,
    MOVE,
    NUMBERS,
    PANEL_TOKENS,
    SIZE,
)

IMAGE, EDIT, MAKE, PAD = SIZE, SIZE + 1, SIZE + 2, SIZE + 3
"""Marks, counted like tokens of patterns."""
OWN_TOKENS = SIZE + PROMPT_MARKS
"""Tokens beyond those of text."""
OWN_TOKENS_WITH_NAME_TEXT = FIRST_PIECE
"""The same where names are written as text."""


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


def pattern_part(sequence: TokenSequence, text_size: int, names: NameText | None = None) -> Sequence:
    """A pattern in the whole vocabulary; with `names`, its names as text."""
    if names is not None:
        spelled = names.spell(sequence)
        return Sequence(names.whole(text_size)[spelled.outputs], spelled.numbers)
    return Sequence(sequence.tokens.astype(np.int64) + text_size, np.asarray(sequence.numbers))


def make_prompt(
    text: tuple[int, ...],
    text_size: int,
    *,
    image_tokens: int = 0,
    edit: TokenSequence | None = None,
    brief: bool = False,
    names: NameText | None = None,
) -> Sequence:
    """The prompt, up to where the answer begins.

    Args:
        text: Tokens of the text; may be empty.
        text_size: Tokens of text that there are.
        image_tokens: Places for the picture; 0 without one.
        edit: Pattern to edit.
        brief: Whether only the outlines of that are told, which takes a third of the tokens.
        names: Of a network that writes names as text.
    """
    prompt = _plain([*[IMAGE + text_size] * image_tokens, *text])
    if edit is not None:
        told = outlines_of(edit) if brief else edit
        prompt = prompt + _plain([EDIT + text_size]) + pattern_part(told, text_size, names)
    return prompt + _plain([MAKE + text_size])


def outlines_of(sequence: TokenSequence) -> TokenSequence:
    """The panels of a pattern without stitches and labels; of one that mirrors another only the name.

    What an instruction is about is said by these; what else is there to be kept is told while the answer is
    written (`counterpart`).
    """
    panels = panels_of(sequence)
    tokens, numbers = [], []
    for name, panel in sorted(panels.items()):
        tokens.append(PANEL_TOKENS[name])
        numbers.append(np.zeros(NUMBERS, np.float32))
        twin = panels.get(TWINS.get(name, -1))
        if twin is not None and are_alike(mirrored(twin, name), panel, SAME):
            continue
        *edges, last = panel.edges
        tokens += [MOVE, *(COMMANDS[edge.kind] for edge in edges), CLOSING_COMMANDS[last.kind]]
        numbers += [panel.placement, *(edge.numbers for edge in panel.edges)]
    return TokenSequence(np.array(tokens, np.int32), np.array(numbers, np.float32).reshape(-1, NUMBERS))


def _plain(tokens: list[int]) -> Sequence:
    return Sequence(np.array(tokens, np.int64), np.zeros((len(tokens), NUMBERS), np.float32))

"""Panel names as text, as AIpparel writes them: marks around a panel, and its name in tokens of text.

::

    panel := <panel_start> NAME-TEXT [<covers:LABEL>] <move> edge* closing-edge <panel_end>

Everything else is as in `vocabulary`. A network that writes names this way chooses among outputs: the tokens
of patterns and the marks by their own numbers, then those tokens of text that names are made of.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from swifttailor.errors import InputError
from swifttailor.networks.text_tokenizer import TextTokenizer
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.pattern_maker.tokens.token_sequence import TokenSequence
from swifttailor.pattern_maker.tokens.vocabulary import NUMBERS, PANEL_TOKENS, PATTERN_END, SIZE

PROMPT_MARKS = 4
"""Marks of prompts (`prompt`), counted after the tokens of patterns."""
PANEL_START, PANEL_END = SIZE + PROMPT_MARKS, SIZE + PROMPT_MARKS + 1
"""Marks around a panel, counted like tokens of patterns."""
FIRST_PIECE = PANEL_END + 1
"""The outputs from here on are tokens of text."""
_LONGEST_NAME = 64


@dataclass(frozen=True, eq=False)
class SpelledPattern:
    """A pattern with its names as text."""

    outputs: NDArray[np.int64]
    """(n,)"""
    numbers: NDArray[np.float32]
    """(n, 8) as in `TokenSequence`."""

    def __len__(self) -> int:
        return len(self.outputs)


@dataclass(frozen=True, eq=False)
class NameText:
    """The names of panels in the text tokens of a network."""

    spelled: tuple[tuple[int, ...], ...]
    """Of text, for each of `PANEL_NAMES`."""
    read: Callable[[Sequence[int]], str]
    """The text of tokens."""

    def __post_init__(self) -> None:
        for name, tokens in zip(PANEL_NAMES, self.spelled, strict=True):
            if not tokens or self.read(tokens) != name:
                raise InputError(
                    f"The text tokenizer makes {self.read(tokens)!r} of the panel name '{name}'; names must "
                    "come back as they were. Choose another tokenizer, or network.names=tokens."
                )

    @staticmethod
    def of(tokenizer: TextTokenizer) -> NameText:
        """The names in the package's kind of text tokens."""
        spelled = tuple(tokenizer.encode(name, _LONGEST_NAME).tokens for name in PANEL_NAMES)
        return NameText(spelled, tokenizer.decode)

    @cached_property
    def pieces(self) -> tuple[int, ...]:
        """The text tokens that names are made of, ascending; piece k is output `FIRST_PIECE` + k."""
        return tuple(sorted({token for tokens in self.spelled for token in tokens}))

    @property
    def outputs(self) -> int:
        """How many different ones there are."""
        return FIRST_PIECE + len(self.pieces)

    @cached_property
    def names(self) -> tuple[tuple[int, ...], ...]:
        """Outputs of each of `PANEL_NAMES`."""
        place = {token: FIRST_PIECE + k for k, token in enumerate(self.pieces)}
        return tuple(tuple(place[token] for token in tokens) for tokens in self.spelled)

    def text_of(self, outputs: Sequence[int]) -> str:
        """What pieces spell."""
        return self.read([self.pieces[k - FIRST_PIECE] for k in outputs])

    def whole(self, text_size: int) -> NDArray[np.int64]:
        """(outputs,) their tokens in the whole vocabulary, in which text comes first."""
        own = np.arange(FIRST_PIECE, dtype=np.int64) + text_size
        return np.concatenate([own, np.array(self.pieces, np.int64)])

    def spell(self, sequence: TokenSequence) -> SpelledPattern:
        """Writes the names of a pattern, or of its outlines, as text."""
        outputs: list[int] = []
        rows: list[NDArray[np.float32]] = []
        nothing, is_open = np.zeros(NUMBERS, np.float32), False

        def add(some: Sequence[int]) -> None:
            outputs.extend(some)
            rows.extend([nothing] * len(some))

        for token, row in zip(sequence.tokens.tolist(), sequence.numbers, strict=True):
            if is_open and (token in PANEL_TOKENS or token == PATTERN_END):
                add([PANEL_END])
                is_open = False
            if token in PANEL_TOKENS:
                add([PANEL_START, *self.names[token - PANEL_TOKENS.start]])
                is_open = True
            else:
                outputs.append(token)
                rows.append(row)
        if is_open:
            add([PANEL_END])
        return SpelledPattern(np.array(outputs, np.int64), np.array(rows, np.float32).reshape(-1, NUMBERS))

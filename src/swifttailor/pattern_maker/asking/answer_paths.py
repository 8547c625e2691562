"""What may be written next, and what comes of it: under the grammar or freely, names as tokens or text."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from swifttailor.errors import PatternError
from swifttailor.pattern_maker.tokens.free_reading import FreeReader
from swifttailor.pattern_maker.tokens.grammar import Grammar, Stage, State, next_state
from swifttailor.pattern_maker.tokens.name_text import FIRST_PIECE, PANEL_END, PANEL_START, NameText
from swifttailor.pattern_maker.tokens.vocabulary import PANEL_TOKENS, PATTERN_END, SIZE


class AnswerPath(Protocol):
    """An answer so far."""

    @property
    def state(self) -> State:
        """Of the pattern."""
        ...

    tokens: list[int]
    """Of the pattern, names as tokens."""
    unsewn: int
    """Edges whose stitches were open at the end."""
    fault: str
    """Why no pattern can come of it; empty while one can."""

    def allowed(self) -> NDArray[np.bool_]:
        """(outputs,) what may come next."""
        ...

    def take(self, output: int) -> int:
        """Writes what was chosen.

        Returns:
            How many tokens of the pattern are complete with it; numbers belong to the last one.
        """
        ...

    @property
    def finished(self) -> bool:
        """Whether nothing more is written."""
        ...


class GrammarPath:
    """Under the grammar, every name a token."""

    def __init__(self, grammar: Grammar) -> None:
        self.grammar = grammar
        self.state: State = State()
        self.tokens: list[int] = []
        self.unsewn, self.fault = 0, ""

    def allowed(self) -> NDArray[np.bool_]:
        """See `AnswerPath`."""
        mask = self.grammar.allowed(self.state)
        mask[PATTERN_END] |= self.grammar.may_break_off(self.state)
        return mask

    def take(self, output: int) -> int:
        """See `AnswerPath`."""
        if output == PATTERN_END and self.state.open:
            self.unsewn = len(self.state.open)
            self.state, self.tokens = self.grammar.broken_off(self.state, self.tokens)
        self.state = self.grammar.advance(self.state, output)
        self.tokens.append(output)
        return 1

    @property
    def finished(self) -> bool:
        """See `AnswerPath`."""
        return self.state.stage is Stage.FINISHED


class SpelledPath(GrammarPath):
    """Under the grammar, names as text: only names that may come are spelled."""

    def __init__(self, grammar: Grammar, names: NameText) -> None:
        super().__init__(grammar)
        self.names = names
        self._letters: tuple[int, ...] | None = None
        """Of the name that is being written."""
        self._end_is_due = False

    def allowed(self) -> NDArray[np.bool_]:
        """See `AnswerPath`."""
        mask = np.zeros(self.names.outputs, bool)
        if self._end_is_due and self.state.stage is Stage.BETWEEN_PANELS:
            mask[PANEL_END] = True
            return mask
        known = super().allowed()
        panels = np.flatnonzero(known[PANEL_TOKENS.start : PANEL_TOKENS.stop])
        if self._letters is None:
            mask[:SIZE] = known
            mask[PANEL_TOKENS.start : PANEL_TOKENS.stop] = False
            mask[PANEL_START] = bool(len(panels))
            return mask
        length = len(self._letters)
        for name in panels.tolist():
            spelled = self.names.names[name]
            if spelled == self._letters:
                mask[:SIZE] |= self.grammar.allowed(next_state(self.state, PANEL_TOKENS[name]))
            elif spelled[:length] == self._letters:
                mask[spelled[length]] = True
        return mask

    def take(self, output: int) -> int:
        """See `AnswerPath`."""
        if output == PANEL_START:
            self._letters = ()
        elif output == PANEL_END:
            self._end_is_due = False
        elif output >= FIRST_PIECE:
            self._letters = (*(self._letters or ()), output)
        elif self._letters is not None:
            name = self.names.names.index(self._letters)
            self._letters, self._end_is_due = None, True
            return super().take(PANEL_TOKENS[name]) + super().take(output)
        else:
            return super().take(output)
        return 0


class FreePath:
    """Whatever the network likes, up to the longest sequence."""

    def __init__(self, longest: int, names: NameText | None) -> None:
        self._reader, self._longest, self._length = FreeReader(names), longest, 0
        self._everything = np.ones(SIZE if names is None else names.outputs, bool)
        self.tokens: list[int] = []
        self.unsewn, self.fault = 0, ""

    @property
    def state(self) -> State:
        """See `AnswerPath`."""
        return self._reader.state

    def allowed(self) -> NDArray[np.bool_]:
        """See `AnswerPath`."""
        return self._everything

    def take(self, output: int) -> int:
        """See `AnswerPath`."""
        self._length += 1
        try:
            done = self._reader.take(output)
            if self._length == self._longest:
                self._reader.require_finished(self._length)
        except PatternError as error:
            self.fault = f"What was written is no pattern. Token {self._length}: {error}"
            return 0
        self.tokens += done
        return len(done)

    @property
    def finished(self) -> bool:
        """See `AnswerPath`."""
        return self._reader.finished or bool(self.fault)

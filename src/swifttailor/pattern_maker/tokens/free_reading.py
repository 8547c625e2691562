"""Reading what a network wrote without the grammar: a pattern, or why it is none (AIpparel's decoding).

The order of tokens must be that of a pattern, every panel must be closed and have one of GarmentCode's names,
and none twice. Panels may come in any order. A stitch tag on one edge, or on three and more, joins nothing:
it is left out, and counted.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from swifttailor.arrays import Singles
from swifttailor.errors import PatternError
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.pattern_maker.tokens.grammar import FEWEST_EDGES, Stage, State, next_state
from swifttailor.pattern_maker.tokens.name_text import FIRST_PIECE, PANEL_END, PANEL_START, NameText
from swifttailor.pattern_maker.tokens.panel_tokens import PanelTokens, panels_of
from swifttailor.pattern_maker.tokens.token_sequence import TokenSequence
from swifttailor.pattern_maker.tokens.vocabulary import (
    CLOSING_COMMANDS,
    COMMANDS,
    EDGE_LABEL_TOKENS,
    MOVE,
    NOT_STITCHED,
    NUMBERS,
    PANEL_LABEL_TOKENS,
    PANEL_LABELS,
    PANEL_TOKENS,
    PATTERN_END,
    PATTERN_START,
    RIGHT_WRONG,
    SIZE,
    STITCH_TOKENS,
    TOKENS,
    curve_type,
    usual_label,
)

_STITCH = frozenset([NOT_STITCHED, *STITCH_TOKENS])
_FOLLOWS: dict[Stage, frozenset[int]] = {
    Stage.NOTHING: frozenset([PATTERN_START]),
    Stage.NAME: frozenset([MOVE, *PANEL_LABEL_TOKENS]),
    Stage.PANEL_LABEL: frozenset([MOVE]),
    Stage.IN_PANEL: frozenset([*COMMANDS, *CLOSING_COMMANDS]),
    Stage.COMMAND: _STITCH | {RIGHT_WRONG, *EDGE_LABEL_TOKENS},
    Stage.EDGE_LABEL: _STITCH | {RIGHT_WRONG},
    Stage.RIGHT_WRONG: _STITCH,
    Stage.FINISHED: frozenset(),
}
"""What may follow but for panels, which depend on what was written before."""


class FreeReader:
    """Follows an answer, output by output."""

    def __init__(self, names: NameText | None = None) -> None:
        """Begins before the first.

        Args:
            names: Of a network that writes names as text.
        """
        self.names, self.state = names, State()
        self._seen: set[int] = set()
        self._letters: list[int] | None = None
        """Of the name that is being written."""
        self._end_is_due = False
        """Whether the mark after a panel is still to come."""

    @property
    def finished(self) -> bool:
        """Whether the pattern is."""
        return self.state.stage is Stage.FINISHED

    def take(self, output: int) -> list[int]:
        """Takes in the next output.

        Returns:
            The tokens of the pattern that are complete with it: none, one, or a name and what follows it.

        Raises:
            PatternError: No pattern can come of what was written.
        """
        if self.names is not None and (done := self._spelled(self.names, output)) is not None:
            return done
        return [self._advance(output)]

    def require_finished(self, length: int) -> None:
        """Refuses an answer that stops early.

        Args:
            length: Outputs in it.

        Raises:
            PatternError: It stops before its pattern is finished.
        """
        if not self.finished:
            where = "" if self._is_between else f" Panel {self._panel} is not closed."
            raise PatternError(f"After {length} tokens the pattern is not finished.{where}")

    def _spelled(self, names: NameText, output: int) -> list[int] | None:
        """What marks and text amount to; None where the output is an ordinary token."""
        if self._letters is not None:
            if output >= FIRST_PIECE:
                self._letters.append(output)
                return []
            text = names.text_of(self._letters)
            if text not in PANEL_NAMES:
                raise PatternError(
                    f"Panel {len(self._seen) + 1} is called {text!r}; GarmentCode's {len(PANEL_NAMES)} names "
                    "are accepted."
                )
            self._letters = None
            token = self._advance(PANEL_TOKENS[PANEL_NAMES.index(text)])
            self._end_is_due = True
            return [token, self._advance(output)]
        if self._end_is_due and self._is_between:
            if output != PANEL_END:
                raise self._misplaced(output, "<panel_end>")
            self._end_is_due = False
            return []
        if output == PANEL_START and self._is_between:
            self._letters = []
            return []
        if output >= SIZE or output in PANEL_TOKENS:
            raise self._misplaced(output, "<panel_start> or <pattern_end>" if self._is_between else "")
        return None

    def _advance(self, token: int) -> int:
        state = self.state
        if self._is_between:
            if token in PANEL_TOKENS:
                self._begin(token - PANEL_TOKENS.start)
            elif token != PATTERN_END:
                raise self._misplaced(token, "a panel or <pattern_end>")
            elif not self._seen:
                raise PatternError("The pattern ends without a panel.")
        elif token not in _FOLLOWS[state.stage]:
            raise self._misplaced(token, "")
        elif token in CLOSING_COMMANDS:
            curved = state.curved or curve_type(token) is not curve_type(COMMANDS[0])
            if state.edges + 1 < FEWEST_EDGES or not (curved or state.edges + 1 > FEWEST_EDGES):
                count = state.edges + 1
                raise PatternError(
                    f"Panel {self._panel} is closed by its edge {count}: it encloses nothing. Three edges, "
                    "or two of which one is curved, are accepted."
                )
        self.state = next_state(state, token)
        return token

    def _begin(self, name: int) -> None:
        if name in self._seen:
            raise PatternError(f"There are two panels '{PANEL_NAMES[name]}'; each name is accepted once.")
        self._seen.add(name)

    @property
    def _is_between(self) -> bool:
        return self.state.stage is Stage.BETWEEN_PANELS

    @property
    def _panel(self) -> str:
        return f"'{PANEL_NAMES[self.state.name]}'" if self._seen else "1"

    def _misplaced(self, output: int, accepted: str) -> PatternError:
        shown = accepted or _shown(_FOLLOWS[self.state.stage])
        where = f"in panel {self._panel}" if self._seen and not self._is_between else "between panels"
        where = "at the beginning" if self.state.stage is Stage.NOTHING else where
        return PatternError(f"{self._word(output)} may not come {where}. Accepted: {shown}.")

    def _word(self, output: int) -> str:
        if output < SIZE:
            return TOKENS[output]
        if output < FIRST_PIECE or self.names is None:
            return {PANEL_START: "<panel_start>", PANEL_END: "<panel_end>"}.get(output, "A mark of prompts")
        return f"The text {self.names.text_of([output])!r}"


@dataclass(frozen=True, eq=False)
class SettledPattern:
    """What was read, as the grammar would have it."""

    sequence: TokenSequence
    dropped: int
    """Stitch tags that stood on one edge, or on three and more."""


def settled(tokens: Sequence[int], numbers: Sequence[Singles]) -> SettledPattern:
    """Puts panels in order and leaves out stitches that join nothing, so that `decode` reads the rest.

    Args:
        tokens: (n,) that a `FreeReader` let pass, to the end.
        numbers: (n, 8) of each.
    """
    panels = panels_of(TokenSequence(np.array(tokens), np.array(numbers).reshape(-1, NUMBERS)))
    tags = Counter(e.stitch for p in panels.values() for e in p.edges if e.stitch in STITCH_TOKENS)
    marked = {e.stitch for p in panels.values() for e in p.edges if e.right_wrong}
    written: list[tuple[int, Singles]] = [(PATTERN_START, _NOTHING)]
    begun: set[int] = set()
    for _, panel in sorted(panels.items()):
        written += _head(panel)
        for number, edge in enumerate(panel.edges):
            if tags[edge.stitch] != 2:
                edge = replace(edge, stitch=NOT_STITCHED)
            commands = CLOSING_COMMANDS if number == len(panel.edges) - 1 else COMMANDS
            written.append((commands[edge.kind], edge.numbers))
            after = [] if edge.label is None else [edge.label]
            if edge.stitch in begun and edge.stitch in marked:
                after.append(RIGHT_WRONG)
            if edge.stitch != NOT_STITCHED:
                begun.add(edge.stitch)
            written += [(token, _NOTHING) for token in (*after, edge.stitch)]
    written.append((PATTERN_END, _NOTHING))
    sequence = TokenSequence(np.array([t for t, _ in written]), np.array([row for _, row in written]))
    return SettledPattern(sequence, sum(count != 2 for count in tags.values()))


def _head(panel: PanelTokens) -> list[tuple[int, Singles]]:
    head = [(PANEL_TOKENS[panel.name], _NOTHING)]
    if panel.label is not None and panel.label != _USUAL[panel.name]:
        head.append((panel.label, _NOTHING))
    return [*head, (MOVE, panel.placement)]


def _shown(tokens: frozenset[int]) -> str:
    some = [TOKENS[token] for token in sorted(tokens)]
    return ", ".join(some[:8]) + (", ..." if len(some) > 8 else "") or "nothing more"


_NOTHING = np.zeros(NUMBERS, np.float32)
_USUAL = [PANEL_LABEL_TOKENS[PANEL_LABELS.index(usual_label(name))] for name in PANEL_NAMES]

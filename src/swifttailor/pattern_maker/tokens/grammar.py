"""Which token may come next: every sequence that this lets through is a pattern, and can always be finished.

::

    pattern := <pattern_start> panel+ <pattern_end>
    panel   := <panel:NAME> [<covers:LABEL>] <move> edge* closing-edge
    edge    := (<line> | <quadratic> | <cubic> | <arc>) [<edge:LABEL>] [<right_wrong>] stitch
    stitch  := <stitch:K> | <not_stitched>

Beyond this: names come in the order of `PANEL_NAMES`; a label is written where it is not the usual one of
that name; a panel has three edges, or two of which one is curved; every stitch tag comes exactly twice, and
``<right_wrong>`` before the second; and the limits are kept.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import Enum, auto
from itertools import islice
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from swifttailor.errors import InputError
from swifttailor.pattern.curve import Line
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.pattern_maker.tokens.vocabulary import (
    CLOSING_COMMANDS,
    COMMANDS,
    EDGE_LABEL_TOKENS,
    MOVE,
    NOT_STITCHED,
    PANEL_LABEL_TOKENS,
    PANEL_LABELS,
    PANEL_TOKENS,
    PATTERN_END,
    PATTERN_START,
    RIGHT_WRONG,
    SIZE,
    STITCH_TAGS,
    STITCH_TOKENS,
    TOKENS,
    curve_type,
    usual_label,
)

FEWEST_EDGES = 2
_NO_NAME = -1
_USUAL = tuple(PANEL_LABEL_TOKENS[PANEL_LABELS.index(usual_label(name))] for name in PANEL_NAMES)


class Stage(Enum):
    """What the last token was, and with it what may follow."""

    NOTHING = auto()
    BETWEEN_PANELS = auto()
    NAME = auto()
    PANEL_LABEL = auto()
    IN_PANEL = auto()
    COMMAND = auto()
    EDGE_LABEL = auto()
    RIGHT_WRONG = auto()
    FINISHED = auto()


_OF_AN_EDGE = (Stage.COMMAND, Stage.EDGE_LABEL, Stage.RIGHT_WRONG)


@dataclass(frozen=True)
class Limits:
    """How large a pattern may become."""

    tokens: int = 1024
    """In the whole sequence, its start and end included."""
    edges: int = 64
    """In one panel."""

    def __post_init__(self) -> None:
        if self.tokens < 9:
            raise InputError(f"limits.tokens is {self.tokens}; at least 9 are needed for one panel.")
        if self.edges < 4:
            raise InputError(f"limits.edges is {self.edges}; at least 4 are accepted.")


class State(NamedTuple):
    """What a prefix amounts to: all that the rules look at."""

    stage: Stage = Stage.NOTHING
    length: int = 0
    """Tokens so far."""
    name: int = _NO_NAME
    """Class id of the latest panel."""
    edges: int = 0
    """Begun in the present panel."""
    curved: bool = False
    """Whether one of them is."""
    closing: bool = False
    """Whether the latest is the panel's last."""
    open: frozenset[int] = frozenset()
    """Stitch tags that have come once."""
    used: frozenset[int] = frozenset()
    """Stitch tags that have come at all."""


@dataclass(frozen=True)
class Grammar:
    """The rules, as a state machine."""

    limits: Limits = field(default_factory=Limits)
    tags: Literal["ascending", "any"] = "ascending"
    """Whether a new stitch has the least free tag, or any free one."""

    def allowed(self, state: State) -> NDArray[np.bool_]:
        """The tokens that may come next.

        Returns:
            (`SIZE`,) a mask. Something is always allowed until the pattern is finished, and nothing then.
        """
        mask = np.zeros(SIZE, bool)
        for tokens in self._by_syntax(state):
            # What follows is the same for all tokens of one group.
            if len(tokens) and self._can_finish(next_state(state, tokens[0])):
                mask[tokens if isinstance(tokens, list) else slice(tokens.start, tokens.stop)] = True
        return mask

    def advance(self, state: State, token: int) -> State:
        """The state after one more token.

        Raises:
            InputError: It may not come here.
        """
        if not 0 <= token < SIZE:
            raise InputError(f"Token {state.length} is {token}; tokens are from 0 to {SIZE - 1}.")
        for tokens in self._by_syntax(state):
            if token in tokens:
                after = next_state(state, token)
                if self._can_finish(after):
                    return after
                raise InputError(
                    f"Token {state.length}: after {TOKENS[token]} the pattern cannot be finished within "
                    f"{self.limits.tokens} tokens and {self.limits.edges} edges to a panel; "
                    f"{len(after.open)} stitches are open."
                )
        expected = [TOKENS[k] for k in np.flatnonzero(self.allowed(state))]
        shown = ", ".join(expected[:8]) + (", ..." if len(expected) > 8 else "")
        raise InputError(
            f"Token {state.length} is {TOKENS[token]}, which may not come here. "
            f"Accepted: {shown or 'nothing more, the pattern is finished'}."
        )

    def may_break_off(self, state: State) -> bool:
        """Whether a pattern could end here but for stitches that are open."""
        return state.stage is Stage.BETWEEN_PANELS and state.name != _NO_NAME and bool(state.open)

    def broken_off(self, state: State, tokens: Sequence[int]) -> tuple[State, list[int]]:
        """Leaves the edges of open stitches unsewn, so that the pattern can end.

        Args:
            state: One in which `may_break_off`.
            tokens: That have led to it.

        Returns:
            The same without the open stitches; where tags count up, those after them count on without a gap.
        """
        kept = sorted(state.used - state.open)
        new = range(len(kept)) if self.tags == "ascending" else kept
        names = {STITCH_TOKENS[tag]: STITCH_TOKENS[name] for tag, name in zip(kept, new, strict=True)}
        names |= {STITCH_TOKENS[tag]: NOT_STITCHED for tag in state.open}
        used = frozenset(names[STITCH_TOKENS[tag]] - STITCH_TOKENS.start for tag in kept)
        return state._replace(open=frozenset(), used=used), [names.get(token, token) for token in tokens]

    def _by_syntax(self, state: State) -> list[list[int] | range]:
        """What the rules let follow, limits aside, in groups that lead to states of equal cost."""
        stage = state.stage
        if stage is Stage.NOTHING:
            return [[PATTERN_START]]
        if stage is Stage.BETWEEN_PANELS:
            # A name is of use if the panels that the open stitches need after it have names too.
            further = -(-max(len(state.open) - self.limits.edges, 0) // self.limits.edges)
            names = PANEL_TOKENS[state.name + 1 :]
            last = max(len(names) - further, 0)
            ended: list[list[int] | range] = (
                [[PATTERN_END]] if state.name != _NO_NAME and not state.open else []
            )
            return [names[:last], names[last:], *ended]
        if stage is Stage.NAME:
            return [[MOVE], [token for token in PANEL_LABEL_TOKENS if token != _USUAL[state.name]]]
        if stage is Stage.PANEL_LABEL:
            return [[MOVE]]
        if stage is Stage.IN_PANEL:
            return self._commands(state)
        if stage in _OF_AN_EDGE:
            return self._edge_continued(state)
        return []

    def _commands(self, state: State) -> list[list[int] | range]:
        groups: list[list[int] | range] = [COMMANDS] if state.edges + 1 < self.limits.edges else []
        if state.edges >= FEWEST_EDGES or (state.edges and state.curved):
            groups.append(CLOSING_COMMANDS)
        elif state.edges:
            groups.append(CLOSING_COMMANDS[1:])
        return groups

    def _edge_continued(self, state: State) -> list[list[int] | range]:
        closing = [STITCH_TOKENS[tag] for tag in state.open]
        if state.stage is Stage.RIGHT_WRONG:
            return [closing]
        free = (tag for tag in range(STITCH_TAGS) if tag not in state.used)
        opening = [STITCH_TOKENS[tag] for tag in (free if self.tags == "any" else islice(free, 1))]
        groups: list[list[int] | range] = [[NOT_STITCHED], closing, opening]
        groups += [[RIGHT_WRONG]] if state.open else []
        return groups + ([EDGE_LABEL_TOKENS] if state.stage is Stage.COMMAND else [])

    def _can_finish(self, state: State) -> bool:
        need = self._tokens_to_finish(state)
        return need is not None and state.length + need <= self.limits.tokens

    def _tokens_to_finish(self, state: State) -> int | None:
        """Tokens that one way of finishing takes, close to the shortest; None when names would not suffice.

        That way: each edge closes a stitch while any is open; a panel ends when no stitch is open, or when it
        is full; further panels are begun only while stitches are open.
        """
        stage, still_open = state.stage, len(state.open)
        if stage is Stage.FINISHED:
            return 0
        begun = 0  # tokens that complete what has been begun
        edges, closed = state.edges, stage is Stage.BETWEEN_PANELS
        if stage is Stage.NOTHING:
            begun, edges, closed = 1, 0, True
        elif stage is Stage.NAME or stage is Stage.PANEL_LABEL:
            begun = 1
        elif stage in _OF_AN_EDGE:
            begun, closed = 1, state.closing
            still_open = max(still_open - 1, 0)
        here = 0
        if not closed:
            least = FEWEST_EDGES if edges == 0 else 1
            here = max(least, min(still_open, self.limits.edges - edges))
            if still_open - here == 1 and here > least:
                here -= 1  # a further panel has two edges at least: one is left for it
            still_open = max(still_open - here, 0)
        first_panel = closed and state.name == _NO_NAME
        panels = max(-(-still_open // self.limits.edges), int(first_panel))
        if panels > len(PANEL_NAMES) - 1 - state.name:
            return None
        there = max(still_open, FEWEST_EDGES * panels)
        return begun + 2 * here + 2 * panels + 2 * there + 1


def next_state(state: State, token: int) -> State:
    """The state after a token that the rules let follow."""
    _, length, name, edges, curved, closing, still_open, used = state
    length += 1
    stage = _STAGE_AFTER.get(token)
    if stage is not None:
        return State(stage, length, name, edges, curved, closing, still_open, used)
    if token in PANEL_TOKENS:
        return State(Stage.NAME, length, token - PANEL_TOKENS.start, 0, False, False, still_open, used)
    if token in COMMANDS or token in CLOSING_COMMANDS:
        curved = curved or curve_type(token) is not Line
        closing = token in CLOSING_COMMANDS
        return State(Stage.COMMAND, length, name, edges + 1, curved, closing, still_open, used)
    stage = Stage.BETWEEN_PANELS if closing else Stage.IN_PANEL
    if token != NOT_STITCHED:
        tag = frozenset([token - STITCH_TOKENS.start])
        still_open, used = still_open ^ tag, used | tag
    return State(stage, length, name, edges, curved, closing, still_open, used)


_STAGE_AFTER = {
    PATTERN_START: Stage.BETWEEN_PANELS,
    PATTERN_END: Stage.FINISHED,
    MOVE: Stage.IN_PANEL,
    RIGHT_WRONG: Stage.RIGHT_WRONG,
    **dict.fromkeys(PANEL_LABEL_TOKENS, Stage.PANEL_LABEL),
    **dict.fromkeys(EDGE_LABEL_TOKENS, Stage.EDGE_LABEL),
}
"""Where a token alone says it."""

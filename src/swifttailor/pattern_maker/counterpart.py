"""Where a pattern that is written stands in the pattern that it is an edited version of.

Most of an edited pattern is what it was before. At every place of the answer there is a token of the old
pattern that would come next if nothing were changed: its counterpart. The network is told it, and decides
whether to take it, to change its numbers, or to write something else.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from swifttailor.pattern_maker.grammar import Stage, State, next_state
from swifttailor.pattern_maker.token_sequence import TokenSequence
from swifttailor.pattern_maker.vocabulary import (
    CLOSING_COMMANDS,
    COMMANDS,
    EDGE_LABEL_TOKENS,
    END,
    MOVE,
    NOT_STITCHED,
    NUMBERS,
    PANEL_TOKENS,
    PATTERN_END,
    PATTERN_START,
    RIGHT_WRONG,
    STITCH_TAGS,
    STITCH_TOKENS,
)

NONE = -1
"""In place of a token where there is no counterpart."""
SAME_END = 0.05
"""Normalised units (1.4 cm): an edge that ends this near to where an old one ended is that edge."""
REACH = 4
"""Edges inserted or left out in a row that are noticed."""
_NO_NUMBERS = np.zeros(NUMBERS, np.float32)


@dataclass(frozen=True, eq=False)
class Counterpart:
    """What the old pattern has at a place of the new one."""

    token: int = NONE
    numbers: NDArray[np.float32] = field(default_factory=lambda: _NO_NUMBERS)
    """(8,) of the old pattern's token."""


@dataclass(frozen=True)
class _Edge:
    command: int
    label: int | None
    """Places of its tokens in the sequence."""
    right_wrong: int | None
    stitch: int


@dataclass(frozen=True)
class _Panel:
    head: tuple[int, ...]
    """Places of its label, if it has one, and its placement."""
    edges: tuple[_Edge, ...]


class Counterparts:
    """Goes along the old pattern while the new one is written, token by token."""

    def __init__(self, old: TokenSequence) -> None:
        """Begins before the first token.

        Args:
            old: Pattern to edit; allowed by the grammar.
        """
        self._old = old
        self._panels = _panels_of(old)
        self._names = sorted(self._panels)
        self._seconds = _second_sides(old)
        self._state = State()
        self._edge = 0
        """Of the old panel: the edge that the present, or next, one was."""
        self._tags: dict[int, int] = {}
        """Tags of the old stitches that have come, and what they are called now."""

    def next(self) -> Counterpart:
        """Of the token that is to come."""
        place = self._place()
        if place is None:
            return Counterpart()
        token = int(self._old.tokens[place])
        if token in STITCH_TOKENS:
            return Counterpart(self._stitch(place, token))
        return Counterpart(token, self._old.numbers[place])

    def follow(self, token: int, numbers: NDArray[np.floating]) -> None:
        """Takes in the next token of the new pattern, one that the grammar allows, and its numbers (8,)."""
        state = self._state
        if token in COMMANDS:
            self._edge = self._nearest(numbers[END])
        elif token in STITCH_TOKENS:
            place = self._place_of_stitch()
            if place is not None and int(self._old.tokens[place]) in STITCH_TOKENS:
                self._tags.setdefault(int(self._old.tokens[place]), token)
        self._state = next_state(state, token)
        if token in STITCH_TOKENS or token == NOT_STITCHED:
            self._edge += 1
        elif token in PANEL_TOKENS:
            self._edge = 0

    def _place(self) -> int | None:
        """Of the counterpart in the old sequence."""
        state, panel = self._state, self._panels.get(self._state.name)
        if state.stage is Stage.NOTHING:
            return 0
        if state.stage is Stage.BETWEEN_PANELS:
            later = next((name for name in self._names if name > state.name), None)
            # A panel's name stands before its head.
            return len(self._old) - 1 if later is None else self._panels[later].head[0] - 1
        if panel is None or state.stage is Stage.FINISHED:
            return None
        if state.stage is Stage.NAME:
            return panel.head[0]
        if state.stage is Stage.PANEL_LABEL:
            return panel.head[-1]
        edge = panel.edges[self._edge] if self._edge < len(panel.edges) else None
        if edge is None:
            return None
        if state.stage is Stage.IN_PANEL:
            return edge.command
        if state.stage is Stage.COMMAND and edge.label is not None:
            return edge.label
        is_open = self._tags.get(int(self._old.tokens[edge.stitch]), NONE) - STITCH_TOKENS.start in state.open
        if edge.right_wrong is not None and is_open and state.stage is not Stage.RIGHT_WRONG:
            return edge.right_wrong
        return edge.stitch

    def _place_of_stitch(self) -> int | None:
        panel = self._panels.get(self._state.name)
        return panel.edges[self._edge].stitch if panel and self._edge < len(panel.edges) else None

    def _stitch(self, place: int, token: int) -> int:
        """What an old stitch is called in the new pattern."""
        state = self._state
        if token in self._tags and self._tags[token] - STITCH_TOKENS.start in state.open:
            return self._tags[token]
        if place in self._seconds:
            return NOT_STITCHED  # what it was sewn to is gone
        free = next((tag for tag in range(STITCH_TAGS) if tag not in state.used), None)
        return NOT_STITCHED if free is None else STITCH_TOKENS[free]

    def _nearest(self, end: NDArray[np.floating]) -> int:
        """The old edge that ends where an edge now ends; the one expected where none does."""
        panel = self._panels.get(self._state.name)
        if panel is None:
            return self._edge
        places = range(max(self._edge - REACH, 0), min(self._edge + REACH + 1, len(panel.edges) - 1))
        same = [
            k
            for k in places
            if np.linalg.norm(self._old.numbers[panel.edges[k].command, END] - end) <= SAME_END
        ]
        return min(same, key=lambda k: abs(k - self._edge), default=self._edge)


def counterparts(old: TokenSequence, new: TokenSequence) -> list[Counterpart]:
    """Of every token of a new version of a pattern."""
    walk, found = Counterparts(old), []
    for token, numbers in zip(new.tokens.tolist(), new.numbers, strict=True):
        found.append(walk.next())
        walk.follow(token, numbers)
    return found


def _panels_of(sequence: TokenSequence) -> dict[int, _Panel]:
    """By class id of their names."""
    heads: dict[int, list[int]] = {}
    edges: dict[int, list[list[int]]] = {}
    name = NONE
    for place, token in enumerate(sequence.tokens.tolist()):
        if token in PANEL_TOKENS:
            name = token - PANEL_TOKENS.start
            heads[name], edges[name] = [], []
        elif token in COMMANDS or token in CLOSING_COMMANDS:
            edges[name].append([place])
        elif token in (PATTERN_START, PATTERN_END):
            continue
        elif token == MOVE or not edges[name]:
            heads[name].append(place)
        else:
            edges[name][-1].append(place)
    return {n: _Panel(tuple(heads[n]), tuple(_edge(sequence, e) for e in edges[n])) for n in heads}


def _edge(sequence: TokenSequence, places: list[int]) -> _Edge:
    kinds = {int(sequence.tokens[place]): place for place in places[1:-1]}
    label = next((place for token, place in kinds.items() if token in EDGE_LABEL_TOKENS), None)
    return _Edge(places[0], label, kinds.get(RIGHT_WRONG), places[-1])


def _second_sides(sequence: TokenSequence) -> set[int]:
    """Places of stitch tags that came before."""
    seen: set[int] = set()
    seconds = set()
    for place, token in enumerate(sequence.tokens.tolist()):
        if token in STITCH_TOKENS:
            if token in seen:
                seconds.add(place)
            seen.add(token)
    return seconds

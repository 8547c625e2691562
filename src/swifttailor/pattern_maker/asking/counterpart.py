"""What a token that is to be written most likely repeats: of a pattern to edit, or of the body's other side.

Most of an edited pattern is what it was before, and most garments are the same left and right. At every place
of an answer where a token of the old pattern would come if nothing were changed, or one of the mirrored panel
if the garment were symmetric, that token is the counterpart. The network is told it, and decides whether to
take it, to change its numbers, or to write something else.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from swifttailor.pattern.names import TWINS
from swifttailor.pattern_maker.asking.plan import PatternPlan
from swifttailor.pattern_maker.tokens.grammar import Stage, State, next_state
from swifttailor.pattern_maker.tokens.panel_tokens import (
    SAME,
    EdgeTokens,
    PanelCollector,
    PanelTokens,
    are_alike,
    mirrored,
    panels_of,
)
from swifttailor.pattern_maker.tokens.token_sequence import TokenSequence
from swifttailor.pattern_maker.tokens.vocabulary import (
    CLOSING_COMMANDS,
    COMMANDS,
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
_INSIDE = frozenset(Stage) - {Stage.NOTHING, Stage.BETWEEN_PANELS, Stage.FINISHED}
Side = tuple[int, int]
"""Class id of a panel and the number of an edge of it."""


@dataclass(frozen=True, eq=False)
class Counterpart:
    """What is likely to be repeated at a place."""

    token: int = NONE
    numbers: NDArray[np.float32] = field(default_factory=lambda: _NO_NUMBERS)
    """(8,) of that token."""
    planned: int = NONE
    """The token that is foreseen (`PatternPlan`), which is rough where what is repeated is exact."""
    planned_numbers: NDArray[np.float32] = field(default_factory=lambda: _NO_NUMBERS)
    panel: int = NONE
    """Class id of the panel that is being written, of which all that is foreseen is told as well."""


class Counterparts:
    """Follows a pattern while it is written, token by token."""

    def __init__(self, old: TokenSequence | None = None, plan: PatternPlan | None = None) -> None:
        """Begins before the first token.

        Args:
            old: Pattern to edit, allowed by the grammar; None where there is none.
            plan: What is foreseen. It is told where there is nothing to repeat, and in an edit beside that.
        """
        self._plan, self._is_edit = plan, old is not None
        self._old = {} if old is None else panels_of(old)
        self._names = sorted(self._old)
        self._old_sides = _sides(self._old.values())
        self._new = PanelCollector()
        self._sides: dict[int, list[Side]] = {}
        """Of each tag that was written."""
        self._tags: dict[int, int] = {}
        """Tags of the old stitches that have come, and what they are called now."""
        self._state = State()
        self._source: PanelTokens | None = None
        """What the present panel is likely to repeat."""
        self._edge = 0
        """Of it: the one that the present, or next, edge repeats."""

    def next(self) -> Counterpart:
        """Of the token that is to come."""
        repeated = self._repeated()
        if self._plan is None:
            return repeated
        panel = self._state.name if self._state.stage in _INSIDE else NONE
        if repeated.token >= 0 and not self._is_edit:
            return replace(repeated, panel=panel)
        planned = self._foreseen(self._plan) or (NONE, _NO_NUMBERS)
        return Counterpart(repeated.token, repeated.numbers, *planned, panel)

    def _foreseen(self, plan: PatternPlan) -> tuple[int, NDArray[np.float32]] | None:
        state = self._state
        if state.stage is Stage.BETWEEN_PANELS:
            return plan.after(state.name), _NO_NUMBERS
        if state.stage in (Stage.NAME, Stage.PANEL_LABEL):
            return MOVE, plan.placement(state.name)
        return plan.edge(state.name, state.edges) if state.stage is Stage.IN_PANEL else None

    def _repeated(self) -> Counterpart:
        state, source = self._state, self._source
        if state.stage is Stage.NOTHING:
            return Counterpart(PATTERN_START)
        if state.stage is Stage.BETWEEN_PANELS:
            return self._next_panel()
        if source is None or state.stage is Stage.FINISHED:
            return Counterpart()
        if state.stage is Stage.NAME and source.label is not None:
            return Counterpart(source.label)
        if state.stage in (Stage.NAME, Stage.PANEL_LABEL):
            return Counterpart(MOVE, source.placement)
        if self._edge >= len(source.edges):
            return Counterpart()
        edge = source.edges[self._edge]
        if state.stage is Stage.IN_PANEL:
            closing = self._edge == len(source.edges) - 1
            return Counterpart((CLOSING_COMMANDS if closing else COMMANDS)[edge.kind], edge.numbers)
        if state.stage is Stage.COMMAND and edge.label is not None:
            return Counterpart(edge.label)
        stitch = self._stitch()
        completes = stitch in STITCH_TOKENS and stitch - STITCH_TOKENS.start in state.open
        if completes and self._is_right_wrong() and state.stage is not Stage.RIGHT_WRONG:
            return Counterpart(RIGHT_WRONG)
        return Counterpart(stitch)

    def follow(self, token: int, numbers: NDArray[np.floating]) -> None:
        """Takes in the next token of the new pattern, one that the grammar allows, and its numbers (8,)."""
        if token in COMMANDS:
            self._edge = self._nearest(numbers[END])
        elif token in STITCH_TOKENS:
            old = self._old_edge()
            if old is not None and old.stitch in STITCH_TOKENS:
                self._tags.setdefault(old.stitch, token)
            self._sides.setdefault(token, []).append((self._state.name, self._state.edges - 1))
        self._state = next_state(self._state, token)
        self._new.add(token, numbers)
        if token in STITCH_TOKENS or token == NOT_STITCHED:
            self._edge += 1
        elif token in PANEL_TOKENS:
            self._source, self._edge = self._source_of(self._state.name), 0

    def _next_panel(self) -> Counterpart:
        if not self._old:
            return Counterpart()
        later = next((name for name in self._names if name > self._state.name), None)
        return Counterpart(PATTERN_END if later is None else PANEL_TOKENS[later])

    def _source_of(self, name: int) -> PanelTokens | None:
        old, twin = self._old.get(name), TWINS.get(name, NONE)
        if twin not in self._new.panels:
            return old
        reflection = mirrored(self._new.panels[twin], name)
        if old is None:
            return reflection
        # What was symmetric stays so: the other side has been changed already.
        was_symmetric = twin in self._old and are_alike(mirrored(self._old[twin], name), old, SAME)
        return reflection if was_symmetric else old

    def _old_edge(self) -> EdgeTokens | None:
        """Of the pattern to edit, at the present edge."""
        panel, source = self._old.get(self._state.name), self._source
        if panel is None or source is None or len(panel.edges) != len(source.edges):
            return None
        return panel.edges[self._edge] if self._edge < len(panel.edges) else None

    def _is_right_wrong(self) -> bool:
        edge = self._old_edge()
        return edge is not None and edge.right_wrong

    def _stitch(self) -> int:
        """The present edge's."""
        old, source = self._old_edge(), self._source
        if old is not None:
            return self._stitch_of_old(old.stitch)
        if source is None or source.edges[self._edge].stitch == NOT_STITCHED:
            return NOT_STITCHED
        return self._stitch_of_twin(source)

    def _stitch_of_old(self, token: int) -> int:
        """What an old stitch is called in the new pattern."""
        if token == NOT_STITCHED:
            return token
        if token in self._tags and self._tags[token] - STITCH_TOKENS.start in self._state.open:
            return self._tags[token]
        first = self._old_sides[token][0]
        is_second = first != (self._state.name, self._edge)
        return NOT_STITCHED if is_second else self._new_tag()  # if second, what it was sewn to is gone

    def _stitch_of_twin(self, source: PanelTokens) -> int:
        """Sewn to the reflection of what the other side is sewn to, if that is there."""
        edges = len(source.edges)
        here = (TWINS.get(source.name, NONE), edges - 1 - self._edge)
        others = [side for side in self._sides.get(source.edges[self._edge].stitch, []) if side != here]
        for panel, edge in others:
            name = next((right for right, left in TWINS.items() if left == panel), None)
            written = self._new.panels.get(NONE if name is None else name)
            if written is None and name == self._new.name:
                written = PanelTokens(name, None, self._new.placement, tuple(self._new.edges))
            total = len(self._new.panels[panel].edges) if panel in self._new.panels else 0
            place = total - 1 - edge
            if written is not None and 0 <= place < len(written.edges):
                tag = written.edges[place].stitch
                if tag in STITCH_TOKENS and tag - STITCH_TOKENS.start in self._state.open:
                    return tag
        return self._new_tag()

    def _new_tag(self) -> int:
        free = next((tag for tag in range(STITCH_TAGS) if tag not in self._state.used), None)
        return NOT_STITCHED if free is None else STITCH_TOKENS[free]

    def _nearest(self, end: NDArray[np.floating]) -> int:
        """The edge of the source that ends where an edge now ends; the one expected where none does."""
        if self._source is None:
            return self._edge
        edges = self._source.edges
        places = range(max(self._edge - REACH, 0), min(self._edge + REACH + 1, len(edges) - 1))
        same = [k for k in places if np.linalg.norm(edges[k].numbers[END] - end) <= SAME_END]
        return min(same, key=lambda k: abs(k - self._edge), default=self._edge)


def counterparts(
    old: TokenSequence | None, new: TokenSequence, plan: PatternPlan | None = None
) -> list[Counterpart]:
    """Of every token of a pattern; see `Counterparts`."""
    walk, found = Counterparts(old, plan), []
    for token, numbers in zip(new.tokens.tolist(), new.numbers, strict=True):
        found.append(walk.next())
        walk.follow(token, numbers)
    return found


def _sides(panels: Iterable[PanelTokens]) -> dict[int, list[Side]]:
    """Of each tag, in the order of a sequence."""
    found: dict[int, list[Side]] = {}
    for panel in sorted(panels, key=lambda panel: panel.name):
        for number, edge in enumerate(panel.edges):
            if edge.stitch != NOT_STITCHED:
                found.setdefault(edge.stitch, []).append((panel.name, number))
    return found

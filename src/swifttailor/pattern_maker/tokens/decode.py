"""From tokens and numbers back to a pattern."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from swifttailor.errors import PatternError
from swifttailor.pattern.names import EDGE_LABELS, PANEL_NAMES
from swifttailor.pattern.panel import Edge, Panel
from swifttailor.pattern.pattern import EdgeRef, Pattern, Stitch
from swifttailor.pattern_maker.tokens.edge_numbers import edge_curve
from swifttailor.pattern_maker.tokens.grammar import Grammar, Limits, Stage, State
from swifttailor.pattern_maker.tokens.normalization import points_in_cm
from swifttailor.pattern_maker.tokens.placement_numbers import placement_of
from swifttailor.pattern_maker.tokens.token_sequence import TokenSequence
from swifttailor.pattern_maker.tokens.vocabulary import (
    CLOSING_COMMANDS,
    COMMANDS,
    EDGE_LABEL_TOKENS,
    END,
    MOVE,
    NUMBERS,
    PANEL_LABEL_TOKENS,
    PANEL_LABELS,
    PANEL_TOKENS,
    RIGHT_WRONG,
    STITCH_TOKENS,
    usual_label,
)

_UNLIMITED = Grammar(Limits(tokens=1_000_000, edges=100_000), tags="any")


@dataclass
class _OpenPanel:
    """A panel of which not all has been read."""

    name: str
    label: str
    placement: NDArray[np.float32] = field(default_factory=lambda: np.zeros(NUMBERS, np.float32))
    commands: list[int] = field(default_factory=list)
    rows: list[NDArray[np.float32]] = field(default_factory=list)
    labels: list[str] = field(default_factory=list)


def decode(sequence: TokenSequence, *, name: str = "pattern") -> Pattern:
    """Reads what `swifttailor.pattern_maker.tokens.encode.encode` or a network has written.

    Args:
        sequence: A finished one. Its numbers may be any: a pattern comes of them, though perhaps not one that
            can be sewn (`swifttailor.check_pattern`).
        name: Of the pattern; a sequence does not hold one.

    Returns:
        The pattern in canonical order; each panel's first vertex is its origin.

    Raises:
        InputError: The tokens are not those of a pattern; the message gives the place.
        PatternError: The sequence stops before the pattern is finished.
    """
    state = State()
    panels: list[_OpenPanel] = []
    first_sides: dict[int, EdgeRef] = {}
    stitches: list[Stitch] = []
    right_wrong = False
    for token, row in zip(sequence.tokens.tolist(), sequence.numbers, strict=True):
        state = _UNLIMITED.advance(state, token)
        if token in PANEL_TOKENS:
            panel_name = PANEL_NAMES[token - PANEL_TOKENS.start]
            panels.append(_OpenPanel(panel_name, usual_label(panel_name)))
        elif token in PANEL_LABEL_TOKENS:
            panels[-1].label = PANEL_LABELS[token - PANEL_LABEL_TOKENS.start]
        elif token == MOVE:
            panels[-1].placement = row
        elif token in COMMANDS or token in CLOSING_COMMANDS:
            panels[-1].commands.append(token)
            panels[-1].rows.append(row)
            panels[-1].labels.append("")
        elif token in EDGE_LABEL_TOKENS:
            panels[-1].labels[-1] = EDGE_LABELS[token - EDGE_LABEL_TOKENS.start]
        elif token == RIGHT_WRONG:
            right_wrong = True
        elif token in STITCH_TOKENS:
            side = EdgeRef(panels[-1].name, len(panels[-1].commands) - 1)
            first = first_sides.setdefault(token, side)
            if first is not side:
                stitches.append(Stitch(first, side, right_wrong))
            right_wrong = False
    if state.stage is not Stage.FINISHED:
        raise PatternError(
            f"The sequence stops after {len(sequence)} tokens, before its pattern is finished "
            f"({len(state.open)} stitches are open). Decode under a grammar, which keeps room for the end."
        )
    return Pattern(tuple(_finish(p) for p in panels), tuple(stitches), name).canonical()


def decoded_vertices(rows: NDArray[np.float32]) -> NDArray[np.float64]:
    """Corners (n + 1, 2) of a panel in cm from its first vertex.

    Args:
        rows: (n, 8) numbers of its edges but the closing one.
    """
    return np.concatenate([np.zeros((1, 2)), points_in_cm(rows[:, END])])


def _finish(panel: _OpenPanel) -> Panel:
    vertices = decoded_vertices(np.array(panel.rows[:-1]))
    edges = []
    for k, (command, row, label) in enumerate(zip(panel.commands, panel.rows, panel.labels, strict=True)):
        chord = vertices[[k, (k + 1) % len(vertices)]]
        edges.append(Edge(edge_curve(command, row, chord), label))
    return Panel(panel.name, vertices, tuple(edges), placement_of(panel.placement, vertices), panel.label)

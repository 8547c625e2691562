"""From a pattern to tokens and numbers."""

from __future__ import annotations

import difflib
from collections.abc import Sequence

import numpy as np

from swifttailor.errors import InputError, PatternError
from swifttailor.pattern.curve import Line
from swifttailor.pattern.names import EDGE_LABELS, PANEL_NAMES
from swifttailor.pattern.panel import Edge, Panel
from swifttailor.pattern.pattern import EdgeRef, Pattern
from swifttailor.pattern_maker.tokens.decode import decoded_vertices
from swifttailor.pattern_maker.tokens.edge_numbers import edge_numbers
from swifttailor.pattern_maker.tokens.grammar import FEWEST_EDGES, Grammar, Limits, State
from swifttailor.pattern_maker.tokens.placement_numbers import placement_numbers
from swifttailor.pattern_maker.tokens.token_sequence import TokenSequence
from swifttailor.pattern_maker.tokens.vocabulary import (
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
    STITCH_TAGS,
    STITCH_TOKENS,
    command_of,
    usual_label,
)

_NO_NUMBERS = np.zeros(NUMBERS, np.float32)
_Written = list[tuple[int, np.ndarray]]


def encode(
    pattern: Pattern, *, tags: Sequence[int] | None = None, limits: Limits | None = None
) -> TokenSequence:
    """Writes a pattern as tokens and numbers; `swifttailor.pattern_maker.tokens.decode.decode` reads them.

    Panels come in canonical order (docs/conventions.md), so that equal patterns have equal sequences.

    Args:
        pattern: What to write; its names and labels must be GarmentCode's.
        tags: Tags of the stitches in the order in which they first appear: a permutation of 0 to 107, for
            training as AIpparel does. By default 0, 1, 2, ...
        limits: How large it may be.

    Raises:
        PatternError: It does not fit, or is sewn in a way that tags cannot say.
        InputError: `tags` are not different numbers from 0 to 107, or too few.
    """
    limits = limits or Limits()
    pattern = pattern.canonical()
    order = list(range(STITCH_TAGS)) if tags is None else [int(t) for t in tags]
    if len(set(order)) < len(order) or not set(order) <= set(range(STITCH_TAGS)):
        raise InputError(f"tags must be different numbers from 0 to {STITCH_TAGS - 1}, got {order[:8]}...")
    stitched = _stitched(pattern, order)
    written: _Written = [(PATTERN_START, _NO_NUMBERS)]
    for panel in pattern.panels:
        written += _panel(panel, stitched, limits)
    written.append((PATTERN_END, _NO_NUMBERS))
    if len(pattern.panels) == 0:
        raise PatternError("The pattern has no panels; at least one is needed.")
    if len(written) > limits.tokens:
        raise PatternError(
            f"The pattern takes {len(written)} tokens; at most {limits.tokens} are accepted. "
            "Use fewer panels or edges, or raise limits.tokens."
        )
    return TokenSequence(np.array([t for t, _ in written]), np.array([row for _, row in written]))


def follow(sequence: TokenSequence, grammar: Grammar) -> list[State]:
    """The states of the grammar before each token of a sequence, and after the last.

    Raises:
        InputError: The grammar does not accept it.
    """
    states = [State()]
    for token in sequence.tokens.tolist():
        states.append(grammar.advance(states[-1], token))
    return states


def _stitched(pattern: Pattern, order: list[int]) -> dict[EdgeRef, tuple[int, bool]]:
    """Tag of each sewn edge, and whether ``right_wrong`` is written before it."""
    if len(pattern.stitches) > len(order):
        raise PatternError(
            f"The pattern has {len(pattern.stitches)} stitches; at most {len(order)} are accepted. "
            "Join edges that are sewn in a row."
        )
    found: dict[EdgeRef, tuple[int, bool]] = {}
    # Canonical stitches are sorted by their first edge: the order of appearance.
    for tag, stitch in zip(order, pattern.stitches, strict=False):
        for side, second in ((stitch.first, False), (stitch.second, True)):
            if not pattern.has_edge(side):
                raise PatternError(
                    f"A stitch names edge {side.edge} of panel '{side.panel}', "
                    "which does not exist. Remove it."
                )
            if side in found:
                raise PatternError(
                    f"Panel '{side.panel}', edge {side.edge} is in two stitches; one is accepted. "
                    "Split the edge, or remove a stitch."
                )
            found[side] = (tag, second and stitch.right_wrong)
    return found


def _panel(panel: Panel, stitched: dict[EdgeRef, tuple[int, bool]], limits: Limits) -> _Written:
    _check(panel, limits)
    first, count = panel.vertices[0], len(panel.edges)
    rows = [edge_numbers(e.curve, panel.chord(k) - first, k == count - 1) for k, e in enumerate(panel.edges)]
    # Placed by the corners as they will be read: which side is the top must not depend on rounding.
    placement = placement_numbers(panel.placement, decoded_vertices(np.array(rows[:-1])), first)
    head: _Written = [(PANEL_TOKENS[PANEL_NAMES.index(panel.name)], _NO_NUMBERS)]
    if panel.label != usual_label(panel.name):
        head.append((PANEL_LABEL_TOKENS[PANEL_LABELS.index(panel.label)], _NO_NUMBERS))
    head.append((MOVE, placement))
    written: _Written = []
    for k, edge in enumerate(panel.edges):
        written.append((command_of(edge.curve, k == count - 1), rows[k]))
        written += _edge_tokens(edge, stitched.get(EdgeRef(panel.name, k)))
    return head + written


def _edge_tokens(edge: Edge, stitch: tuple[int, bool] | None) -> _Written:
    tokens = [EDGE_LABEL_TOKENS[EDGE_LABELS.index(edge.label)]] if edge.label else []
    if stitch is None:
        tokens.append(NOT_STITCHED)
    else:
        tag, right_wrong = stitch
        tokens += [RIGHT_WRONG] if right_wrong else []
        tokens.append(STITCH_TOKENS[tag])
    return [(token, _NO_NUMBERS) for token in tokens]


def _check(panel: Panel, limits: Limits) -> None:
    if panel.name not in PANEL_NAMES:
        near = difflib.get_close_matches(panel.name, PANEL_NAMES, 1, 0.5)
        hint = f"'{near[0]}' is near. " if near else ""
        raise PatternError(
            f"Panel '{panel.name}' has a name that the pattern maker does not know. {hint}Rename it "
            f"to one of GarmentCode's {len(PANEL_NAMES)} names (swifttailor.pattern.PANEL_NAMES)."
        )
    if panel.label not in PANEL_LABELS:
        raise PatternError(
            f"Panel '{panel.name}' is labelled '{panel.label}'; body, arm, leg or none is accepted."
        )
    for k, edge in enumerate(panel.edges):
        if edge.label and edge.label not in EDGE_LABELS:
            raise PatternError(
                f"Panel '{panel.name}', edge {k} is labelled '{edge.label}'; accepted are "
                f"{', '.join(EDGE_LABELS)} or none."
            )
    if not FEWEST_EDGES <= len(panel.edges) <= limits.edges:
        raise PatternError(
            f"Panel '{panel.name}' has {len(panel.edges)} edges; {FEWEST_EDGES} to {limits.edges} "
            "are accepted."
        )
    if len(panel.edges) == FEWEST_EDGES and all(isinstance(e.curve, Line) for e in panel.edges):
        raise PatternError(
            f"Panel '{panel.name}' has two edges, both straight; one must be curved. Remove the panel."
        )

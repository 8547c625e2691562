"""The tokens of a sewing pattern: AIpparel's commands and stitch tags, and tokens for what it leaves out.

A token is a small integer here; the network adds the size of its text vocabulary. AIpparel writes panel names
as text, closes panels by tokens of their own, and has none for labels and ``right_wrong``.
"""

from __future__ import annotations

from swifttailor.pattern.curve import Arc, Cubic, Curve, Line, Quadratic
from swifttailor.pattern.names import EDGE_LABELS, PANEL_NAMES, body_region

STITCH_TAGS = 108
"""Stitches that a pattern can have at most, as in AIpparel."""
PANEL_LABELS = ("", "body", "arm", "leg")
CURVES: tuple[type[Curve], ...] = (Line, Quadratic, Cubic, Arc)

TOKENS: tuple[str, ...] = (
    "<pattern_start>",
    "<pattern_end>",
    "<move>",
    *("<line>", "<quadratic>", "<cubic>", "<arc>"),
    *("<closing_line>", "<closing_quadratic>", "<closing_cubic>", "<closing_arc>"),
    "<right_wrong>",
    *(f"<edge:{label}>" for label in EDGE_LABELS),
    *(f"<covers:{label or 'nothing'}>" for label in PANEL_LABELS),
    "<not_stitched>",
    *(f"<stitch:{tag}>" for tag in range(STITCH_TAGS)),
    *(f"<panel:{name}>" for name in PANEL_NAMES),
)
"""All of them as text; the position is the id. Ids are part of trained weights: they do not change."""

PATTERN_START, PATTERN_END, MOVE = 0, 1, 2
COMMANDS = range(3, 7)
"""Edges that end at a new vertex, in the order of `CURVES`."""
CLOSING_COMMANDS = range(7, 11)
"""Edges that end where the panel began, in the order of `CURVES`."""
RIGHT_WRONG = 11
EDGE_LABEL_TOKENS = range(12, 12 + len(EDGE_LABELS))
PANEL_LABEL_TOKENS = range(EDGE_LABEL_TOKENS.stop, EDGE_LABEL_TOKENS.stop + len(PANEL_LABELS))
NOT_STITCHED = PANEL_LABEL_TOKENS.stop
STITCH_TOKENS = range(NOT_STITCHED + 1, NOT_STITCHED + 1 + STITCH_TAGS)
PANEL_TOKENS = range(STITCH_TOKENS.stop, STITCH_TOKENS.stop + len(PANEL_NAMES))
SIZE = len(TOKENS)

NUMBERS = 8
"""Numbers that a token can have: those of a placement, or of an edge."""
END, CONTROL_1, CONTROL_2, MID = slice(0, 2), slice(2, 4), slice(4, 6), slice(6, 8)
"""Where an edge's points stand: its end, its control points, the middle of an arc."""
TRANSLATION, QUATERNION = slice(0, 3), slice(3, 7)
"""Where a placement's numbers stand."""

_POINTS: tuple[tuple[slice, ...], ...] = ((), (CONTROL_1,), (CONTROL_1, CONTROL_2), (MID,))
"""In the order of `CURVES`."""


def number_slots(token: int) -> tuple[slice, ...]:
    """The parts of a row of numbers that mean something for `token`; none for most tokens."""
    if token == MOVE:
        return TRANSLATION, QUATERNION
    if token in COMMANDS:
        return END, *_POINTS[token - COMMANDS.start]
    if token in CLOSING_COMMANDS:
        return _POINTS[token - CLOSING_COMMANDS.start]
    return ()


def command_of(curve: Curve, closing: bool) -> int:
    """The command for an edge of that shape."""
    return (CLOSING_COMMANDS if closing else COMMANDS)[CURVES.index(type(curve))]


def curve_type(command: int) -> type[Curve]:
    """The shape that a command, closing or not, stands for."""
    return CURVES[(command - COMMANDS.start) % len(CURVES)]


def usual_label(name: str) -> str:
    """The label that GarmentCode gives a panel of this name; other labels are written, this one is not."""
    return body_region(name)

"""The pattern that a panel tensor says, be it exact or as a network answers it."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from swifttailor.arrays import Floats
from swifttailor.errors import PatternError
from swifttailor.latent_diffusion import tensor_layout as at
from swifttailor.latent_diffusion.stitch_tags import nearest_pairs
from swifttailor.pattern import Arc, Cubic, Edge, EdgeRef, Line, Panel, Pattern, Placement, Quadratic, Stitch
from swifttailor.pattern.curve import Curve
from swifttailor.pattern.names import body_region

_LEAST_BEND = 1e-3
"""Arcs that are flatter are lines: their radius would be hundreds of times the chord."""
_SURE = 1e-6
"""No bit counts as surer."""


def pattern_of(tensor: Floats, *, name: str = "pattern") -> Pattern:
    """Reads a panel tensor.

    A panel has as many edges as is likeliest, given how likely each is there. Its placement is averaged over
    them, and a gap of its outline spread over all of them. Stitches join the edges whose tags are nearest.

    Args:
        tensor: `tensor_layout.SHAPE`; bits are probabilities.
        name: Of the pattern.

    Returns:
        In canonical order.

    Raises:
        PatternError: It says no pattern: there is no panel, or one without an outline or a place.
    """
    if tensor.shape != at.SHAPE:
        raise PatternError(f"A panel tensor is of shape {at.SHAPE}, and this one of {tensor.shape}.")
    if not np.isfinite(tensor).all():
        raise PatternError("The panel tensor holds numbers that are not finite.")
    panels, tags, turned = [], {}, {}
    for slot, rows in zip(at.SLOTS, tensor, strict=True):
        rows = rows[: edge_count(rows[:, at.THERE])]
        if not len(rows):
            continue
        panels.append(_panel_of(slot, rows))
        for edge, row in enumerate(rows):
            if row[at.FREE] < 0.5:
                side = EdgeRef(slot, edge)
                tags[side], turned[side] = row[at.TAG], float(row[at.REVERSED])
    if not panels:
        raise PatternError("The panel tensor holds no panel.")
    pattern = Pattern(tuple(panels), (), name)
    pairs = nearest_pairs(tags, {side: pattern.edge_length(side) for side in tags})
    stitches = [Stitch(one, other, turned[one] + turned[other] > 1.0) for one, other in pairs]
    return Pattern(tuple(panels), tuple(stitches), name).canonical()


def edge_count(there: Floats) -> int:
    """How many edges there are, of (edges,) probabilities that each is: those from the first one on."""
    sure = np.clip(there, _SURE, 1 - _SURE)
    odds = np.log(sure) - np.log(1 - sure)
    return int(np.argmax(np.concatenate([[0.0], np.cumsum(odds)])))


def _panel_of(name: str, rows: Floats) -> Panel:
    if len(rows) < 2:
        raise PatternError(f"Panel '{name}' has one edge, and no outline is of one.")
    steps = rows[:, at.STEP] - rows[:, at.STEP].mean(0)
    vertices = np.concatenate([np.zeros((1, 2)), np.cumsum(steps, 0)[:-1]])
    edges = tuple(
        Edge(_curve_of(row, step), at.LABELS[_number(row[at.LABEL], len(at.LABELS))])
        for row, step in zip(rows, steps, strict=True)
    )
    turns = rows[:, at.TURN]
    turn = np.where(turns @ turns[:1].T < 0, -turns, turns).mean(0)  # q and -q are one rotation
    if np.linalg.norm(turn) < 1e-3:
        raise PatternError(f"Panel '{name}' stands in no direction: its quaternion is {turn.tolist()}.")
    placement = Placement().moved(Rotation.from_quat(turn).as_matrix(), rows[:, at.PLACE].mean(0))
    return Panel(name, vertices - vertices.mean(0), edges, placement, body_region(name))


def _curve_of(row: Floats, step: Floats) -> Curve:
    kind = at.KINDS[_number(row[at.KIND], len(at.KINDS))]
    if kind is Quadratic:
        x, y = row[at.QUADRATIC].tolist()
        return Quadratic((x, y))
    if kind is Cubic:
        x1, y1, x2, y2 = row[at.CUBIC].tolist()
        return Cubic((x1, y1), (x2, y2))
    bend, chord = float(np.clip(row[at.BEND], 0.0, 1.0)), float(np.hypot(*step))
    if kind is Line or bend < _LEAST_BEND or chord == 0.0:
        return Line()
    return Arc(chord / (2 * bend), bool(row[at.LARGE] > 0.5), bool(row[at.RIGHT] > 0.5))


def _number(bits: Floats, count: int) -> int:
    """The likeliest of the first `count` numbers."""
    sure = np.clip(bits, _SURE, 1 - _SURE)
    is_set = np.arange(count)[:, None] >> np.arange(len(sure)) & 1
    return int(np.argmax(np.where(is_set, np.log(sure), np.log(1 - sure)).sum(1)))

"""The plain reference of `swifttailor.refitting.even_lengths`: row by row, edge by edge."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import spsolve

from swifttailor.pattern import Panel, Pattern
from swifttailor.pattern.curve import scale
from swifttailor.refitting.even_lengths import _CLOSE, _HELD, _MOST_ROUNDS, _SEAM


def keep_seam_ratios(before: Pattern, after: Pattern) -> Pattern:
    """Moves corners as little as possible until each seam's sides have the ratio that they had.

    Args:
        before: The pattern whose ratios count.
        after: The same panels, edges and stitches in other sizes.
    """
    pattern = after
    for _ in range(_MOST_ROUNDS):
        if _worst_ratio(before, pattern) < _CLOSE:
            break
        pattern = _once(before, pattern, after)
    return pattern


def _worst_ratio(before: Pattern, now: Pattern) -> float:
    off = 0.0
    for stitch in now.stitches:
        was, here = (
            p.edge_length(stitch.first) / max(p.edge_length(stitch.second), 1e-9) for p in (before, now)
        )
        off = max(off, abs(here / max(was, 1e-9) - 1.0))
    return off


def _once(before: Pattern, now: Pattern, target: Pattern) -> Pattern:
    start = np.cumsum([0, *(len(p.vertices) for p in now.panels)])
    place = np.concatenate([p.vertices for p in now.panels])
    at = place.tolist()
    rows: list[tuple[list[int], list[float], float]] = []
    for number, (panel, goal) in enumerate(zip(now.panels, target.panels, strict=True)):
        count, goals = len(panel.vertices), goal.vertices.tolist()
        for k in range(count):
            i, j = start[number] + k, start[number] + (k + 1) % count
            for axis in (0, 1):
                chord = goals[(k + 1) % count][axis] - goals[k][axis]
                gap = chord - (at[j][axis] - at[i][axis])
                rows.append(([2 * j + axis, 2 * i + axis], [1.0, -1.0], gap))
                held = goals[k][axis] - at[i][axis]
                rows.append(([2 * i + axis], [_HELD], _HELD * held))
    for stitch in now.stitches:
        ratio = before.edge_length(stitch.first) / max(before.edge_length(stitch.second), 1e-9)
        columns: list[int] = []
        slopes: list[float] = []
        lengths = []
        for ref, weight in zip(stitch.sides, (1.0, -ratio), strict=True):
            number = now.panel_index(ref.panel)
            count = len(now.panels[number].vertices)
            i, j = start[number] + ref.edge, start[number] + (ref.edge + 1) % count
            along = place[j] - place[i]
            length, chord = now.edge_length(ref), float(np.linalg.norm(along))
            # The curve goes with its chord: its length is a multiple of the chord's.
            pull = weight * (length / max(chord, 1e-9)) * along / max(chord, 1e-9)
            columns += [2 * j, 2 * j + 1, 2 * i, 2 * i + 1]
            slopes += [pull[0], pull[1], -pull[0], -pull[1]]
            lengths.append(weight * length)
        rows.append((columns, [_SEAM * s for s in slopes], -_SEAM * sum(lengths)))
    index = np.repeat(np.arange(len(rows)), [len(c) for c, _, _ in rows])
    system = sparse.csr_array(
        (np.concatenate([v for _, v, _ in rows]), (index, np.concatenate([c for c, _, _ in rows]))),
        shape=(len(rows), 2 * len(place)),
    )
    right = np.array([r for _, _, r in rows])
    step = spsolve((system.T @ system).tocsc(), system.T @ right).reshape(-1, 2)
    moved = place + step
    panels = [_with_corners(panel, moved[start[k] : start[k + 1]]) for k, panel in enumerate(now.panels)]
    return replace(now, panels=tuple(panels))


def _with_corners(panel: Panel, vertices: np.ndarray) -> Panel:
    """The panel with other corners, each edge a scaled copy of what it was."""
    old = np.linalg.norm(np.roll(panel.vertices, -1, axis=0) - panel.vertices, axis=1)
    new = np.linalg.norm(np.roll(vertices, -1, axis=0) - vertices, axis=1)
    edges = tuple(
        replace(edge, curve=scale(edge.curve, float(b / max(a, 1e-9))))
        for edge, a, b in zip(panel.edges, old, new, strict=True)
    )
    return replace(panel, vertices=vertices, edges=edges)

"""Cut-outs that show the wearer: on both shoulders, at both sides of the waist, in the middle of the back."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.pattern import EdgeRef
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Patch, Trim
from swifttailor.pattern.trims.side_stripes import SIDE, outer_seams, top_seams

_ON_CLOTH = 0.04
"""How exactly an opening lies on its panel, cm."""
_POINTS, _LEAST = 17, 0.05
"""Of each of its lines; and its least width, cm."""
_FROM_CAP, _SHOULDER, _SHOULDER_DEEP, _OF_SLEEVE = 2.2, 14.0, 5.6, 0.75
"""Where it begins below the armhole, how long it is and how far it goes beside the seam on top of a sleeve,
cm; and what part of a sleeve it takes at most."""
_ABOVE_WAIST, _SIDE, _SIDE_DEEP, _SHORTEST_SIDE, _BELOW_ARM = 1.5, 11.0, (9.0, 7.0), 5.0, 1.5
"""The same at the sides of the waist, in front and behind, cm; and what stays free below the underarm."""
_SHARES = (1.0, 0.85, 0.7, 0.55)
"""So deep, as parts of that, they are tried."""
_BELOW_NAPE, _BACK, _HALF_BACK, _OF_BACK, _BESIDE = 5.0, 17.0, 7.5, 0.5, 1.2
"""The same in the back, of whose seam in the middle it takes such a part at most; how far beside the middle a
half is looked at, cm."""


def shoulder_cut_outs(chalk: Chalk, name: str) -> list[Trim]:
    """An opening on top of each sleeve, below the shoulder."""
    s, found = chalk.size, []
    for pair in top_seams(chalk.pattern):
        for ref in pair:
            reach = min(_SHOULDER * s, _OF_SLEEVE * chalk.pattern.edge_length(ref) - _FROM_CAP * s)
            found.append(_half(chalk, name, ref, (_FROM_CAP * s, reach), _SHOULDER_DEEP * s))
    return _all(found)


def waist_cut_outs(chalk: Chalk, name: str) -> list[Trim]:
    """An opening at each side, from just above the waist up."""
    s = chalk.size
    seams: list[tuple[tuple[EdgeRef, EdgeRef], tuple[float, float]]] = []
    for pair in outer_seams(chalk.pattern, SIDE):
        if not all("torso" in ref.panel for ref in pair):
            continue
        panel = chalk.pattern.panel(pair[0].panel)
        heights = panel.to_world(panel.sample_edge(pair[0].edge, 9))[:, 1]
        low = max(chalk.waist + _ABOVE_WAIST * s, heights.min() + _LEAST)
        high = min(low + _SIDE * s, heights.max() - _BELOW_ARM * s)
        if high - low >= _SHORTEST_SIDE * s:
            seams.append((pair, (float(heights.max() - high), float(high - low))))
    if len(seams) != 2:
        return []
    found: list[Trim] = []
    for side, most in enumerate(_SIDE_DEEP):  # darts leave less room on some
        tried = (
            _all([_half(chalk, name, pair[side], along, share * most * s) for pair, along in seams])
            for share in _SHARES
        )
        halves = next((both for both in tried if both), [])
        if not halves:
            return []
        found += halves
    return found


def back_cut_out(chalk: Chalk, name: str) -> list[Trim]:
    """A round opening between the shoulder blades."""
    if any("hood" in panel.name for panel in chalk.pattern.panels):
        return []
    s = chalk.size
    halves = [(chalk.views.get(f"{side}_btorso"), sign) for side, sign in (("left", 1), ("right", -1))]
    columns = [None if view is None else view.column(sign * _BESIDE) for view, sign in halves]
    ends = [column for column in columns if column is not None]
    if len(ends) < 2:
        return []
    low, high = max(end[0] for end in ends), min(end[1] for end in ends)
    height = min(_BACK * s, _OF_BACK * (high - low))
    top = high - _BELOW_NAPE * s
    if height < 0.5 * _BACK * s or high < chalk.shoulder - 12.0 * s:
        return []
    shares = np.linspace(0.0, 1.0, _POINTS)
    wide = np.maximum(2.0 * np.sqrt(shares * (1.0 - shares)) * _HALF_BACK * s * height / (_BACK * s), _LEAST)
    pieces: list[Trim] = []
    for view, sign in halves:
        assert view is not None
        first, second = [], []
        for share, width in zip(shares, wide, strict=True):
            y = float(top - share * height)
            span = view.span(y)
            inner = 0.0 if span is None or span[0] * span[1] <= 0 else min(abs(span[0]), abs(span[1]))
            first.append((sign * (inner + 0.02), y))
            second.append((sign * (inner + 0.02 + float(width)), y))
        if not view.bridges([*first, *second]):
            return []
        pieces += chalk.ruled(name, view.panel.name, first, second, "hole", is_cut=False, to_the_edge=True)
    return pieces


def _half(chalk: Chalk, name: str, ref: EdgeRef, along: tuple[float, float], deep: float) -> Patch | None:
    """Half of an opening over a seam; None where it has no room.

    Args:
        chalk: Of the pattern.
        name: Of the trim.
        ref: The seam's edge on this half's panel.
        along: How far from the seam's upper end it begins, and how long it is, cm.
        deep: How far it goes beside the seam, cm.
    """
    import shapely

    panel = chalk.pattern.panel(ref.panel)
    seam = panel.sample_edge(ref.edge, 81)
    world = panel.to_world(seam)
    if world[0, 1] < world[-1, 1]:
        seam = seam[::-1]
    run = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(seam, axis=0), axis=1))])
    begins, length = along
    if length < _LEAST + deep / 2 or begins + length > run[-1]:
        return None
    shares = np.linspace(0.0, 1.0, _POINTS)
    at = begins + shares * length
    first = np.stack([np.interp(at, run, seam[:, k]) for k in (0, 1)], axis=1)
    tangent = np.gradient(first, axis=0)
    across = np.stack([-tangent[:, 1], tangent[:, 0]], axis=1)
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    cloth = shapely.Polygon(panel.outline(0.01)).buffer(_ON_CLOTH)
    middle = _POINTS // 2
    if not cloth.contains(shapely.Point(first[middle] + 0.5 * across[middle])):
        across = -across
    wide = np.maximum(np.sqrt(np.sin(np.pi * shares).clip(0.0)) * deep, _LEAST)[:, None]
    second = first + wide * across
    piece = shapely.Polygon([*first, *second[::-1]])
    fits = piece.is_valid and cloth.covers(piece)
    return Patch(name, ref.panel, first, second, "hole", is_cut=False) if fits else None


def _all(halves: list[Patch | None]) -> list[Trim]:
    """All of them, or none where one has no room."""
    found: list[Trim] = [half for half in halves if half is not None]
    return found if len(found) == len(halves) else []

"""Halves of a garment that a straight seam joins in the middle, made into one panel to be cut on the fold."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.making.closings import closing_trim
from swifttailor.pattern import EdgeRef, Line, Panel, Pattern, Stitch, body_region
from swifttailor.pattern.trims import Belt, Button, Patch, Trim, place_trims

_UPRIGHT = 0.02
"""Sine of the largest angle between such a seam and the grain."""
_EVEN_CM = 0.03
_SIDE_WORDS = ("left_", "right_", "_left", "_right")


def fold_centres(pattern: Pattern, *, front: bool, back: bool) -> Pattern:
    """The pattern without straight seams in the middle of front or back; their panels become one.

    Only where both panels are each other's mirror image at that seam, which is straight, runs along the
    grain, and is all that joins them.

    Args:
        pattern: Any pattern that can be sewn.
        front: Whether the front is folded.
        back: Whether the back is.
    """
    return fold_with_trims(pattern, front=front, back=back)[0]


def fold_with_trims(pattern: Pattern, *, front: bool, back: bool) -> tuple[Pattern, tuple[Trim, ...]]:
    """As `fold_centres`, with where the trims lie on the folded panels, panel-local.

    A front that buttons or a zip close stays in halves, and so does a back with a zip.
    """
    pattern = pattern.canonical()
    front = front and not closing_trim(pattern)
    back = back and "back zip" not in pattern.trims
    return _folded(pattern, place_trims(pattern), front=front, back=back)


def _folded(
    pattern: Pattern, trims: tuple[Trim, ...], *, front: bool, back: bool
) -> tuple[Pattern, tuple[Trim, ...]]:
    for stitch in pattern.stitches:
        if not all(pattern.has_edge(side) for side in stitch.sides):
            continue
        a, b = (pattern.panel(side.panel) for side in stitch.sides)
        wanted = front if a.normal()[2] > 0 else back
        if wanted and a.name != b.name and _is_centre(pattern, stitch, a, b):
            joined, name = _joined(pattern, stitch, a, b)
            moved = _moved_trims(trims, stitch, a, b, name)
            return _folded(joined, moved, front=front, back=back)
    return pattern, trims


def _moved_trims(trims: Sequence[Trim], stitch: Stitch, a: Panel, b: Panel, name: str) -> tuple[Trim, ...]:
    """Trims of both panels of a stitch on the one that they become."""
    chords = b.chord(stitch.second.edge), a.chord(stitch.first.edge)

    def lay(points: Floats, panel: str) -> Floats:
        return _lay(points, *chords) if panel == b.name else points

    moved: list[Trim] = []
    for trim in trims:
        if isinstance(trim, Belt) or trim.panel not in (a.name, b.name):
            moved.append(trim)
        elif isinstance(trim, Patch):
            first, second = (lay(points, trim.panel) for points in (trim.first, trim.second))
            moved.append(replace(trim, panel=name, first=first, second=second))
        elif isinstance(trim, Button):
            x, y = lay(np.array([trim.at]), trim.panel)[0].tolist()
            moved.append(replace(trim, panel=name, at=(x, y)))
    return tuple(moved)


def _is_centre(pattern: Pattern, stitch: Stitch, a: Panel, b: Panel) -> bool:
    """Whether a stitch is such a seam."""
    first, second = stitch.sides
    if stitch.right_wrong or body_region(a.name, a.label) != body_region(b.name, b.label):
        return False
    between = [s for s in pattern.stitches if {x.panel for x in s.sides} == {a.name, b.name}]
    curves = a.edges[first.edge].curve, b.edges[second.edge].curve
    if len(between) != 1 or not all(isinstance(curve, Line) for curve in curves):
        return False
    if a.signed_area() * b.signed_area() <= 0 or a.normal() @ b.normal() < 0.9:
        return False
    start, end = a.chord(first.edge)
    along = (end - start) / max(float(np.hypot(*(end - start))), 1e-9)
    if abs(along[0]) > _UPRIGHT or abs(pattern.edge_length(first) - pattern.edge_length(second)) > _EVEN_CM:
        return False
    middle = a.to_world(a.chord(first.edge))[:, 0]
    if np.abs(middle).max() > 1.0:  # elsewhere than in the middle of the body
        return False
    mirrored = _mirrored(a, first.edge)
    moved = _moved(b, second.edge, a, first.edge)
    return len(mirrored) == len(moved) and bool(np.abs(mirrored - moved).max() <= _EVEN_CM)


def _mirrored(a: Panel, edge: int) -> Floats:
    """Points of a panel's other edges, mirrored at one edge, in the order of the mirror image."""
    start, end = a.chord(edge)
    along = (end - start) / float(np.hypot(*(end - start)))
    count = len(a.edges)
    points = np.concatenate([a.sample_edge((edge + 1 + k) % count, 5)[:-1] for k in range(count - 1)])
    points = np.concatenate([points, start[None]])[::-1] - start
    return start + 2 * (points @ along)[:, None] * along - points


def _moved(b: Panel, own: int, a: Panel, edge: int) -> Floats:
    """Points of the other panel's other edges, laid against the first."""
    count = len(b.edges)
    points = np.concatenate([b.sample_edge((own + 1 + k) % count, 5)[:-1] for k in range(count - 1)])
    return _lay(np.concatenate([points, b.chord(own)[:1]]), b.chord(own), a.chord(edge))


def _lay(points: Floats, own: Floats, other: Floats) -> Floats:
    """Moves points so that a chord comes to lie on another, end to start."""
    u, v = own[1] - own[0], other[0] - other[1]
    cosine, sine = float(u @ v), float(u[0] * v[1] - u[1] * v[0])
    turn = np.array([[cosine, -sine], [sine, cosine]]) / max(float(np.hypot(cosine, sine)), 1e-12)
    return (points - own[0]) @ turn.T + other[1]


def _joined(pattern: Pattern, stitch: Stitch, a: Panel, b: Panel) -> tuple[Pattern, str]:
    """Both panels of a stitch as one, which keeps the place of the first, and its name."""
    k, m = stitch.first.edge, stitch.second.edge
    count, other = len(a.edges), len(b.edges)
    of_a = [(k + 1 + i) % count for i in range(count - 1)]
    of_b = [(m + 1 + i) % other for i in range(other - 1)]
    corners = np.concatenate([a.vertices[of_a], _lay(b.vertices[of_b], b.chord(m), a.chord(k))])
    edges = tuple(a.edges[i] for i in of_a) + tuple(b.edges[i] for i in of_b)
    name = a.name
    for word in _SIDE_WORDS:
        name = name.replace(word, "")
    if name == a.name or any(p.name == name for p in pattern.panels if p is not a and p is not b):
        name = f"{a.name}_{b.name}"
    where = {EdgeRef(a.name, e): EdgeRef(name, i) for i, e in enumerate(of_a)}
    where |= {EdgeRef(b.name, e): EdgeRef(name, len(of_a) + i) for i, e in enumerate(of_b)}
    panels = [
        replace(a, name=name, vertices=corners, edges=edges) if p is a else p
        for p in pattern.panels
        if p is not b
    ]
    stitches = tuple(
        Stitch(where.get(s.first, s.first), where.get(s.second, s.second), s.right_wrong)
        for s in pattern.stitches
        if s is not stitch
    )
    return replace(pattern, panels=tuple(panels), stitches=stitches).canonical(), name

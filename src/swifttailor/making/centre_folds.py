"""Halves of a garment that a straight seam joins in the middle, made into one panel to be cut on the fold."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern import EdgeRef, Panel, Pattern, Stitch
from swifttailor.pattern.centre_seams import foldable_sides, is_centre_seam, laid_on
from swifttailor.pattern.trims import Belt, Bow, Button, Frill, Layer, Patch, Stirrup, Trim, place_trims

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
    may_front, may_back = foldable_sides(pattern)
    return _folded(pattern, place_trims(pattern), front=front and may_front, back=back and may_back)


def _folded(
    pattern: Pattern, trims: tuple[Trim, ...], *, front: bool, back: bool
) -> tuple[Pattern, tuple[Trim, ...]]:
    for stitch in pattern.stitches:
        if not all(pattern.has_edge(side) for side in stitch.sides):
            continue
        a, b = (pattern.panel(side.panel) for side in stitch.sides)
        wanted = front if a.normal()[2] > 0 else back
        if wanted and a.name != b.name and is_centre_seam(pattern, stitch):
            joined, name = _joined(pattern, stitch, a, b)
            moved = _moved_trims(trims, stitch, a, b, name)
            return _folded(joined, moved, front=front, back=back)
    return pattern, trims


def _moved_trims(trims: Sequence[Trim], stitch: Stitch, a: Panel, b: Panel, name: str) -> tuple[Trim, ...]:
    """Trims of both panels of a stitch on the one that they become."""
    chords = b.chord(stitch.second.edge), a.chord(stitch.first.edge)

    def lay(points: Floats, panel: str) -> Floats:
        return laid_on(points, *chords) if panel == b.name else points

    moved: list[Trim] = []
    for trim in trims:
        if isinstance(trim, Belt | Frill | Layer | Stirrup) or trim.panel not in (a.name, b.name):
            moved.append(trim)
        elif isinstance(trim, Patch):
            first, second = (lay(points, trim.panel) for points in (trim.first, trim.second))
            moved.append(replace(trim, panel=name, first=first, second=second))
        elif isinstance(trim, Button | Bow):
            x, y = lay(np.array([trim.at]), trim.panel)[0].tolist()
            moved.append(replace(trim, panel=name, at=(x, y)))
    return tuple(moved)


def _joined(pattern: Pattern, stitch: Stitch, a: Panel, b: Panel) -> tuple[Pattern, str]:
    """Both panels of a stitch as one, which keeps the place of the first, and its name."""
    k, m = stitch.first.edge, stitch.second.edge
    count, other = len(a.edges), len(b.edges)
    of_a = [(k + 1 + i) % count for i in range(count - 1)]
    of_b = [(m + 1 + i) % other for i in range(other - 1)]
    corners = np.concatenate([a.vertices[of_a], laid_on(b.vertices[of_b], b.chord(m), a.chord(k))])
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

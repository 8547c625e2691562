"""Pieces on the inside that trims need: pocket bags, facings of fronts, facing and shield of a fly."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
import shapely

from swifttailor.arrays import Floats
from swifttailor.making.allowances import Allowances
from swifttailor.making.closings import Closing
from swifttailor.making.cut_line import cut_line
from swifttailor.making.piece import Piece
from swifttailor.making.trim_marks import TrimMark
from swifttailor.making.trim_shapes import rectangle, ring_of, shape_piece
from swifttailor.making.trim_words import OPENINGS

_BAG_BELOW_CM, _BAG_ABOVE_CM, _BAG_IN_CM = 11.0, 3.0, 12.0
"""How far a pocket bag reaches below its opening, above it, and beyond it towards the middle."""
_ROUND_CM = 4.0
_FACING_CM = 6.0
"""A front's facing reaches so far beyond the middle, away from its edge."""
_FLY_CM = 0.7
"""The facing of a fly reaches so far beyond its topstitching."""


def bags(name: str, pieces: Sequence[Piece], allowances: Allowances) -> Iterator[Piece]:
    """Bags of pockets that hang inside, cut along the front that they hang on."""
    if name not in OPENINGS:
        return
    slanted = name == "slant pockets"
    for piece in pieces:
        lines = [m for m in piece.marks if m.trim == name and m.kind == "line"]
        if not lines:
            continue
        # On a piece that is its own mirror image both sides are marked.
        mark = max(lines, key=lambda m: float(m.points[:, 0].mean()))
        count = sum(len(m.panels) for m in lines)
        front = shapely.Polygon(piece.sew_line)
        back = _bag(front, mark.points, along=not slanted)
        half = max(count // 2, 1)
        names = [f"{name} bag {k}" for k in range(2 * count)]
        if not slanted:  # both sides of the bag are sewn to the side seam
            yield shape_piece(
                "Pocket bag", name, ring_of(back), names[:count], mirrored=names[count:],
                seam=allowances.seam, cloth="of the cloth or of lining",
            )  # fmt: skip
            continue
        for k, (title, shape, cloth) in enumerate((
            ("Pocket bag, front", _inside_of(back, mark.points, front), "of the cloth or of lining"),
            ("Pocket bag, back", back, "of the cloth"),
        )):  # fmt: skip
            own = names[k * count : (k + 1) * count]
            yield shape_piece(
                title, name, ring_of(shape), own[:half], mirrored=own[half:], seam=allowances.seam,
                marks=[mark] if k else (), cloth=cloth,
            )  # fmt: skip


def facings(closing: Closing, pieces: Sequence[Piece], allowances: Allowances) -> Iterator[Piece]:
    """Of fronts that lap: what lies behind their edges, from the neck to the hem."""
    number = 0
    for piece in pieces:
        if closing.panels.isdisjoint((*piece.panels, *piece.mirrored)):
            continue
        drawn = (*piece.panels, *piece.mirrored)[0]
        bare = []
        for run in piece.runs:
            is_open = run.edge in {ref.edge for ref in closing.edges if ref.panel == drawn}
            bare.append(type(run)(run.points, run.kind, closing.extension if is_open else 0.0, run.edge))
        whole = shapely.Polygon(cut_line(bare, closing.falling(bare, drawn, 0.0, 0.0)).outline)
        middle = np.concatenate([m.points for m in piece.marks if m.words == "centre front"])
        x = middle[:, 0]
        low, high = whole.bounds[1] - 1, whole.bounds[3] + 1
        right = x.mean() > piece.middle
        strip = (
            shapely.box(x.min() - _FACING_CM, low, 1e3, high)
            if right
            else shapely.box(-1e3, low, x.max() + _FACING_CM, high)
        )
        names = [f"{closing.trim} facing {number + k + 1}" for k in range(piece.count)]
        number += piece.count
        yield shape_piece(
            "Front facing",
            closing.trim,
            ring_of(shapely.intersection(whole, strip)),
            names[: len(piece.panels)],
            mirrored=names[len(piece.panels) :],
            seam=allowances.seam,
            cloth="and of interfacing",
        )


def fly_pieces(pieces: Sequence[Piece], allowances: Allowances) -> Iterator[Piece]:
    """What lies behind the zip of a fly: the facing of the upper side, the shield of the lower one."""
    found = [(p, m) for p in pieces for m in p.marks if m.trim == "fly" and m.kind == "line"]
    if not found:
        return
    piece, mark = found[0]
    length = float(np.ptp(mark.points[:, 1])) + 2.0
    front = shapely.Polygon(piece.sew_line)
    # From the seam in the middle to the topstitching.
    toward = -1.0 if mark.points[0, 0] < piece.middle else 1.0
    far = mark.points[::-1] + np.array([toward * 30.0, 0.0])
    above = np.array([[0.0, 3.0]])
    area = np.concatenate([mark.points[:1] + above, mark.points, far, far[-1:] + above])
    shape = shapely.intersection(front, shapely.Polygon(area).buffer(_FLY_CM))
    yield shape_piece(
        "Fly facing", "fly", ring_of(shape), ["fly facing"], seam=allowances.seam, cloth="and of interfacing"
    )
    line = np.array([[0.0, -length / 2], [0.0, length / 2]])
    fold = TrimMark("fly", "line", line, "fold", (), "middle")
    yield shape_piece(
        "Fly shield", "fly", rectangle(9.0, length), ["fly shield"], seam=allowances.seam, marks=[fold]
    )


def _bag(front: shapely.Polygon, opening: Floats, *, along: bool) -> shapely.Polygon:
    """The part of a front behind which a bag hangs, with a round corner below.

    Args:
        front: All of it.
        opening: (n, 2) the line that stays open.
        along: Whether the bag hangs along the opening, as in a flared side seam, instead of upright.
    """
    line = opening[np.argsort(opening[:, 1])]
    up = _unit(line[-1] - line[0]) if along else np.array([0.0, 1.0])
    frame = np.array([[up[1], -up[0]], up])  # points @ frame.T stand upright
    own = opening @ frame.T
    outline = shapely.transform(front, lambda points: points @ frame.T)
    outer_is_right = opening[:, 0].mean() > (front.bounds[0] + front.bounds[2]) / 2
    low, high = own.min(axis=0), own.max(axis=0)
    inner = low[0] - _BAG_IN_CM if outer_is_right else high[0] + _BAG_IN_CM
    outer = 1e3 if outer_is_right else -1e3
    bottom = low[1] - _BAG_BELOW_CM
    box = shapely.box(min(inner, outer), bottom, max(inner, outer), high[1] + _BAG_ABOVE_CM)
    parts = shapely.get_parts(shapely.intersection(outline, box))
    bag = max((part for part in parts if isinstance(part, shapely.Polygon)), key=lambda part: part.area)
    sign = 1.0 if outer_is_right else -1.0
    # A quarter of a circle in place of the corner where the inner side meets the bottom.
    x, y = inner + sign * _ROUND_CM, bottom + _ROUND_CM
    square = shapely.box(min(inner, x), bottom, max(inner, x), y)
    disk = shapely.Point(x, y).buffer(_ROUND_CM, quad_segs=8)
    return shapely.transform(bag.difference(square.difference(disk)), lambda points: points @ frame)


def _inside_of(bag: shapely.Polygon, opening: Floats, front: shapely.Polygon) -> shapely.Geometry:
    """What is left of a bag where its opening is cut along a line from the waist to the side seam."""
    line = opening[np.argsort(opening[:, 1])]
    ends = np.array(
        [line[0] - 3.0 * _unit(line[1] - line[0]), *line, line[-1] + 3.0 * _unit(line[-1] - line[-2])]
    )
    outer = 1.0 if opening[:, 0].mean() > (front.bounds[0] + front.bounds[2]) / 2 else -1.0
    beyond = np.concatenate([ends, ends[::-1] + np.array([outer * 40.0, 0.0])])
    return shapely.difference(bag, shapely.Polygon(beyond))


def _unit(step: Floats) -> Floats:
    return step / max(float(np.hypot(*step)), 1e-9)

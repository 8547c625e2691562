"""Pieces that are cut for trims: pockets, flaps, belts, bands, facings, pocket bags."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

import numpy as np
import shapely

from swifttailor.arrays import Floats
from swifttailor.making.allowances import Allowances
from swifttailor.making.closings import Closing
from swifttailor.making.inner_pieces import bags, facings, fly_pieces
from swifttailor.making.piece import Piece
from swifttailor.making.sewn_pattern import SewnPattern
from swifttailor.making.trim_marks import HOLE_EASE_CM, TrimMark
from swifttailor.making.trim_shapes import rectangle, ring, same_shape, shape_piece
from swifttailor.making.trim_words import ACROSS, BANDS, POCKETS, is_flap
from swifttailor.making.waist_girth import waist_girth
from swifttailor.pattern.trims import Belt, Button, Patch, Trim

FACING_CM = 3.0
"""Folded to the inside at the opening of a pocket."""
_OPEN_CM = 0.5
_UP_TO_NECK_CM = 6.0
TIE_CM, BUCKLE_CM = 60.0, 20.0
"""Beyond the waist, to be tied or to go through a buckle."""


def trim_pieces(
    sewn: SewnPattern,
    pieces: Sequence[Piece],
    trims: Sequence[Trim],
    closing: Closing | None,
    allowances: Allowances,
) -> list[Piece]:
    """The pieces that are cut for what is put on a pattern, in its order.

    Args:
        sewn: The panels.
        pieces: Those of the panels, with their marks.
        trims: Where trims lie on the panels.
        closing: How the front closes.
        allowances: Around edges that are sewn.
    """
    found: list[Piece] = []
    for name in dict.fromkeys(trim.trim for trim in trims):
        own = [trim for trim in trims if trim.trim == name]
        if name in POCKETS:
            found += _pockets(sewn, name, own, allowances, is_open=closing is not None)
        found += bags(name, pieces, allowances)
        if name in BANDS:
            found += _bands(name, pieces, allowances)
        if name == "fly":
            found += fly_pieces(pieces, allowances)
        found += [_belt(sewn, belt, allowances) for belt in own if isinstance(belt, Belt)]
        if closing is not None and closing.trim == name and closing.extension > 0:
            found += facings(closing, pieces, allowances)
    return _named_apart(found)


def _named_apart(pieces: Sequence[Piece]) -> list[Piece]:
    """Pieces of one name with numbers behind it."""
    counts, taken = Counter(piece.name for piece in pieces), Counter[str]()
    named = []
    for piece in pieces:
        taken[piece.name] += 1
        more = f" {taken[piece.name]}" if counts[piece.name] > 1 else ""
        named.append(replace(piece, name=piece.name + more))
    return named


def _pockets(
    sewn: SewnPattern, name: str, own: Sequence[Trim], allowances: Allowances, *, is_open: bool
) -> Iterator[Piece]:
    """Pockets that are sewn on, and their flaps; those that are alike are one piece.

    Halves that meet in the middle are one pocket, unless the front is open there.
    """
    patches = [t for t in own if isinstance(t, Patch) and t.is_cut]
    if name in ACROSS and not is_open:
        yield _across(sewn, name, patches, allowances)
        return
    title = POCKETS[name].capitalize()
    for part in ("", " flap"):
        groups: list[tuple[Floats, list[str], list[str], Patch]] = []
        for patch in patches:
            if is_flap(patch, own) != bool(part):
                continue
            outline = ring(patch.outline @ sewn.panel(patch.panel).turn.T)
            number = sum(len(g[1]) + len(g[2]) for g in groups) + 1
            # Every flap has a side that is seen and one that is not.
            names = [f"{name}{part} {number}"] if not part else [f"{name}{part} {number}{s}" for s in "ab"]
            for first, plain, mirrored, _ in groups:
                if same_shape(outline, first):
                    plain += names
                    break
                if same_shape(outline * (-1.0, 1.0), first):
                    mirrored += names
                    break
            else:
                groups.append((outline, names, [], patch))
        for outline, plain, mirrored, patch in groups:
            yield shape_piece(
                f"{title}{part}",
                name,
                outline,
                plain,
                mirrored=mirrored,
                seam=allowances.seam,
                facing=None if part else _folded([_opening(patch, sewn)]),
                marks=_flap_holes(sewn, patch, own) if part else (),
                cloth="half of them with interfacing" if part else "",
            )


def _folded(openings: Sequence[Floats]) -> Callable[[Floats, Floats], float]:
    """How wide an edge of a pocket is folded over, by its ends: those that stay open, each (2, 2)."""
    return lambda start, end: FACING_CM if any(_joins(start, end, o) for o in openings) else 0.0


def _opening(patch: Patch, sewn: SewnPattern) -> Floats:
    """Ends (2, 2) of a pocket's edge that stays open: the upper one, or that where a hand goes in."""
    line = patch.second @ sewn.panel(patch.panel).turn.T
    return line[-2:] if patch.trim == "kangaroo pocket" else line[[0, -1]]


def _joins(start: Floats, end: Floats, ends: Floats) -> bool:
    """Whether an edge has these ends (2, 2), either way around."""
    own = np.array([start, end])
    return bool(min(np.abs(own - ends).max(), np.abs(own[::-1] - ends).max()) < _OPEN_CM)


def _across(sewn: SewnPattern, name: str, patches: Sequence[Patch], allowances: Allowances) -> Piece:
    """A pocket whose halves meet in the middle, as one piece."""
    lines = []
    for patch in patches:
        turn = sewn.panel(patch.panel).turn
        low, high = patch.first @ turn.T, patch.second @ turn.T
        up = (high[0] - low[0]) / np.hypot(*(high[0] - low[0]))
        upright = np.array([[up[1], -up[0]], [up[0], up[1]]])  # their seam upright, where the fold is
        lines.append(((low - low[0]) @ upright.T, (high - low[0]) @ upright.T))
    (low, high), (other_low, other_high) = sorted(lines, key=lambda line: -float(line[0][:, 0].mean()))
    bottom = np.concatenate([other_low[::-1], low[1:]])
    top = np.concatenate([high[::-1], other_high[1:]])
    outline = np.concatenate([bottom, top])
    if name == "bib pocket":
        openings = [np.array([high[-1], other_high[-1]])]
    else:  # hands go in from the sides
        openings = [high[-2:], other_high[-2:]]
    return shape_piece(
        POCKETS[name].capitalize(),
        name,
        outline,
        [name],
        seam=allowances.seam,
        facing=_folded(openings),
    )


def _flap_holes(sewn: SewnPattern, patch: Patch, own: Sequence[Trim]) -> list[TrimMark]:
    """The buttonhole of a flap, above the button on its pocket."""
    turn, area = sewn.panel(patch.panel).turn, shapely.Polygon(patch.outline)
    marks = []
    for button in own:
        if isinstance(button, Button) and button.panel == patch.panel:
            if not area.contains(shapely.Point(button.at)):
                continue
            at = np.array([button.at]) @ turn.T
            half = np.array([0.0, button.radius + HOLE_EASE_CM / 2])
            hole = np.array([at[0] - half, at[0] + half])
            words = "buttonhole"
            marks.append(
                TrimMark(patch.trim, "hole", at, words, (patch.panel,), "middle", button.radius, hole)
            )
    return marks


def _bands(name: str, pieces: Sequence[Piece], allowances: Allowances) -> Iterator[Piece]:
    """Bands on both sides of an opening, folded in the middle; on them are buttons and holes."""
    length, width = 0.0, 0.0
    for piece in pieces:
        outlines = [m for m in piece.marks if m.trim == name and m.kind == "outline"]
        if outlines:
            # One side: pieces that are not cut twice bear both of them.
            length += band_length(piece, outlines[0])
            width = 2 * float(np.ptp(outlines[0].points[:, 0]))
    if width <= 0:
        return
    yield shape_piece(
        "Front band",
        name,
        rectangle(2 * width, length),
        [f"{name} band 1", f"{name} band 2"],
        seam=allowances.seam,
        marks=[_fold_line(name, length)],
        cloth="and of interfacing",
    )


def band_length(piece: Piece, mark: TrimMark) -> float:
    """How long a piece is along the inner line of a band, cm; where the band ends before, until there."""
    outline = shapely.Polygon(piece.sew_line)
    line = mark.points[len(mark.points) // 2 :]
    line = line[np.argsort(line[:, 1])]
    beyond = []
    # Bands are drawn a little short of the edges that they end at; above that is the neck or the waist.
    for end, before, reach in ((line[0], line[1], 0.6), (line[-1], line[-2], _UP_TO_NECK_CM)):
        step = (end - before) / np.hypot(*(end - before))
        leaves = not outline.contains(shapely.Point(end + reach * step))
        beyond.append(end + (reach + 1.0) * step if leaves else end)
    whole = shapely.LineString([beyond[0], *line, beyond[1]])
    return float(shapely.length(shapely.intersection(whole, outline.buffer(1e-6))))


def _fold_line(name: str, length: float) -> TrimMark:
    line = np.array([[0.0, -length / 2], [0.0, length / 2]])
    return TrimMark(name, "line", line, "fold", (), "middle")


def _belt(sewn: SewnPattern, belt: Belt, allowances: Allowances) -> Piece:
    """A belt, folded along its middle."""
    length = waist_girth(sewn.pattern) + (TIE_CM if belt.trim == "tie belt" else BUCKLE_CM)
    return shape_piece(
        "Belt",
        belt.trim,
        rectangle(2 * belt.width, length),
        [belt.trim],
        seam=allowances.seam,
        marks=[_fold_line(belt.trim, length)],
        cloth="" if belt.trim == "tie belt" else "and of interfacing",
    )

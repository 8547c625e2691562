"""Pieces nested on a width of cloth, grain along its length."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from swifttailor.arrays import Floats
from swifttailor.errors import InputError, MissingExtraError
from swifttailor.making.close_packing import pack_closely
from swifttailor.making.piece import Piece
from swifttailor.making.sheet_layout import skyline

GAP_CM = 0.3
"""Left free between pieces, for the scissors."""
MIN_WIDTH_CM, MAX_WIDTH_CM = 20.0, 500.0
MAX_SECONDS = 600
MOST_PIECES = 500
_SIMPLER_CM = 0.05
_TOUCHING_CM2 = 0.01
_LEFT_TURN = np.array([[0.0, -1.0], [1.0, 0.0]])


@dataclass(frozen=True, eq=False)
class LaidPiece:
    """One piece of cloth on the marker."""

    piece: Piece
    mirrored: bool
    turn: Floats
    """(2, 2): points of the piece (mirrored first where it is) become points @ turn.T + shift."""
    shift: Floats
    """(2,) cm."""

    @property
    def outline(self) -> Floats:
        """Cut line (n, 2) on the cloth: x along it, y across, cm."""
        return self.place(self.piece.cut.outline)

    def place(self, points: Floats) -> Floats:
        """Carries points (n, 2) of the piece onto the cloth."""
        sign = np.array([-1.0 if self.mirrored else 1.0, 1.0])
        return points * sign @ self.turn.T + self.shift


@dataclass(frozen=True, eq=False)
class Marker:
    """How all pieces of a pattern are cut from one length of cloth."""

    laid: tuple[LaidPiece, ...]
    width: float
    """Of the cloth, cm."""
    length: float
    """Needed, cm."""

    @property
    def waste(self) -> float:
        """Share of the cloth that is left over, 0 to 1."""
        used = sum(shapely.Polygon(item.piece.cut.outline).area for item in self.laid)
        return 1.0 - used / (self.width * self.length)


def nest(
    pieces: Sequence[Piece], width: float, *, seconds: int = 10, seed: int = 0, one_way: bool = False
) -> Marker:
    """Nests pieces by their true outlines; what comes back is checked to have no overlap.

    The search (spyrrow, which binds the packer "sparrow") takes the time it is given on one core. The same
    seed gives the same search; a faster machine gets further in it.

    Args:
        pieces: What to cut; each as often as it is needed.
        width: Of the cloth, cm.
        seconds: Time for the search.
        seed: Of the search.
        one_way: Whether all pieces point the same way, for cloth with nap or a print; else some are turned
            by 180 degrees.

    Raises:
        InputError: The width is out of range, or a piece is wider than the cloth.
        MissingExtraError: spyrrow is not installed.
    """
    items = _items(pieces, width)
    others = [pack_boxes(pieces, width), pack_grid(pieces, width, one_way=one_way)]
    packed = min((m for m in others if m is not None), key=lambda m: m.length)
    try:
        import spyrrow
    except ImportError:
        raise MissingExtraError("spyrrow", "print", "Nesting pieces") from None
    shapes = [
        spyrrow.Item(str(k), _outline(piece, mirrored), 1, [0.0] if one_way else [0.0, 180.0])
        for k, (piece, mirrored) in enumerate(items)
    ]
    config = spyrrow.StripPackingConfig(
        early_termination=True,
        total_computation_time=seconds,
        num_workers=1,
        seed=seed,
        min_items_separation=GAP_CM,
    )
    solution = spyrrow.StripPackingInstance("marker", width, shapes).solve(config)
    laid: list[LaidPiece | None] = [None] * len(items)
    for placed in solution.placed_items:
        piece, mirrored = items[int(placed.id)]
        angle = math.radians(placed.rotation)
        turn = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
        laid[int(placed.id)] = LaidPiece(piece, mirrored, turn @ _LEFT_TURN.T, np.array(placed.translation))
    marker = _marker([item for item in laid if item is not None], width)
    usable = len(marker.laid) == len(items) and overlap(marker) < _TOUCHING_CM2
    return marker if usable and marker.length < packed.length else packed


def overlap(marker: Marker) -> float:
    """Largest area in cm2 that two pieces share, or that a piece lies beside the cloth."""
    shapes = [shapely.Polygon(item.outline) for item in marker.laid]
    cloth = shapely.box(0.0, 0.0, marker.length, marker.width)
    pairs = shapely.STRtree(shapes).query(shapes, predicate="intersects").T
    shared = [shapes[a].intersection(shapes[b]).area for a, b in pairs.tolist() if a < b]
    return max([0.0, *shared, *(float(s.difference(cloth).area) for s in shapes)])


def pack_boxes(pieces: Sequence[Piece], width: float) -> Marker:
    """Packs pieces by their bounding boxes: what nesting is compared with.

    Raises:
        InputError: The width is out of range, or a piece is wider than the cloth.
    """
    items = _items(pieces, width)
    # Across the cloth first, as the skyline fills it: boxes of (across, along).
    sizes = np.array([np.ptp(piece.cut.outline, axis=0) for piece, _ in items]) + GAP_CM
    corners, _ = skyline(sizes, width + GAP_CM)
    laid = []
    for (piece, mirrored), corner in zip(items, corners, strict=True):
        item = LaidPiece(piece, mirrored, _LEFT_TURN.T, np.zeros(2))
        low = item.outline.min(axis=0)
        laid.append(LaidPiece(piece, mirrored, _LEFT_TURN.T, corner[::-1] - low))
    return _marker(laid, width)


def estimate_length(pieces: Sequence[Piece], width: float) -> float:
    """A length of cloth in cm, in whole 5 cm, that is enough for all pieces; the same every time.

    They are packed by their outlines on a coarse grid, at once; `nest` searches for less.

    Raises:
        InputError: The width is out of range, or a piece is wider than the cloth.
    """
    boxes, grid = pack_boxes(pieces, width), pack_grid(pieces, width)
    length = boxes.length if grid is None else min(boxes.length, grid.length)
    return 5.0 * math.ceil(length / 5.0)


def pack_grid(pieces: Sequence[Piece], width: float, *, one_way: bool = False) -> Marker | None:
    """Packs pieces by their outlines on a coarse grid, at once and the same every time.

    Returns:
        The marker; None where there is too much cloth to try.

    Raises:
        InputError: The width is out of range, or a piece is wider than the cloth.
    """
    items = _items(pieces, width)
    shapes = [shapely.Polygon(p.cut.outline * (-1.0 if mirrored else 1.0, 1.0)) for p, mirrored in items]
    height = sum(s.bounds[3] - s.bounds[1] + 2.0 for s in shapes)
    packed = pack_closely(shapes, width, height, turns=1 if one_way else 2)
    if packed is None:
        return None
    down = _LEFT_TURN.T  # what lies across the cloth from the left comes to lie from the top
    laid = [
        LaidPiece(piece, mirrored, down @ turn, down @ shift + np.array([0.0, width]))
        for (piece, mirrored), (turn, shift) in zip(items, packed, strict=True)
    ]
    return _marker(laid, width)


def require_width(width: float) -> None:
    """Refuses cloth that nobody weaves.

    Raises:
        InputError: It is too narrow or too wide, or not a number.
    """
    if not MIN_WIDTH_CM <= width <= MAX_WIDTH_CM:
        raise InputError(
            f"The cloth is {width:g} cm wide; from {MIN_WIDTH_CM:g} to {MAX_WIDTH_CM:g} cm is accepted. "
            "Usual are 110, 140 and 150."
        )


def _items(pieces: Sequence[Piece], width: float) -> list[tuple[Piece, bool]]:
    require_width(width)
    for piece in pieces:
        across = float(np.ptp(piece.box[:, 0]))
        if across > width - 2e-3:
            raise InputError(
                f"'{piece.name}' is {across:.1f} cm across the grain, wider than the cloth ({width:g} cm). "
                "Take wider cloth, or divide the panel."
            )
    items = [
        (p, mirrored) for p in pieces for mirrored in (False,) * len(p.panels) + (True,) * len(p.mirrored)
    ]
    if len(items) > MOST_PIECES:
        raise InputError(f"The pattern has {len(items)} pieces to cut; at most {MOST_PIECES} are nested.")
    return items


def _marker(laid: Sequence[LaidPiece], width: float) -> Marker:
    """Starts the cloth where the first piece starts."""
    low = min(float(item.outline[:, 0].min()) for item in laid)
    start = np.array([low, 0.0])
    moved = tuple(LaidPiece(i.piece, i.mirrored, i.turn, i.shift - start) for i in laid)
    return Marker(moved, width, max(float(i.outline[:, 0].max()) for i in moved))


def _outline(piece: Piece, mirrored: bool) -> list[tuple[float, float]]:
    """The cut line as the packer takes it: grain along x, few corners, never inside the true line."""
    points = piece.cut.outline * np.array([-1.0 if mirrored else 1.0, 1.0]) @ _LEFT_TURN
    shape = shapely.Polygon(points).simplify(_SIMPLER_CM)
    if not isinstance(shape, shapely.Polygon) or not shape.is_valid:
        shape = shapely.Polygon(points)
    return [(float(x), float(y)) for x, y in shapely.get_coordinates(shape.exterior)]

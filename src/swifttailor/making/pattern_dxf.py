"""DXF of cutting rooms: ASTM D6673-10, or the older AAMA header that some programs ask for.

A block for each piece, inserted once; millimetres; the grain lies along x, as cutters lay cloth. The file is
written group by group, since general DXF writers add blocks of their own that some cutting rooms' readers
refuse.
"""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import numpy as np
import shapely

from swifttailor.arrays import Floats
from swifttailor.atomic_files import write_bytes
from swifttailor.making.dxf_text import DxfText, block_names
from swifttailor.making.piece import Piece
from swifttailor.making.pieces import CuttingPlan
from swifttailor.making.size_run import NestedPiece, SizeRun
from swifttailor.making.trim_marks import TrimMark

Dialect = Literal["astm", "aama"]
CUT, TURN_POINT, CURVE_POINT, SLIT_NOTCH, GRAIN, INTERNAL, DRILL_HOLE, SEW, ANNOTATION = (
    1,
    2,
    3,
    4,
    7,
    8,
    13,
    14,
    15,
)
VALIDATION = {CUT: 84, INTERNAL: 85, SEW: 87}
"""Each line once more, for readers to check their curves against."""
NOTCH_DEPTH_MM = 5.0
_MM = 10.0
_SIMPLER_CM = 0.001
_CORNER_DEGREES = 12.0
_DRILL_BEFORE_CM = 1.0
"""Holes are drilled this far before the point of a dart, so that the seam hides them."""
_TEETH_APART_CM = 0.5
_GAP_MM = 50.0
_ALONG_X = np.array([[0.0, 1.0], [-1.0, 0.0]])
"""Turns the grain from y to x."""


def write_dxf(
    plan: CuttingPlan | SizeRun,
    path: Path | str,
    *,
    dialect: Dialect = "astm",
    seam_names: bool = False,
    overwrite: bool = False,
) -> Path:
    """Writes all pieces as DXF.

    Args:
        plan: The pieces; of several sizes each has blocks of its own, inserted over the others' on a layer
            ``SIZE_36``.
        path: File to write.
        dialect: Which standard's header.
        seam_names: Whether every sewn edge is labelled with the number of its seam.
        overwrite: Whether another file of that name is replaced.

    Raises:
        InputError: The file cannot be written.
    """
    return write_bytes(
        path, dxf_text(plan, dialect=dialect, seam_names=seam_names).encode("ascii"), overwrite=overwrite
    )


def dxf_text(plan: CuttingPlan | SizeRun, *, dialect: Dialect = "astm", seam_names: bool = False) -> str:
    """The content of the file that `write_dxf` writes."""
    dxf = DxfText()
    if dialect == "aama":
        dxf.add(999, "ANSI/AAMA")
    _section(dxf, "HEADER")
    dxf.add(9, "$ACADVER")
    dxf.add(1, "AC1009")
    dxf.start("ENDSEC")
    groups = _nests(plan)
    pieces = [piece for nested in groups for piece in nested.pieces]
    names = block_names(f"{p.name} {p.size}" for p in pieces)
    _section(dxf, "BLOCKS")
    for name, piece in zip(names, pieces, strict=True):
        dxf.start("BLOCK", CUT)
        dxf.add(2, name)
        dxf.add(70, "0")
        dxf.add(10, 0.0)
        dxf.add(20, 0.0)
        dxf.add(30, 0.0)
        _piece(dxf, piece, dialect, seam_names)
        dxf.start("ENDBLK", CUT)
    dxf.start("ENDSEC")
    _section(dxf, "ENTITIES")
    x, left = 0.0, iter(names)
    for nested in groups:
        boxes = [
            _box(piece) + on_table(shift) for piece, shift in zip(nested.pieces, nested.shifts, strict=True)
        ]
        low, high = np.min([b[0] for b in boxes], axis=0), np.max([b[1] for b in boxes], axis=0)
        for piece, shift in zip(nested.pieces, nested.shifts, strict=True):
            place = on_table(shift) - low
            dxf.start("INSERT", f"SIZE_{piece.size}" if piece.size else CUT)
            dxf.add(2, next(left))
            dxf.add(10, float(x + place[0]))
            dxf.add(20, float(place[1]))
            dxf.add(30, 0.0)
        x += float(high[0] - low[0]) + _GAP_MM
    for k, line in enumerate(_style_texts(plan, dialect)):
        dxf.text(CUT, line, np.array([0.0, -20.0 - 10.0 * k]))
    dxf.start("ENDSEC")
    dxf.start("EOF")
    return dxf.content()


def on_table(points: Floats) -> Floats:
    """Points (n, 2) of a piece in cm, as they stand in the file: millimetres, grain along x."""
    return np.asarray(points) @ _ALONG_X.T * _MM


def _nests(plan: CuttingPlan | SizeRun) -> tuple[NestedPiece, ...]:
    if isinstance(plan, SizeRun):
        return plan.nested
    return tuple(NestedPiece((piece,), (np.zeros(2),)) for piece in plan.pieces)


def _style_texts(plan: CuttingPlan | SizeRun, dialect: Dialect) -> list[str]:
    from swifttailor import __version__

    size = plan.sizes[plan.base] if isinstance(plan, SizeRun) else plan.pieces[0].size
    # Files contain no dates, so that the same pattern gives the same file.
    lines = [
        f"Style Name:{plan.name}",
        "Creation Date:",
        "Creation Time:",
        f"Author:SwiftTailor {__version__}",
        f"Sample Size:{size or 'ONE'}",
        "Grade Rule Table:",
        "Units:METRIC",
        "Curve Tolerance:0.05",
    ]
    if dialect == "aama":
        return [line.split(":")[0].upper() + ":" + line.split(":", 1)[1] for line in lines] + [
            "ANSI/AAMA VERSION:292-B"
        ]
    return [*lines, "ASTM/D13Proposal 1 Version:D6673-10"]


def _piece(dxf: DxfText, piece: Piece, dialect: Dialect, seam_names: bool) -> None:
    cut, sew = simpler(piece.cut.outline), simpler(piece.sew_line)
    plain, mirrored = (piece.count, 0) if piece.symmetric else (len(piece.panels), len(piece.mirrored))
    texts = [
        f"Piece Name:{piece.name}",
        f"Quantity:{plain},{mirrored}",
        "Material:SHELL",
        f"Size:{piece.size or 'ONE'}",
        f"Annotation:{piece.instruction}",
    ]
    middle = on_table(piece.grain.mean(axis=0))
    for k, text in enumerate(texts):
        layer = ANNOTATION if text.startswith("Annotation") else CUT
        dxf.text(layer, text, middle + np.array([0.0, -10.0 - 8.0 * k]))
    _curve(dxf, CUT, cut, dialect, closed=True)
    _curve(dxf, SEW, sew, dialect, closed=True)
    for dart in piece.darts:
        for leg in dart.legs:
            _curve(dxf, INTERNAL, leg, dialect, closed=False)
        tip, mouth = dart.legs[0][-1], (dart.legs[0][0] + dart.legs[1][0]) / 2
        step = (mouth - tip) / max(float(np.hypot(*(mouth - tip))), 1e-9)
        dxf.point(DRILL_HOLE, on_table(tip + _DRILL_BEFORE_CM * step))
    for mark in piece.marks:
        _trim(dxf, mark, dialect)
    for mark in piece.edge_marks:
        dxf.text(ANNOTATION, mark.text, on_table(mark.points[len(mark.points) // 2]))
    if seam_names:
        for mark in piece.seam_marks:
            for k, number in enumerate(mark.numbers):
                dxf.text(ANNOTATION, f"Seam {number}", on_table(mark.point + 0.6 * (k + 1) * mark.inward))
    ring = shapely.LinearRing(piece.cut.outline)
    for notch in piece.notches:
        along = np.array([-notch.outward[1], notch.outward[0]])
        for offset in (0.0,) if notch.teeth == 1 else (-_TEETH_APART_CM / 2, _TEETH_APART_CM / 2):
            sought = notch.point + notch.depth * notch.outward + offset * along
            at = shapely.get_coordinates(ring.interpolate(ring.project(shapely.Point(sought))))[0]
            inward = on_table(-notch.outward)
            angle = float(np.degrees(np.arctan2(inward[1], inward[0]))) % 360.0
            dxf.point(SLIT_NOTCH, on_table(at), depth=NOTCH_DEPTH_MM, angle=angle)
    dxf.line(GRAIN, *on_table(piece.grain))


def _trim(dxf: DxfText, mark: TrimMark, dialect: Dialect) -> None:
    """Outlines, lines and buttonholes among the inner lines; buttons as drill holes, all with their words."""
    if mark.kind in ("outline", "line"):
        _curve(dxf, INTERNAL, mark.points, dialect, closed=mark.kind == "outline")
    if mark.kind == "button":
        dxf.point(DRILL_HOLE, on_table(mark.points[0]))
    if mark.hole is not None:
        _curve(dxf, INTERNAL, mark.hole, dialect, closed=False)
    if mark.words:
        dxf.text(ANNOTATION, mark.words, on_table(mark.points[len(mark.points) // 2]), size=3.0)


def simpler(points: Floats) -> Floats:
    """A closed polyline (n, 2) with fewer points, a hundredth of a millimetre away at most."""
    ring = shapely.LinearRing(points)
    return shapely.get_coordinates(shapely.simplify(ring, _SIMPLER_CM))[:-1]


def _curve(dxf: DxfText, layer: int, points: Floats, dialect: Dialect, *, closed: bool) -> None:
    """A line, its key points, and in ASTM files the line once more for validation."""
    placed = on_table(points)
    dxf.polyline(layer, placed, closed=closed)
    if dialect == "astm":
        dxf.polyline(VALIDATION[layer], placed, closed=closed)
    if layer != CUT:
        return
    coming = placed - np.roll(placed, 1, axis=0)
    going = np.roll(placed, -1, axis=0) - placed
    turn = np.arctan2(coming[:, 0] * going[:, 1] - coming[:, 1] * going[:, 0], (coming * going).sum(axis=1))
    for point, angle in zip(placed, np.abs(np.degrees(turn)), strict=True):
        dxf.point(TURN_POINT if angle > _CORNER_DEGREES else CURVE_POINT, point)


def _box(piece: Piece) -> Floats:
    """(2, 2) lowest and highest corner, mm."""
    placed = on_table(piece.cut.outline)
    return np.array([placed.min(axis=0), placed.max(axis=0)])


def _section(dxf: DxfText, name: str) -> None:
    dxf.start("SECTION")
    dxf.add(2, name)

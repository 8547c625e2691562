"""Where pockets, buttons, zips and openings are marked on the pieces that they are put on."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
import shapely
from numpy.typing import ArrayLike

from swifttailor.arrays import Floats
from swifttailor.making.closings import DOUBLE, SINGLE, Closing
from swifttailor.making.cut_line import Run
from swifttailor.making.sewn_pattern import FlatPanel, SewnPattern
from swifttailor.making.trim_words import is_flap, words_of
from swifttailor.making.twins import Match
from swifttailor.pattern.trims import Button, Patch, Trim
from swifttailor.pattern.trims.front_view import FrontView, edge_at

MarkKind = Literal["outline", "line", "button", "hole"]
HOLE_EASE_CM = 0.3
"""A buttonhole is so much longer than its button is wide, and begins so far beyond the middle."""
_SAME_CM = 0.06
"""Marks of twins that lie this close to each other are drawn once."""
_ROWS = (*SINGLE, "button placket", "polo placket", "waist placket")
_MIDDLE_CM = 0.5


@dataclass(frozen=True, eq=False)
class TrimMark:
    """One mark on a piece."""

    trim: str
    kind: MarkKind
    points: Floats
    """(n, 2) of the piece, cm: an outline, its first point not repeated; a line; the middle of a button."""
    words: str
    """What is printed beside it; may be empty."""
    panels: tuple[str, ...]
    """Of those that are cut from the piece, the ones that it is on."""
    side: str
    """Of the wearer: ``left``, ``right`` or ``middle``."""
    radius: float = 0.0
    """Of a button, cm."""
    hole: Floats | None = None
    """(2, 2) ends of the buttonhole, cm."""

    def moved(self, sign: float, shift: ArrayLike) -> TrimMark:
        """The mark with x times `sign`, then shifted by (2,) cm."""
        scale = np.array([sign, 1.0])
        hole = None if self.hole is None else self.hole * scale + np.asarray(shift)
        return replace(self, points=self.points * scale + np.asarray(shift), hole=hole)

    def lies_on(self, other: TrimMark) -> bool:
        """Whether both are one mark on the paper."""
        if self.kind != other.kind or self.trim != other.trim or self.words != other.words:
            return False
        return float(shapely.hausdorff_distance(self._shape, other._shape)) <= _SAME_CM

    @property
    def _shape(self) -> shapely.Geometry:
        if self.kind in ("button", "hole"):
            return shapely.Point(self.points[0])
        return (shapely.LinearRing if self.kind == "outline" else shapely.LineString)(self.points)


def panel_marks(
    sewn: SewnPattern, trims: Sequence[Trim], closing: Closing | None
) -> dict[str, tuple[TrimMark, ...]]:
    """The marks of every panel, as it lies flat.

    Args:
        sewn: The panels.
        trims: Where trims lie on them, panel-local.
        closing: How the front closes.
    """
    found: dict[str, list[TrimMark]] = {panel.name: [] for panel in sewn.panels}
    for trim in trims:
        if isinstance(trim, Patch):
            found[trim.panel].append(_patch_mark(sewn, trim, trims))
        elif isinstance(trim, Button):
            for mark in _button_marks(sewn, trim, trims, closing):
                found[mark.panels[0]].append(mark)
    if closing is not None:
        for name in sorted(closing.panels):
            found[name] += _front_lines(sewn, name, closing)
        band = next((p for p in sewn.pattern.panels if p.name == "wb_front"), None)
        column = None if band is None else FrontView(band).column(0.0)
        if band is not None and column is not None:
            line = FrontView(band).local([(0.0, y) for y in column])
            found[band.name].append(_mark(sewn, closing.trim, "line", band.name, line, "cut open here"))
    return {name: tuple(marks) for name, marks in found.items()}


def piece_marks(
    sewn: SewnPattern, group: Sequence[tuple[str, Match]], marks: Mapping[str, Sequence[TrimMark]]
) -> tuple[TrimMark, ...]:
    """The marks of a piece: those of all panels that are cut from it, each place once.

    Args:
        sewn: The panels.
        group: Panels that are cut from the piece, the first as it is drawn, with how they lie on it.
        marks: As `panel_marks` gives them.
    """
    drawn = _middle(sewn.panel(group[0][0]))
    found: list[TrimMark] = []
    for name, match in group:
        sign = -1.0 if match.mirrored else 1.0
        shift = drawn - _middle(sewn.panel(name)) * (sign, 1.0)
        for mark in marks[name]:
            carried = mark if name == group[0][0] else mark.moved(sign, shift)
            same = next((k for k, other in enumerate(found) if carried.lies_on(other)), None)
            if same is None:
                found.append(carried)
            else:
                found[same] = replace(found[same], panels=(*found[same].panels, name))
    names = [name for name, _ in group]
    return tuple([replace(mark, words=_with_only(sewn, mark, names)) for mark in found])


def on_half(marks: Sequence[TrimMark], middle: float) -> list[TrimMark]:
    """Marks of a piece that is drawn as its right half: those of the left half are turned over onto it.

    What is on one side alone says so.
    """
    found: list[tuple[TrimMark, set[str]]] = []
    for mark in marks:
        own = float(mark.points[:, 0].mean())
        turned = mark.moved(-1.0, (2 * middle, 0.0)) if own < middle - 1e-6 else mark
        for other, sides in found:
            if turned.lies_on(other):
                sides.add(mark.side)
                break
        else:
            found.append((turned, {mark.side}))
    shown = []
    for mark, sides in found:
        alone = len(sides) == 1 and mark.side != "middle" and _can_be_alone(mark, middle)
        shown.append(replace(mark, words=_joined(mark.words, f"{mark.side} only")) if alone else mark)
    return shown


def _can_be_alone(mark: TrimMark, middle: float) -> bool:
    return bool(mark.words) and abs(float(mark.points[:, 0].mean()) - middle) > _MIDDLE_CM


def _joined(words: str, more: str) -> str:
    return f"{words}, {more}" if words and more and more not in words else words


def _with_only(sewn: SewnPattern, mark: TrimMark, group: Sequence[str]) -> str:
    """The words of a mark, with the panels that it is on where it is not on all of its piece's."""
    if set(mark.panels) == set(group):
        return mark.words
    placed, own = ([sewn.panel(name).placed for name in names] for names in (group, mark.panels))
    words = []
    faces = {p.face for p in own}
    if len(faces) == 1 and len({p.face for p in placed}) > 1:
        words += faces
    sides = {p.side for p in own}
    if len(sides) == 1 and len({p.side for p in placed if p.face in faces}) > 1:
        words += sides
    return _joined(mark.words, f"{' '.join(words)} only") if words else mark.words


def _mark(
    sewn: SewnPattern,
    trim: str,
    kind: MarkKind,
    name: str,
    points: Floats,
    words: str,
    radius: float = 0.0,
    hole: Floats | None = None,
) -> TrimMark:
    """A mark of panel-local points; the hole is of the flat panel."""
    x = float(sewn.pattern.panel(name).to_world(points)[:, 0].mean())
    side = "middle" if abs(x) < _MIDDLE_CM else "left" if x > 0 else "right"
    flat = np.asarray(points) @ sewn.panel(name).turn.T
    return TrimMark(trim, kind, flat, words, (name,), side, radius, hole)


def _patch_mark(sewn: SewnPattern, patch: Patch, trims: Sequence[Trim]) -> TrimMark:
    words = words_of(patch, is_flap=is_flap(patch, trims))
    if patch.look == "dark":  # drawn with a width, for the eye
        return _mark(sewn, patch.trim, "line", patch.panel, (patch.first + patch.second) / 2, words)
    return _mark(sewn, patch.trim, "outline", patch.panel, patch.outline, words)


def _button_marks(
    sewn: SewnPattern, button: Button, trims: Sequence[Trim], closing: Closing | None
) -> list[TrimMark]:
    """The button, and where the other front has its like or its buttonhole."""
    at = np.array([button.at])
    seen = FrontView(sewn.pattern.panel(button.panel)).seen(at)
    fronts = () if closing is None or button.panel not in closing.panels else tuple(sorted(closing.panels))
    if button.trim == DOUBLE and fronts:
        marks = [_mark(sewn, DOUBLE, "button", button.panel, at, "button", button.radius)]
        # The upper front's edge lies above the other front: its holes meet the row beyond the middle.
        for name in fronts:
            view = FrontView(sewn.pattern.panel(name))
            if name != button.panel:
                own = view.local(seen - (2 * _middle_x(sewn, closing, button.panel, seen[0, 1]), 0.0))
                hole = _hole(sewn, name, own, button.radius, upright=False)
                words = "buttonhole, upper front"
                marks.append(_mark(sewn, DOUBLE, "hole", name, own, words, button.radius, hole))
        return marks
    if button.trim not in _ROWS:
        words = "button" if button.trim == "fly" else ""
        return [_mark(sewn, button.trim, "button", button.panel, at, words, button.radius)]
    banded = any(isinstance(t, Patch) and t.trim == button.trim and t.panel == button.panel for t in trims)
    marks = []
    for name in fronts or _halves(sewn, button):
        # Fronts that were recut need not meet where they are placed, but are each other's mirror image.
        turned = seen if name == button.panel else seen * (-1.0, 1.0)
        own = FrontView(sewn.pattern.panel(name)).local(turned)
        hole = _hole(sewn, name, own, button.radius, upright=banded)
        words = "button; upper front: buttonhole"
        marks.append(_mark(sewn, button.trim, "button", name, own, words, button.radius, hole))
    return marks


def _middle_x(sewn: SewnPattern, closing: Closing | None, name: str, y: float) -> float:
    """Where a front ends in the middle of the body at a height, cm."""
    refs = [] if closing is None else [ref for ref in closing.edges if ref.panel == name]
    if not refs:
        return 0.0
    ends = FrontView(sewn.pattern.panel(name))
    heights = [abs(float(ends.seen(sewn.pattern.panel(name).chord(r.edge))[:, 1].mean()) - y) for r in refs]
    return edge_at(sewn.pattern, refs[int(np.argmin(heights))], y)


def _halves(sewn: SewnPattern, button: Button) -> tuple[str, ...]:
    """The fronts that a row in the middle is on, where their seam is closed below it."""
    names = {"left_ftorso", "right_ftorso"}
    is_half = button.panel in names and names <= {panel.name for panel in sewn.panels}
    return tuple(sorted(names)) if is_half else (button.panel,)


def _hole(sewn: SewnPattern, name: str, at: Floats, radius: float, *, upright: bool) -> Floats:
    """Ends (2, 2) of a buttonhole on a flat panel, for a button at panel-local (1, 2)."""
    panel = sewn.panel(name)
    x, y = (at @ panel.turn.T)[0]
    length = 2 * radius + HOLE_EASE_CM
    if upright:
        return np.array([[x, y - length / 2], [x, y + length / 2]])
    edge = np.sign(x - _middle(panel)[0]) or 1.0  # the front's edge is the side it is nearer to
    return np.array([[x + edge * HOLE_EASE_CM, y], [x + edge * (HOLE_EASE_CM - length), y]])


def _front_lines(sewn: SewnPattern, name: str, closing: Closing) -> list[TrimMark]:
    """The middle of a front that laps, and its edge."""
    if closing.extension <= 0:
        return []
    panel, marks = sewn.panel(name), []
    side = panel.placed.side
    for ref in sorted(closing.edges, key=lambda ref: ref.edge):
        if ref.panel != name:
            continue
        line = panel.edges[ref.edge]
        step = np.diff(line[[0, -1]], axis=0)[0]
        out = np.array([step[1], -step[0]]) / max(float(np.hypot(*step)), 1e-9)
        marks += [
            TrimMark(closing.trim, "line", line, "centre front", (name,), side),
            TrimMark(closing.trim, "line", line + closing.extension * out, "front edge", (name,), side),
        ]
    marks += [
        TrimMark(closing.trim, "line", panel.edges[ref.edge], "not sewn here", (name,), side)
        for ref in sorted(closing.below, key=lambda ref: ref.edge)
        if ref.panel == name
    ]
    runs = [
        Run(points, kind, 0.0, k)
        for k, (points, kind) in enumerate(zip(panel.edges, panel.kinds, strict=True))
    ]
    straight = closing.straight(runs, name)
    if straight is not None:  # as far as it lies outside of what the panel covers itself
        own = shapely.Polygon(panel.outline)
        rest = shapely.difference(shapely.LineString(straight[:2]), own)
        first = min(shapely.get_parts(rest), key=lambda part: part.distance(shapely.Point(straight[0])))
        marks.append(TrimMark(closing.trim, "line", shapely.get_coordinates(first), "", (name,), side))
    return marks


def _middle(panel: FlatPanel) -> Floats:
    """(2,) of its box, on which twins are laid."""
    return (panel.outline.min(axis=0) + panel.outline.max(axis=0)) / 2

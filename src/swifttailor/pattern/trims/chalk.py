"""The panels of one pattern, with the marks that trims are made of."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.measurements import DraftMeasurements
from swifttailor.pattern.pattern import Pattern
from swifttailor.pattern.trims.front_view import FrontView, dart_tips, edge_at, front_edge
from swifttailor.pattern.trims.shapes import Button, Look, Patch, Trim

_STEP = 0.5
"""Distance of the places at which the border of a piece is looked at, cm."""
_SHORTEST = 2.0
"""Length of a line that is worth drawing, cm."""
_UNEVEN = 3.0
"""A skirt's front whose sides are so much nearer and farther from the middle is wrapped around, cm."""
LINE = 0.16
"""Half the width of a line of stitches or of an opening, as it is drawn, cm."""
_HEIGHT = DraftMeasurements().height

Point = tuple[float, float]


class Chalk:
    """Marks trims on one pattern; every method that marks something returns nothing where it has no place."""

    def __init__(self, pattern: Pattern) -> None:
        self.pattern = pattern
        tips = dart_tips(pattern)
        self.views: Mapping[str, FrontView] = {
            panel.name: view
            for panel in pattern.panels
            if (view := FrontView(panel, tips.get(panel.name, ()))).faces_front
        }
        figure = Figure.of(DraftMeasurements())
        measures = {} if pattern.drafted_for is None else dict(pattern.drafted_for.measures)
        self.size = min(max(measures.get("height", _HEIGHT) / _HEIGHT, 0.4), 1.3)
        """Of the wearer beside the default body: children have smaller pockets."""
        self.waist = self._waist_at(self.size * figure.waist_y)
        self.crotch = self.size * figure.crotch_y
        self.shoulder = self.size * figure.shoulder_line(figure.shoulder_x)
        """Height of the shoulder tips, cm."""

    def _waist_at(self, usual: float) -> float:
        """Height of the waistband or the waist seam, cm; the body's waist where there is neither."""
        band = self.views.get("wb_front")
        torso = self.views.get("left_ftorso")
        if band is not None and torso is None:
            return (band.low + band.high) / 2
        skirt = self.views.get("skirt_front")
        return torso.low if torso is not None and skirt is not None else usual

    def pocket(
        self, trim: str, panel: str, at: Point, width: float, height: float, *, point: float = 0.0
    ) -> list[Trim]:
        """A patch with its upper edge in the middle of `at`; its lower edge may come to a point, cm."""
        (x, top), low = at, at[1] - height
        xs = (x - width / 2, x, x + width / 2)
        first = [(xs[0], low + point), (xs[1], low), (xs[2], low + point)]
        found = self.ruled(trim, panel, first, [(each, top) for each in xs])
        hem = self.line(trim, panel, [(xs[0] + 0.2, top - 2), (xs[2] - 0.2, top - 2)])
        return [*found, *hem] if found and hem else []

    def flap(self, trim: str, panel: str, at: Point, width: float, height: float) -> list[Trim]:
        """What falls over a pocket, with a button."""
        x, top = at[0], at[1] + 1.0
        xs = (x - width / 2, x, x + width / 2)
        first = [(xs[0], top - height + 1), (xs[1], top - height), (xs[2], top - height + 1)]
        pieces = self.ruled(trim, panel, first, [(each, top) for each in xs])
        button = self.button(trim, panel, (x, top - height + 1.4), 0.6 * self.size)
        return [*pieces, *button] if pieces and button else []

    def ruled(
        self,
        trim: str,
        panel: str,
        first: Sequence[Point],
        second: Sequence[Point],
        look: Look = "cloth",
        *,
        is_cut: bool = True,
        to_the_edge: bool = False,
    ) -> list[Trim]:
        """A piece between two lines of the view, with as many points each, a little inside of its panel.

        With `to_the_edge` it may end where the panel does.
        """
        view = self.views[panel]
        ends = [np.array(line, float) for line in (first, second)]
        border = _border(*ends)
        held = view.holds(np.concatenate(ends)) and view.bridges(border) and view.carries(border)
        if not (to_the_edge or held):
            return []
        return [Patch(trim, panel, view.local(ends[0]), view.local(ends[1]), look, is_cut)]

    def line(self, trim: str, panel: str, points: Sequence[Point], width: float = LINE) -> list[Trim]:
        """A line of stitches, an opening or a cord along points of the view."""
        line = np.array(points, float)
        if len(line) < 2 or np.linalg.norm(np.diff(line, axis=0), axis=1).sum() < _SHORTEST:
            return []
        along = np.gradient(line, axis=0)
        across = np.stack([-along[:, 1], along[:, 0]], axis=1)
        lengths = np.linalg.norm(across, axis=1, keepdims=True)
        if lengths.min() < 1e-6:
            return []
        across *= width / lengths
        view = self.views[panel]
        if not view.holds(line) or not view.bridges(_border(line + across, line - across)):
            return []
        sides = (view.local(line + across), view.local(line - across))
        return [Patch(trim, panel, sides[0], sides[1], "dark", is_cut=False)]

    def button(self, trim: str, panel: str, at: Point, radius: float) -> list[Trim]:
        """A button at a point of the view, its radius in cm."""
        view = self.views[panel]
        if not view.holds([at]):
            return []
        x, y = view.local([at])[0]
        return [Button(trim, panel, (float(x), float(y)), radius)]

    def beside_side_seam(self, trim: str, below: float, length: float, *, both: bool) -> list[Trim]:
        """A line along the left side seam or both, from so far below the waist on, cm."""
        pieces: list[Trim] = []
        for side, sign in (("left", 1), ("right", -1))[: 2 if both else 1]:
            names = ("skirt_front", f"pant_f_{side[0]}", f"{side}_ftorso")
            view = next((self.views[name] for name in names if name in self.views), None)
            if view is None:
                return []
            top = min(view.high, self.waist) - below * self.size
            if both and not self.is_even(view, top):
                return []
            heights = np.linspace(top, top - length * self.size, 5)
            outer = [self.outer(view, y, sign) for y in heights]
            if any(x is None for x in outer):
                return []
            line = [(x - sign * 0.8, float(y)) for x, y in zip(outer, heights, strict=True) if x is not None]
            found = self.line(trim, view.panel.name, line, width=0.25)
            if not found:
                return []
            pieces += found
        return pieces

    def is_even(self, view: FrontView, y: float) -> bool:
        """Whether a panel of one half reaches a height, or one of both as far on the left as on the right."""
        span = view.span(y)
        return span is not None and (span[0] * span[1] >= 0 or abs(span[0] + span[1]) <= _UNEVEN)

    def outer(self, view: FrontView, y: float, sign: int) -> float | None:
        """The x of a panel's outer side at a height; None where it does not reach it."""
        span = view.span(y)
        return None if span is None else (span[1] if sign > 0 else span[0])

    def middle(self, sign: int, y: float) -> float:
        """The x of the left (1) or right (-1) front's edge in the middle at a height, cm."""
        seam = front_edge(self.pattern)
        return 0.0 if seam is None else edge_at(self.pattern, seam[1 if sign > 0 else 0], y)

    def top_at(self, view: FrontView, x: float) -> float:
        """The greatest height of a panel at distance `x` from the middle."""
        column = view.column(x)
        return view.high if column is None else column[1]

    def height_within(self, view: FrontView, x: float, top: float, bottom: float) -> float:
        """The greatest height up to `top` at which a panel covers `x`, to half a cm."""
        for y in np.arange(top, bottom, -0.5):
            if view.holds([(x, y)]):
                return float(y)
        return bottom + 1.0


def _border(first: Floats, second: Floats) -> Floats:
    """Places (m, 2) all around a piece between two lines (n, 2), `_STEP` apart at most."""
    ring = np.concatenate([first, second[::-1], first[:1]])
    lengths = np.linalg.norm(np.diff(ring, axis=0), axis=1)
    parts = [
        np.linspace(a, b, max(int(np.ceil(length / _STEP)), 1), endpoint=False)
        for a, b, length in zip(ring[:-1], ring[1:], lengths, strict=True)
    ]
    return np.concatenate(parts)

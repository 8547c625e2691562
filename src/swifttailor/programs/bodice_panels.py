"""Quarters of an upper garment before sleeve and collar are cut out: fitted with darts, or straight."""

from __future__ import annotations

import math

from swifttailor.programs.body_parameters import BodyParameters
from swifttailor.programs.curved_edges import curve_from_tangents
from swifttailor.programs.design import Design
from swifttailor.programs.edge_sequence import EdgeSequence
from swifttailor.programs.edge_shapes import dart_shape, from_verts
from swifttailor.programs.interface import Interface
from swifttailor.programs.panel import Panel

_SMALL_DIFFERENCE_CM = 4
"""The back takes cloth from its sides only if waist and back differ by more than this."""


class BaseBodicePanel(Panel):
    """The right front or back of an upper garment.

    Interfaces: ``outside`` (the side), ``inside`` (the middle), ``shoulder``, ``bottom``, and the corners out
    of which sleeve and collar are cut, ``shoulder_corner`` and ``collar_corner``.
    """

    def __init__(self, name: str, body: BodyParameters) -> None:
        """Keeps the body; the outline is drafted by the subclass."""
        super().__init__(name)
        self.body = body
        self.width = 0.0

    def get_width(self, level: float) -> float:
        """Width without darts, cm, at a level in cm below the shoulder."""
        side = self.interfaces["outside"].edges[-1]
        across, up = side.end[0] - side.start[0], side.end[1] - side.start[1]
        return level * across / up + self.body["shoulder_w"] / 2

    def _set_interfaces(
        self, outside: EdgeSequence, bottom: EdgeSequence, bottom_ruffle: float = 1.0
    ) -> None:
        side, shoulder, inside = self.edges[-3], self.edges[-2], self.edges[-1]
        self.interfaces = {
            "outside": Interface(self, outside),
            "inside": Interface(self, inside),
            "shoulder": Interface(self, shoulder),
            "bottom": Interface(self, bottom, ruffle=bottom_ruffle),
            "shoulder_corner": Interface(self, EdgeSequence(side, shoulder)),
            "collar_corner": Interface(self, EdgeSequence(shoulder, inside)),
        }

    def _hang(self, height: float) -> None:
        """Puts the top of the middle, `height` cm over the hem, at the base of the neck."""
        self.translate_by([0.0, self.body["height"] - self.body["head_l"] - height, 0.0])


class BodiceFrontHalf(BaseBodicePanel):
    """Front of the fitted bodice, with a dart at the side and one at the waist."""

    def __init__(self, name: str, body: BodyParameters, design: Design) -> None:
        """Drafts the panel; the design has no part in it."""
        super().__init__(name, body)
        bust_point = body["bust_points"] / 2
        front_frac = (body["bust"] - body["back_width"]) / 2 / body["bust"]
        self.width = front_frac * body["bust"]
        waist = (body["waist"] - body["waist_back_width"]) / 2
        slope = _shoulder_slope(body)
        shoulder_incl = slope * self.width
        bottom_d_width = (self.width - waist) * 2 / 3

        # The side is as long as that of the back; what the front has more goes into the side dart.
        max_len = body["waist_over_bust_line"] - slope * (self.width - body["shoulder_w"] / 2)
        fb_diff = (front_frac - (0.5 - front_frac)) * body["bust"]
        back_adjustment = slope * (body["back_width"] / 2 - body["shoulder_w"] / 2)
        side_len = body["waist_line"] - back_adjustment - slope * fb_diff

        self.edges = from_verts(
            [0.0, 0.0], [-self.width, 0.0], [-self.width, max_len], [0.0, max_len + shoulder_incl], loop=True
        )
        bust_line = body["waist_line"] - body["_bust_line"]
        side_d_width = max_len - side_len
        side_d_depth = 0.75 * (self.width - bust_point)
        side, outside = self.add_dart(
            dart_shape(side_d_width, side_d_depth), self.edges[1], offset=bust_line + side_d_width / 2
        )
        self.edges.substitute(1, side)
        narrower = self.width - body["shoulder_w"] / 2
        top = side[-1].end
        top[:] = [top[0] + narrower, top[1] + slope * narrower]

        hem, bottom = self.add_dart(
            dart_shape(bottom_d_width, 0.9 * bust_line), self.edges[0], offset=bust_point + bottom_d_width / 2
        )
        self.edges.substitute(0, hem)
        hem[-1].end[0] = -(waist + bottom_d_width)
        self._set_interfaces(outside, bottom)
        self._hang(max_len + shoulder_incl)


class BodiceBackHalf(BaseBodicePanel):
    """Back of the fitted bodice, with two darts at the waist where it is narrower than the back."""

    def __init__(self, name: str, body: BodyParameters, design: Design) -> None:
        """Drafts the panel; the design has no part in it."""
        super().__init__(name, body)
        self.width = body["back_width"] / 2
        waist = body["waist_back_width"] / 2
        waist_width = max(waist, self.width)
        slope = _shoulder_slope(body)
        shoulder_incl = slope * self.width
        length = body["waist_line"] - slope * (self.width - body["shoulder_w"] / 2)

        # The middle of the back is a little shorter.
        hem = curve_from_tangents([0.0, shoulder_incl / 4], [-waist_width, 0.0], target_tan0=[-1.0, 0.0])
        self.edges = EdgeSequence(
            hem,
            from_verts(
                hem.end,
                [-self.width, body["waist_line"] - body["_bust_line"]],
                [-self.width, length],
                [0.0, length + shoulder_incl],
            ),
        ).close_loop()
        self._set_interfaces(self.edges[1:3], self.edges[0:1])
        if waist < self.width:
            self._add_waist_darts(waist_width - waist, length)
        self._hang(length + shoulder_incl)

    def get_width(self, level: float) -> float:
        """Width, cm, the same at all levels."""
        return self.width

    def _add_waist_darts(self, surplus: float, length: float) -> None:
        from_side = 0.0 if surplus < _SMALL_DIFFERENCE_CM else surplus / 6
        width = (surplus - from_side) / 2
        depth = length - self.body["_bust_line"]
        place = self.body["bum_points"] / 2
        apart = place * 0.5
        hem, bottom = self.add_dart(
            dart_shape(width, 0.9 * depth), self.edges[0], offset=place + apart / 2 + width + width / 2
        )
        hem, bottom = self.add_dart(
            dart_shape(width, depth),
            hem[0],
            offset=place - apart / 2 + width / 2,
            edge_seq=hem,
            int_edge_seq=bottom,
        )
        self.edges.substitute(0, hem)
        self.interfaces["bottom"] = Interface(self, bottom)
        hem[-1].end[0] += from_side


class TorsoHalfPanel(BaseBodicePanel):
    """Front or back of a straight upper garment, as wide as the bust asks for."""

    def __init__(
        self, name: str, body: BodyParameters, design: Design, bust: float, waist: float, shorter: float = 0.0
    ) -> None:
        """Drafts the panel.

        Args:
            name: Name of the panel.
            body: The body.
            design: Its parameters ``shirt.width``, ``shirt.flare`` and ``shirt.length`` are used.
            bust: The part of the bust's girth that the panel covers, cm.
            waist: The same of the waist, to which what hangs below is gathered.
            shorter: What the side loses to the slope of the shoulder, cm.
        """
        super().__init__(name, body)
        self.width = design["shirt.width"] * bust
        length = design["shirt.length"] * body["waist_line"] - shorter
        top = length + _shoulder_slope(body) * self.width
        hem_width = design["shirt.flare"] * self.width
        self.edges = from_verts([0.0, 0.0], [-hem_width, 0.0], [-self.width, length], [0.0, top], loop=True)
        self._set_interfaces(self.edges[1:2], self.edges[0:1], self.edges[0].length() / waist)
        self._hang(top)

    def get_width(self, level: float) -> float:
        """Width, cm, at a level in cm below the shoulder."""
        return super().get_width(level) + self.width - self.body["shoulder_w"] / 2


class TorsoFrontHalfPanel(TorsoHalfPanel):
    """Front of a straight upper garment."""

    def __init__(self, name: str, body: BodyParameters, design: Design) -> None:
        """Drafts the panel."""
        bust = (body["bust"] - body["back_width"]) / 2
        wider_than_back = 2 * bust - body["bust"] / 2
        waist = (body["waist"] - body["waist_back_width"]) / 2
        super().__init__(name, body, design, bust, waist, _shoulder_slope(body) * wider_than_back)


class TorsoBackHalfPanel(TorsoHalfPanel):
    """Back of a straight upper garment."""

    def __init__(self, name: str, body: BodyParameters, design: Design) -> None:
        """Drafts the panel."""
        super().__init__(name, body, design, body["back_width"] / 2, body["waist_back_width"] / 2)


def _shoulder_slope(body: BodyParameters) -> float:
    return math.tan(math.radians(body["_shoulder_incl"]))

"""Circle skirts, symmetric or longer at the back, and the panel that is a part of a ring."""

from __future__ import annotations

import math

from swifttailor.programs.body_parameters import BodyParameters
from swifttailor.programs.bottoms import StackableSkirt
from swifttailor.programs.curved_edges import arc_from_points_radius, arc_from_three_points
from swifttailor.programs.cutting import cut_into_edge
from swifttailor.programs.design import Design
from swifttailor.programs.edge_shapes import dart_shape
from swifttailor.programs.edges import ArcEdge, Edge
from swifttailor.programs.interface import Interface
from swifttailor.programs.panel import Panel
from swifttailor.programs.stitching import Stitches


class RingPanel(Panel):
    """A panel between two arcs, the upper one in the middle of the x axis."""

    def _draft(
        self,
        top: ArcEdge,
        bottom_corner: list[float],
        bottom: ArcEdge,
        match_top_int_proportion: float | None,
        match_bottom_int_proportion: float | None = None,
    ) -> None:
        """Joins both arcs by straight sides.

        Args:
            top: The upper arc.
            bottom_corner: Where the lower arc starts.
            bottom: The lower arc.
            match_top_int_proportion: Length of what the top is gathered or stretched to, cm; none without it.
            match_bottom_int_proportion: The same for the bottom.
        """
        self.edges.append(top)
        self.edges.append(Edge(top.end, bottom_corner))
        self.edges.append(bottom)
        self.edges.close_loop()
        self.interfaces = {
            "top": Interface(self, top, _ruffle(top, match_top_int_proportion)).reverse(True),
            "bottom": Interface(self, bottom, _ruffle(bottom, match_bottom_int_proportion)),
            "left": Interface(self, self.edges[1]),
            "right": Interface(self, self.edges[3]),
        }

    def length(self, longest_dim: bool = False) -> float:
        """Length of its sides, cm."""
        return self.interfaces["right"].edges.length()


class CircleArcPanel(RingPanel):
    """A sector of a ring."""

    def __init__(
        self,
        name: str,
        top_rad: float,
        length: float,
        angle: float,
        match_top_int_proportion: float | None = None,
        match_bottom_int_proportion: float | None = None,
    ) -> None:
        """Drafts it from the inner radius and the length in cm and the angle in radians."""
        super().__init__(name)
        half = angle / 2
        x_top, x_bottom = top_rad * math.sin(half), (top_rad + length) * math.sin(half)
        y, large = -length * math.cos(half), half > math.pi / 2
        top = arc_from_points_radius([-x_top, 0.0], [x_top, 0.0], top_rad, large)
        corner = [x_bottom, y]
        bottom = arc_from_points_radius(corner, [-x_bottom, y], top_rad + length, large, right=False)
        self._draft(top, corner, bottom, match_top_int_proportion, match_bottom_int_proportion)

    @classmethod
    def from_w_length_suns(
        cls,
        name: str,
        length: float,
        top_width: float,
        sun_fraction: float,
        match_top_int_proportion: float | None = None,
    ) -> CircleArcPanel:
        """From its length, the width of its top and the fraction of a full circle that it is."""
        arc = sun_fraction * 2 * math.pi
        return cls(name, top_width / arc, length, arc, match_top_int_proportion)

    @classmethod
    def from_all_length(
        cls,
        name: str,
        length: float,
        top_width: float,
        bottom_width: float,
        match_top_int_proportion: float | None = None,
        match_bottom_int_proportion: float | None = None,
    ) -> CircleArcPanel:
        """From its length and the widths of top and bottom."""
        arc = (bottom_width - top_width) / length
        return cls(name, top_width / arc, length, arc, match_top_int_proportion, match_bottom_int_proportion)


class AsymHalfCirclePanel(RingPanel):
    """Half a ring with another centre for the lower arc, so that its length changes from middle to sides."""

    def __init__(
        self,
        name: str,
        top_rad: float,
        length_f: float,
        length_s: float,
        match_top_int_proportion: float | None = None,
    ) -> None:
        """Drafts it from the inner radius and the lengths in the middle and at the sides, cm."""
        super().__init__(name)
        x_bottom = top_rad + length_s
        top = arc_from_points_radius([-top_rad, 0.0], [top_rad, 0.0], top_rad)
        corner = [x_bottom, 0.0]
        bottom = arc_from_three_points(corner, [-x_bottom, 0.0], [0.0, -(top_rad + length_f)])
        self._draft(top, corner, bottom, match_top_int_proportion)


class SkirtCircle(StackableSkirt):
    """A skirt of two sectors of a ring."""

    asymm = False

    def __init__(
        self,
        body: BodyParameters,
        design: Design,
        tag: str = "",
        length: float | None = None,
        rise: float | None = None,
        slit: bool = True,
        top_ruffles: bool = True,
        min_len: float = 5.0,
    ) -> None:
        """Drafts front and back; length and rise may be given in place of the design's."""
        super().__init__(body, design, tag)
        design = design.section("flare-skirt")
        self.rise = design["rise"] if rise is None else rise
        waist, hips_depth, _ = self.eval_rise(self.rise)
        if length is None:
            length = hips_depth + design["length"] * body["_leg_length"]
        length = max(length, min_len)

        self.front, self.back = (
            self._asymmetric(design, waist, length, tag)
            if self.asymm
            else self._symmetric(design, waist, length, tag)
        )
        self.front.translate_by([0.0, body["_waist_level"], 15.0])
        self.back.translate_by([0.0, body["_waist_level"], -15.0])
        if design["cut.add"] and slit:
            self._add_cut(self.front if design["cut.place"] > 0 else self.back, design, length)

        front, back = self.front.interfaces, self.back.interfaces
        self.stitching_rules = Stitches((front["right"], back["right"]), (front["left"], back["left"]))
        self.interfaces = {
            "top": Interface.from_multiple(front["top"], back["top"]),
            "bottom_f": front["bottom"],
            "bottom_b": back["bottom"],
            "bottom": Interface.from_multiple(front["bottom"], back["bottom"]),
        }

    def length(self) -> float:
        """Length of its front, cm."""
        return self.front.length()

    def _symmetric(self, design: Design, waist: float, length: float, tag: str) -> tuple[Panel, Panel]:
        front_width, back_width = _waist_widths(self.body)
        suns = design["suns"] / 2
        make = CircleArcPanel.from_w_length_suns
        return (
            make(_tagged("skirt_front", tag), length, waist / 2, suns, front_width),
            make(_tagged("skirt_back", tag), length, waist / 2, suns, back_width),
        )

    def _asymmetric(self, design: Design, waist: float, length: float, tag: str) -> tuple[Panel, Panel]:
        """A full circle whose centre is not that of the waist."""
        front_width, back_width = _waist_widths(self.body)
        radius = waist / 2 / math.pi
        at_front = design["asymm.front_length"] * length
        total = radius * 2 + length + at_front
        shift = total / 2 - at_front - radius
        at_side = math.sqrt((total / 2) ** 2 - shift**2) - radius
        return (
            AsymHalfCirclePanel(_tagged("skirt_front", tag), radius, at_front, at_side, front_width),
            AsymHalfCirclePanel(_tagged("skirt_back", tag), radius, length, at_side, back_width),
        )

    def _add_cut(self, panel: Panel, design: Design, length: float) -> None:
        """Cuts a wedge into the hem."""
        width, depth = design["cut.width"] * length, design["cut.depth"] * length
        hem = panel.interfaces["bottom"].edges[0]
        hem_length = hem.length()
        offset = abs(design["cut.place"] * hem_length)
        offset = min(max(offset, width / 2), hem_length - width / 2)
        right = hem.start[0] > hem.end[0]  # upwards in these panels
        new_edges, _, left_over = cut_into_edge(dart_shape(width, depth=depth), hem, offset, right)
        panel.edges.substitute(hem, new_edges)
        panel.interfaces["bottom"].substitute(hem, left_over, [panel] * len(left_over))


class AsymmSkirtCircle(SkirtCircle):
    """A full circle skirt that is shorter at the front."""

    asymm = True


def _ruffle(edge: Edge, partner: float | None) -> float:
    return 1.0 if partner is None else edge.length() / partner


def _waist_widths(body: BodyParameters) -> tuple[float, float]:
    return body["waist"] - body["waist_back_width"], body["waist_back_width"]


def _tagged(name: str, tag: str) -> str:
    return f"{name}_{tag}" if tag else name

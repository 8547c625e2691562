"""Panels of skirts: trapezium, thin gore, and fitted with darts."""

from __future__ import annotations

import math

from swifttailor.programs.body_parameters import BodyParameters
from swifttailor.programs.curved_edges import arc_from_three_points, curve_from_tangents
from swifttailor.programs.cutting import cut_into_edge
from swifttailor.programs.design import Design
from swifttailor.programs.design_error import DesignError
from swifttailor.programs.edge_sequence import EdgeSequence
from swifttailor.programs.edge_shapes import dart_shape, from_verts, side_with_cut
from swifttailor.programs.edges import Edge, Vertex, close_enough
from swifttailor.programs.interface import Interface
from swifttailor.programs.panel import Panel


class SkirtPanel(Panel):
    """A trapezium, gathered at the waist."""

    def __init__(
        self,
        name: str,
        waist_length: float = 70.0,
        length: float = 70.0,
        ruffles: float = 1.0,
        match_top_int_to: float | None = None,
        bottom_cut: float = 0.0,
        flare: float = 0.0,
    ) -> None:
        """Drafts it; `bottom_cut` cm of the sides stay open, `flare` cm are added at the hem on each side."""
        super().__init__(name)
        if close_enough(length):
            raise DesignError(
                f"Panel '{name}' would have no length. Lengthen this part, or give it a smaller cuff."
            )
        top_width = waist_length * ruffles
        low_width = top_width + 2 * flare
        inset = (low_width - top_width) / 2
        cut = bottom_cut / length
        right = side_with_cut([0.0, 0.0], [inset, length], start_cut=cut)
        waist = Edge(right[-1].end, [inset + top_width, length])
        left = side_with_cut(waist.end, [low_width, 0.0], end_cut=cut)
        bottom = Edge(left[-1].end, right[0].start)
        ruffle = ruffles if match_top_int_to is None else waist.length() / match_top_int_to
        self.interfaces = {
            "right": Interface(self, right[-1]),
            "top": Interface(self, waist, ruffle).reverse(True),
            "left": Interface(self, left[0]),
            "bottom": Interface(self, bottom),
        }
        self.edges = EdgeSequence(right, waist, left, bottom)
        self.top_center_pivot()
        self.center_x()


class ThinSkirtPanel(Panel):
    """A gore of a skirt of many panels."""

    def __init__(
        self, name: str, top_width: float, bottom_width: float, length: float, b_curvature: float = 0.0
    ) -> None:
        """Drafts it; the hem may be an arc whose height is given in lengths of the hem."""
        super().__init__(name)
        flare = (bottom_width - top_width) / 2
        self.edges = from_verts(
            [0.0, 0.0], [flare, length], [flare + top_width, length], [flare * 2 + top_width, 0.0]
        )
        if close_enough(b_curvature, 0.0):
            self.edges.close_loop()
        else:
            start, end = self.edges[-1].end, self.edges[0].start
            self.edges.append(arc_from_three_points(start, end, [0.5, b_curvature], relative=True))
        self.set_pivot(self.edges[0].end)
        self.interfaces = {
            "right": Interface(self, self.edges[0]),
            "top": Interface(self, self.edges[1]),
            "left": Interface(self, self.edges[2]),
            "bottom": Interface(self, self.edges[-1]),
        }


class FittedSkirtPanel(Panel):
    """A panel of a pencil skirt, with darts at the waist and slits at the hem."""

    def __init__(
        self,
        name: str,
        body: BodyParameters,
        design: Design,
        waist: float,
        hips: float,
        hips_depth: float,
        length: float,
        hipline_ext: float = 1.0,
        dart_position: float = 0.0,
        dart_frac: float = 0.5,
        double_dart: bool = False,
        match_top_int_to: float | None = None,
        slit: float = 0.0,
        left_slit: float = 0.0,
        right_slit: float = 0.0,
        side_cut: EdgeSequence | None = None,
    ) -> None:
        """Drafts it.

        Args:
            name: Of the panel.
            body: The wearer.
            design: The section ``pencil-skirt``.
            waist: Half of the panel's width at the top, cm.
            hips: Half of its width at the hips, cm.
            hips_depth: From the top to the hips, cm.
            length: From the hips to the hem, cm.
            hipline_ext: How much deeper the hips of this panel lie than those of its partner.
            dart_position: From the middle of the panel to the first dart, cm.
            dart_frac: Depth of the darts, in depths of the hips.
            double_dart: Two darts on each side in place of one.
            match_top_int_to: Length of what the top is sewn to, cm.
            slit: In the middle of the hem, in lengths of the panel.
            left_slit: At the left side, in lengths of the side below the hips.
            right_slit: At the right side.
            side_cut: An ornament cut into the left side.
        """
        super().__init__(name)
        depth = hips_depth * hipline_ext
        dart_depth = max(hips_depth * dart_frac - (hips_depth - depth), 0.0)
        spare = hips - waist
        side_shift = min(math.tan(math.radians(body["_hip_inclination"])) * depth, spare)
        low_width = body["hips"] * (design["flare"] - 1) / 4 + hips
        slope = math.tan(math.radians(design["low_angle"])) * low_width
        straight = close_enough(design["flare"], 1.0)

        right_bottom = _side_below_hips([hips - low_width, slope], [0.0, length], straight)
        right = EdgeSequence(
            right_bottom,
            curve_from_tangents(right_bottom.end, [side_shift, length + depth], target_tan0=[0.0, 1.0]),
        )
        top = Edge(right[-1].end, [hips * 2 - side_shift, length + depth])
        left_top = curve_from_tangents(top.end, [hips * 2, length], target_tan1=[0.0, -1.0])
        left_bottom = _side_below_hips(left_top.end, [hips + low_width, -slope], straight)
        left = EdgeSequence(left_top, left_bottom)
        self.edges = EdgeSequence(right, top, left).close_loop()
        bottom: Edge | EdgeSequence = self.edges[-1]

        if slit:
            shape = dart_shape(2.0, depth=slit * length)
            hem = self.edges[-1]
            new_edges, _, bottom = cut_into_edge(shape, hem, offset=hem.length() / 2)
            self.edges.substitute(hem, new_edges)
        if left_slit:
            parts = left_bottom.subdivide_len([1 - left_slit, left_slit])
            left.substitute(left_bottom, parts[0])
            self.edges.substitute(left_bottom, parts)
            left_bottom = parts[0]
        if right_slit:
            parts = right_bottom.subdivide_len([right_slit, 1 - right_slit])
            right.substitute(right_bottom, parts[1])
            self.edges.substitute(right_bottom, parts)
        if side_cut is not None:
            self._ornament(side_cut, left_bottom, left)

        self.top_center_pivot()
        self.translation = [-hips / 2, 5.0, 0.0]
        self.interfaces = {
            "bottom": Interface(self, bottom),
            "right": Interface(self, right, [1.0] * (len(right) - 1) + [hipline_ext]),
            "left": Interface(self, left, [hipline_ext] + [1.0] * (len(left) - 1)),
        }
        self.interfaces["left"].edges_flipping[0] = True
        self.interfaces["right"].edges_flipping[-1] = True

        at_top: Edge | EdgeSequence = top
        if spare > side_shift:
            edges, at_top = self._add_darts(top, spare - side_shift, dart_depth, dart_position, double_dart)
            self.edges.substitute(top, edges)
        ruffle = 1.0 if match_top_int_to is None else at_top.length() / match_top_int_to
        self.interfaces["top"] = Interface(self, at_top, ruffle)

    def _ornament(self, shape: EdgeSequence, side: Edge, left: EdgeSequence) -> None:
        """Cuts a shape into the side; leaves it out where it does not fit, as beside a long slit."""
        try:
            new_edges, _, _ = cut_into_edge(shape, side, offset=side.length() / 2)
        except DesignError:
            return
        self.edges.substitute(side, new_edges)
        left.substitute(side, new_edges)

    def _add_darts(
        self, top: Edge, width: float, depth: float, position: float, double: bool
    ) -> tuple[EdgeSequence, EdgeSequence]:
        """Cuts darts into the top, symmetrically; gives all its edges, and those that are not of a dart."""
        if double:
            apart = position * 0.5
            full, small = dart_shape(width / 2, depth), dart_shape(width / 2, depth * 0.9)
            darts = [small, full, full, small]
            offsets = [
                -(position + apart / 2 + width / 2) - width / 4,
                -(position - apart / 2) - width / 4,
                position - apart / 2 + width / 4,
                position + apart / 2 + width / 2 + width / 4,
            ]
        else:
            darts = [dart_shape(width, depth)] * 2
            offsets = [-position - width / 2, position + width / 2]
        whole = top.length()
        edges, between = EdgeSequence(top), EdgeSequence(top)
        for offset, dart in zip(offsets, darts, strict=True):
            last = edges[-1]
            at = (last.length() - whole / 2) + offset
            edges, between = self.add_dart(dart, last, at, edge_seq=edges, int_edge_seq=between)
        return edges, between


def _side_below_hips(start: Vertex, end: Vertex, straight: bool) -> Edge:
    """A side that is vertical at the hips, travelled up or down."""
    if straight:
        return Edge(start, end)
    if end[1] > start[1]:
        return curve_from_tangents(start, end, target_tan1=[0.0, 1.0], initial_guess=[0.75, 0.0])
    return curve_from_tangents(start, end, target_tan0=[0.0, -1.0], initial_guess=[0.25, 0.0])

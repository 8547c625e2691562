"""Trousers: four panels with a crotch curve, darts at the waist, and cuffs."""

from __future__ import annotations

import math

from swifttailor.programs.body_parameters import BodyParameters
from swifttailor.programs.bottoms import BaseBottoms
from swifttailor.programs.cuffs import CUFFS
from swifttailor.programs.curved_edges import curve_from_tangents
from swifttailor.programs.design import Design
from swifttailor.programs.design_parameters import DESIGN_PARAMETERS
from swifttailor.programs.edge_sequence import EdgeSequence
from swifttailor.programs.edge_shapes import dart_shape
from swifttailor.programs.edges import Edge, close_enough
from swifttailor.programs.interface import Interface
from swifttailor.programs.panel import Panel
from swifttailor.programs.stitching import Stitches

SHORTEST = DESIGN_PARAMETERS["pants.length"].range[0]
"""What of the legs a cuff leaves uncovered at least, in lengths of the leg."""


class PantPanel(Panel):
    """A quarter of a pair of trousers."""

    def __init__(
        self,
        name: str,
        body: BodyParameters,
        flare: float,
        length: float,
        waist: float,
        hips: float,
        hips_depth: float,
        crotch_width: float,
        dart_position: float,
        match_top_int_to: float,
        hipline_ext: float = 1.0,
        double_dart: bool = False,
    ) -> None:
        """Drafts it.

        Args:
            name: Of the panel.
            body: The wearer.
            flare: Of the leg; 1 is straight.
            length: From the hips to the hem, cm.
            waist: Width at the top, cm.
            hips: Width at the hips, cm.
            hips_depth: From the top to the hips, cm.
            crotch_width: How far the crotch reaches beyond the hips, cm.
            dart_position: From the middle of the body to the first dart, cm.
            match_top_int_to: Length of what the top is sewn to, cm.
            hipline_ext: How much deeper the hips of this panel lie than those of its partner.
            double_dart: Two darts in place of one.
        """
        super().__init__(name)
        straight = close_enough(flare, 1.0)
        wider = body["leg_circ"] * (flare - 1) / 4
        hips_depth = hips_depth * hipline_ext
        crotch_depth = body["crotch_hip_diff"]
        spare = hips - waist
        side_shift = min(math.tan(math.radians(body["_hip_inclination"])) * hips_depth, spare)

        hem, hip = [-wider, 0.0], [0.0, length]
        right_bottom = (
            Edge(hem, hip)
            if straight
            else curve_from_tangents(hem, hip, target_tan1=[0.0, 1.0], initial_guess=[0.75, 0.0])
        )
        right_top = curve_from_tangents(hip, [side_shift, length + hips_depth], target_tan0=[0.0, 1.0])
        top = Edge(right_top.end, [spare + waist, length + hips_depth])
        # A little above the hips, and below the lowest rise.
        crotch_top = Edge(top.end, [hips, length + 0.45 * hips_depth])
        crotch = [hips + crotch_width, length - crotch_depth]
        crotch_bottom = curve_from_tangents(
            crotch_top.end,
            crotch,
            target_tan0=[0.0, -1.0],
            target_tan1=[1.0, 0.0],
            initial_guess=[0.5, -0.5],
        )
        # The leg ends 2 cm inside the crotch; shorts that end above the crotch cover the inside of the leg.
        inner_end = min(0.0, length - crotch_depth * 1.5)
        left = curve_from_tangents(
            crotch,
            [crotch[0] - 2 + wider, inner_end],
            target_tan1=[wider, inner_end - crotch[1]],
            initial_guess=[0.3, 0.0],
        )
        self.edges = EdgeSequence(right_bottom, right_top, top, crotch_top, crotch_bottom, left).close_loop()
        bottom = self.edges[-1]
        self.set_pivot(crotch)
        self.translation = [-0.5, -hips_depth - crotch_depth + 5, 0.0]
        self.interfaces = {
            "outside": Interface(self, EdgeSequence(right_bottom, right_top), [1.0, hipline_ext]),
            "crotch": Interface(self, EdgeSequence(crotch_top, crotch_bottom)),
            "inside": Interface(self, left),
            "bottom": Interface(self, bottom),
        }
        at_top: Edge | EdgeSequence = top
        if spare > side_shift:
            edges, at_top = self._add_darts(
                top, spare - side_shift, hips_depth * 0.8, dart_position, double_dart
            )
            self.edges.substitute(top, edges)
        self.interfaces["top"] = Interface(self, at_top, waist / match_top_int_to)

    def _add_darts(
        self, top: Edge, width: float, depth: float, position: float, double: bool
    ) -> tuple[EdgeSequence, EdgeSequence]:
        """Cuts darts into the top; gives all its edges, and those that are not of a dart."""
        if double:
            apart = position * 0.5
            darts = [dart_shape(width / 2, depth * 0.9), dart_shape(width / 2, depth)]
            offsets = [
                -(position + apart / 2 + width / 2 + width / 4),
                -(position - apart / 2) - width / 4,
            ]
        else:
            darts, offsets = [dart_shape(width, depth)], [-position - width / 2]
        edges, between = EdgeSequence(top), EdgeSequence(top)
        for offset, dart in zip(offsets, darts, strict=True):
            last = edges[-1]
            edges, between = self.add_dart(
                dart, last, last.length() + offset, edge_seq=edges, int_edge_seq=between
            )
        return edges, between


class PantsHalf(BaseBottoms):
    """One leg, with its cuff."""

    def __init__(self, tag: str, body: BodyParameters, design: Design, rise: float | None = None) -> None:
        """Drafts the right leg."""
        super().__init__(body, design, tag)
        design = design.section("pants")
        self.rise = design["rise"] if rise is None else rise
        waist, hips_depth, waist_back = self.eval_rise(self.rise)
        # So that a leg goes in, with 5 cm of ease; most of what the design adds lies at the back.
        extension = (body["leg_circ"] - body["hips"] / 2 + 5) * design["width"]
        front_extension = (body["hips"] - body["hip_back_width"]) / 2 / 4

        length, cuff_len = design["length"], design["cuff.cuff_len"]
        if design["cuff.type"]:
            if length - cuff_len < SHORTEST:
                cuff_len = length - SHORTEST
            length -= cuff_len
        length *= body["_leg_length"]
        cuff_len *= body["_leg_length"]

        self.front = PantPanel(
            f"pant_f_{tag}",
            body,
            design["flare"],
            length=length,
            waist=(waist - waist_back) / 2,
            hips=(body["hips"] - body["hip_back_width"]) / 2,
            hips_depth=hips_depth,
            crotch_width=front_extension,
            dart_position=body["bust_points"] / 2,
            match_top_int_to=(body["waist"] - body["waist_back_width"]) / 2,
        ).translate_by([0.0, body["_waist_level"] - 5, 25.0])
        self.back = PantPanel(
            f"pant_b_{tag}",
            body,
            design["flare"],
            length=length,
            waist=waist_back / 2,
            hips=body["hip_back_width"] / 2,
            hips_depth=hips_depth,
            crotch_width=extension - front_extension,
            dart_position=body["bum_points"] / 2,
            match_top_int_to=body["waist_back_width"] / 2,
            hipline_ext=1.1,
            double_dart=True,
        ).translate_by([0.0, body["_waist_level"] - 5, -20.0])

        front, back = self.front.interfaces, self.back.interfaces
        self.stitching_rules = Stitches(
            (front["outside"], back["outside"]), (front["inside"], back["inside"])
        )
        self._leg_length = self.front.length()
        if design["cuff.type"]:
            hem = Interface.from_multiple(front["bottom"], back["bottom"])
            width = hem.edges.length() / design["cuff.top_ruffle"]
            own = design.replaced({"cuff.b_width": width, "cuff.cuff_len": cuff_len})
            self.cuff = CUFFS[design["cuff.type"]](f"pant_{tag}", own)
            self.cuff.place_by_interface(self.cuff.interfaces["top"], hem, gap=5.0, alignment="left")
            self.stitching_rules.append((hem, self.cuff.interfaces["top"]))
            self._leg_length += self.cuff.length()
        self.interfaces = {
            "crotch_f": front["crotch"],
            "crotch_b": back["crotch"],
            "top_f": front["top"],
            "top_b": back["top"],
        }

    def length(self) -> float:
        """Length of the front and the cuff, cm."""
        return self._leg_length


class Pants(BaseBottoms):
    """Both legs."""

    def __init__(self, body: BodyParameters, design: Design, rise: float | None = None) -> None:
        """Drafts the legs and sews them together at the crotch."""
        super().__init__(body, design)
        self.right = PantsHalf("r", body, design, rise)
        self.left = PantsHalf("l", body, design, rise).mirror()
        right, left = self.right.interfaces, self.left.interfaces
        self.stitching_rules = Stitches(
            (right["crotch_f"], left["crotch_f"]), (right["crotch_b"], left["crotch_b"])
        )
        self.interfaces = {
            "top_f": Interface.from_multiple(right["top_f"], left["top_f"]),
            "top_b": Interface.from_multiple(right["top_b"], left["top_b"]),
            # Around the body from the middle of the front right; the reversed ones keep the direction.
            "top": Interface.from_multiple(
                right["top_f"].flip_edges(),
                left["top_f"].reverse(with_edge_dir_reverse=True),
                left["top_b"].flip_edges(),
                right["top_b"].reverse(with_edge_dir_reverse=True),
            ),
        }

    def get_rise(self) -> float:
        """How far up the legs reach."""
        return self.right.get_rise()

    def length(self) -> float:
        """Length of a leg, cm."""
        return self.right.length()

"""Sleeves: two panels, on request with a square shoulder, gathers and a cuff."""

from __future__ import annotations

import math

from swifttailor.programs.armhole_openings import even_armhole_openings
from swifttailor.programs.armholes import ARMHOLES, Armhole, armhole_curve, sleeve_opening
from swifttailor.programs.body_parameters import BodyParameters
from swifttailor.programs.component import Component
from swifttailor.programs.cuffs import CUFFS
from swifttailor.programs.design import Design
from swifttailor.programs.edge_sequence import EdgeSequence
from swifttailor.programs.edge_shapes import from_verts
from swifttailor.programs.edges import Edge, close_enough
from swifttailor.programs.interface import Interface
from swifttailor.programs.panel import Panel
from swifttailor.programs.rotation import Rotation
from swifttailor.programs.stitching import Stitches

_SHORTEST_CM = 5.0
_STANDING_MARGIN = math.radians(5)
"""A square shoulder needs a sleeve that much steeper than the shoulder."""
_LONGEST_CUFF = 0.7
"""A cuff takes this part of the sleeve at most."""
_EVEN_CM = 0.2


class SleevePanel(Panel):
    """Front or back of a sleeve."""

    def __init__(
        self, name: str, body: BodyParameters, design: Design, open_shape: EdgeSequence, length_shift: float
    ) -> None:
        """Drafts it.

        Args:
            name: Name of the panel.
            body: The body.
            design: The parameters below ``sleeve`` (or ``left.sleeve``).
            open_shape: The end that is sewn into the armhole; becomes part of the panel.
            length_shift: Is added to the length, cm.
        """
        super().__init__(name)
        end_width = design["end_width"] * abs(open_shape[0].start[1] - open_shape[-1].end[1])
        end_width = max(end_width, body["wrist"] / 2)
        ruffle = design["connect_ruffle"]
        if not close_enough(ruffle, 1.0):
            open_shape.extend(ruffle)
        opening_length = abs(open_shape[0].start[0] - open_shape[-1].end[0])
        arm_width = abs(open_shape[0].start[1] - open_shape[-1].end[1])
        length = design["length"] * (body["arm_length"] - opening_length)
        length = max(length + length_shift, _SHORTEST_CM)

        self.edges = from_verts([0.0, 0.0], [0.0, -end_width], [length, -arm_width])
        armpit = self.edges[-1].end
        open_shape.snap_to(armpit)
        open_shape[0].start = armpit
        self.edges.append(open_shape).close_loop()
        top = self._stand_shoulder(body, design) if design["standing_shoulder"] else self.edges[-1:]
        self.interfaces = {
            "in": Interface(self, open_shape, ruffle=ruffle),
            "out": Interface(self, self.edges[0], ruffle=design["cuff.top_ruffle"]),
            "top": Interface(self, top),
            "bottom": Interface(self, self.edges[1]),
        }
        self.set_pivot(self.edges[-1].start)
        self.translate_to([-body["shoulder_w"] / 2, body["height"] - body["head_l"], 0.0])

    def _stand_shoulder(self, body: BodyParameters, design: Design) -> EdgeSequence:
        """Bends the upper edge for a square shoulder, if the sleeve is steep enough; returns it."""
        top = self.edges[-1]
        over = rest_angle(body, design) - math.radians(body["_shoulder_incl"])
        if over <= _STANDING_MARGIN:
            return EdgeSequence(top)
        reach = design["standing_shoulder_len"]
        x, y = top.start
        shelf = Edge(top.start, [x - reach * math.cos(over), y + reach * math.sin(over)])
        top.start = shelf.end
        self.edges.substitute(top, [shelf, top])
        return EdgeSequence(shelf, top)


class Sleeve(Component):
    """A sleeve, or an armhole alone.

    `front_shape` and `back_shape` are what it cuts out of the bodice. Interface ``in`` of a sleeve is sewn
    in there, ``out`` is its free end.
    """

    def __init__(self, tag: str, body: BodyParameters, design: Design, front_w: float, back_w: float) -> None:
        """Drafts it.

        Args:
            tag: Begins the names of the panels.
            body: The body.
            design: The parameters below ``sleeve``; ``connecting_width`` in cm.
            front_w: Width of the front of the bodice at the bottom of the armhole, cm.
            back_w: The same of the back.
        """
        super().__init__(f"Sleeve_{tag}")
        balance = body["_base_sleeve_balance"] / 2
        width, smoothing = design["connecting_width"], design["smoothing_coeff"]
        front, back = (Armhole(w - balance, width, smoothing) for w in (front_w, back_w))
        # What could be sewn into angular armholes is not known: they are for garments without sleeves.
        shape = ARMHOLES[design["armhole_shape"]] if design["sleeveless"] else armhole_curve
        self.front_shape, self.back_shape = shape(front), shape(back)
        if not design["sleeveless"]:
            self._draft(tag, body, design, front, back)

    def _draft(self, tag: str, body: BodyParameters, design: Design, front: Armhole, back: Armhole) -> None:
        angle, mix = rest_angle(body, design), design["opening_dir_mix"]
        front_opening, back_opening = (sleeve_opening(hole, angle, mix) for hole in (front, back))
        if front.incl != back.incl:
            even_armhole_openings(front_opening, back_opening, tol=_EVEN_CM / front_opening.length())

        cuff_len = _cuff_length(body, design) if design["cuff.type"] else 0.0
        self.f_sleeve = SleevePanel(f"{tag}_sleeve_f", body, design, front_opening, -cuff_len)
        self.f_sleeve.translate_by([0.0, 0.0, 15.0])
        self.b_sleeve = SleevePanel(f"{tag}_sleeve_b", body, design, back_opening, -cuff_len)
        self.b_sleeve.translate_by([0.0, 0.0, -15.0])
        one, two = self.f_sleeve.interfaces, self.b_sleeve.interfaces
        self.stitching_rules = Stitches((one["top"], two["top"]), (one["bottom"], two["bottom"]))
        self.interfaces = {
            "in": Interface.from_multiple(one["in"], two["in"].reverse(with_edge_dir_reverse=True)),
            "out": Interface.from_multiple(one["out"], two["out"]),
        }
        if design["cuff.type"]:
            self._add_cuff(tag, body, design, cuff_len)
        self.rotate_by(Rotation.from_euler(0.0, 0.0, body["arm_pose_angle"]))
        self.set_panel_label("arm")

    def _add_cuff(self, tag: str, body: BodyParameters, design: Design, length: float) -> None:
        end = self.interfaces["out"]
        girth = max(end.edges.length() / design["cuff.top_ruffle"], body["wrist"])
        own = design.replaced({"cuff.b_width": girth, "cuff.cuff_len": length})
        self.cuff = CUFFS[design["cuff.type"]](f"sl_{tag}", own)
        self.cuff.rotate_by(Rotation.from_euler(0.0, 0.0, -90.0))
        self.cuff.place_by_interface(self.cuff.interfaces["top"], end, gap=2.0, alignment="top")
        self.stitching_rules.append((self.cuff.interfaces["top"], end))
        self.interfaces["out"] = self.cuff.interfaces["bottom"]


def rest_angle(body: BodyParameters, design: Design) -> float:
    """Angle of the sleeve below the horizontal, radians: no flatter than the shoulder."""
    return math.radians(max(design["sleeve_angle"], body["_shoulder_incl"]))


def _cuff_length(body: BodyParameters, design: Design) -> float:
    longest = design["length"] * body["arm_length"] * _LONGEST_CUFF
    return min(design["cuff.cuff_len"] * body["arm_length"], longest)

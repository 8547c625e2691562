"""Collars: what they cut out of the bodice, and the panels that some of them add. The hood is in `hood`."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.programs.body_parameters import BodyParameters
from swifttailor.programs.circle_skirt import CircleArcPanel
from swifttailor.programs.component import Component
from swifttailor.programs.design import Design
from swifttailor.programs.edge_sequence import EdgeSequence
from swifttailor.programs.edge_shapes import from_verts
from swifttailor.programs.edges import ArcEdge, BezierEdge
from swifttailor.programs.interface import Interface
from swifttailor.programs.necklines import NECKLINES, Neckline, circle_neck_arc
from swifttailor.programs.panel import Panel
from swifttailor.programs.rotation import Rotation
from swifttailor.programs.waistbands import StraightBandPanel


class Collar(Component):
    """A collar of half an upper garment.

    `front_shape` and `back_shape` are what it cuts out of the bodice. If it has panels, it has an interface
    ``bottom``, and ``front`` and ``back`` where it meets that of the other half.

    The design has ``collar.width``, ``collar.fc_depth`` and ``collar.bc_depth`` in cm.
    """

    def __init__(self, name: str, front: EdgeSequence, back: EdgeSequence) -> None:
        """Keeps the shapes."""
        super().__init__(name)
        self.front_shape = front
        self.back_shape = back


class NoPanelsCollar(Collar):
    """A neckline alone."""

    def __init__(self, tag: str, body: BodyParameters, design: Design) -> None:
        """Draws both shapes."""
        super().__init__(tag, _neckline(design, "f"), _neckline(design, "b"))


class RoundCollar(Collar):
    """A collar on a round neckline."""

    def __init__(self, name: str, design: Design) -> None:
        """Draws both shapes."""
        width = design["collar.width"]
        self.front_arc = circle_neck_arc(design["collar.fc_depth"], width)
        self.back_arc = circle_neck_arc(design["collar.bc_depth"], width)
        super().__init__(name, EdgeSequence(self.front_arc), EdgeSequence(self.back_arc))


class Turtle(RoundCollar):
    """A standing band around the neck."""

    def __init__(self, tag: str, body: BodyParameters, design: Design) -> None:
        """Drafts front and back."""
        super().__init__(f"Turtle_{tag}", design)
        depth = design["collar.component.depth"]
        length_f, length_b = self.front_arc.length(), self.back_arc.length()
        height = body["height"] - body["head_l"] + depth
        self.front = StraightBandPanel(f"{tag}_collar_front", length_f, depth)
        self.front.translate_by([-length_f / 2, height, 10.0])
        self.back = StraightBandPanel(f"{tag}_collar_back", length_b, depth)
        self.back.translate_by([-length_b / 2, height, -10.0])
        front, back = self.front.interfaces, self.back.interfaces
        self.stitching_rules.append((front["right"], back["right"]))
        self.interfaces = {
            "front": front["left"],
            "back": back["left"],
            "bottom": Interface.from_multiple(front["bottom"], back["bottom"]),
        }


class SimpleLapelPanel(Panel):
    """The front of a lapel."""

    def __init__(self, name: str, length: float, max_depth: float) -> None:
        """Drafts it; lengths in cm."""
        super().__init__(name)
        self.edges = from_verts([0.0, 0.0], [max_depth, 0.0], [max_depth, -length])
        self.edges.append(BezierEdge(self.edges[-1].end, self.edges[0].start, [[0.7, 0.2]]))
        self.interfaces = {
            "to_collar": Interface(self, self.edges[0]),
            "to_bodice": Interface(self, self.edges[1]),
        }


class SimpleLapel(Collar):
    """A lapel of any neckline in front, with a standing or lying collar behind."""

    def __init__(self, tag: str, body: BodyParameters, design: Design) -> None:
        """Drafts front and back."""
        depth, standing = design["collar.component.depth"], design["collar.component.lapel_standing"]
        front_shape = _neckline(design, "f", default_curve=True)
        back_arc = circle_neck_arc(design["collar.bc_depth"], design["collar.width"])
        super().__init__(f"SimpleLapel_{tag}", front_shape, EdgeSequence(back_arc))

        height = body["height"] - body["head_l"] + depth * 2
        self.front = SimpleLapelPanel(f"{tag}_collar_front", front_shape.length(), depth)
        self.front.translate_by([-depth * 2, height, 35.0])
        if standing:
            self.back = _standing_back(f"{tag}_collar_back", back_arc, depth, height)
        else:
            self.back = _lying_back(f"{tag}_collar_back", back_arc, depth, height)
        front, back = self.front.interfaces, self.back.interfaces
        self.stitching_rules.append((front["to_collar"], back["right"]))
        behind = back["bottom"] if standing else back["top"].set_right_wrong(True)
        self.interfaces = {
            "back": back["left"],
            "bottom": Interface.from_multiple(front["to_bodice"].set_right_wrong(True), behind),
        }


def _standing_back(name: str, arc: ArcEdge, depth: float, height: float) -> Panel:
    length = arc.length()
    panel = StraightBandPanel(name, length, depth).translate_by([-length / 2, height, -10.0])
    panel.interfaces["right"].set_right_wrong(True)
    return panel


def _lying_back(name: str, arc: ArcEdge, depth: float, height: float) -> Panel:
    """Curved like the neckline."""
    panel = CircleArcPanel(name, arc.radius(), depth, arc.angle())
    return panel.translate_by([-arc.length(), height, -10.0]).rotate_by(Rotation.from_euler(90.0, 45.0, 0.0))


def _neckline(design: Design, side: str, default_curve: bool = False) -> EdgeSequence:
    """Half of the neckline in front (``f``) or behind (``b``); `default_curve` leaves x and y as they are."""
    neck = Neckline(
        design[f"collar.{side}c_depth"],
        design["collar.width"],
        design[f"collar.{side}c_angle"],
        design[f"collar.{side}_flip_curve"],
    )
    if not default_curve:
        x, y = design[f"collar.{side}_bezier_x"], design[f"collar.{side}_bezier_y"]
        neck = replace(neck, x=x, y=y)
    return NECKLINES[design[f"collar.{side}_collar"]](neck)

"""The hood of two panels."""

from __future__ import annotations

from swifttailor.programs.body_parameters import BodyParameters
from swifttailor.programs.collars import RoundCollar
from swifttailor.programs.curve_fits import curve_match_tangents
from swifttailor.programs.design import Design
from swifttailor.programs.edge_sequence import EdgeSequence
from swifttailor.programs.edge_shapes import from_verts
from swifttailor.programs.edges import BezierEdge, Vertex, to_complex
from swifttailor.programs.interface import Interface
from swifttailor.programs.panel import Panel
from swifttailor.programs.planar_curves import CubicCurve
from swifttailor.programs.rotation import Rotation

_LEVEL = [1.0, 0.0]


class HoodPanel(Panel):
    """One side of the hood."""

    def __init__(
        self,
        name: str,
        f_depth: float,
        b_depth: float,
        f_length: float,
        b_length: float,
        width: float,
        in_length: float,
        depth: float,
    ) -> None:
        """Drafts it; all in cm.

        Args:
            name: Name of the panel.
            f_depth: Depth of the neckline in front.
            b_depth: The same behind.
            f_length: Length of half of the neckline in front.
            b_length: The same behind.
            width: Width of the whole neckline.
            in_length: Height of the hood over the neck, without what its width adds.
            depth: Width of its top.
        """
        super().__init__(name)
        half = width / 2
        length = in_length + half / 2
        back = _bottom([-half, -b_depth], [0.0, 0.0], [[0.3, -0.2], [0.6, 0.2]], b_length)
        front = _bottom(back.end, [half, -f_depth], [[0.3, 0.2], [0.6, -0.2]], f_length)
        face = from_verts(front.end, [half * 1.2, length], [half * 1.2 - depth, length])
        nape = BezierEdge(face[-1].end, back.start, [[0.2, -0.5]])
        self.edges = EdgeSequence(back, front, face, nape)
        self.interfaces = {
            "to_other_side": Interface(self, self.edges[-2:]),
            "to_bodice": Interface(self, self.edges[0:2]).reverse(),
        }
        self.rotate_by(Rotation.from_euler(0.0, -90.0, 0.0))
        self.translate_by([-half, 0.0, 0.0])


class Hood2Panels(RoundCollar):
    """Half of a hood, on a round neckline."""

    def __init__(self, tag: str, body: BodyParameters, design: Design) -> None:
        """Drafts the panel."""
        super().__init__(f"Hood_{tag}", design)
        width = design["collar.width"]
        self.panel = HoodPanel(
            f"{tag}_hood",
            design["collar.fc_depth"],
            design["collar.bc_depth"],
            f_length=self.front_arc.length(),
            b_length=self.back_arc.length(),
            width=width,
            in_length=body["head_l"] * design["collar.component.hood_length"],
            depth=width / 2 * design["collar.component.hood_depth"],
        )
        self.panel.translate_by([0.0, body["height"] - body["head_l"] + 10, 0.0])
        self.interfaces = {
            "back": self.panel.interfaces["to_other_side"],
            "bottom": self.panel.interfaces["to_bodice"],
        }


def _bottom(start: Vertex, end: Vertex, controls: list[Vertex], length: float) -> BezierEdge:
    """An edge that starts and arrives level and is as long as the neckline to which it is sewn."""
    chord = to_complex(end) - to_complex(start)
    inner = [to_complex(start) + to_complex(c) * chord for c in controls]
    curve = CubicCurve(to_complex(start), inner[0], inner[1], to_complex(end))
    edge = curve_match_tangents(curve, _LEVEL, _LEVEL, length)
    edge.start = start
    return edge

"""Godet skirt: triangles let into the hem of a skirt."""

from __future__ import annotations

import math

from swifttailor.programs.body_parameters import BodyParameters
from swifttailor.programs.bottoms import BaseBottoms
from swifttailor.programs.cutting import cut_into_edge
from swifttailor.programs.design import Design
from swifttailor.programs.distributing import distribute_horizontally
from swifttailor.programs.edge_shapes import from_verts
from swifttailor.programs.edges import Edge
from swifttailor.programs.interface import Interface
from swifttailor.programs.panel import Panel
from swifttailor.programs.skirt_paneled import PencilSkirt, Skirt2

BASES = {"Skirt2": Skirt2, "PencilSkirt": PencilSkirt}


class Insert(Panel):
    """A triangle, sewn in along the two sides of its interface ``sides``."""

    def __init__(self, width: float, depth: float) -> None:
        """Drafts it with its point up."""
        super().__init__("Insert")
        self.edges = from_verts([0.0, 0.0], [width / 2, depth], [width, 0.0], loop=True)
        self.interfaces = {"sides": Interface(self, self.edges[:2])}
        self.top_center_pivot()
        self.center_x()


class GodetSkirt(BaseBottoms):
    """A skirt of two panels with inserts in its hem."""

    def __init__(self, body: BodyParameters, design: Design, rise: float | None = None) -> None:
        """Drafts the base, without slits, then cuts its hem open for the inserts."""
        super().__init__(body, design, rise=rise)
        own = design.section("godet-skirt")
        self.base = BASES[own["base"]](body, design, rise=rise, slit=False)
        hem = self.base.interfaces["bottom"]
        count = int(own["num_inserts"] / len(hem))
        for edge, panel in zip(hem.edges, hem.panel, strict=True):
            self._let_in(edge, panel, own["insert_w"], own["insert_depth"], count, own["cuts_distance"])
        self.interfaces = {"top": self.base.interfaces["top"]}

    def get_rise(self) -> float:
        """How far up the base reaches."""
        return self.base.get_rise()

    def length(self) -> float:
        """Length of the base, cm."""
        return self.base.length()

    def _let_in(self, hem: Edge, panel: Panel, width: float, depth: float, count: int, apart: float) -> None:
        """Makes inserts, cuts and the stitches between them.

        Args:
            hem: An edge of the panel.
            panel: A panel of the base.
            width: Of an insert, cm.
            depth: Of an insert, cm.
            count: Of the inserts in this panel.
            apart: Between two cuts, cm; less where the hem is too short.
        """
        low, high = panel.bbox_3d()
        z = panel.translation[2] + math.copysign(5.0, panel.translation[2])
        length = hem.length()
        cut_width = (length - apart * count) / count
        if cut_width < 1:
            cut_width = 1.0
            apart = (length - cut_width * count) / count

        insert = Insert(width, depth).translate_by(
            [(low[0] + high[0]) / 2 - count * width / 2 + width / 2, low[1] + depth, z]
        )
        inserts = distribute_horizontally(insert, count, -width, "ins_" + panel.name)
        self.subs += inserts

        side = math.hypot(width / 2, depth)
        if side > cut_width / 2:
            cut_depth = math.sqrt(side**2 - (cut_width / 2) ** 2)
        else:
            cut_depth = 1.0
            cut_width = 2 * math.sqrt(side**2 - cut_depth**2)
        shape = from_verts([0.0, 0.0], [cut_width / 2, cut_depth], [cut_width, 0.0])

        right = z < 0  # upwards in the skirts that are used as bases
        for i in range(count):
            offset = cut_width / 2 + (apart / 2 if i == 0 else apart)
            new_edges, cut, _ = cut_into_edge(shape, hem, offset=offset, right=right)
            panel.edges.substitute(hem, new_edges)
            hem = new_edges[-1]
            opening = Interface(panel, cut)
            if right:
                opening.reverse()
            partner = inserts[-1 - i] if right else inserts[i]
            self.stitching_rules.append((partner.interfaces["sides"], opening))

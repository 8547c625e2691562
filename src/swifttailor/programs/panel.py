"""A panel while it is drafted: a loop of edges, placed in space."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Self

import numpy as np

from swifttailor.pattern import Arc, Cubic, Curve, Line, Placement, Quadratic
from swifttailor.pattern import Edge as PatternEdge
from swifttailor.pattern import Panel as PatternPanel
from swifttailor.programs.component import BaseComponent, Box
from swifttailor.programs.cutting import cut_into_edge
from swifttailor.programs.design_error import DesignError
from swifttailor.programs.edge_sequence import EdgeSequence
from swifttailor.programs.edges import ArcEdge, BezierEdge, Edge, close_enough
from swifttailor.programs.interface import Interface
from swifttailor.programs.rotation import Rotation

if TYPE_CHECKING:
    from swifttailor.pattern import Stitch

OPEN_CM = 1e-3


class Panel(BaseComponent):
    """One flat piece of cloth. Methods that change it return it."""

    def __init__(self, name: str, label: str = "") -> None:
        """Makes a panel without edges at the origin."""
        super().__init__(name)
        self.label = label
        self.translation: list[float] = [0.0, 0.0, 0.0]
        self.rotation = Rotation()
        self.edges = EdgeSequence()

    # what it is

    def panels(self) -> Iterator[Panel]:
        """The panel itself."""
        yield self

    def pivot_3d(self) -> list[float]:
        """Where its origin is placed."""
        return self.point_to_3d([0.0, 0.0])

    def length(self, longest_dim: bool = False) -> float:
        """Height of its box in the plane, or the longer side of the box, cm."""
        left, right, low, high = self.edges.bbox()
        return max(right - left, high - low) if longest_dim else high - low

    def point_to_3d(self, point: Sequence[float]) -> list[float]:
        """Where a point of the plane is placed."""
        x, y = point[0], point[1]
        return [r[0] * x + r[1] * y + t for r, t in zip(self.rotation.rows, self.translation, strict=True)]

    def bbox_3d(self) -> Box:
        """Least and largest x, y and z of it, cm."""
        points = [self.point_to_3d(p) for p in self.edges.points()]
        return [min(c) for c in zip(*points, strict=True)], [max(c) for c in zip(*points, strict=True)]

    def norm(self) -> list[float]:
        """Unit vector out of its right side."""
        side = self._turning()
        return [side * row[2] for row in self.rotation.rows]

    def _turning(self) -> float:
        """1 if the outline runs counter-clockwise, -1 if clockwise.

        Decided as GarmentCode does, by the points that touch the box: thin and bent panels depend on it.
        """
        points = self.edges.points()
        xs, ys = [p[0] for p in points], [p[1] for p in points]
        left, right, low, high = min(xs), max(xs), min(ys), max(ys)
        touching = [p for p in points if p[0] in (left, right) or p[1] in (low, high)]
        if len(touching) == 2:
            corner = [left, low]
            if any(p[0] == left and p[1] == low for p in touching):
                corner = [left, high]
            touching.insert(1, corner)
        cx = sum(p[0] for p in touching) / len(touching)
        cy = sum(p[1] for p in touching) / len(touching)
        signs = []
        for a, b in zip(touching, [*touching[1:], touching[0]], strict=True):
            turn = (a[0] - cx) * (b[1] - cy) - (a[1] - cy) * (b[0] - cx)
            signs.append(math.copysign(1.0, turn))
        return math.copysign(1.0, sum(signs) or signs[0])

    # changes of the outline

    def set_panel_label(self, label: str, overwrite: bool = True) -> None:
        """Says to which part of the body it belongs."""
        if overwrite or not self.label:
            self.label = label

    def set_pivot(self, point: Sequence[float], replicate_placement: bool = False) -> Self:
        """Takes a point of the plane as the new origin.

        Vertices move by whole centimetres, as they do in GarmentCode: otherwise neither the patterns nor
        their places would be the same.
        """
        x, y = point[0], point[1]
        if replicate_placement:
            self.translation = self.point_to_3d([x, y])
        for v in self.edges.verts():
            v[0] -= int(x)
            v[1] -= int(y)
        return self

    def top_center_pivot(self) -> Self:
        """Takes the middle of that side of its box which is highest in space as the new origin."""
        verts = self.edges.verts()
        xs, ys = [v[0] for v in verts], [v[1] for v in verts]
        left, right, low, high = min(xs), max(xs), min(ys), max(ys)
        x, y = (right + left) / 2, (high + low) / 2
        middles = [[x, high], [x, low], [right, y], [left, y]]
        heights = [self.point_to_3d(m)[1] for m in middles]
        return self.set_pivot(middles[heights.index(max(heights))])

    def add_dart(
        self,
        dart_shape: EdgeSequence,
        edge: Edge,
        offset: float,
        right: bool = True,
        edge_seq: EdgeSequence | None = None,
        int_edge_seq: EdgeSequence | None = None,
    ) -> tuple[EdgeSequence, EdgeSequence]:
        """Cuts a dart into an edge and sews its sides together.

        Args:
            dart_shape: Two edges.
            edge: Where to cut.
            offset: Length along the edge to the middle of the dart, cm.
            right: Whether the dart lies to the right of travel.
            edge_seq: A sequence in which the edge is to be replaced by all new edges.
            int_edge_seq: A sequence in which it is to be replaced by what is left of it.

        Returns:
            The new edges, and what is left of the edge; the given sequences if they are given.
        """
        edges_new, dart_edges, int_new = cut_into_edge(dart_shape, edge, offset=offset, right=right)
        self.stitching_rules.append((Interface(self, dart_edges[0]), Interface(self, dart_edges[1])))
        if edge_seq is not None:
            edges_new = edge_seq.substitute(edge, edges_new)
        if int_edge_seq is not None:
            int_new = int_edge_seq.substitute(edge, int_new)
        return edges_new, int_new

    # changes of the placement

    def translate_by(self, delta: Sequence[float]) -> Self:
        """Moves it."""
        return self.translate_to([t + d for t, d in zip(self.translation, delta, strict=True)])

    def translate_to(self, place: Sequence[float]) -> Self:
        """Moves its origin to a place."""
        self.translation = [float(c) for c in place]
        return self.autonorm()

    def rotate_by(self, rotation: Rotation) -> Self:
        """Turns it about its origin."""
        return self.rotate_to(rotation * self.rotation)

    def rotate_to(self, rotation: Rotation) -> Self:
        """Gives it a rotation."""
        self.rotation = rotation
        return self.autonorm()

    def rotate_align(self, vector: Sequence[float]) -> Self:
        """Turns it until its right side looks into a direction."""
        return self.rotate_by(Rotation.aligning(self.norm(), vector))

    def center_x(self) -> Self:
        """Moves its centre into the plane x = 0."""
        points = self.edges.points(3)
        center = [sum(c) / len(points) for c in zip(*points, strict=True)]
        self.translation[0] -= self.point_to_3d(center)[0]
        return self

    def autonorm(self) -> Self:
        """Travels the outline so that the right side looks away from the origin of space."""
        if sum(n * t for n, t in zip(self.norm(), self.translation, strict=True)) < 0:
            self.edges.reverse()
        return self

    def mirror(self) -> Self:
        """Mirrors it across the plane x = 0."""
        self.edges.reflect([0.0, 0.0], [0.0, 1.0])
        self.translation[0] *= -1
        return self.rotate_to(self.rotation.mirrored())

    # the result

    def all_stitches(self) -> list[Stitch]:
        """Stitches inside the panel."""
        return list(self.stitching_rules.assembly())

    def assembly(self) -> PatternPanel:
        """The finished panel; numbers its edges for the stitches."""
        self.set_pivot(self.edges[0].start, replicate_placement=True)
        for i, (edge, following) in enumerate(zip(self.edges, [*self.edges[1:], self.edges[0]], strict=True)):
            gap = math.dist(edge.end, following.start)
            if gap > OPEN_CM:
                raise DesignError(
                    f"Panel '{self.name}' would be open by {gap:.3g} cm after edge {i}. "
                    "Change the parameters of this part."
                )
            edge.geometric_id = i
        x, y, z = self.translation
        return PatternPanel(
            self.name,
            np.array([e.start for e in self.edges], float),
            tuple(PatternEdge(_curve(e), e.label) for e in self.edges),
            Placement((x, y, z), self.rotation.as_euler()),
            self.label,
        )


def _curve(edge: Edge) -> Curve:
    if isinstance(edge, ArcEdge):
        if close_enough(edge.control_y, 0.0, 1e-9):
            return Line()
        return Arc(edge.radius(), edge.is_large(), edge.control_y < 0)
    if isinstance(edge, BezierEdge):
        points = [(c.real, c.imag) for c in edge.controls]
        return Quadratic(points[0]) if len(points) == 1 else Cubic(points[0], points[1])
    return Line()

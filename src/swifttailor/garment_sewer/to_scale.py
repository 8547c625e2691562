"""Garments for bodies of other heights, sewn at the scale of the body that the network learnt on.

The network knows shoulders at 1.4 m and hems of trousers at 8 cm. A child's dress is enlarged until the child
is as tall as the default body, sewn there, and made small again; cloth at rest does not mind.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from swifttailor.arrays import Floats
from swifttailor.body import Body
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.garment_sewer.sewer import GarmentSewer, Prepared
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.pattern import Pattern
from swifttailor.pattern.curve import scale

_ALIKE = 0.004
"""Bodies whose heights differ by less, as a share, are of one scale."""
_ANGLES = frozenset({"shoulder_incl", "arm_pose_angle", "hip_inclination"})
_LENGTHS = ("edge_length_cm", "cm_per_pixel")


@dataclass(frozen=True, eq=False)
class EnlargedPattern:
    """A pattern that is prepared at another scale."""

    mesh: PatternMesh
    """At its own scale."""
    prepared: Prepared
    """At the default body's, with the same mesh enlarged."""


@dataclass(frozen=True, eq=False)
class ScaledSewer(GarmentSewer):
    """A GarmentSewer for a body of another height; its `body` is enlarged to the default body's."""

    factor: float = 1.0
    """What lengths are multiplied by."""

    def prepare(self, pattern: Pattern, *, edge_length: float = 2.0, resolution: int | None = None) -> Any:
        """See `GarmentSewer.prepare`."""
        enlarged = scaled_pattern(pattern, self.factor)
        inner = super().prepare(enlarged, edge_length=edge_length * self.factor, resolution=resolution)
        large = inner.layout.pattern
        own = replace(
            pattern, panels=tuple(pattern.panel(p.name) for p in large.panels), stitches=large.stitches
        )
        # A mesh of the enlarged pattern may join other points: ties are broken by the last digit, and a
        # garment's folder is read by meshing its pattern again.
        mesh = mesh_pattern(own, edge_length)
        enlarged_mesh = replace(mesh, pattern=large, flat_vertices=mesh.flat_vertices * self.factor)
        return EnlargedPattern(mesh, replace(inner, mesh=enlarged_mesh))

    def predict(self, prepared: Sequence[Any]) -> list[Floats]:
        """See `GarmentSewer.predict`."""
        return super().predict([one.prepared for one in prepared])

    def decode(self, prepared: Any, values: Floats) -> Garment:
        """See `GarmentSewer.decode`."""
        large = super().decode(prepared.prepared, values)
        sewing = {
            name: value / self.factor if name.endswith("_cm") else value
            for name, value in large.report["sewing"].items()
        }
        lengths = {name: large.report[name] / self.factor for name in _LENGTHS}
        report = large.report | lengths | {"sewing": sewing}
        return Garment(prepared.mesh, large.vertices / self.factor, report)


def sewer_for(sewer: GarmentSewer, body: Body) -> GarmentSewer:
    """What sews on a body, with the network of another sewer.

    Args:
        sewer: For any body.
        body: Who wears the garments.
    """
    default = Body.default()
    factor = default.measurements.height / body.measurements.height
    if abs(factor - 1.0) < _ALIKE:
        return GarmentSewer(sewer.model, BodyDistance.of(body), sewer.closing, coarse=sewer.coarse)
    enlarged = BodyDistance.of(_scaled_body(body, factor))
    return ScaledSewer(sewer.model, enlarged, sewer.closing, factor, coarse=sewer.coarse)


def scaled_pattern(pattern: Pattern, factor: float) -> Pattern:
    """A pattern with all lengths multiplied, placements included."""
    panels = []
    for panel in pattern.panels:
        x, y, z = (factor * c for c in panel.placement.translation)
        edges = tuple(replace(edge, curve=scale(edge.curve, factor)) for edge in panel.edges)
        placement = replace(panel.placement, translation=(x, y, z))
        panels.append(replace(panel, vertices=panel.vertices * factor, edges=edges, placement=placement))
    return replace(pattern, panels=tuple(panels))


def _scaled_body(body: Body, factor: float) -> Body:
    m = body.measurements
    values = {name: value * (1 if name in _ANGLES else factor) for name, value in m.as_dict().items()}
    return replace(body, vertices=body.vertices * factor, measurements=type(m)(**values))

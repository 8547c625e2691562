"""GarmentSewer at use (paper, Fig. 3): patterns in, stitched garments out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.body import Body
from swifttailor.clock import Clock
from swifttailor.errors import InputError
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer.closing import ClosingSettings, close_seams, seam_gaps
from swifttailor.garment_sewer.conditioning import conditioning_image
from swifttailor.garment_sewer.crumpling import crumpled_share
from swifttailor.garment_sewer.model_file import SewerModel, load_model
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.garment_sewer.pixels.pixel_table import PixelTable, tabulate
from swifttailor.garment_sewer.pixels.sewn_prior import vertices_ignoring_arms
from swifttailor.ggi import Layout
from swifttailor.ggi.outline_decode import outline_sampler
from swifttailor.ggi.panel_cells import lay_out_as
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.pattern import Pattern

if TYPE_CHECKING:
    from swifttailor.draping.coarse import CoarseSettings
    from swifttailor.draping.compiled_code import CoarseDrapeLoading

SHIPPED = Path(__file__).with_name("garment_sewer.onnx")
BATCH = 8
"""Garments that go through the network together."""


@dataclass(frozen=True, eq=False)
class Prepared:
    """A pattern, drawn for the network."""

    layout: Layout
    table: PixelTable
    mesh: PatternMesh
    edge_length: float
    """Of the mesh, cm."""


@dataclass(frozen=True, eq=False)
class GarmentSewer:
    """Turns patterns into garments on the default body, without simulating the cloth at rest."""

    model: SewerModel
    body: BodyDistance
    closing: ClosingSettings = field(default_factory=ClosingSettings)
    coarse: CoarseSettings | None = field(default=None, kw_only=True)
    """How finely the drape is done that the network starts from; as it learnt it when None."""

    @staticmethod
    def load(weights: Path | str | None = None, *, threads: int = 1) -> GarmentSewer:
        """Opens a model file.

        Args:
            weights: File; the one that comes with the package when None.
            threads: CPU cores for the network.

        Raises:
            InputError: There is no such file, or it is damaged or another.
        """
        if weights is None and not SHIPPED.is_file():
            raise InputError(
                "This version comes without weights for a GarmentSewer. Give a model file (--weights FILE; "
                "with generate and edit --sewer-weights FILE); one is made by: "
                "swifttailor train garment-sewer --data DIR --out RUN"
            )
        model = load_model(SHIPPED if weights is None else weights, threads=threads)
        return GarmentSewer(model, BodyDistance.of(Body.default()))

    @property
    def card(self) -> dict[str, Any]:
        """What the network was trained on, and how good it is."""
        return self.model.card

    @property
    def must_compile(self) -> bool:
        """Whether the first garment waits for code that is not compiled on this machine yet."""
        if self.model.conditioning.prior != "hung":
            return False
        from swifttailor.draping.compiled_code import coarse_drape_is_compiled

        return not coarse_drape_is_compiled()

    def load_drape(self) -> None:
        """Begins to load, or to compile, the coarse drape in the background, before there is a pattern.

        What keeps it from being loaded is raised when the first pattern is prepared.
        """
        _ = self._drape_loading

    @cached_property
    def _drape_loading(self) -> CoarseDrapeLoading | None:
        if self.model.conditioning.prior != "hung":
            return None
        from swifttailor.draping.compiled_code import load_coarse_drape

        return load_coarse_drape(self.body.full, self.body.without_arms, self.body.measurements)

    def sew(self, pattern: Pattern, *, edge_length: float = 2.0, resolution: int | None = None) -> Garment:
        """Makes the garment of a pattern.

        Args:
            pattern: In any order.
            edge_length: Of the mesh, cm.
            resolution: Of the images; the model's own when None.

        Raises:
            InputError: An argument is out of range.
            PatternError: The pattern cannot be meshed.
            GeometryError: A panel crosses itself.
        """
        clock = Clock()
        prepared = self.prepare(pattern, edge_length=edge_length, resolution=resolution)
        clock.stop("drawing")
        (values,) = self.predict([prepared])
        clock.stop("network")
        garment = self.decode(prepared, values)
        clock.stop("decoding")
        return replace(garment, report=garment.report | {"seconds": clock.seconds})

    def prepare(
        self, pattern: Pattern, *, edge_length: float = 2.0, resolution: int | None = None
    ) -> Prepared:
        """Lays a pattern out, meshes it, and collects what the network is shown.

        Raises:
            SwiftTailorError: See `sew`.
        """
        resolution = self.model.resolution if resolution is None else resolution
        if resolution % self.model.patch_size:
            raise InputError(
                f"The resolution is {resolution}; a multiple of {self.model.patch_size} is accepted by this "
                f"network, which was trained at {self.model.resolution}."
            )
        layout = lay_out_as(self.model.conditioning.layout, pattern, resolution)
        mesh = mesh_pattern(layout.pattern, edge_length)
        if loading := self.__dict__.get("_drape_loading"):  # only where somebody has begun to
            loading.wait()
        table = tabulate(layout, self.model.conditioning.prior, self.body, coarse=self.coarse)
        return Prepared(layout, table, mesh, edge_length)

    def predict(self, prepared: Sequence[Prepared]) -> list[Floats]:
        """Positions (n, 3) in cm of the occupied pixels of each layout; all of one resolution."""
        tables = [p.table for p in prepared]
        size = tables[0].resolution
        conditioning = np.stack([conditioning_image(t, self.model.conditioning) for t in tables])
        occupancy = np.zeros((len(tables), 1, size * size), np.float32)
        prior = np.zeros((len(tables), 3, size * size), np.float32)
        for k, table in enumerate(tables):
            occupancy[k, 0, table.pixels] = 1
            for axis in range(3):
                prior[k, axis, table.pixels] = table.prior[:, axis]
        shape = (len(tables), -1, size, size)
        positions = self.model.network(conditioning, occupancy.reshape(shape), prior.reshape(shape))
        positions = positions.reshape(len(tables), 3, -1)
        return [positions[k][:, t.pixels].T.astype(np.float64) for k, t in enumerate(tables)]

    def decode(self, prepared: Prepared, values: Floats) -> Garment:
        """The garment of predicted positions (n, 3) of a layout's occupied pixels.

        Raises:
            InputError: The positions are not finite.
        """
        layout, mesh = prepared.layout, prepared.mesh
        if not np.isfinite(values).all():
            raise InputError("The network's positions are not finite numbers: its weights are damaged.")
        weights = outline_sampler(layout, mesh).weights
        flat = weights @ values
        gaps, crumpled = seam_gaps(mesh, flat), crumpled_share(mesh, flat)
        vertices = close_seams(mesh, flat, self.body, self.closing)
        depth, _ = self.body.sample(vertices, vertices_ignoring_arms(mesh))
        report: dict[str, Any] = {
            "source": "garment sewer",
            "edge_length_cm": prepared.edge_length,
            "rotation": layout.pattern.panels[0].placement.reading,
            "resolution": layout.resolution,
            "cm_per_pixel": layout.cm_per_pixel,
            "vertices": mesh.vertex_count,
            "faces": len(mesh.faces),
            "panels": len(layout.pattern.panels),
            "stitches": len(layout.pattern.stitches),
            "sewing": {
                "seam_gap_before_median_cm": float(np.median(gaps)) if len(gaps) else 0.0,
                "seam_gap_before_p95_cm": float(np.percentile(gaps, 95)) if len(gaps) else 0.0,
                "inside_body": float((depth < 0).mean()),
                "crumpled": crumpled,
            },
        }
        return Garment(mesh, vertices, report)

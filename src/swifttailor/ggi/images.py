"""The Garment Geometry Image: three aligned images of a pattern and its drape (paper, Sec. 4.2)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swifttailor.garment.garment import Garment
from swifttailor.ggi.geometry import rasterize_geometry
from swifttailor.ggi.layout import Layout, lay_out
from swifttailor.ggi.semantic import semantic_image
from swifttailor.ggi.stitching import StitchingImage, stitching_image
from swifttailor.pattern import Pattern


@dataclass(frozen=True, eq=False)
class GarmentGeometryImage:
    """Semantic, stitching and geometry image, (N, N) each, row 0 at the bottom."""

    layout: Layout | None
    """None where only the images are known."""
    occupancy: NDArray[np.bool_]
    """(N, N) whether a pixel belongs to a panel. The other images mean nothing elsewhere."""
    panel: NDArray[np.int16]
    """(N, N) panel index, -1 where there is none."""
    semantic: NDArray[np.uint8]
    """(N, N) panel type (`semantic.PANEL_TYPES`), 0 where there is none."""
    stitching: StitchingImage
    """What is sewn to what."""
    geometry: NDArray[np.float32] | None = None
    """(N, N, 3) position in cm, None for a pattern without a drape."""

    @property
    def resolution(self) -> int:
        """Pixels along each side."""
        return len(self.occupancy)


def encode(
    source: Pattern | Garment,
    resolution: int = 256,
    *,
    gutter: int = 2,
    cm_per_pixel: float | None = None,
    packing: str = "skyline",
) -> GarmentGeometryImage:
    """Draws a pattern (semantic and stitching image) or a garment (all three).

    Args:
        source: A pattern in any order, or a garment.
        resolution: Pixels along each side.
        gutter: Free pixels kept between any two panels.
        cm_per_pixel: A scale to use instead of the largest one at which all panels fit.
        packing: How panels are packed; see `lay_out`.

    Raises:
        InputError: The panels do not fit, or an argument is out of range.
    """
    pattern = source.pattern if isinstance(source, Garment) else source
    layout = lay_out(pattern, resolution, gutter=gutter, cm_per_pixel=cm_per_pixel, packing=packing)
    geometry = None
    if isinstance(source, Garment):
        geometry, _ = rasterize_geometry(layout, source.mesh, source.vertices)
    return GarmentGeometryImage(
        layout,
        layout.raster.occupancy,
        layout.raster.panel,
        semantic_image(layout),
        stitching_image(layout),
        geometry,
    )

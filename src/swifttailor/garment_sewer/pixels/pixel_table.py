"""What a pattern knows of each pixel of its images, before anything is predicted."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from swifttailor.garment_sewer.pixels.body_distance import BodyDistance, panels_ignoring_arms
from swifttailor.garment_sewer.pixels.sewn_prior import SewingSettings, sew_around_body
from swifttailor.ggi import Layout
from swifttailor.ggi.geometry import geometry_raster
from swifttailor.ggi.panel_colors import PANEL_COLORS
from swifttailor.ggi.semantic import panel_type
from swifttailor.ggi.stitching import StitchingImage, stitching_image
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern import Pattern

if TYPE_CHECKING:
    from swifttailor.draping.coarse import CoarseSettings
    from swifttailor.garment_sewer.conditioning import PriorKind

Array = Any
"""A numpy array or a torch tensor: the same table is used on either side."""


@dataclass(frozen=True, eq=False)
class PixelTable:
    """The n occupied pixels of a layout and its p panels; cm, and pixel coordinates as in `Layout`."""

    resolution: int
    cm_per_pixel: float
    """Of all panels, or the mean where each is stretched by itself."""
    pixels: Array
    """(n,) row * resolution + column."""
    panel: Array
    """(n,) panel index."""
    point: Array
    """(n, 2) pixel coordinates of the point each pixel stands for."""
    contour: Array
    """(n,) whether that point lies on the outline."""
    partner: Array
    """(n,) index into this table of the pixel it is sewn to, -1 where there is none."""
    prior: Array
    """(n, 3) where the prior puts it."""
    distance: Array
    """(n,) from the body, at the prior; 0 without a prior."""
    direction: Array
    """(n, 3) away from the body, at the prior; 0 without a prior."""
    panel_color: Array
    """(p, 3) of each panel's type, -1 to 1."""
    mirror_color: Array
    """(p, 3) of the type that the panel has in the mirrored garment."""
    panel_origin: Array
    """(p, 2) pixel coordinates of the panel's local origin."""
    panel_sign: Array
    """(p,) -1 where local x runs from right to left."""
    panel_cm: Array
    """(p, 2) cm from column to column and from row to row."""
    panel_log_cm: Array
    """(p, 2) their logarithms."""
    panel_axes: Array
    """(p, 2, 3) directions of local x and y in the world."""
    panel_offset: Array
    """(p, 3) placed local origin."""
    panel_normal: Array
    """(p, 3) outward normal of the placed panel."""
    panel_box: Array
    """(p, 4) first column, first row, last column, last row."""

    def local(self) -> Array:
        """(n, 2) panel-local position."""
        local = (self.point - self.panel_origin[self.panel]) * self.panel_cm[self.panel]
        local[:, 0] *= self.panel_sign[self.panel]
        return local

    def placed(self) -> Array:
        """(n, 3) position of the flat panel where the pattern places it."""
        local, axes = self.local(), self.panel_axes[self.panel]
        return local[:, :1] * axes[:, 0] + local[:, 1:] * axes[:, 1] + self.panel_offset[self.panel]

    def map(self, change: Callable[[Array], Array]) -> PixelTable:
        """This table with all its arrays changed, for instance into tensors on a device."""
        arrays = {f.name: change(getattr(self, f.name)) for f in fields(self) if f.type == "Array"}
        return replace(self, **arrays)


def tabulate(
    layout: Layout,
    prior: PriorKind,
    body: BodyDistance | None,
    *,
    stitching: StitchingImage | None = None,
    sewing: SewingSettings | None = None,
    coarse: CoarseSettings | None = None,
) -> PixelTable:
    """Collects what is known of a pattern's pixels; float32 and int64 arrays.

    Args:
        layout: Of the pattern.
        prior: Where to start from; see `Conditioning`.
        body: Needed with a prior.
        stitching: Of the layout, where it was drawn already.
        sewing: How the panels are sewn, with the prior ``sewn``.
        coarse: How finely they are draped, with the prior ``hung``; as the network learnt it when None.

    Raises:
        PatternError: The panels cannot be meshed, with the priors ``sewn`` and ``hung``.
        GeometryError: A panel crosses itself, with the same.
        SimulationError: The cloth went to infinity, with the prior ``hung``.
    """
    raster, panels = layout.raster, layout.pattern.panels
    pixel_panel = raster.pixel_panel.astype(np.int64)
    axes = np.array([p.to_world([[1.0, 0.0], [0.0, 1.0]]) - p.to_world([[0.0, 0.0]]) for p in panels])
    mirror = mirror_partners(layout.pattern)
    color = PANEL_COLORS[[panel_type(p.name, p.label) for p in panels]] / 127.5 - 1
    table = PixelTable(
        resolution=layout.resolution,
        cm_per_pixel=layout.cm_per_pixel,
        pixels=raster.pixels.astype(np.int64),
        panel=pixel_panel,
        point=raster.points.astype(np.float32),
        contour=raster.edge >= 0,
        partner=_partners(layout, stitching or stitching_image(layout)),
        prior=np.zeros((len(pixel_panel), 3), np.float32),
        distance=np.zeros(len(pixel_panel), np.float32),
        direction=np.zeros((len(pixel_panel), 3), np.float32),
        panel_color=color.astype(np.float32),
        mirror_color=color[mirror].astype(np.float32),
        panel_origin=layout.origins.astype(np.float32),
        panel_sign=np.where(layout.mirrored, -1.0, 1.0).astype(np.float32),
        panel_cm=layout.panel_cm_per_pixel.astype(np.float32),
        panel_log_cm=np.log(layout.panel_cm_per_pixel).astype(np.float32),
        panel_axes=axes.astype(np.float32),
        panel_offset=np.concatenate([p.to_world([[0.0, 0.0]]) for p in panels]).astype(np.float32),
        panel_normal=np.array([p.normal() for p in panels], np.float32),
        panel_box=layout.boxes,
    )
    if prior == "none":
        return table
    assert body is not None, "a prior is given together with a body"
    if prior == "sewn":
        sewing = sewing or SewingSettings()
        mesh = mesh_pattern(layout.pattern, sewing.edge_length)
        points = geometry_raster(layout, mesh).values(sew_around_body(mesh, body, sewing))
    elif prior == "hung":
        points = _hung(layout, body, coarse)
    else:
        points = table.placed().astype(np.float64)
    ignores = panels_ignoring_arms(layout.pattern)[pixel_panel]
    distance, direction = body.sample(points, ignores)
    return replace(
        table,
        prior=points.astype(np.float32),
        distance=distance.astype(np.float32),
        direction=direction.astype(np.float32),
    )


def _hung(layout: Layout, body: BodyDistance, coarse: CoarseSettings | None) -> Array:
    """(n, 3) where a coarse drape puts the pixels."""
    from swifttailor.draping.coarse import CoarseSettings, coarse_edge_length, drape_coarsely

    settings = coarse or CoarseSettings()
    mesh = mesh_pattern(layout.pattern, coarse_edge_length(layout.pattern, settings))
    hung = drape_coarsely(mesh, body.full, body.without_arms, body.measurements, settings=settings)
    return geometry_raster(layout, mesh).values(hung)


def _partners(layout: Layout, stitching: StitchingImage) -> Array:
    """(n,) index of the pixel that each occupied pixel is sewn to, -1 where there is none."""
    raster = layout.raster
    partner = np.full(len(raster.pixels), -1, np.int64)
    slot = np.searchsorted(raster.pixels, stitching.pixels)
    other = np.searchsorted(raster.pixels, stitching.partners())
    # A pixel may be in several sides; the first stays, as in the stitching image.
    partner[slot[::-1]] = other[::-1]
    return partner


_SIDE = re.compile(r"left|right|(?<=_)[lr](?=_|$)|\d+")


def mirror_partners(pattern: Pattern) -> Array:
    """(p,) for each panel the one whose part it takes when the garment is mirrored left to right.

    Of the panels whose names differ from its own in sides and numbers alone it is the one whose placed middle
    is nearest to the mirror image of its own; a panel in the middle is its own partner.
    """
    panels = pattern.panels
    middle = np.array([p.to_world(p.vertices).mean(axis=0) for p in panels])
    family = np.array([_SIDE.sub("#", p.name.lower()) for p in panels])
    apart = np.linalg.norm(middle[:, None] * [-1.0, 1.0, 1.0] - middle[None], axis=2)
    apart[family[:, None] != family[None]] = np.inf
    return apart.argmin(axis=1)

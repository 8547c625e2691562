"""From the images alone back to a mesh, as the paper does it: its pixels are the vertices (Alg. 5 and 6)."""

from __future__ import annotations

import numpy as np

from swifttailor.errors import GeometryError, InputError
from swifttailor.ggi.images import GarmentGeometryImage
from swifttailor.ggi.pockets import fill_pockets
from swifttailor.ggi.remesh import PixelGrid, remesh
from swifttailor.ggi.slits import open_grid, seam_sides
from swifttailor.ggi.stitch import SewnGrid, sew


def decode_grid(images: GarmentGeometryImage) -> SewnGrid:
    """Makes the garment that the images show; neither pattern nor layout is looked at.

    Panels become triangles between neighbouring pixels, are cut open where they would reach across a slit,
    and are sewn along the sides of the stitching image.

    Raises:
        InputError: The images have no geometry, or one that is not finite, or contradict each other.
        GeometryError: No panel is wide enough to have a face.
    """
    if images.geometry is None:
        raise InputError(
            "These images are of a pattern without a drape: there are no positions to decode. "
            "Encode a draped garment."
        )
    stitching = images.stitching
    if not np.isfinite(images.geometry[images.panel >= 0]).all():
        raise InputError("The geometry image holds positions inside panels that are not finite numbers.")
    if not (images.panel.ravel()[stitching.pixels] >= 0).all():
        raise InputError("The stitching image sews pixels that belong to no panel.")
    begins = np.zeros(len(stitching.pixels) + 1, np.bool_)
    begins[stitching.start] = True
    if not (begins[1:-1] | (np.diff(stitching.fraction) >= 0)).all():
        raise InputError("The stitching image has a side whose pixels are not in the order of its seam.")
    panel, geometry = fill_pockets(images.panel, images.geometry, stitching)
    grid = PixelGrid.of(panel)
    positions = geometry.reshape(-1, 3)[grid.pixels]
    sides = seam_sides(grid, stitching)
    faces = remesh(grid, positions, sides.links)
    if not len(faces):
        raise GeometryError(
            "No panel in these images is as much as two pixels wide, so there is nothing to make a mesh of. "
            "Draw them with a higher resolution, or decode them with the method 'outline'."
        )
    mesh = open_grid(grid, faces, sides)
    return sew(grid, positions, mesh, sides, stitching)

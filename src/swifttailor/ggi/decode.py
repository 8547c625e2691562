"""From Garment Geometry Images back to a garment, in one of two ways."""

from __future__ import annotations

from typing import Literal

from swifttailor.errors import InputError
from swifttailor.garment.garment import Garment
from swifttailor.ggi.grid_decode import decode_grid
from swifttailor.ggi.images import GarmentGeometryImage
from swifttailor.ggi.outline_decode import decode_outline
from swifttailor.ggi.stitch import SewnGrid

Method = Literal["outline", "grid"]


def decode(
    images: GarmentGeometryImage, method: Method = "outline", edge_length: float = 2.0
) -> Garment | SewnGrid:
    """Makes a garment of images.

    Args:
        images: With geometry.
        method: ``outline`` cuts panels along their exact outlines and needs the layout. ``grid`` takes the
            pixels as vertices and finds the seams in the images (paper, Alg. 5 and 6).
        edge_length: Of the mesh in cm, with ``outline``.

    Returns:
        A `Garment` with ``outline``, a `SewnGrid` with ``grid``.

    Raises:
        InputError: The images lack what the method needs.
        PatternError: The pattern cannot be meshed.
        GeometryError: A panel crosses itself.
    """
    if method == "grid":
        return decode_grid(images)
    if method != "outline":
        raise InputError(f"There is no method '{method}'. Known ones: outline, grid.")
    if images.layout is None:
        raise InputError(
            "These images come without their pattern and its layout, which the method 'outline' needs. "
            "Decode them with the method 'grid'."
        )
    if images.geometry is None:
        raise InputError(
            "These images are of a pattern without a drape: there are no positions to decode. "
            "Encode a draped garment."
        )
    return decode_outline(images.layout, images.geometry, edge_length)

"""A picture printed on a garment's cloth: where each panel lies on it, at true scale and along the grain."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.body import Body
from swifttailor.describing.measuring.anatomy import Anatomy
from swifttailor.describing.measuring.parts import ARM_PARTS
from swifttailor.errors import InputError
from swifttailor.garment import Garment
from swifttailor.garment.triangle_mesh import PrintedPicture
from swifttailor.making.upright import turn_upright
from swifttailor.render.picture_file import read_picture
from swifttailor.render.png import encode_png

MIN_WIDTH_CM, MAX_WIDTH_CM = 0.5, 500.0


def cloth_print(garment: Garment, picture: Path | str, width: float) -> PrintedPicture:
    """A picture that repeats over all panels of a garment.

    Each panel shows the part of the printed cloth that it would be cut from: the picture stands upright
    along the grain and has its true size. Panels are laid so that the picture meets at the side seams as
    nearly as it can: at the height and the distance from the middle where they are worn. On sleeves it
    follows the arm.

    Args:
        garment: What is printed.
        picture: PNG, JPEG, WebP or another picture file; one repeat.
        width: Of one repeat, cm.

    Raises:
        InputError: The picture cannot be used, or the width is out of range.
    """
    if not MIN_WIDTH_CM <= width <= MAX_WIDTH_CM:
        raise InputError(
            f"One repeat of the print is {width:g} cm wide; from {MIN_WIDTH_CM:g} to {MAX_WIDTH_CM:g} cm "
            "is accepted."
        )
    pixels = read_picture(picture)
    height = width * pixels.shape[0] / pixels.shape[1]
    return PrintedPicture(encode_png(pixels), places_on_cloth(garment) / (width, height))


def places_on_cloth(garment: Garment) -> Floats:
    """(m, 2) where each flat vertex lies on the cloth, cm: x across the grain, y along it, upwards."""
    mesh = garment.mesh
    parts = Anatomy.of(garment.pattern, Body.default().measurements).parts
    places = np.zeros_like(mesh.flat_vertices)
    for k, panel in enumerate(garment.pattern.panels):
        own = mesh.flat_panel == k
        on_arm = parts[panel.name].part in ARM_PARTS
        flat = mesh.flat_vertices[own] @ turn_upright(panel, on_arm=on_arm).T
        middle = (flat.min(axis=0) + flat.max(axis=0)) / 2
        worn = np.zeros(2)
        if not on_arm:
            world = panel.to_world(mesh.flat_vertices[own])
            # Seen from outside, the back runs the other way.
            sign = -1.0 if panel.normal()[2] < 0 else 1.0
            worn = (world.min(axis=0) + world.max(axis=0))[:2] / 2 * (sign, 1.0)
        places[own] = flat - middle + worn
    return places

"""Whether a garment that was sewn still lies on the shoulders."""

from __future__ import annotations

from swifttailor.body import BodyMeasurements
from swifttailor.describing.measuring.anatomy import Anatomy
from swifttailor.describing.measuring.wear import wear
from swifttailor.errors import SwiftTailorError
from swifttailor.garment.garment import Garment

SLIPPED = 0.35
"""Part of the way from the bust up to the neck; shoulder seams that lie lower have slipped."""
SLIPS = "it slips off the shoulders"


def slips_off(garment: Garment, body: BodyMeasurements) -> bool:
    """Whether a shoulder seam lies near the bust or lower.

    Args:
        garment: As it was sewn.
        body: Of its wearer.
    """
    mesh = garment.mesh
    try:
        anatomy = Anatomy.of(mesh.pattern, body)
        shoulders = wear(anatomy).shoulders
    except SwiftTailorError:
        return False
    figure = anatomy.figure
    lowest = figure.bust_y + SLIPPED * (figure.neck_y - figure.bust_y)
    number = {panel.name: k for k, panel in enumerate(mesh.pattern.panels)}
    for seam in shoulders:
        for ref in () if seam is None else seam.own:
            vertices = mesh.weld[mesh.edge_vertices[number[ref.panel]][ref.edge]]
            if float(garment.vertices[vertices, 1].mean()) < lowest:
                return True
    return False

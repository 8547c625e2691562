"""Whether a garment has holes that no garment has: seams that were left open."""

from __future__ import annotations

import numpy as np

from swifttailor.describing.measuring.anatomy import Anatomy, Border
from swifttailor.describing.measuring.parts import Part
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import EdgeRef, Panel, Pattern
from swifttailor.recutting.table.cutter import Cutter

_GORE = "skirt_panel_"
STEEP, TALL = 0.8, 0.5
"""Rise over length, and over the height of its panel, of an edge that is the side of a gore."""


def has_holes(pattern: Pattern) -> bool:
    """Whether its free borders are others than one at the top, a hem or two legs, and one on each arm.

    So it is with each of GarmentCode's 150 validation patterns; and each gore of theirs is sewn to its
    neighbours.
    """
    if not pattern.panels:
        return False
    try:
        anatomy = Cutter(pattern).anatomy
    except SwiftTailorError:
        return False  # what is wrong with it is said elsewhere
    count = {border: len(anatomy.loops(border)) for border in Border}
    if any(_is_open(pattern, panel) for panel in anatomy.panels(Part.SKIRT) if _GORE in panel.name):
        return True
    legs, hems = count[Border.LEG], count[Border.HEM]
    arms = [loop.center[0] > 0 for loop in anatomy.loops(Border.ARM)]
    return (
        count[Border.TOP] != 1
        or count[Border.OTHER] > _bare_backs(anatomy)
        or (legs, hems) not in ((2, 0), (0, 1))
        or any(arms.count(side) > 1 for side in (True, False))
    )


def _bare_backs(anatomy: Anatomy) -> int:
    """1 for a halter, whose arms and back are bare in one border around both sides, front and back."""
    if anatomy.loops(Border.ARM):
        return 0
    around = [{anatomy.parts[r.panel] for r in loop.edges} for loop in anatomy.loops(Border.OTHER)]
    sides = [{(each.side, each.face) for each in parts if each.part is Part.TORSO} for parts in around]
    return int(any(len(each - {("middle", "front"), ("middle", "back")}) == 4 for each in sides))


def _is_open(pattern: Pattern, panel: Panel) -> bool:
    """Whether a side of a panel is sewn to nothing."""
    sewn = {side for stitch in pattern.stitches for side in stitch.sides}
    height = float(np.ptp(panel.to_world(panel.vertices)[:, 1]))
    for edge in range(len(panel.edges)):
        if EdgeRef(panel.name, edge) not in sewn:
            rise = float(np.ptp(panel.to_world(panel.chord(edge))[:, 1]))
            if rise > max(STEEP * panel.edge_length(edge), TALL * height):
                return True
    return False

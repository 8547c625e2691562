"""How far below its waist seam the hem of a skirt lies, all around, as tailors measure hems."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from swifttailor.describing.facts import HemFacts
from swifttailor.describing.measuring.hems import find_hem, measure_hem
from swifttailor.describing.measuring.parts import SKIRT_PARTS, Part
from swifttailor.describing.measuring.skirts import upper_edges
from swifttailor.recutting.table.cutter import Cutter


def hem_below_waist(cutter: Cutter) -> HemFacts | None:
    """The hem of a skirt that hangs from a waist all of which is at one height.

    The front of a fitted bodice is longer than its back, for it goes over the bust: dresses hang level whose
    skirts are everywhere as long.

    Returns:
        Heights above the floor, cm; None without a skirt, or where not all of the hem hangs from its upper
        edge.
    """
    anatomy, worn = cutter.anatomy, cutter.worn
    top, _ = upper_edges(anatomy, Part.SKIRT)
    hem = cutter.hem_of(*SKIRT_PARTS)
    if not top or not hem:
        return None
    fall = anatomy.cloth.distances(anatomy.cloth.nodes(top))
    if not np.isfinite(fall[anatomy.cloth.nodes(hem)]).all():
        return None
    waist = float(worn.levels(anatomy, top).mean())
    level = np.where(np.isfinite(fall), waist - fall, worn.level)
    return measure_hem(anatomy, replace(worn, level=level), find_hem(anatomy, worn))

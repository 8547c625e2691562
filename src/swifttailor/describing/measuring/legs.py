"""Trouser legs."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from swifttailor.describing.facts import Trousers
from swifttailor.describing.measuring.anatomy import Anatomy, Border
from swifttailor.describing.measuring.parts import Part, Side
from swifttailor.describing.measuring.skirts import upper_edges
from swifttailor.describing.measuring.sleeves import measure_cuff
from swifttailor.describing.measuring.slices import girth_at, width_in_plane
from swifttailor.describing.measuring.wear import Worn
from swifttailor.pattern import EdgeRef

_BELOW_CROTCH_CM = 2.0


def measure_trousers(anatomy: Anatomy, worn: Worn) -> Trousers | None:
    """Measures the legs; None where there are none."""
    panels = anatomy.panels(Part.TROUSER)
    legs = [leg for side in ("left", "right") if (leg := _leg(anatomy, side)) is not None]
    if not panels or not legs:
        return None
    top, seam = upper_edges(anatomy, Part.TROUSER)
    cuffs = [measure_cuff(anatomy, Part.TROUSER, Part.LEG_CUFF, side) for side in ("left", "right")]
    joined = anatomy.seam(Part.TROUSER, Part.LEG_CUFF)
    openings = [loop.length for loop in anatomy.loops(Border.LEG)]
    inseam, thigh, hem = (float(v) for v in np.mean(legs, axis=0))
    return Trousers(
        inseam=inseam,
        thigh=thigh,
        hem=hem,
        opening=float(np.mean(openings)) if openings else hem,
        end_gather=joined.gather,
        gather=seam.gather,
        hips=_hips(anatomy, worn, top),
        cuff=next((c for c in cuffs if c), None),
        darts=anatomy.darts(Part.TROUSER),
    )


def _leg(anatomy: Anatomy, side: Side) -> tuple[float, float, float] | None:
    """Inseam with cuff, thigh and hem of one leg, cm."""
    cloth = anatomy.cloth
    names = {p.name for p in anatomy.panels(Part.TROUSER, side=side)}
    between = [
        s for s in cloth.stitches if {r.panel for r in s.sides} <= names and s.first.panel != s.second.panel
    ]
    if not between:
        return None
    inner = _inner_seam(anatomy, [s.first for s in between])
    refs = {r for s in between for r in s.sides if s.first in inner}
    ends = [*anatomy.seam(Part.TROUSER, Part.LEG_CUFF, side=side).own]
    ends += [r for loop in anatomy.loops(Border.LEG) for r in loop.edges if r.panel in names]
    thigh = 0.0
    for name in names:
        own = [r for r in refs if r.panel == name]
        if not own:
            return None
        crotch = float(cloth.placed(own)[:, 1].max())
        thigh += width_in_plane(anatomy.pattern.panel(name), (0.0, 1.0, 0.0), crotch - _BELOW_CROTCH_CM)
    cuff = measure_cuff(anatomy, Part.TROUSER, Part.LEG_CUFF, "left" if side == "left" else "right")
    inseam = sum(map(anatomy.edge_length, inner)) + (cuff.length if cuff else 0.0)
    return inseam, thigh, sum(map(anatomy.edge_length, ends))


def _inner_seam(anatomy: Anatomy, refs: Sequence[EdgeRef]) -> list[EdgeRef]:
    """Those edges of front-to-back seams of one leg that lie on its inside."""
    middle = {r: abs(float(anatomy.cloth.placed([r])[:, 0].mean())) for r in refs}
    split = (min(middle.values()) + max(middle.values())) / 2
    return [r for r in refs if middle[r] <= split]


def _hips(anatomy: Anatomy, worn: Worn, top: Sequence[EdgeRef]) -> float:
    """Girth at the height of the hips, on the placed panels that far below their upper edges."""
    if not top:
        return 0.0
    depth = float(worn.levels(anatomy, top).mean()) - anatomy.figure.hip_y
    total = 0.0
    for panel in anatomy.panels(Part.TROUSER):
        own = [r for r in top if r.panel == panel.name]
        if own:
            placed = float(anatomy.cloth.placed(own)[:, 1].mean())
            total += girth_at([panel], placed - max(depth, 1.0))
    return total

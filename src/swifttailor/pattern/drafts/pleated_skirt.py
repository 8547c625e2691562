"""Skirts laid in knife pleats: strips that overlap, joined by the cloth that is folded away between them.

Cloth does not keep a crease, so folds are seams: like those of collars that lie folded, nothing unbends them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.drafts.around_body import around
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Halves
from swifttailor.pattern.drafts.outline import Outline

LEAST_PLEATS = 2
"""Strips of a pleated skirt on each side, at least."""
_INSIDE_CM = 0.3
"""How far inside the strips the cloth between them stands."""
_LIFT_CM = 2.0
"""How much further in the hidden edge of a strip stands than the one that is seen."""
_TUCK_DROP_CM = 2.0
"""How far below the waist hidden edges begin: cut away, they do not stand out below the band."""
_DEEPEST = 0.85
"""Depth of a pleat over the width of a strip at the waist, at most."""
_OF_HIPS = 0.6
"""Part of what the waist is narrower than the hips that the strips widen by there, at least."""
Face = Literal["front", "back"]


@dataclass(frozen=True)
class KnifePleats:
    """How the skirt is cut."""

    length: float
    """Upper edge to hem, cm."""
    strips: int
    """Seen in front, and as many behind: one more than there are pleats."""
    depth: float
    """Cloth that is folded under each strip, twice, cm; less where strips are narrow."""
    flare: float
    """Width of the hem over that of the waist as it hangs, cm around."""
    apron: bool = False
    """Whether the front is flat, in one strip, as of a kilt."""

    def strips_of(self, face: Face) -> int:
        """Of one face: front or back."""
        return 1 if self.apron and face == "front" else self.strips


def lay_pleated_skirt(
    table: CuttingTable, waist: Halves, shape: KnifePleats, top_y: float, *, hips: Halves, to_hips: float
) -> None:
    """Lays the strips ``skirt_pleat_0_front`` ... and what is folded away, ``skirt_under_1_front`` ...

    Edges: hem, right, top, tuck, left; `sew_pleats_to_band` or `sew_pleats_to_bodice` sews the upper ones.

    Args:
        table: Where they go.
        waist: Half widths of the upper edge, cm.
        shape: The cut.
        top_y: World height of the upper edge, cm.
        hips: Half widths that it must have there, cm.
        to_hips: Upper edge to the hips, cm.
    """
    # Front and back widen alike, so that their sides are equally long; pleats that open give room as well.
    lacking = max(hips.front - waist.front, hips.back - waist.back) * shape.length / to_hips
    wider = max(shape.flare / 2, 2 * _OF_HIPS * lacking)
    faces: tuple[tuple[Face, float], ...] = (("front", 2 * waist.front), ("back", 2 * waist.back))
    for face, width in faces:
        panel = _Half(face, width, width + wider, shape)
        for k in range(shape.strips_of(face)):
            panel.lay(table, k, top_y)
        for k in range(1, shape.strips_of(face)):
            panel.lay(table, k, top_y, under=True)
            before, under, after = panel.name(k - 1), panel.name(k, under=True), panel.name(k)
            table.seam(f"{before}.right", f"{under}.right", folded=True)
            table.seam(f"{under}.left", f"{after}.left", folded=True)
            table.seam(f"{under}.tuck", f"{after}.tuck", folded=True)
    front, back = (shape.strips_of(face) - 1 for face in ("front", "back"))
    table.seam("skirt_pleat_0_front.left", "skirt_pleat_0_back.left")
    table.seam(f"skirt_pleat_{front}_front.right", f"skirt_pleat_{back}_back.right")


def sew_pleats_to_band(table: CuttingTable, strips: int, *, apron: bool = False) -> None:
    """Sews what is seen of the strips to the lower edge of the waistband.

    Args:
        table: Where they lie.
        strips: Behind, and as many in front.
        apron: Whether the front is one strip.
    """
    for face in ("front", "back"):
        count = 1 if apron and face == "front" else strips
        edges = [f"skirt_pleat_{k}_{face}.top" for k in range(count)]
        table.seam(f"wb_{face}.bottom", edges if face == "front" else edges[::-1])


def sew_pleats_to_bodice(table: CuttingTable, strips: int, edge: str = "waist") -> None:
    """Sews what is seen of the strips to the waist of both halves of a bodice, or to another lower edge."""
    for face, halves in (("front", ("left", "right")), ("back", ("right", "left"))):
        edges = [f"skirt_pleat_{k}_{face}.top" for k in range(strips)]
        for top in edges:
            table.label(top, "lower_interface")
        waists = [f"{half}_{face[0]}torso.{edge}" for half in halves]
        table.seam(edges[::-1] if face == "front" else edges, waists)


@dataclass(frozen=True)
class _Half:
    """Front or back, from the wearer's right (-x) to the left."""

    face: Face
    top: float
    hem: float
    """Widths as it hangs, cm."""
    shape: KnifePleats

    def name(self, k: int, *, under: bool = False) -> str:
        return f"skirt_{'under' if under else 'pleat'}_{k}_{self.face}"

    def lay(self, table: CuttingTable, k: int, top_y: float, *, under: bool = False) -> None:
        """Lays strip `k`, or what is folded away between it and the one before."""
        hidden = k > 0
        depth = (
            min(self.shape.depth, _DEEPEST * self.top / self.shape.strips_of(self.face)) if hidden else 0.0
        )
        drop = _TUCK_DROP_CM if hidden else 0.0
        left = (self._fold(k, drop) - depth, -drop)
        below = (self._end(k)[0] - depth, self._end(k)[1])
        right = k if under else k + 1
        outline = Outline(*below).line("hem", *self._end(right))
        outline.line("right", self._fold(right, 0.0), 0.0)
        if not under:
            outline.line("top", self._fold(k, 0.0), 0.0)
        if hidden:
            outline.line("tuck", *left)
        outline.line("left", *below)
        ends = (left[0], self._fold(right, 0.0))
        place, turn = self._place(
            *ends, lift=_LIFT_CM if hidden else 0.0, inside=_INSIDE_CM if under else 0.0
        )
        table.lay(
            self.name(k, under=under),
            outline.closed(),
            label="leg",
            at=(place[0], top_y, place[1]),
            rotation=(0.0, turn, 0.0),
            back=self.face == "back",
        )

    def _fold(self, k: int, down: float) -> float:
        """X of fold `k` so far below the waist, cm."""
        strips = self.shape.strips_of(self.face)
        start, end = ((k / strips - 0.5) * width for width in (self.top, self.hem))
        return start + (end - start) * down / self.shape.length

    def _end(self, k: int) -> tuple[float, float]:
        """Where fold `k` meets the hem: folds are as long as the middle, or the sides would hang lower."""
        x, length = self._fold(k, 0.0), self.shape.length
        share = length / math.hypot(self._fold(k, length) - x, length)
        return x + share * (self._fold(k, length) - x), -share * length

    def _place(self, left: float, right: float, *, lift: float, inside: float) -> tuple[Floats, float]:
        """Where (x, z) the local origin of a strip goes, and how far it is turned about y, degrees."""
        middle = (max(left, -self.top / 2) + right) / 2
        at, _ = around(right / self.top + 0.5)
        _, along = around(middle / self.top + 0.5)
        outward = np.array([-along[1], along[0]])
        tilt = math.asin(min(lift / (right - left), 0.9))
        axis = math.cos(tilt) * along + math.sin(tilt) * outward
        at = at - inside * outward
        if self.face == "back":
            axis, at = axis * [1.0, -1.0], at * [1.0, -1.0]
        return at - right * axis, math.degrees(math.atan2(-axis[1], axis[0]))

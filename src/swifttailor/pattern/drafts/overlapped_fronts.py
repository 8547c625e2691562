"""Fronts of jackets and robes that lie over each other below the last button."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.pattern.drafts.cutting_table import CuttingTable, Piece
from swifttailor.pattern.drafts.outline import Side

OVER_SHARE = 0.35
"""Part of an overlap that lies beyond the middle, on the side of the lower front."""
_STEEPEST = 0.8
"""An overlap at the hem over the length of what is open, at most."""
_FLATTEST = 0.7
"""How far beside the middle fronts meet, over the length of the seam above, at most."""
OVERLAP_Z = 6.0
"""So far behind the upper front the lower one stands before draping, cm."""


def overlap_fronts(table: CuttingTable, opening: float, crossing: float = 0.0) -> None:
    """Lays the right front over the left one below where they are sewn; after `CuttingTable.mirror`.

    Args:
        table: Where both lie.
        opening: See `LooseBodice.front_opening`; nothing is done unless it is negative.
        crossing: How far beside the middle, on the wearer's left, the fronts meet where they are sewn last:
            the seam above runs there from the neck, as the edge of the upper front does, cm.
    """
    parted = [_front_slit(table.pieces[name]) for name in ("left_ftorso", "right_ftorso")]
    if opening >= 0.0 or None in parted:
        return
    reach = min(-opening, _STEEPEST * min(slit.length for slit in parted if slit is not None))
    if crossing:
        crossing = min(crossing, _FLATTEST * table.length("left_ftorso.centre"))
        for name in ("left_ftorso", "right_ftorso"):
            _move_meeting(table.pieces[name], crossing)
    for name, slit, x in zip(
        ("left_ftorso", "right_ftorso"), parted, (OVER_SHARE * reach - reach, OVER_SHARE * reach), strict=True
    ):
        assert slit is not None
        corner = min(slit.start, slit.end, key=lambda point: point[1])
        moved = (x + crossing, corner[1])
        piece = table.pieces[name]
        piece.sides = [
            replace(s, start=moved if s.start == corner else s.start, end=moved if s.end == corner else s.end)
            for s in piece.sides
        ]
    lower = table.pieces["left_ftorso"]
    place = lower.placement
    behind = (*place.translation[:2], place.translation[2] - OVERLAP_Z)
    lower.placement = replace(place, translation=behind)


def _move_meeting(piece: Piece, aside: float) -> None:
    """Moves the upper end of the open edge aside, and with it the lower end of the seam above."""
    slit = _front_slit(piece)
    assert slit is not None
    meeting = max(slit.start, slit.end, key=lambda point: point[1])
    moved = (aside, meeting[1])
    piece.sides = [
        replace(s, start=moved if s.start == meeting else s.start, end=moved if s.end == meeting else s.end)
        for s in piece.sides
    ]


def _front_slit(piece: Piece) -> Side | None:
    """The edge in the middle that is open from the hem up; slits in side seams have the same name."""
    slits = [s for s in piece.sides if s.name == "slit" and min(abs(s.start[0]), abs(s.end[0])) < 1e-6]
    return slits[0] if slits else None

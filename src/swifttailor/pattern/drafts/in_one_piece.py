"""Bodices and briefs in one piece, down to a strip between the legs: of cloth that stretches."""

from __future__ import annotations

from swifttailor.pattern.drafts.cutting_table import CuttingTable, Piece
from swifttailor.pattern.drafts.outline import Side

_GUSSET_CM = 6.5
"""Height of the strip between the legs, which alone is sewn on."""


def cut_in_one(table: CuttingTable) -> None:
    """Joins the left halves of a bodice without darts and of briefs at the waist; before the mirror.

    Of the briefs a strip between the legs is left, with edges of the same names; its ``waist`` is sewn to
    that of the bodice, as theirs were.
    """
    for part in "fb":
        upper, lower = table.pieces[f"left_{part}torso"], table.pieces[f"pant_{part}_l"]
        back = part == "b"
        body, strip = _joined(_loop(upper, back=back), _loop(lower, back=back))
        _put(upper, body, back=back)
        _put(lower, strip, back=back)


def _loop(piece: Piece, *, back: bool) -> list[Side]:
    """Its edges counter-clockwise, as they were drawn: in the plane of the front."""
    return [side.reversed() for side in reversed(piece.sides)] if back else list(piece.sides)


def _put(piece: Piece, sides: list[Side], *, back: bool) -> None:
    piece.sides[:] = [side.reversed() for side in reversed(sides)] if back else sides


def _joined(torso: list[Side], briefs: list[Side]) -> tuple[list[Side], list[Side]]:
    """Edges of the whole and of the strip, counter-clockwise."""
    (hem,) = [side for side in briefs if side.name == "hem"]
    (centre,) = [side for side in briefs if side.name == "centre"]
    level = centre.end[1] + _GUSSET_CM
    below, above = hem.split([_share_at(hem, level)])
    corner = below.end
    middle = (centre.start[0], corner[1])
    waist = Side("waist", middle, corner)
    body = [
        waist,
        above,
        *[side for side in briefs if side.name == "side"],
        *[side for side in torso if side.name != "waist"],
        Side("centre", centre.start, middle),
    ]
    strip = [
        below,
        Side("waist", corner, middle),
        Side("centre", middle, centre.end),
        *[side for side in briefs if side.name == "inseam"],
    ]
    return body, strip


def _share_at(hem: Side, level: float) -> float:
    """Part of the length of an edge that rises, at which it comes to a height."""
    from scipy.optimize import brentq

    def over(share: float) -> float:
        return hem.split([share])[0].end[1] - level

    share = brentq(over, 1e-3, 1.0 - 1e-3, xtol=1e-6)
    assert isinstance(share, float)
    return share

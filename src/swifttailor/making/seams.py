"""The seams of a garment as a sewist knows them: shoulder seam, side seam, waist, in the order of sewing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

import numpy as np

from swifttailor.describing.measuring.parts import ARM_PARTS, LEG_PARTS, SKIRT_PARTS, Part
from swifttailor.making.sewn_pattern import SewnPattern
from swifttailor.pattern import EdgeRef

GATHERED = 1.05
"""An edge that is longer than its partner by a larger factor, and by `GATHERED_CM`, is gathered."""
EASED = 1.01
_AT_NECK = (Part.COLLAR, Part.HOOD)
GATHERED_CM = 0.3


class SeamRole(Enum):
    """What a seam is in the garment; the values are in the order of sewing."""

    DART = 1, "darts"
    SHAPING = 2, "shaping seams"
    CENTRE_BACK = 3, "centre back seam"
    CENTRE_FRONT = 4, "centre front seam"
    SHOULDER = 5, "shoulder seams"
    COLLAR = 6, "collar"
    HOOD = 7, "hood"
    NECKLINE = 8, "neckline seam"
    OVERARM = 9, "upper sleeve seams"
    ARMHOLE = 10, "armhole seams"
    SIDE = 11, "side seams"
    UNDERARM = 12, "underarm seams"
    GODET = 13, "godets"
    SKIRT = 14, "skirt seams"
    OUTSEAM = 15, "outer leg seams"
    INSEAM = 16, "inner leg seams"
    CROTCH = 17, "crotch seam"
    TIER = 18, "tier seams"
    BAND_ENDS = 19, "ends of the waistband"
    WAIST = 20, "waist seam"
    CUFF_ENDS = 21, "ends of the cuffs"
    CUFF = 22, "cuff seams"
    OTHER = 23, "other seams"

    @property
    def words(self) -> str:
        """What a sewist calls it."""
        return self.value[1]

    @property
    def rank(self) -> int:
        """Place in the order of sewing."""
        return self.value[0]


@dataclass(frozen=True)
class Seam:
    """Stitches that are sewn in one go: neighbouring edges between the same two panels."""

    role: SeamRole
    stitches: tuple[int, ...]
    """Positions in `Pattern.stitches`, in the order along the seam."""
    panels: tuple[str, str]
    number: int = 0
    """Printed on the pieces; seams that are sewn alike on both sides of the body share it. 0: none yet."""


def find_seams(sewn: SewnPattern) -> tuple[Seam, ...]:
    """All seams, darts among them, in the order of sewing."""
    darts = {ref for dart in sewn.darts for ref in dart.legs}
    rows: dict[int, list[int]] = {}
    usable = [k for k, s in enumerate(sewn.pattern.stitches) if sewn.partner.get(s.first) == s.second]
    for k in usable:
        rows[k] = [k]
    for a in usable:
        for b in usable:
            if a < b and rows[a] is not rows[b] and _continues(sewn, a, b, darts):
                joined = rows[a] + rows[b]
                for k in joined:
                    rows[k] = joined
    groups = {id(row): row for row in rows.values()}
    seams = []
    for row in groups.values():
        first = sewn.pattern.stitches[row[0]]
        role = SeamRole.DART if first.first in darts else _role(sewn, row)
        seams.append(Seam(role, tuple(_in_line(sewn, row)), (first.first.panel, first.second.panel)))
    return tuple(sorted(seams, key=lambda s: (_turn(s, raglan=_is_raglan(sewn)), s.stitches)))


def _is_raglan(sewn: SewnPattern) -> bool:
    """Whether sleeves border the neckline, which is whole only when they are sewn in."""
    return any(
        {sewn.panel(ref.panel).placed.part for ref in stitch.sides} in ({Part.SLEEVE, c} for c in _AT_NECK)
        for stitch in sewn.pattern.stitches
    )


def _turn(seam: Seam, *, raglan: bool) -> float:
    """When a seam is sewn."""
    late = raglan and seam.role is SeamRole.NECKLINE
    return SeamRole.ARMHOLE.rank + 0.5 if late else seam.role.rank


def gather(own: float, other: float) -> str:
    """How an edge must be shortened to fit its partner: ``gather``, ``ease`` or nothing."""
    if own > GATHERED * other and own - other > GATHERED_CM:
        return "gather"
    return "ease" if own > EASED * other and own - other > GATHERED_CM else ""


def _continues(sewn: SewnPattern, a: int, b: int, darts: set[EdgeRef]) -> bool:
    """Whether two stitches follow each other on both of their panels."""
    one, two = (sewn.pattern.stitches[k] for k in (a, b))
    if one.right_wrong != two.right_wrong or {one.first, two.first} & darts:
        return False
    for second in (two.sides, two.sides[::-1]):
        if all(x.panel == y.panel and _near(sewn, x, y) for x, y in zip(one.sides, second, strict=True)):
            return True
    return False


def _near(sewn: SewnPattern, x: EdgeRef, y: EdgeRef) -> bool:
    count = len(sewn.panel(x.panel).edges)
    if (x.edge - y.edge) % count in (1, count - 1):
        return True
    for first, last in ((x.edge, y.edge), (y.edge, x.edge)):  # a dart between them is sewn before
        if any(
            d.panel == x.panel and (first + 1) % count == d.leg_in and (d.leg_out + 1) % count == last
            for d in sewn.darts
        ):
            return True
    return False


def _in_line(sewn: SewnPattern, row: Sequence[int]) -> list[int]:
    """Stitches in the order along the first panel's loop, starting after the largest gap."""
    stitches = sewn.pattern.stitches
    panel = stitches[row[0]].first.panel
    count = len(sewn.panel(panel).edges)

    def edge(k: int) -> int:
        s = stitches[k]
        return s.first.edge if s.first.panel == panel else s.second.edge

    order = sorted(row, key=edge)
    gaps = [(edge(order[k]) - edge(order[k - 1])) % count for k in range(len(order))]
    start = int(np.argmax(gaps)) if len(order) > 1 else 0
    return order[start:] + order[:start]


def _role(sewn: SewnPattern, row: Sequence[int]) -> SeamRole:
    first, second = sewn.pattern.stitches[row[0]].sides
    a, b = (sewn.panel(r.panel).placed for r in (first, second))
    parts = {a.part, b.part}
    if Part.GODET in parts:
        return SeamRole.GODET
    if parts <= {Part.COLLAR}:
        return SeamRole.COLLAR
    if parts <= {Part.HOOD}:
        return SeamRole.HOOD
    if parts & {Part.COLLAR, Part.HOOD}:
        return SeamRole.NECKLINE
    if parts == {Part.WAISTBAND}:
        return SeamRole.BAND_ENDS
    if Part.WAISTBAND in parts or (Part.TORSO in parts and parts & (SKIRT_PARTS | LEG_PARTS)):
        return SeamRole.WAIST
    if parts == {Part.TORSO}:
        return _torso_role(sewn, row)
    if parts == {Part.TORSO, Part.SLEEVE}:
        return SeamRole.ARMHOLE
    if parts == {Part.SLEEVE}:
        return SeamRole.OVERARM if _is_upper(sewn, row) else SeamRole.UNDERARM
    if parts <= {Part.CUFF, Part.LEG_CUFF}:
        return SeamRole.CUFF_ENDS if a.face != b.face else SeamRole.CUFF
    if parts & {Part.CUFF, Part.LEG_CUFF}:
        return SeamRole.CUFF
    if parts == {Part.TROUSER}:
        if a.face == b.face:
            return SeamRole.CROTCH
        return SeamRole.INSEAM if _is_inner(sewn, row) else SeamRole.OUTSEAM
    if parts <= SKIRT_PARTS | LEG_PARTS:
        return SeamRole.SKIRT if _is_upright(sewn, row) else SeamRole.TIER
    return SeamRole.ARMHOLE if parts & ARM_PARTS else SeamRole.OTHER


def _torso_role(sewn: SewnPattern, row: Sequence[int]) -> SeamRole:
    first, second = sewn.pattern.stitches[row[0]].sides
    a, b = (sewn.panel(r.panel).placed for r in (first, second))
    if a.face == b.face:
        if a.side == b.side:
            return SeamRole.SHAPING
        return SeamRole.CENTRE_BACK if a.face == "back" else SeamRole.CENTRE_FRONT
    # Under sleeves that are cut in one with the body it runs on along the arm.
    middle = (
        sewn.pattern.panel(first.panel).to_world(sewn.pattern.panel(first.panel).outline(0.5))[:, 1].mean()
    )
    low = bool(_ends(sewn, row)[..., 1].mean() < middle)
    return SeamRole.SIDE if low or _is_upright(sewn, row) else SeamRole.SHOULDER


def _ends(sewn: SewnPattern, row: Sequence[int]) -> np.ndarray:
    """Placed ends (n, 2, 3) of all edges of a seam, cm."""
    pattern = sewn.pattern
    refs = [r for k in row for r in pattern.stitches[k].sides]
    return np.array([pattern.panel(r.panel).to_world(pattern.panel(r.panel).chord(r.edge)) for r in refs])


def _is_upright(sewn: SewnPattern, row: Sequence[int]) -> bool:
    step = np.abs(np.diff(_ends(sewn, row), axis=1)[:, 0]).sum(axis=0)
    return bool(step[1] > 0.9 * np.hypot(step[0], step[2]))


def _is_inner(sewn: SewnPattern, row: Sequence[int]) -> bool:
    """Whether a leg seam lies on the inner side of its leg."""
    side = sewn.panel(sewn.pattern.stitches[row[0]].first.panel)
    panel = sewn.pattern.panel(side.name)
    middle = panel.to_world(panel.outline(0.5))[:, 0].mean()
    return bool(abs(_ends(sewn, row)[..., 0].mean()) < abs(middle))


def _is_upper(sewn: SewnPattern, row: Sequence[int]) -> bool:
    """Whether a sleeve seam lies above the middle of its sleeve, across the arm."""
    panel = sewn.pattern.panel(sewn.pattern.stitches[row[0]].first.panel)
    flat = sewn.panel(panel.name)
    up = panel.placement.matrix()[:, :2] @ flat.turn.T  # columns: across the piece, along it, in the world
    across = up[:, 0] if abs(up[1, 0]) > 1e-3 else np.array([0.0, 1.0, 0.0])
    across = across * np.sign(across[1] or 1.0)
    middle = panel.to_world(panel.outline(0.5)).mean(axis=0)
    return bool(((_ends(sewn, row).mean(axis=(0, 1)) - middle) @ across) > 0)

"""What holds of every trim, wherever it is put: the checks that several tests share."""

from __future__ import annotations

from collections import defaultdict

import numpy as np
import shapely

from swifttailor.pattern import Pattern
from swifttailor.pattern.trims import Belt, Bow, Button, Frill, Layer, Patch, Stirrup, Trim

ON_PANEL = 0.05
"""How far corners may lie beside their panel, cm."""
IN_PAIRS = (
    "chest pockets", "patch pockets", "kangaroo pocket", "bib pocket", "side pockets", "slant pockets",
    "back pockets", "cargo pockets", "drawstring", "neck cord", "lacing", "double-breasted buttons",
    "lower back pockets", "knee patches", "back welt pockets",
    "shoulder cut-outs", "waist cut-outs", "back cut-out", "cowl folds", "elbow patches",
    "chest heart", "chest star",
)  # fmt: skip


def corners(trim: Patch | Button | Bow) -> np.ndarray:
    """(n, 2) panel-local cm."""
    return trim.outline if isinstance(trim, Patch) else np.array([trim.at])


SEWN_IN = ("side stripes", "satin stripes", "sleeve stripes", "front frills", "shoulder frills", "knit bands")
"""What lies beside seams."""


def assert_on_panels(pattern: Pattern, trims: tuple[Trim, ...]) -> None:
    """Corners lie on the panel, and what is between them on cloth or in darts, which are sewn shut."""
    cloths: dict[str, tuple[shapely.Geometry, ...]] = {}
    for trim in trims:
        if isinstance(trim, Belt):
            assert 0 < trim.width < 12 and 20 < trim.height < 160, trim
            continue
        if isinstance(trim, Layer):
            assert pattern.panel_index(trim.panel) >= 0 and 0.0 < trim.low < trim.height - 3.0, trim
            assert 0.0 < trim.reach <= 180.0 and 0.0 < trim.opacity <= 1.0 and trim.behind >= 0.0, trim
            continue
        if isinstance(trim, Frill | Stirrup):
            sewn = {side for stitch in pattern.stitches for side in stitch.sides}
            free = trim.trim not in SEWN_IN
            assert trim.edges and (not free or not sewn & set(trim.edges)), "frills are sewn to free edges"
            assert len(set(trim.edges)) == len(trim.edges) and all(map(pattern.has_edge, trim.edges))
            assert 0 < (trim.depth if isinstance(trim, Frill) else trim.width) < 20, trim
            continue
        if trim.panel not in cloths:
            outline = shapely.Polygon(pattern.panel(trim.panel).outline(0.002))
            wedges = darts(pattern, trim.panel)
            roomy = shapely.union_all([outline.buffer(ON_PANEL), *wedges])
            cloths[trim.panel] = outline, shapely.union_all([outline, *wedges]), roomy
        panel, bridged, roomy = cloths[trim.panel]
        points = corners(trim)
        assert np.isfinite(points).all(), trim
        # Lines run on over what is sewn shut.
        on = bridged if isinstance(trim, Patch) and not trim.is_cut else panel
        away = shapely.distance(on, shapely.points(points)).max()
        assert away <= ON_PANEL, f"{trim.trim}: {away:.2f} cm beside {trim.panel}"
        if isinstance(trim, Patch):
            assert trim.first.shape == trim.second.shape and len(trim.first) >= 2
            piece = shapely.Polygon(points)
            assert piece.is_valid, f"{trim.trim} on {trim.panel} crosses itself"
            least = 0.5 if trim.is_cut else 0.1  # folds are thin lines
            assert piece.area > least, f"{trim.trim} on {trim.panel} has no area"
            beside = piece.difference(roomy)
            assert beside.area < 0.01 * piece.area, f"{trim.trim} hangs over {trim.panel}"
        elif isinstance(trim, Bow):
            assert 2 < trim.width < 30 and 2 < trim.tail < 30, trim
        else:
            assert 0.1 < trim.radius < 2.7


def darts(pattern: Pattern, name: str) -> list[shapely.Geometry]:
    """What the darts of a panel take away, and a little more."""
    panel = pattern.panel(name)
    count = len(panel.edges)
    found = []
    for stitch in pattern.stitches:
        one, other = stitch.sides
        if one.panel == other.panel == name and (one.edge - other.edge) % count in (1, count - 1):
            first = min(one.edge, other.edge) if abs(one.edge - other.edge) == 1 else count - 1
            wedge = panel.vertices[[first, (first + 1) % count, (first + 2) % count]]
            found.append(shapely.Polygon(wedge).buffer(0.1))
    return found


def seen(pattern: Pattern, trim: Patch | Button) -> np.ndarray:
    """(n, 2) its corners from the front: x to the wearer's left, y up, cm."""
    return pattern.panel(trim.panel).to_world(corners(trim))[:, :2]


def assert_in_pairs(pattern: Pattern, trims: tuple[Trim, ...], names: tuple[str, ...] = IN_PAIRS) -> None:
    """Each piece of a trim that has two sides has its mirror image."""
    of_trim: dict[str, list[np.ndarray]] = defaultdict(list)
    for trim in trims:
        if trim.trim in names and not isinstance(trim, Belt):
            edge = trim.trim == "double-breasted buttons" and isinstance(trim, Patch)
            if not edge:  # of the front that lies above the other one
                of_trim[trim.trim].append(seen(pattern, trim))
    for name, pieces in of_trim.items():
        for piece in pieces:
            mirrored = piece * (-1, 1)
            assert any(same_points(mirrored, other) for other in pieces), f"half a pair of {name}"
        assert len(pieces) % 2 == 0


def same_points(some: np.ndarray, others: np.ndarray, within: float = 0.05) -> bool:
    """Whether both are the same points, in any order."""
    if len(some) != len(others):
        return False
    away = np.linalg.norm(some[:, None] - others[None], axis=2)
    return bool(away.min(axis=0).max() <= within and away.min(axis=1).max() <= within)

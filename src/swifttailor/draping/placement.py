"""Where the panels stand when sewing begins."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import shapely

from swifttailor.arrays import Floats
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.pattern import Panel, Pattern
from swifttailor.pattern.check import panel_regions

_CLEAR_CM = 1.0
_MAX_SHIFT_CM = 20.0


def place_vertices(mesh: PatternMesh, *, sleeves_out: bool = False) -> Floats:
    """Positions (v, 3) in cm of the welded vertices: each at the mean of its panels' placed vertices.

    Args:
        mesh: The flat panels.
        sleeves_out: Whether to move sleeves out along the arm until their underarm is clear of the torso.
            Placed as a pattern gives them it often starts inside, and is then sewn in tucked through it.
    """
    panels = _sleeves_moved_out(mesh.pattern) if sleeves_out else mesh.pattern.panels
    placed = np.concatenate(
        [p.to_world(mesh.flat_vertices[mesh.flat_panel == k]) for k, p in enumerate(panels)]
    )
    return mesh.welded_mean(placed)


def _sleeves_moved_out(pattern: Pattern) -> tuple[Panel, ...]:
    regions = panel_regions(pattern)
    arms = [p for p in pattern.panels if regions[p.name] == "arm"]
    torso = [p for p in pattern.panels if regions[p.name] == "body"]
    if not arms or not torso:
        return pattern.panels
    names = {p.name for p in arms}
    inner = Pattern(tuple(arms), tuple(s for s in pattern.stitches if all(r.panel in names for r in s.sides)))
    shadow = shapely.union_all([_front_view(p) for p in torso])
    moved: dict[str, Panel] = {}
    for group in inner.components():
        panels = [pattern.panel(n) for n in group]
        own = set(group)
        armhole = _armhole(pattern, own, names, torso_side=True)
        if not len(armhole):
            continue
        direction = _away_from_torso(armhole, panels)
        if direction is None:
            continue
        cap = _armhole(pattern, own, names, torso_side=False)
        underarm = cap[cap[:, 1] < cap[:, 1].min() + 1.0, :2]
        shift = _clearing_shift(underarm, shadow, direction)
        for p in panels:
            x, y, z = p.placement.translation
            offset = (x + shift * direction[0], y + shift * direction[1], z)
            moved[p.name] = replace(p, placement=replace(p.placement, translation=offset))
    return tuple(moved.get(p.name, p) for p in pattern.panels)


def _front_view(panel: Panel) -> shapely.Geometry:
    """The placed panel as seen from the front, a polygon in x and y."""
    return shapely.make_valid(shapely.Polygon(panel.to_world(panel.outline(0.1))[:, :2]))


def _away_from_torso(armhole: Floats, panels: list[Panel]) -> Floats | None:
    """Unit direction (2,) in x and y from the armhole (n, 3) to the middle of the sleeve."""
    middle = np.concatenate([p.to_world(p.outline(1.0)) for p in panels]).mean(axis=0)
    direction = (middle - armhole.mean(axis=0))[:2]
    length = float(np.hypot(*direction))
    return direction / length if length > 1.0 else None


def _armhole(pattern: Pattern, own: set[str], arm_names: set[str], torso_side: bool) -> Floats:
    """Points (n, 3) of the placed edges that join the sleeve panels `own` to the torso, from either side."""
    found = [np.zeros((0, 3))]
    for s in pattern.stitches:
        for arm, torso in (s.sides, s.sides[::-1]):
            if arm.panel in own and torso.panel not in arm_names:
                ref = torso if torso_side else arm
                panel = pattern.panel(ref.panel)
                found.append(panel.to_world(panel.sample_edge(ref.edge, 9)))
    return np.concatenate(found)


def _clearing_shift(underarm: Floats, torso: shapely.Geometry, direction: Floats) -> float:
    """Smallest way along `direction`, to 0.5 cm, that takes the underarm points (n, 2) off the torso."""
    for shift in np.arange(0.0, _MAX_SHIFT_CM, 0.5):
        if shapely.distance(shapely.points(underarm + shift * direction), torso).min() >= _CLEAR_CM:
            return float(shift)
    return _MAX_SHIFT_CM

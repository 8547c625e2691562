"""Edges that nothing is sewn to, by where they lie: around the neck, at the ends of sleeves, at the hem."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.panel import Panel
from swifttailor.pattern.pattern import EdgeRef, Pattern

_ARM_WORDS = ("sleeve", "cuff")
_NECK_WORDS = ("torso", "collar", "hood")
_LEVEL = 0.8
"""A hem runs aside at least so many times as far as it rises."""
_HEM_CM, _PANELS_CM = 5.0, 30.0
"""A hem reaches so near to the lowest point of its panel, and that to the lowest of the garment, cm."""
_ARMHOLE_CM, _BESIDE_CM, _SHOULDER_CM = 6.0, 4.0, 8.0
"""An armhole rises at least so far, lies so far from the middle, ends so near to the top of its panel, cm."""
_SHORTEST_CM, _NEAR_MIDDLE_CM, _MEETING_CM = 1.0, 2.0, 0.01


def neck_edges(pattern: Pattern) -> tuple[EdgeRef, ...]:
    """Free edges around the neck: those of the collar where there is one, else of front and back.

    None of a strapless garment, or of one with a hood.
    """
    found = [each for each in _free(pattern) if any(word in each[0].panel for word in _NECK_WORDS)]
    if any("hood" in ref.panel for ref, _ in found) or not any("torso" in p.name for p in pattern.panels):
        return ()
    collars = [ref for ref, _ in found if "collar" in ref.panel]
    if collars:
        tops = {ref: points[:, 1].mean() for ref, points in found if "collar" in ref.panel}
        return tuple([ref for ref in collars if tops[ref] >= max(tops.values()) - 3.0])
    return tuple([ref for ref, points in found if _around_neck(pattern.panel(ref.panel), ref, points)])


def hood_edges(pattern: Pattern) -> tuple[EdgeRef, ...]:
    """Free edges of a hood around the face; none of a garment without."""
    return tuple([ref for ref, _ in _free(pattern) if "hood" in ref.panel])


def armhole_edges(pattern: Pattern) -> tuple[EdgeRef, ...]:
    """Free edges of fronts and backs around armholes without sleeves; none of a garment without shoulders."""
    taken = {*neck_edges(pattern), *hem_edges(pattern)}
    if not neck_edges(pattern):
        return ()
    found, ends, below = [], [], []
    for ref, points in _free(pattern):
        if "torso" not in ref.panel or ref in taken or float(np.abs(points[:, 0]).min()) <= _BESIDE_CM:
            continue
        outline = pattern.panel(ref.panel).to_world(pattern.panel(ref.panel).outline(0.5))
        upper = float(points[:, 1].max()) >= float(outline[:, 1].max()) - _SHOULDER_CM
        if upper and float(np.ptp(points[:, 1])) > _ARMHOLE_CM:
            found.append(ref)
            ends += [(ref.panel, points[k]) for k in (0, -1)]
        else:
            below.append((ref, points))
    # An armhole that is cut in between the shoulder blades goes on below its upper edge.
    found += [ref for ref, points in below if any(_meets(ref.panel, points, end) for end in ends)]
    return tuple(found)


def armhole_seams(pattern: Pattern) -> tuple[EdgeRef, ...]:
    """Edges of fronts and backs that sleeves are set into; none where they are cut otherwise."""
    found = []
    for stitch in pattern.stitches:
        body = [side for side in stitch.sides if "torso" in side.panel]
        if len(body) == 1 and any("sleeve" in side.panel for side in stitch.sides):
            found += body
    return tuple(found)


def _meets(panel: str, points: Floats, end: tuple[str, Floats]) -> bool:
    """Whether an edge of a panel begins or ends where another one does."""
    apart = [float(np.abs(points[k] - end[1]).max()) for k in (0, -1)]
    return panel == end[0] and min(apart) < _MEETING_CM


def sleeve_ends(pattern: Pattern) -> tuple[EdgeRef, ...]:
    """Free edges at the ends of sleeves and cuffs."""
    return tuple([ref for ref, _ in _free(pattern) if _is_of_sleeve(ref.panel)])


def leg_ends(pattern: Pattern, side: str) -> tuple[tuple[EdgeRef, ...], float]:
    """Free edges at the end of one leg, or of its cuff, and how high the lowest of them lies, cm.

    Args:
        pattern: Any pattern.
        side: ``l`` or ``r``, the wearer's.
    """
    own = [(r, p) for r, p in _free(pattern) if r.panel.startswith("pant_") and side in r.panel.split("_")]
    low = min([float(points[:, 1].mean()) for _, points in own], default=0.0)
    level = [ref for ref, points in own if points[:, 1].mean() < low + _HEM_CM and _is_level(points)]
    return tuple(level), low


def hem_edges(pattern: Pattern) -> tuple[EdgeRef, ...]:
    """Free edges along the hem of a skirt, dress or top; none of trousers."""
    if any(panel.name.startswith("pant_") for panel in pattern.panels):
        return ()
    below = [each for each in _free(pattern) if not _is_above_the_hem(each[0].panel)]
    lowest = {ref: _lowest(pattern.panel(ref.panel)) for ref, _ in below}
    garment = min(lowest.values(), default=0.0)
    return tuple(
        [
            ref
            for ref, points in below
            if lowest[ref] <= garment + _PANELS_CM
            and points[:, 1].min() <= lowest[ref] + _HEM_CM
            and _is_level(points)
        ]
    )


def _lowest(panel: Panel) -> float:
    """Height of the lowest point of a panel, cm."""
    return float(panel.to_world(panel.outline(0.5))[:, 1].min())


def _is_of_sleeve(panel: str) -> bool:
    """Whether a panel is of a sleeve or its cuff; armholes are sewn, so its free edges are at the end."""
    return any(word in panel for word in _ARM_WORDS) and not panel.startswith("pant_")


def _is_above_the_hem(panel: str) -> bool:
    """Whether a panel is a sleeve's, a collar's or a hood's."""
    return _is_of_sleeve(panel) or "collar" in panel or "hood" in panel


def _is_level(points: Floats) -> bool:
    """Whether an edge ends about as high as it begins, as a hem does, which may be bent between."""
    across = points[-1] - points[0]
    return float(np.linalg.norm(across[[0, 2]])) >= _LEVEL * abs(float(across[1]))


def _around_neck(panel: Panel, ref: EdgeRef, points: Floats) -> bool:
    """Whether a free edge of a front or back runs from the shoulder to the middle."""
    outline = panel.to_world(panel.outline(0.5))
    high, low = float(outline[:, 1].max()), float(outline[:, 1].min())
    widest = float(np.abs(outline[:, 0]).max())
    inner = np.abs(points[:, 0])
    between = float(inner.min()) < _NEAR_MIDDLE_CM  # straps: the edge in the middle begins below their ends
    above = between or float(points[:, 1].max()) >= high - 1.0
    above = above and float(points[:, 1].min()) > low + 0.35 * (high - low)
    return above and float(inner.min()) < 3.0 and float(inner.max()) < 0.9 * widest


def _free(pattern: Pattern) -> Iterator[tuple[EdgeRef, Floats]]:
    """Every free edge with points along it in space (n, 3), cm."""
    sewn = {side for stitch in pattern.stitches for side in stitch.sides}
    for panel in pattern.panels:
        for k in range(len(panel.edges)):
            ref = EdgeRef(panel.name, k)
            if ref not in sewn and panel.edge_length(k) >= _SHORTEST_CM:
                yield ref, panel.to_world(panel.sample_edge(k, 9))

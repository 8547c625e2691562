"""The order in which GarmentCode lists panels: left to right, then upwards, then back to front, roughly."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from swifttailor.pattern import Panel

ALIKE_CM = 10.0
"""Places that differ by less along one axis are ordered by the next."""

Places = dict[str, tuple[float, float, float]]


def in_garmentcode_order(panels: Sequence[Panel]) -> tuple[Panel, ...]:
    """The panels in GarmentCode's order."""
    by_name = {p.name: p for p in panels}
    places = {p.name: _top(p) for p in panels}
    return tuple(by_name[name] for name in _sorted(list(by_name), places, 0))


def _top(panel: Panel) -> tuple[float, float, float]:
    """Where the highest of the middles of the sides of the panel's box is placed.

    GarmentCode reads the angles here in the other way than where it places panels, and so the order is made.
    """
    left, low = panel.vertices.min(axis=0).tolist()
    right, high = panel.vertices.max(axis=0).tolist()
    x, y = (right + left) / 2, (high + low) / 2
    placement = replace(panel.placement, reading="extrinsic")
    middles = placement.apply([[x, high], [x, low], [right, y], [left, y]])
    a, b, c = middles[middles[:, 1].argmax()].tolist()
    return a, b, c


def _sorted(names: list[str], places: Places, axis: int) -> list[str]:
    order = sorted(names, key=lambda name: (places[name][axis], name))
    if axis == 2:
        return order
    done: list[str] = []
    group: list[str] = []
    for name in order:
        if group and places[name][axis] - places[group[0]][axis] >= ALIKE_CM:
            done += _sorted(group, places, axis + 1)
            group = []
        group.append(name)
    return done + _sorted(group, places, axis + 1)

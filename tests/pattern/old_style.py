"""Patterns as older programs of the same family write them, made from drafts.

The origin is in the middle of the body, which stands in T-pose; nothing is labelled; angles are extrinsic.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from swifttailor.pattern import EdgeRef, Pattern, Stitch
from swifttailor.pattern.check import panel_regions
from swifttailor.pattern.panel import Edge

DOWN_CM = 112.0
ARM_DEGREES = 45.483
SHOULDER = np.array([18.2284, 142.1809, 0.0])


def old_style(pattern: Pattern, *, names: dict[str, str] | None = None, legs_apart: float = 0.0) -> Pattern:
    """The same garment for a body in T-pose around the origin.

    Args:
        pattern: Placed as GarmentCode does.
        names: Other names for some panels.
        legs_apart: How far trouser legs are turned outwards, degrees.
    """
    called = {p.name: (names or {}).get(p.name, p.name) for p in pattern.panels}
    regions, panels = panel_regions(pattern), []
    for panel in pattern.panels:
        middle = panel.to_world(panel.vertices).mean(axis=0)
        side = np.sign(middle[0])
        turn, shift = np.eye(3), np.zeros(3)
        if regions[panel.name] == "arm":
            turn, shift = about(SHOULDER * [side, 1, 1], side * ARM_DEGREES)
        elif "pant" in panel.name and legs_apart:
            turn, shift = about(np.array([side * 10.0, 85.0, 0.0]), side * legs_apart)
        placement = panel.placement.moved(turn, shift - [0.0, DOWN_CM, 0.0])
        edges = tuple(Edge(edge.curve) for edge in panel.edges)
        placement = replace(placement.read_as("extrinsic"), reading="intrinsic")
        panels.append(replace(panel, name=called[panel.name], label="", edges=edges, placement=placement))
    stitches = [
        Stitch(*(EdgeRef(called[ref.panel], ref.edge) for ref in s.sides), s.right_wrong)
        for s in pattern.stitches
    ]
    return Pattern(tuple(panels), tuple(stitches))


def about(pivot, degrees):
    """Rotation about z through a point, as a matrix and a motion that follows it."""
    c, s = np.cos(np.deg2rad(degrees)), np.sin(np.deg2rad(degrees))
    turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    return turn, pivot - turn @ pivot

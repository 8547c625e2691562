"""The flat frame of a sleeve: its seam on top, the way down the arm, and the way into the cloth."""

from __future__ import annotations

from swifttailor.arrays import Floats
from swifttailor.pattern.pattern import EdgeRef, Panel

_SAMPLES = 41


def seam_from_the_top(panel: Panel, ref: EdgeRef) -> Floats:
    """(41, 2) points of a seam in the flat panel, cm, from its upper end down.

    Args:
        panel: Of a sleeve.
        ref: Its edge in the seam on top.
    """
    seam = panel.sample_edge(ref.edge, _SAMPLES)
    world = panel.to_world(seam)
    return seam if world[0, 1] > world[-1, 1] else seam[::-1]


def into_cloth(along: Floats, seam: Floats, outline: Floats) -> Floats:
    """(2,) unit vector across a seam, to the side on which the panel lies.

    Args:
        along: (2,) unit vector down the seam.
        seam: (n, 2) points of it, cm.
        outline: (m, 2) points around the panel, cm.
    """
    across = along[::-1] * [-1.0, 1.0]
    return across if (outline.mean(axis=0) - seam.mean(axis=0)) @ across > 0 else -across

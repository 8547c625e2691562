"""How a panel lies on the table: its right side up, its grain upright."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern import Panel

_SHOULDER = np.array([17.0, 139.0, 0.0])
"""Of the default body, on the wearer's left, cm; where an arm begins."""


def turn_upright(panel: Panel, *, on_arm: bool) -> Floats:
    """The matrix (2, 2) that lays a panel down as a cutter does.

    Seen from the right side of the cloth, so panels whose loop runs clockwise are mirrored. The grain is that
    axis of the panel which runs most nearly up the body, or along the arm for panels on it, since sleeves may
    be drawn lying on their side; it points up or towards the shoulder.

    Args:
        panel: Where it is placed says which way up it is worn.
        on_arm: Whether it is a sleeve or a cuff.

    Returns:
        M: panel-local points (n, 2) become points @ M.T.
    """
    flip = np.diag([-1.0 if panel.signed_area() < 0 else 1.0, 1.0])
    up = np.array([0.0, 1.0, 0.0])
    if on_arm:
        middle = panel.to_world(panel.outline(0.5)).mean(axis=0)
        side = np.array([1.0 if middle[0] >= 0 else -1.0, 1.0, 1.0])
        along = _SHOULDER * side - middle
        along[2] = 0.0
        size = float(np.linalg.norm(along))
        up = along / size if size > 1.0 else up
    # The panel's own y first: it wins where none is nearer.
    axes = np.array([[0.0, 1.0], [1.0, 0.0], [-1.0, 0.0], [0.0, -1.0]])
    nearness = (axes @ flip) @ panel.placement.matrix()[:, :2].T @ up
    best = axes[int(np.argmax(np.round(nearness, 6)))]
    turn = np.array([[best[1], -best[0]], [best[0], best[1]]])  # carries `best` to (0, 1)
    return turn @ flip

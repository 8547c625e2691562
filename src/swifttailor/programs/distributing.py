"""Copies of a panel around the body or side by side."""

from __future__ import annotations

import copy
import math

from swifttailor.programs.panel import Panel
from swifttailor.programs.rotation import Rotation


def distribute_y(panel: Panel, n_copies: int, name_tag: str = "panel") -> list[Panel]:
    """The panel and copies of it in a circle around the y axis; all are named by the tag and a number."""
    turn = Rotation.from_euler(0.0, 360 / n_copies, 0.0)
    panel.name = f"{name_tag}_0"
    copies = [panel]
    for i in range(1, n_copies):
        new = copy.deepcopy(copies[-1])
        new.name = f"{name_tag}_{i}"
        new.rotate_by(turn)
        new.translate_to(turn.apply(new.translation))
        copies.append(new)
    return copies


def distribute_horizontally(
    panel: Panel, n_copies: int, stride: float = 20.0, name_tag: str = "panel"
) -> list[Panel]:
    """The panel and copies of it in a row, level and in its own plane, `stride` cm apart."""
    x, _, z = panel.rotation.apply([0.0, 0.0, 1.0])
    size = math.hypot(x, z)
    panel.name = f"{name_tag}_0"
    copies = [panel]
    for i in range(1, n_copies):
        new = copy.deepcopy(copies[-1])
        new.name = f"{name_tag}_{i}"
        new.translate_by([-z / size * stride, 0.0, x / size * stride])
        copies.append(new)
    return copies

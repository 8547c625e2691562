"""How much cloth goes around a body at each height: measured in the flat panels."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from swifttailor.arrays import Bools, Floats
from swifttailor.panel_mesh.pattern_mesh import PatternMesh


def cloth_around(
    mesh: PatternMesh, along: Floats, counted: Bools, places: Floats, groups: Sequence[Bools] = ()
) -> Floats:
    """Width of the cloth where a garment is cut across, not stretched and not folded.

    Args:
        mesh: Of the garment.
        along: (m,) of every flat vertex, how far along the body it lies: its height, or its way down the arm.
        counted: (f,) faces that count.
        places: (p,) where it is cut across.
        groups: Flat vertices (m,) of each part whose widths are wanted by themselves; all when empty.

    Returns:
        (p, g) cm, for each group; of a face that is cut the group of most of its corners counts.
    """
    faces = mesh.flat_faces[counted]
    groups = groups or (np.ones(len(mesh.flat_vertices), np.bool_),)
    member = np.stack([group[faces].mean(axis=1) > 0.5 for group in groups], axis=1)
    value, flat = along[faces], mesh.flat_vertices[faces]
    low, high = value.min(axis=1), value.max(axis=1)
    result = np.zeros((len(places), len(groups)))
    for k, place in enumerate(places):
        cut = np.flatnonzero((low <= place) & (high > place))
        if not len(cut):
            continue
        width = cut_lengths(value[cut] - place, flat[cut])
        result[k] = width @ member[cut]
    return result


def cut_lengths(value: Floats, flat: Floats) -> Floats:
    """Length of the line on which a value vanishes in each of some flat triangles.

    Args:
        value: (f, 3) at the corners; not of one sign.
        flat: (f, 3, 2) corners.
    """
    ends, count = np.zeros((len(value), 2, 2)), np.zeros(len(value), np.int64)
    for k in range(3):
        a, b = value[:, k], value[:, (k + 1) % 3]
        crossed = (a > 0) != (b > 0)
        t = np.where(crossed, a / np.where(crossed, a - b, 1.0), 0.0)[:, None]
        point = flat[:, k] * (1 - t) + flat[:, (k + 1) % 3] * t
        rows = np.flatnonzero(crossed & (count < 2))
        ends[rows, count[rows]] = point[rows]
        count[rows] += 1
    return np.where(count == 2, np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1), 0.0)

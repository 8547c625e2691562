"""Small pictures to print, by name: fruit, animals, hearts, stars, splashes of paint; each of a few shapes.

A figure is drawn on a square from -1 to 1, y up, in the inks 1 to 3; what comes later lies on top.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from swifttailor.arrays import Array
from swifttailor.render import drawn_animals, drawn_beasts
from swifttailor.render.figure_shapes import Shape, in_pairs, line, oval, polygon, star

_RADIUS = 0.225
"""Half the side of a figure's square, as a part of its repeat: two stand across, every second row shifted."""
_SPLASHES = 110


def figure_picture(name: str, side: int) -> Array:
    """(side, side) uint8 of one repeat of a print, 0 the ground, row 0 at the bottom, as it lies on cloth.

    Args:
        name: One of `FIGURES`.
        side: Cells.
    """
    if name == "splatters":
        return _splatters(side)
    picture = np.zeros((side, side), np.uint8)
    reach = int(1.2 * _RADIUS * side)
    own: Array = np.zeros((2 * reach, 2 * reach), np.uint8)
    y, x = (np.mgrid[0 : 2 * reach, 0 : 2 * reach] + 0.5 - reach) / (side * _RADIUS)
    for ink, shape in _DRAWN[name]:
        own[shape(x, y)] = ink
    for quarter in (side // 4, 3 * side // 4):
        at = (np.arange(-reach, reach) + quarter) % side
        picture[np.ix_(at, at)] = np.maximum(picture[np.ix_(at, at)], own)
    return picture


def _splatters(side: int) -> Array:
    """Drops and splashes of three paints, a few large and many small, the same in every process."""
    chance = np.random.default_rng(7)
    picture = np.zeros((side, side), np.uint8)
    y, x = (np.mgrid[0:side, 0:side] + 0.5) / side
    for k in range(_SPLASHES):
        cx, cy = chance.random(2)
        dx, dy = (x - cx + 0.5) % 1.0 - 0.5, (y - cy + 0.5) % 1.0 - 0.5
        size = 0.006 + 0.06 * chance.random() ** 4
        lobes, phase = int(chance.integers(5, 10)), chance.uniform(0.0, 7.0)
        turn = np.arctan2(dy, dx)
        rough = 1.0 + 0.16 * np.cos(lobes * turn + phase) + 0.14 * np.cos((lobes + 4) * turn + 2.0 * phase)
        picture[np.hypot(dx, dy) < size * rough] = 1 + k % 3
    return picture


def _heart(x: Array, y: Array) -> Array:
    u, v = 1.25 * x, 1.25 * y + 0.1
    return (u * u + v * v - 1.0) ** 3 < u * u * v**3


def _moon(x: Array, y: Array) -> Array:
    return (np.hypot(x, y) < 0.9) & (np.hypot(x - 0.42, y - 0.15) > 0.75)


_DRAWN: Mapping[str, list[tuple[int, Shape]]] = {
    "hearts": [(1, _heart)],
    "stars": [(1, star(0.0, 0.0, 1.0))],
    "moons": [(1, _moon), (2, star(0.45, 0.2, 0.35))],
    "bolts": [
        (1, polygon((0.2, 1), (-0.55, -0.1), (-0.05, -0.1), (-0.25, -1), (0.55, 0.2), (0.05, 0.2), (0.5, 1)))
    ],
    "cherries": [
        (2, line(-0.45, -0.4, 0.25, 0.85, 0.06)),
        (2, line(0.5, -0.3, 0.25, 0.85, 0.06)),
        (2, oval(0.55, 0.8, 0.36, 0.16, 15)),
        (1, oval(-0.45, -0.5, 0.42, 0.4)),
        (1, oval(0.5, -0.4, 0.42, 0.4)),
        (0, oval(-0.6, -0.38, 0.09, 0.11)),
        (0, oval(0.36, -0.28, 0.09, 0.11)),
    ],
    "strawberries": [
        (
            1,
            polygon(
                (-0.72, 0.4), (-0.5, 0.62), (0.5, 0.62), (0.72, 0.4), (0.5, -0.35), (0, -0.95), (-0.5, -0.35)
            ),
        ),
        (2, star(0.0, 0.62, 0.6, 6)),
        *[
            (3, oval(x, y, 0.06, 0.09))
            for x, y in ((-0.35, 0.1), (0.35, 0.1), (0, 0.0), (-0.2, -0.35), (0.2, -0.35))
        ],
    ],
    "lemons": [
        (2, oval(0.45, 0.62, 0.45, 0.2, 25)),
        (1, oval(0.0, -0.05, 0.72, 0.55, 35)),
        (1, oval(0.62, 0.38, 0.16, 0.13, 35)),
        (1, oval(-0.62, -0.48, 0.14, 0.11, 35)),
        (3, line(-0.3, 0.1, 0.05, 0.32, 0.06)),
    ],
    "mushrooms": [
        (2, oval(0.0, -0.45, 0.24, 0.5)),
        (1, lambda x, y: oval(0.0, 0.0, 0.85, 0.8)(x, y) & (y > -0.08)),
        *[(2, oval(x, y, 0.13, 0.11)) for x, y in ((-0.45, 0.2), (0.05, 0.5), (0.5, 0.18), (0.0, 0.12))],
    ],
    "foxes": [
        *in_pairs((1, polygon((0.18, 0.35), (0.85, 1.0), (0.8, 0.0)))),
        (1, polygon((-0.85, 0.3), (0.85, 0.3), (0.6, -0.3), (0.0, -0.9), (-0.6, -0.3))),
        *in_pairs((2, polygon((0.78, 0.05), (0.22, -0.12), (0.04, -0.8), (0.56, -0.33)))),
        *in_pairs((3, oval(0.34, 0.05, 0.1, 0.12)), (2, polygon((0.5, 0.4), (0.74, 0.75), (0.74, 0.3)))),
        (3, oval(0.0, -0.75, 0.16, 0.14)),
    ],
    "cats": [
        *in_pairs((1, polygon((0.1, 0.4), (0.72, 1.0), (0.75, 0.0)))),
        (1, oval(0.0, -0.1, 0.82, 0.68)),
        *in_pairs((2, oval(0.33, 0.02, 0.14, 0.16)), (2, line(0.3, -0.32, 0.72, -0.25, 0.035))),
        (3, polygon((-0.12, -0.22), (0.12, -0.22), (0.0, -0.36))),
    ],
    "bears": [
        *in_pairs((1, oval(0.6, 0.62, 0.3, 0.3)), (2, oval(0.6, 0.62, 0.15, 0.15))),
        (1, oval(0.0, -0.05, 0.82, 0.75)),
        (2, oval(0.0, -0.35, 0.36, 0.28)),
        *in_pairs((3, oval(0.32, 0.12, 0.09, 0.1))),
        (3, oval(0.0, -0.24, 0.12, 0.09)),
    ],
    "rabbits": [
        *in_pairs((1, oval(0.3, 0.6, 0.17, 0.44, -10)), (2, oval(0.31, 0.6, 0.07, 0.3, -10))),
        (1, oval(0.0, -0.25, 0.62, 0.58)),
        *in_pairs((3, oval(0.25, -0.12, 0.08, 0.1))),
        (2, oval(0.0, -0.35, 0.1, 0.08)),
    ],
    "birds": [
        (1, polygon((-0.45, 0.0), (-1.0, 0.3), (-0.95, -0.15))),
        (1, oval(0.0, -0.05, 0.62, 0.38, 15)),
        (1, oval(0.5, 0.32, 0.28, 0.26)),
        (3, polygon((0.74, 0.42), (1.0, 0.3), (0.74, 0.22))),
        (2, oval(-0.1, 0.0, 0.36, 0.18, -20)),
        (0, oval(0.56, 0.38, 0.06, 0.06)),
        *[(3, line(x, -0.4, x, -0.75, 0.04)) for x in (-0.05, 0.15)],
    ],
    "butterflies": [
        *in_pairs((1, oval(0.5, 0.35, 0.48, 0.36, 35)), (2, oval(0.42, -0.38, 0.36, 0.28, -35))),
        *in_pairs((2, oval(0.58, 0.42, 0.2, 0.14, 35)), (3, line(0.03, 0.45, 0.22, 0.85, 0.035))),
        (3, oval(0.0, 0.0, 0.1, 0.55)),
    ],
    "bees": [
        *in_pairs((2, oval(0.36, 0.52, 0.2, 0.4, -30))),
        (1, oval(0.0, -0.15, 0.78, 0.48)),
        *[
            (3, lambda x, y, at=at: oval(0.0, -0.15, 0.78, 0.48)(x, y) & (abs(x - at) < 0.1))
            for at in (-0.3, 0.05, 0.4)
        ],
        (3, oval(-0.68, -0.12, 0.22, 0.24)),
    ],
    "fishes": [
        (1, polygon((0.4, 0.0), (0.95, 0.45), (0.8, 0.0), (0.95, -0.45))),
        (1, oval(-0.15, 0.0, 0.72, 0.42)),
        (2, polygon((-0.2, 0.05), (0.2, 0.2), (0.1, -0.2))),
        (0, oval(-0.55, 0.1, 0.09, 0.09)),
    ],
    "dinosaurs": [
        (1, polygon((0.3, 0.1), (1.0, -0.45), (0.25, -0.4))),
        (1, oval(0.1, -0.15, 0.5, 0.36)),
        (1, line(-0.25, 0.0, -0.55, 0.65, 0.15)),
        (1, oval(-0.68, 0.74, 0.27, 0.17)),
        *[(1, line(x, -0.35, x, -0.8, 0.12)) for x in (-0.15, 0.35)],
        (0, oval(-0.7, 0.8, 0.05, 0.05)),
        *[(2, oval(x, y, 0.09, 0.08)) for x, y in ((-0.05, 0.0), (0.2, 0.02), (0.08, -0.2))],
    ],
    "anchors": [
        (1, lambda x, y: (np.hypot(x, y - 0.75) < 0.24) & (np.hypot(x, y - 0.75) > 0.12)),
        (1, line(0.0, 0.5, 0.0, -0.8, 0.09)),
        (1, line(-0.4, 0.32, 0.4, 0.32, 0.08)),
        (1, lambda x, y: (abs(np.hypot(x, y + 0.1) - 0.72) < 0.09) & (y < -0.25)),
        *in_pairs((1, polygon((0.45, -0.3), (0.95, -0.3), (0.72, 0.08)))),
    ],
    "boats": [
        (1, polygon((-0.85, -0.4), (0.85, -0.4), (0.5, -0.85), (-0.5, -0.85))),
        (1, line(0.0, -0.4, 0.0, 0.9, 0.045)),
        (2, polygon((0.1, 0.85), (0.1, -0.25), (0.75, -0.25))),
        (3, polygon((-0.1, 0.65), (-0.1, -0.25), (-0.6, -0.25))),
    ],
    **drawn_animals.DRAWN,
    **drawn_beasts.DRAWN,
}
FIGURES = (*_DRAWN, "splatters")
"""Names, in the order in which they lie in the bank of patterns."""

"""Ornaments as prints: leaves, drops, lozenges, patches and bands, each a picture that repeats."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from swifttailor.arrays import Array
from swifttailor.render.ramps import NAMED_SIDE, RAMP, cells, even_noise, scattered, stamped

_SERAPE = (5, 2, 1, 3, 1, 2, 6, 1, 2, 4, 1, 3, 2, 1, 5, 2, 1, 3, 2, 4)
"""How wide its bands are beside each other."""


def palms() -> Array:
    """Large fronds in three shades, one over the other."""
    chance = np.random.default_rng(31)
    picture: Array = np.zeros((NAMED_SIDE, NAMED_SIDE))
    places = [*scattered(chance, 4, 0.3), *scattered(chance, 2, 0.2)]
    for k, place in enumerate(places):
        turn, long = chance.uniform(0.0, 2 * np.pi), chance.uniform(0.17, 0.23)
        bend = chance.uniform(-0.8, 0.8)

        def frond(
            x: Array,
            y: Array,
            turn: float = turn,
            long: float = long,
            bend: float = bend,
            ink: int = k % 3 + 1,
        ):
            along = (x * np.cos(turn) + y * np.sin(turn)) / long
            across = (y * np.cos(turn) - x * np.sin(turn)) / long - bend * 0.3 * along**2
            half = 0.62 * np.clip(1 - np.abs(along) ** 2.2, 0.0, 1.0)
            leaflet = ((along - 0.75 * np.abs(across)) * 5.5) % 1.0 < 0.74
            inside = (np.abs(along) < 1.0) & (np.abs(across) < half) & leaflet
            rib = (np.abs(across) < 0.03) & (np.abs(along) < 1.05)
            return inside | rib, np.where(rib, RAMP * (ink % 3 + 1), RAMP * ink)

        stamped(picture, (place[0], place[1]), 0.26, frond)
    return picture


def paisley() -> Array:
    """Bent drops, one within the other, edged with dots."""
    chance = np.random.default_rng(32)
    picture: Array = np.zeros((NAMED_SIDE, NAMED_SIDE))
    steps = np.linspace(0.0, 1.0, 14)
    # The spine of a drop, and how far from it the drop reaches.
    spine = np.stack([0.62 * steps**2.2, 1.35 * steps - 0.35], axis=1)
    reach = 0.5 * (1.0 - steps) ** 0.75 + 0.03
    for k, place in enumerate(scattered(chance, 4, 0.05)):
        turn, side = chance.uniform(-0.5, 0.5) + np.pi * (k % 2), 1 if (k // 4) % 2 else -1
        cosine, sine = np.cos(turn), np.sin(turn)

        def drop(x: Array, y: Array, cosine: float = cosine, sine: float = sine, side: int = side):
            u, v = side * (cosine * x + sine * y) / 0.105, (cosine * y - sine * x) / 0.105
            away = np.full(x.shape, np.inf)
            for (cx, cy), radius in zip(spine, reach, strict=True):
                away = np.minimum(away, np.hypot(u - cx, v - cy) / radius)
            heart = np.hypot(u, v + 0.3)
            petals = heart < 0.17 + 0.07 * np.cos(5 * np.arctan2(v + 0.3, u))
            dots = (away > 1.12) & (away < 1.42) & (np.cos(16 * np.arctan2(v - 0.1, u)) > 0.2)
            ink = np.select(
                [petals, away < 0.62, away < 0.76, away < 1.0], [3 * RAMP, 2 * RAMP, 0.0, RAMP], 2 * RAMP
            )
            return (away < 1.0) | dots, ink

        stamped(picture, (place[0], place[1]), 0.15, drop)
    return picture


def lozenges() -> Array:
    """A harlequin's, ten across and six up: of each colour in turn."""
    x, y = cells()
    across, up = (np.floor(10 * x + 6 * y) % 2, np.floor(10 * x - 6 * y) % 2)
    return RAMP * np.where(across == up, 2 * across, 1 + 2 * across)


def argyle() -> Array:
    """Lozenges with thin lines that cross over them."""
    x, y = cells()
    a, b = 6 * x + 4 * y, 6 * x - 4 * y
    shown = np.where((np.floor(a) + np.floor(b)) % 2 == 0, np.where(np.floor(a) % 2 == 0, 1.0, 2.0), 0.0)
    line = np.minimum(np.abs(a % 1.0 - 0.5), np.abs(b % 1.0 - 0.5)) < 0.035
    return RAMP * np.where(line, 3.0, shown)


def patchwork() -> Array:
    """Squares of all colours, some of them dotted, striped or checked, with seams between."""
    chance = np.random.default_rng(33)
    x, y = cells()
    count = 6
    column, row = np.floor(count * x).astype(np.int64), np.floor(count * y).astype(np.int64)
    inks = np.zeros((count, count), np.int64)
    for k in range(count):
        for j in range(count):
            near = {
                inks[k - 1, j],
                inks[k, j - 1],
                inks[0, j] if k == count - 1 else -1,
                inks[k, 0] if j == count - 1 else -1,
            }
            inks[k, j] = chance.choice([ink for ink in range(6) if ink not in near])
    ink, kind = inks[row, column], chance.integers(0, 6, (count, count))[row, column]
    u, v = (count * x) % 1.0, (count * y) % 1.0
    dots = np.hypot((4 * u) % 1.0 - 0.5, (4 * v) % 1.0 - 0.5) < 0.22
    figured = np.select(
        [kind == 0, kind == 1, kind == 2],
        [dots, (6 * v) % 1.0 < 0.35, ((4 * u) % 1.0 < 0.5) ^ ((4 * v) % 1.0 < 0.5)],
        False,
    )
    ink = np.where(figured, (ink + 2) % 6, ink)
    seam = (np.minimum(np.minimum(u, 1 - u), np.minimum(v, 1 - v)) < 0.02) & (
        ((8 * u) % 1.0 < 0.6) & ((8 * v) % 1.0 < 0.6)
    )
    return RAMP * np.where(seam, (ink + 1) % 6, ink).astype(np.float64)


def serape() -> Array:
    """Bands of six colours, some broad and some narrow."""
    _, y = cells()
    ends = np.cumsum(_SERAPE) / np.sum(_SERAPE)
    band = np.searchsorted(ends, y, side="right") % len(_SERAPE)
    order = np.array([0, 1, 5, 2, 5, 3, 4, 5, 1, 2, 5, 0, 3, 5, 4, 1, 5, 2, 3, 1])
    return RAMP * order[band].astype(np.float64)


def medallions() -> Array:
    """Figures of brocade: flowers of many petals in a net of curved lines."""
    x, y = cells()
    picture = np.zeros((NAMED_SIDE, NAMED_SIDE))
    net = np.cos(4 * np.pi * x) + np.cos(4 * np.pi * y)
    picture[np.abs(net) < 0.11] = RAMP

    def bloom(u: Array, v: Array):
        away, turn = np.hypot(u, v), np.arctan2(v, u)
        edge = 0.12 * (0.74 + 0.26 * np.abs(np.cos(4 * turn)))
        ring = np.abs(away - 0.05) < 0.008
        return (away < edge) & ~ring, np.where(away < 0.042, 2 * RAMP, RAMP)

    for place in scattered(np.random.default_rng(0), 2, 0.0):
        stamped(picture, (place[0], place[1]), 0.14, bloom)
    return picture


def waves() -> Array:
    """Broad swirls of all colours, one beside the other."""
    chance = np.random.default_rng(35)
    x, _ = cells()
    bands = 6 * x + 0.42 * even_noise(chance, 2.5)
    return RAMP * (np.floor(bands) % 6)


def triangles() -> Array:
    """Rows of triangles in all colours."""
    x, y = cells()
    up = (8 * y) % 1.0
    left = (8 * x + 0.5 * up + 0.5 * (np.floor(8 * y) % 2)) % 8
    right = (8 * x - 0.5 * up + 0.5 * (np.floor(8 * y) % 2)) % 8
    points_up = np.floor(left) == np.floor(right)
    ink = (np.floor(left) * 2 + np.floor(8 * y) * 3 + points_up) % 4
    return RAMP * ink


def aztec() -> Array:
    """Rows of stepped lozenges between bands of points and stripes."""
    x, y = cells()
    u, v = np.abs((4 * x) % 1.0 - 0.5), (2 * y) % 1.0
    step = np.floor(np.abs(v - 0.35) * 20) / 20 * 1.7 + np.floor(u * 10) / 10
    row = np.select([step < 0.12, step < 0.26, step < 0.4], [2.0, 0.0, 1.0], 0.0)
    points = np.abs((12 * x) % 1.0 - 0.5) * 0.16 + 0.8
    band = np.select([v < 0.76, v < 0.78, v < points, v < 0.9, v < 0.96], [0.0, 3.0, 1.0, 0.0, 2.0], 3.0)
    return RAMP * np.where(v < 0.72, row, band)


def wax_print() -> Array:
    """Large rounds of rings and rays, with dots between them."""
    x, y = cells()
    picture: Array = RAMP * 2.0 * (np.hypot((16 * x) % 1.0 - 0.5, (16 * y) % 1.0 - 0.5) < 0.2)

    def round_(u: Array, v: Array):
        away, turn = np.hypot(u, v) / 0.22, np.arctan2(v, u)
        rays = np.cos(16 * turn) > 0.0
        ink = np.select(
            [away < 0.2, away < 0.32, away < 0.42, away < 0.74, away < 0.84],
            [1.0, 3.0, 2.0, np.where(rays, 1.0, 3.0), 2.0],
            1.0,
        )
        return away < 0.94 + 0.05 * np.cos(24 * turn), RAMP * ink

    for place in scattered(np.random.default_rng(0), 2, 0.0):
        stamped(picture, (place[0], place[1]), 0.24, round_)
    return picture


DRAWN: Mapping[str, Callable[[], Array]] = {
    "palms": palms,
    "paisley": paisley,
    "lozenges": lozenges,
    "argyle": argyle,
    "patchwork": patchwork,
    "serape": serape,
    "medallions": medallions,
    "waves": waves,
    "triangles": triangles,
    "aztec": aztec,
    "wax_print": wax_print,
}

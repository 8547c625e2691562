"""Shoes for the default body: hulls of the slices of its feet, one above the other, on a sole."""

from __future__ import annotations

import functools
from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Array, read_only
from swifttailor.body.body import Body
from swifttailor.body.measuring import slice_points
from swifttailor.body.parts import BodyPart
from swifttailor.errors import InputError

AROUND, RINGS = 44, 14
"""Points around a shoe, and rings from its sole to its border."""
STEP_CM = 0.6
"""Between the slices of a foot."""


@dataclass(frozen=True)
class Footwear:
    """How a shoe is made."""

    top: float
    """Level of its upper border at the ankle, cm above the floor."""
    instep: float
    """Level of its upper border over the foot, cm."""
    sole: float
    """Height of its sole, cm."""
    thickness: float
    """Of what covers the foot, cm."""


FOOTWEAR = {
    "flats": Footwear(5.5, 3.2, 0.8, 0.4),
    "shoes": Footwear(7.0, 7.0, 2.0, 0.6),
    "sneakers": Footwear(9.0, 9.5, 3.0, 0.9),
    "ankle_boots": Footwear(14.0, 14.0, 3.0, 0.8),
    "boots": Footwear(33.0, 33.0, 3.0, 0.8),
}


def footwear(kind: str) -> tuple[Array, Array, float]:
    """A pair of shoes on the standing default body, to be carried along with it.

    Args:
        kind: One of `FOOTWEAR`.

    Returns:
        Vertices (P, 3) in cm, down to the sole's height below the floor; faces (M, 3), anticlockwise seen
        from outside; and the sole's height, for `carry(..., sole=)`.

    Raises:
        InputError: There is no such kind.
    """
    if kind not in FOOTWEAR:
        raise InputError(f"There is no footwear {kind!r}; there are {', '.join(FOOTWEAR)}.")
    return _footwear(kind)


@functools.lru_cache(maxsize=16)
def _footwear(kind: str) -> tuple[Array, Array, float]:
    made = FOOTWEAR[kind]
    levels, rings = _slices(made)
    # Over the foot the border is lower than at the heel; each point of a ring has its own level.
    share = np.clip((rings[-1, :, 1] + 5.5) / 5.0, 0.0, 1.0)
    top = made.top + share * (made.instep - made.top)
    rows = np.linspace(0.0, 1.0, RINGS)[:, None] * top
    shell = np.stack([_between(levels, rings[:, k], rows[:, k]) for k in range(AROUND)], axis=1)
    edge = rings[0].mean(axis=0) + 1.02 * (rings[0] - rings[0].mean(axis=0))
    sole = np.stack([edge[:, 0], np.full(AROUND, -made.sole), edge[:, 1]], axis=1)
    middle = sole.mean(axis=0)[None]
    left = np.concatenate([middle, sole, *shell])
    k = np.arange(AROUND)
    beside = (k + 1) % AROUND
    first = 1 + AROUND * np.arange(RINGS)[:, None]
    quads = np.stack([first + k, first + AROUND + k, first + AROUND + beside, first + beside], axis=-1)
    quads = quads.reshape(-1, 4)
    bottom = np.stack([np.zeros_like(k), 1 + k, 1 + beside], axis=1)
    faces = np.concatenate([bottom, quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    vertices = np.concatenate([left, left * (-1, 1, 1)])
    both = np.concatenate([faces[:, ::-1], faces + len(left)])
    return read_only(vertices), read_only(both.astype(np.int32)), made.sole


def _slices(made: Footwear) -> tuple[Array, Array]:
    """Levels (L,) from the floor up, and what surrounds the left foot there: (L, AROUND, 2), x and z, cm."""
    body = Body.default()
    legs = body.faces[(body.vertex_part == BodyPart.LEFT_LEG)[body.faces].all(axis=1)]
    up = np.array([0.0, 1.0, 0.0])
    levels = np.arange(0.0, max(made.top, made.instep) + STEP_CM, STEP_CM)
    turn = np.linspace(0.0, 2 * np.pi, AROUND, endpoint=False)
    directions = np.stack([np.sin(turn), np.cos(turn)], axis=1)
    rings = []
    for level in levels:
        # What lies a little lower or higher counts as well: the shell reaches over toes and around the heel.
        low = max(level - made.thickness - 1.0, 0.3)
        slab = np.concatenate(
            [
                slice_points(body.vertices, legs, up, at)[:, [0, 2]]
                for at in low + np.array([0.0, 0.5, 1.2, 2.0, 3.0])
            ]
        )
        middle = 0.5 * (slab.min(axis=0) + slab.max(axis=0))
        rings.append(middle + _reach(slab - middle, directions, made.thickness)[:, None] * directions)
    smooth = np.stack(rings)
    smooth[1:-1] = 0.5 * smooth[1:-1] + 0.25 * (smooth[:-2] + smooth[2:])
    return levels, smooth


def _reach(points: Array, directions: Array, thickness: float) -> Array:
    """How far the thickened hull of points (n, 2) around the origin reaches in directions (k, 2)."""
    from scipy.spatial import ConvexHull

    sides = ConvexHull(points).equations
    away = directions @ sides[:, :2].T
    return np.where(away > 1e-9, (thickness - sides[:, 2]) / np.maximum(away, 1e-9), np.inf).min(axis=1)


def _between(levels: Array, ring: Array, wanted: Array) -> Array:
    """Points (r, 3) at wanted levels of a line that is at ring (L, 2) at the levels (L,)."""
    return np.stack(
        [np.interp(wanted, levels, ring[:, 0]), wanted, np.interp(wanted, levels, ring[:, 1])], axis=1
    )

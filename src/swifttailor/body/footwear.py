"""Shoes for the default body: the mannequin's feet, pushed outwards and set on a sole."""

from __future__ import annotations

import functools
from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Array, read_only
from swifttailor.body.body import Body
from swifttailor.body.mannequin import mannequin
from swifttailor.errors import InputError


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
    "flats": Footwear(5.0, 3.4, 0.8, 0.5),
    "shoes": Footwear(6.5, 7.0, 2.0, 0.8),
    "sneakers": Footwear(8.0, 9.0, 3.0, 1.2),
    "ankle_boots": Footwear(14.0, 14.0, 3.0, 1.1),
    "boots": Footwear(33.0, 33.0, 3.0, 1.0),
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


@functools.cache
def _footwear(kind: str) -> tuple[Array, Array, float]:
    made = FOOTWEAR[kind]
    figure, faces = mannequin(Body.default())
    _, y, z = figure.T
    # Over the foot the border is lower than at the heel; it rises towards the leg.
    share = np.clip((z + 3.0) / 6.0, 0.0, 1.0)
    border = made.top + share * (made.instep - made.top)
    kept = faces[(y < border)[faces].all(axis=1)]
    used = np.unique(kept)
    vertices, shoe = figure[used], np.searchsorted(used, kept)
    normals = _normals(vertices, shoe)
    height = vertices[:, 1]
    vertices = vertices + made.thickness * normals
    # The lowest part becomes the sole: level below, its sides upright.
    low = np.clip((2.2 - height) / 1.4, 0.0, 1.0)
    vertices[:, 1] = (1.0 - low) * np.maximum(vertices[:, 1], -made.sole) - low * made.sole
    return read_only(vertices), read_only(shoe.astype(np.int32)), made.sole


def _normals(vertices: Array, faces: Array) -> Array:
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    across = np.cross(b - a, c - a)
    total = np.zeros_like(vertices)
    for k in range(3):
        np.add.at(total, faces[:, k], across)
    return total / np.maximum(np.linalg.norm(total, axis=1, keepdims=True), 1e-9)

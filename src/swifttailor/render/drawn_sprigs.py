"""Little flowers, each by itself on much ground: what small figures on dresses and blouses are."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from swifttailor.arrays import Array
from swifttailor.render.ramps import NAMED_SIDE, RAMP, scattered, stamped

_ACROSS = 4
"""In a row of a repeat."""
_BLOSSOMS = 2
_REACH = 0.075
"""Half the width of one, as a part of the repeat: ground of more than its own width lies between two."""


def sprigs() -> Array:
    """Blossoms of five petals on a stem with two leaves, in rows, each turned its own way."""
    chance = np.random.default_rng(51)
    picture = np.zeros((NAMED_SIDE, NAMED_SIDE))
    for k, place in enumerate(scattered(chance, _ACROSS, 0.2)):
        turned, petals = chance.uniform(0, 2 * np.pi), float(RAMP if k % 3 else 2 * RAMP)

        def sprig(x: Array, y: Array, turned: float = turned, petals: float = petals):
            u = (x * np.cos(turned) + y * np.sin(turned)) / _REACH
            v = (y * np.cos(turned) - x * np.sin(turned)) / _REACH
            away, turn = np.hypot(u, v), np.arctan2(v, u)
            blossom = away < 0.72 * (0.76 + 0.24 * np.cos(5 * turn))
            stem = (np.abs(v) < 0.07) & (u < 0) & (u > -1.0)
            leaf = ((u + 0.68) / 0.3) ** 2 + ((np.abs(v) - 0.22) / 0.16) ** 2 < 1.0
            heart = away < 0.2
            ink = np.where(heart, 3 * RAMP - petals, np.where(blossom, petals, 3 * RAMP))
            return blossom | stem | leaf, ink

        stamped(picture, (place[0], place[1]), _REACH, sprig)
    return picture


def daisies() -> Array:
    """Blossoms of narrow petals around a round heart, large and small."""
    return _blossoms(11, heart=0.26, with_leaves=False)


def sunflowers() -> Array:
    """Blossoms of pointed petals around a large heart, with leaves."""
    return _blossoms(16, heart=0.46, with_leaves=True)


def _blossoms(petals: int, *, heart: float, with_leaves: bool) -> Array:
    """Blossoms in rows: petals of the second colour, hearts of the third, leaves of the fourth."""
    chance = np.random.default_rng(52)
    picture = np.zeros((NAMED_SIDE, NAMED_SIDE))
    for k, place in enumerate(scattered(chance, _BLOSSOMS, 0.08)):
        size, turned = (0.19, 0.15)[k % 2], chance.uniform(0, 2 * np.pi)

        def blossom(x: Array, y: Array, size: float = size, turned: float = turned):
            away, turn = np.hypot(x, y) / size, np.arctan2(y, x) + turned
            petal = away < 0.62 + 0.36 * np.abs(np.cos(petals * turn / 2))
            leaf = (np.abs(np.sin(turn)) < 0.32 * (1.25 - away)) & (away < 1.2) & with_leaves
            ink = np.where(away < heart, 2 * RAMP, np.where(petal, RAMP, 3 * RAMP))
            return petal | leaf, ink

        stamped(picture, (place[0], place[1]), 1.25 * size, blossom)
    return picture


DRAWN: Mapping[str, Callable[[], Array]] = {"sprigs": sprigs, "daisies": daisies, "sunflowers": sunflowers}

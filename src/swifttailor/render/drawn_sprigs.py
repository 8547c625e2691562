"""Little flowers, each by itself on much ground: what small figures on dresses and blouses are."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from swifttailor.arrays import Array
from swifttailor.render.ramps import NAMED_SIDE, RAMP, scattered, stamped

_ACROSS = 4
"""In a row of a repeat."""
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


DRAWN: Mapping[str, Callable[[], Array]] = {"sprigs": sprigs}

"""What the face of cloth looks like from near: curls, plaits, sequins, pile; heights of 0 to 2 * RAMP.

Their three colours are those of hollows, of the whole and of what stands out.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from swifttailor.arrays import Array
from swifttailor.render.motifs import smooth_noise
from swifttailor.render.ramps import NAMED_SIDE, RAMP, cells, even_noise

_SEQUINS = 16
CHANNELS = 4
"""Cushions of puffed cloth in a repeat."""
_CURLS = 30.0


def curls() -> Array:
    """Fleece and teddy: short curls, all of about one size."""
    chance = np.random.default_rng(41)
    field = even_noise(chance, _CURLS, spread=0.3)
    return RAMP * (1.0 + 0.95 * np.tanh(1.2 * field))


def cables() -> Array:
    """A plait of two strands between ribs, twice across."""
    x, y = cells()
    across = (2 * x) % 1.0 - 0.5
    height = 0.55 + 0.35 * np.cos(2 * np.pi * 14 * across)
    plait = np.abs(across) < 0.29
    turn = 2 * np.pi * 2 * y
    strands = []
    for phase in (0.0, np.pi):
        middle = 0.13 * np.sin(turn + phase)
        lift = 0.12 * np.cos(turn + phase)
        strands.append(1.0 - ((across - middle) / 0.13) ** 2 + lift)
    stitches = 0.14 * np.cos(2 * np.pi * (24 * y + 6 * np.abs(across)))
    return RAMP * np.clip(np.where(plait, 1.7 * np.maximum(*strands) + stitches, height + 0.3), 0.0, 2.0)


def sequins() -> Array:
    """Small discs side by side, a few of which throw back the light."""
    x, y = cells()
    row = np.floor(_SEQUINS * y)
    column = _SEQUINS * x + 0.5 * (row % 2)
    away = np.hypot(column % 1.0 - 0.5, (_SEQUINS * y) % 1.0 - 0.5)
    chance = np.random.default_rng(42)
    shine = chance.choice([0.35, 0.8, 1.1, 2.0], (_SEQUINS, _SEQUINS), p=[0.2, 0.35, 0.25, 0.2])
    lit = shine[row.astype(np.int64), np.floor(column).astype(np.int64) % _SEQUINS]
    return RAMP * np.where(away < 0.46, lit, 0.0)


def pile() -> Array:
    """Velvet: pile that lies a little this way and that, in long soft strokes."""
    chance = np.random.default_rng(43)
    soft = 0.7 * even_noise(chance, 5.0, stretch=2.2, spread=0.5) + 0.3 * even_noise(
        chance, 20.0, stretch=2.0
    )
    return RAMP * np.clip(1.0 + 0.5 * soft, 0.0, 2.0)


def channels() -> Array:
    """Puffed cloth: four cushions one above the other, lit from above, with creases at their seams."""
    chance = np.random.default_rng(46)
    _, y = cells()
    up = (CHANNELS * y) % 1.0
    lit = -np.cos(np.pi * up) * np.sin(np.pi * up) ** 0.35
    creases = even_noise(chance, 16.0, spread=0.6) * np.abs(up - 0.5) ** 1.5
    return RAMP * np.clip(1.0 + 0.9 * lit + 0.6 * creases, 0.0, 2.0)


def foil() -> Array:
    """Metal: bright and dark strokes down the cloth."""
    chance = np.random.default_rng(44)
    soft = even_noise(chance, 6.0, stretch=5.0, spread=0.6)
    return RAMP * np.clip(1.0 + 0.62 * soft, 0.0, 2.0)


def fur() -> Array:
    """Hair: fine strokes that fall, in locks."""
    chance = np.random.default_rng(45)
    hair, locks = smooth_noise(chance, NAMED_SIDE, 0.6, 0.2), even_noise(chance, 7.0, stretch=2.0)
    return RAMP * np.clip(1.0 + 0.45 * hair + 0.4 * locks, 0.0, 2.0)


DRAWN: Mapping[str, Callable[[], Array]] = {
    "curls": curls,
    "cables": cables,
    "sequins": sequins,
    "pile": pile,
    "foil": foil,
    "channels": channels,
    "fur": fur,
}

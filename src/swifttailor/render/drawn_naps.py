"""What the face of cloth looks like from near: curls, plaits, sequins, pile; heights of 0 to 2 * RAMP.

Their three colours are those of hollows, of the whole and of what stands out.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from swifttailor.arrays import Array
from swifttailor.render.motifs import smooth_noise
from swifttailor.render.ramps import NAMED_SIDE, RAMP, cells, even_noise

_SEQUINS = 20
_SPARKLES = 0.05
"""Share of sequins that throw back the light: more of them would be another colour from afar."""
CHANNELS = 4
"""Cushions of puffed cloth in a repeat."""
_STITCHED = 0.02
"""Half the width of a line of stitches, as a part of a cushion."""
_CURLS = 72.0
"""Across a repeat: finer than previews show, so that fleece is soft and has no pebbles."""


def curls() -> Array:
    """Fleece and teddy: short curls that lie no way more than another."""
    field = even_noise(np.random.default_rng(41), _CURLS, spread=0.4)
    return RAMP * (1.0 + 0.9 * np.tanh(field))


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
    """Small discs side by side, a few of which throw back the light; their mean is the colour asked for."""
    x, y = cells()
    row = np.floor(_SEQUINS * y)
    column = _SEQUINS * x + 0.5 * (row % 2)
    away = np.hypot(column % 1.0 - 0.5, (_SEQUINS * y) % 1.0 - 0.5)
    chance = np.random.default_rng(42)
    shares = [0.25, 0.45, 0.3 - _SPARKLES, _SPARKLES]
    shine = chance.choice([0.86, 1.0, 1.1, 2.0], (_SEQUINS, _SEQUINS), p=shares)
    lit = shine[row.astype(np.int64), np.floor(column).astype(np.int64) % _SEQUINS]
    return RAMP * np.where(away < 0.46, lit, 0.75)


def pile() -> Array:
    """Velvet: pile that lies a little this way and that, in long soft strokes."""
    chance = np.random.default_rng(43)
    soft = 0.7 * even_noise(chance, 5.0, stretch=2.2, spread=0.5) + 0.3 * even_noise(
        chance, 20.0, stretch=2.0
    )
    return RAMP * np.clip(1.0 + 0.22 * soft, 0.0, 2.0)


def channels() -> Array:
    """Puffed cloth: four cushions one above the other, lit from above, with stitches between."""
    _, y = cells()
    up = (CHANNELS * y) % 1.0
    # Softer than the stitches, so that small pictures show an even shade where they lie.
    shade = 0.7 * np.exp(-up / 0.13) + 0.5 * np.exp(-(1.0 - up) / 0.08)
    lit = 0.75 * np.exp(-(((up - 0.6) / 0.2) ** 2))
    stitched = np.minimum(up, 1.0 - up) < _STITCHED
    return RAMP * np.where(stitched, 0.0, np.clip(1.0 + lit - shade, 0.0, 2.0))


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

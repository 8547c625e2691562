"""Pictures to print that have names, each drawn when it is first asked for."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from swifttailor.arrays import Array
from swifttailor.render import (
    drawn_cloths,
    drawn_dyes,
    drawn_naps,
    drawn_ornaments,
    drawn_skins,
    drawn_sprigs,
    drawn_weaves,
)
from swifttailor.render.drawn_figures import FIGURES, figure_picture
from swifttailor.render.motifs import BANDS
from swifttailor.render.ramps import NAMED_SIDE, RAMP

_FIELDS = {
    **drawn_skins.DRAWN,
    **drawn_dyes.DRAWN,
    **drawn_ornaments.DRAWN,
    **drawn_naps.DRAWN,
    **drawn_sprigs.DRAWN,
    **drawn_weaves.DRAWN,
    **drawn_cloths.DRAWN,
}
NAMED = (*FIGURES, *_FIELDS)
"""All names; their numbers as motifs follow `motifs.BANDS`."""


def number_of(name: str) -> int:
    """Of one of `NAMED`, as a motif."""
    return BANDS + 1 + NAMED.index(name)


@lru_cache(maxsize=64)
def named_picture(number: int) -> Array:
    """(NAMED_SIDE²,) int16: where on the ramp of its colours each cell of a motif lies (`ramps`).

    Args:
        number: See `number_of`.
    """
    name = NAMED[(number - BANDS - 1) % len(NAMED)]
    drawn = _FIELDS[name]() if name in _FIELDS else RAMP * figure_picture(name, NAMED_SIDE).astype(np.float64)
    return np.round(drawn).astype(np.int16).ravel()

"""Colours that a text refuses: what looks like one of them, and what a garment has instead of them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from swifttailor.render.lab import lab_of_hex
from swifttailor.wishes.looks.print_inks import brightness

_OTHERS = ("#5c7c9c", "#76836b", "#8c3b45", "#b9a58a", "#8a8f98")
"""Blue, sage, berry, sand and grey: the first that is unlike all that is refused is taken."""
_APART = 38.0
"""Distance in CIELAB from which two colours are called by different names."""
_ALIKE = 32
"""Difference in red, green and blue up to which two colours are called the same, 0 to 255."""
_BLACK, _BLACKISH = 45.0, 82.0
"""Brightness of what is called black, and of what hardly differs from it on the body, 0 to 255."""


def is_like(one: str, refused: str) -> bool:
    """Whether a colour is hardly told apart from a refused one: charcoal from black.

    Args:
        one: ``rrggbb``.
        refused: The same.
    """
    apart = [abs(int(one[k : k + 2], 16) - int(refused[k : k + 2], 16)) for k in (0, 2, 4)]
    dark = brightness(f"#{refused}") < _BLACK and brightness(f"#{one}") < _BLACKISH
    return max(apart) <= _ALIKE or dark


def color_besides(refused: Sequence[str]) -> str | None:
    """A colour that is none of those that a text refuses, ``rrggbb``; None where it refuses none.

    Args:
        refused: ``rrggbb`` each.
    """
    if not refused:
        return None
    away = [lab_of_hex(f"#{one}") for one in refused]
    least = {other: min(float(np.linalg.norm(lab_of_hex(other) - one)) for one in away) for other in _OTHERS}
    found = next((other for other in _OTHERS if least[other] >= _APART), max(least, key=lambda o: least[o]))
    return found.removeprefix("#")

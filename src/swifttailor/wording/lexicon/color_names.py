"""What people call a colour, by the plain ones of the names that the tables know."""

from __future__ import annotations

from functools import cache

import numpy as np

from swifttailor.arrays import Array
from swifttailor.render.lab import lab_of_hex
from swifttailor.wording.lexicon.vocabulary import entries_in

PLAIN = (
    *("black", "charcoal", "dark grey", "grey", "light grey", "white", "cream", "beige", "sand", "taupe"),
    *("camel", "tan", "caramel", "brown", "dark brown", "rust", "terracotta", "copper", "nude"),
    *("red", "dark red", "burgundy", "scarlet", "coral", "salmon", "pink", "pale pink", "dusty pink"),
    *("dark pink", "hot pink", "fuchsia", "rose", "plum", "mauve", "magenta", "lilac", "lavender"),
    *("purple", "dark purple", "violet", "aubergine", "orange", "dark orange", "peach", "yellow"),
    *("light yellow", "mustard", "olive", "khaki", "sage", "mint", "pistachio", "lime", "green"),
    *("light green", "dark green", "bright green", "army green", "petrol", "teal", "turquoise"),
    *(
        "dark turquoise",
        "pale turquoise",
        "blue",
        "dark blue",
        "navy",
        "light blue",
        "sky blue",
        "soft sky blue",
    ),
    *("denim blue", "blue grey", "royal blue", "bright blue", "baby blue", "steel blue"),
)
"""Names that need no explanation; the tables know odder ones."""


def color_name(rgb: str) -> str:
    """The name of the nearest plain colour.

    Args:
        rgb: sRGB as ``rrggbb``, with or without ``#``.
    """
    known, (lightness, red, yellow) = _plain(), lab_of_hex(rgb)
    strong, own = np.hypot(known[:, 1], known[:, 2]), np.hypot(red, yellow)
    away = (known[:, 1] - red) ** 2 + (known[:, 2] - yellow) ** 2
    hue = np.maximum(away - (strong - own) ** 2, 0.0)
    # CIE94: what is strong in colour may be stronger still, and what is grey is soon something else.
    both = np.sqrt(strong * own)
    apart = (known[:, 0] - lightness) ** 2 + ((strong - own) / (1 + 0.045 * both)) ** 2
    apart += hue / (1 + 0.015 * both) ** 2
    return PLAIN[int(apart.argmin())]


@cache
def _plain() -> Array:
    known = {word: e.color for e in reversed(entries_in("colors")) for word in e.words if e.color is not None}
    return np.array([lab_of_hex(str(known[name])) for name in PLAIN])

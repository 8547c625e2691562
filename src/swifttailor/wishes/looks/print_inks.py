"""The colours of a print from those that a text names: which is the ground, and what goes with them."""

from __future__ import annotations

import colorsys
from collections.abc import Sequence

LIGHT, DARK, INK = "#f4f1e8", "#1f2a44", "#a8443c"
_WHITE, _BLACK = "#ffffff", "#17151a"
_LIGHT_FROM = 190.0
"""Brightness from which a colour counts as light, 0 to 255."""
_PALE_FROM, _COLORED, _ALL_BUT_WHITE = 165.0, 0.12, 0.96
"""The same of what fades into a stronger one; saturation and lightness of what is no white or grey."""
_PETALS = {True: ("#c2566c", "#f6ead9", "#5f8a5a"), False: (LIGHT, "#e6a9ac", "#84a878")}
"""Petals, others and leaves on light cloth, and on darker."""
FIGURES = {
    "hearts": ("#f6f1ea", "#c8354a"),
    "stars": ("#1f2a44", "#e9c85c"),
    "moons": ("#1f2a44", "#e9dfb4", "#e9c85c"),
    "bolts": ("#f4f1e8", "#e2b32c"),
    "cherries": ("#f6f1e6", "#b3202c", "#3f7a3c"),
    "strawberries": ("#f6f1e6", "#c92f38", "#3f7a3c", "#f3dfa0"),
    "lemons": ("#f4f1e8", "#f0cf3a", "#4f8a48", "#fbeea0"),
    "mushrooms": ("#dfe5d0", "#b8332c", "#f6efe0"),
    "foxes": ("#dfe6e2", "#d0702c", "#f8f2e6", "#33261f"),
    "cats": ("#f1e6dc", "#3a3a42", "#e9d27a", "#d98a94"),
    "bears": ("#dbe6ee", "#9a6b45", "#e6c9a4", "#33261f"),
    "rabbits": ("#a6c3d3", "#faf7f2", "#e6a8ae", "#4a3d3a"),
    "birds": ("#f2eee2", "#3d6f96", "#a9c8d8", "#d38a34"),
    "butterflies": ("#f4f0e8", "#d8763a", "#f0b85a", "#33261f"),
    "bees": ("#eef2ea", "#efc03a", "#c9d8e2", "#2b2622"),
    "fishes": ("#e4eef0", "#3f86a8", "#e79a5a"),
    "dinosaurs": ("#f1ede0", "#5f9a5c", "#e2b64a"),
    "anchors": ("#f4f1e8", "#1f2a44"),
    "boats": ("#e6eef2", "#1f2a44", "#ffffff", "#c8354a"),
    "splatters": ("#f4f1e8", "#2f6fae", "#d8453a", "#efc03a"),
    "cranes": ("#33507a", "#f6f3ea", "#c8354a", "#20222b"),
    "elephants": ("#f1e8d8", "#6d7f8e", "#a9b8c2", "#f8f4ec"),
    "dogs": ("#e4ebee", "#8a5a36", "#5f3a22", "#2b2320"),
    "horses": ("#efe6d6", "#7a4a2c", "#3a251a"),
    "flamingos": ("#e3f0ee", "#ee8fa6", "#d8607f", "#2b2622"),
    "owls": ("#f1e8da", "#8a6240", "#d9b98c", "#2e2119"),
    "turtles": ("#e9f1ea", "#4f7f56", "#93b27a", "#2f5138"),
    "pineapples": ("#f6f1e4", "#e6b53a", "#3f7a4a", "#a8742a"),
    "skulls": ("#26242a", "#f1ede2"),
    "snowflakes": ("#2a4a78", "#f4f6f8"),
    "crosses": ("#f4f1e8", "#a8323a"),
    "penguins": ("#dcebf2", "#26303c", "#f8f6f0", "#e2963a"),
    "pandas": ("#d9e8d8", "#26262a", "#faf8f2", "#6f9a5f"),
    "sharks": ("#e4f0f3", "#5d7f94", "#f8f6f0", "#2f4a5c"),
    "whales": ("#eef3f2", "#3d6f96", "#cfe0e8", "#7fb4cc"),
    "unicorns": ("#f2b3cb", "#ffffff", "#7f68c2", "#f0c23a"),
    "parrots": ("#eef3e4", "#c9342f", "#2f8a55", "#20242c"),
    "tigers": ("#e9f1ea", "#e08a2c", "#f8f2e6", "#2b201a"),
    "rockets": ("#22345c", "#eef1f4", "#d23a3a", "#f0b63f"),
    "cacti": ("#f6efe2", "#4f8a58", "#f2a0b0", "#c9754a"),
    "daisies": ("#7fa3c9", "#fdfcf6", "#efbf35", "#4f7f45"),
    "sunflowers": ("#f4f1e8", "#f2b62c", "#5a3720", "#4f7f45"),
    "palms": ("#f4f1e8", "#2f5f3c", "#6f9a5f", "#a9bf7c"),
    "palm_trees": ("#e3f0f1", "#2f7a4a", "#8a5a36", "#e2c48a"),
}
"""Pictures that keep their own colours on whatever ground, the first: foxes are red on blue."""
_SKINS = {
    "leopard": ("#cfa266", "#2b1d14", "#9a6a36"),
    "zebra": ("#f5f2ea", "#141414"),
    "tiger": ("#d9822b", "#efc58c", "#1c1410"),
    "giraffe": ("#ecdcb4", "#8a5226", "#6d3d1a"),
    "cowhide": ("#f5f2ea", "#1b1a19"),
    "dalmatian": ("#f5f2ea", "#1b1a19"),
    "scales": ("#cdbd95", "#8d7a55", "#3d3526"),
    "crocodile": ("#26301f", "#46583a", "#6f8258"),
}
_PATCHED = frozenset({"zebra", "giraffe", "cowhide", "dalmatian"})
"""Whose marks are dark on light."""
_OTHERS = {
    "flowers": ("#f4f1e8", "#b0485a", "#d9a0a8", "#5f8a5a"),
    "sprigs": ("#f4f1e8", "#b0485a", "#d9a0a8", "#5f8a5a"),
    "leaves": ("#f4f1e8", "#3f6b46", "#7fa070", "#c2a25c"),
    "spots": ("#cfa56b", "#35261a", "#8a6238", "#5b4127"),
    "blotches": ("#6f7758", "#3c4530", "#a89e76", "#2b2b23"),
    "plaid": ("#b0242d", "#1e3a36", "#eadfc6"),
    "tie_dye": ("#f6f2ea", "#3f86c4", "#f6f2ea", "#d8598c", "#f6f2ea", "#f0b63f"),
    "batik": ("#2c3f73", "#e8e4d8", "#7d9bc9"),
    "marble": ("#f4f2ef", "#c6c2c0", "#4a4744"),
    "clouds": ("#f4f1ec", "#a8c6dc", "#e2b6c4", "#c4d6b4"),
    "ikat": ("#f4efe2", "#2c4576", "#a8443c"),
    "paisley": ("#7a2430", "#e0b45c", "#f3e3c0", "#2f5a58"),
    "lozenges": ("#ab252e", "#e8c95f", "#2a5ca8", "#f4f1e8"),
    "argyle": ("#1f2a44", "#8a1f2d", "#5d6b86", "#f4f1e8"),
    "patchwork": ("#7f3b3f", "#e9dcc0", "#3f5f7f", "#c79a4b", "#5f7a58", "#d9a9a0"),
    "serape": ("#c92f38", "#2f7a55", "#f0b63f", "#2a5ca8", "#d8598c", "#f4f1e8"),
    "medallions": ("#26375f", "#d9b45b", "#f0dc9c"),
    "waves": ("#e8893c", "#f4d9a0", "#8a3b2a", "#d8598c", "#f4f1e8", "#e2b32c"),
    "triangles": ("#f4f1e8", "#1f2a44", "#d8a24a", "#a8443c"),
    "galaxy": ("#12142e", "#41337c", "#2a6a9a", "#b04f98", "#f6f4ff"),
    "camouflage": ("#6f7a4e", "#3f4a30", "#a39a6c", "#26261f"),
    "zigzag": ("#f4f1e8", "#1f2a44"),
    "herringbone": ("#948c80", "#4f4a44"),
    "rainbow": ("#d8403a", "#ec8a34", "#f2cf45", "#4f9a55", "#3a6fb8", "#7a4a9a"),
    "ombre": ("#f3dfe4", "#dd97ae", "#b83f6d"),
    "aztec": ("#f1e8d8", "#a8443c", "#1f2a44", "#d8a24a"),
    "houndstooth": ("#eeebe4", "#232428"),
    "granny_squares": ("#f1e9d8", "#c8505a", "#3f7f8a", "#e6b53a", "#7a4a7a"),
    "wax_print": ("#f2a51d", "#b5281e", "#15603c", "#1b2a63"),
}
_INKS = FIGURES | _SKINS | _OTHERS
_AS_NAMED = frozenset({"houndstooth", "lozenges", "waves", "triangles", "zigzag", "rainbow"})
"""Of as many colours as are named, and no others."""
SHADED = {
    "curls": (0.9, 0.08),
    "cables": (0.8, 0.3),
    "sequins": (0.6, 0.75),
    "pile": (0.72, 0.14),
    "foil": (0.6, 0.75),
    "channels": (0.55, 0.0),
    "fur": (0.68, 0.22),
    "marl": (0.8, 0.24),
    "linen": (0.94, 0.12),
}
"""The face of cloth, of one colour: how light its hollows are, and how much of white what stands out has;
without any it is of the same hue, but brighter."""
_MORE_LIGHT = 30
_LEAST_APART = 56
"""By so much some part of a figure's colour differs from its ground, 0 to 255."""


def usual_inks(name: str) -> tuple[str, ...]:
    """What such a print has where no colour is named; empty where that is not known.

    Args:
        name: A motif, or ``plaid``.
    """
    return _INKS.get(name, ())


def shades(name: str, color: str) -> tuple[str, ...]:
    """Hollows, the whole and what stands out.

    Args:
        name: One of `SHADED`.
        color: ``#rrggbb``.
    """
    hollow, bright = SHADED[name]
    dark = mixed(color, "#000000", hollow)
    return dark, color, mixed(_WHITE, color, bright) if bright else _brighter(color)


def _brighter(color: str) -> str:
    """The same hue in more light: white mixed in would make navy grey."""
    parts = [int(color[k : k + 2], 16) for k in (1, 3, 5)]
    factor = min(max(parts) + _MORE_LIGHT, 255) / max(*parts, 1)
    return "#" + "".join([f"{min(round(max(part, 1) * factor), 255):02x}" for part in parts])


def motif_inks(name: str, named: Sequence[str]) -> tuple[str, ...]:
    """All colours of a motif.

    Args:
        name: The motif.
        named: One or more, ``#rrggbb``, the ground first.
    """
    first = named[0]
    if name in SHADED:
        return shades(name, first)
    if name == "tie_dye":
        return _tied(named)
    if name in _SKINS:
        return _coat(name, named)
    whole = ("patchwork", "granny_squares")
    if name in ("serape", "rainbow") or (name in whole and len(named) == 1):
        return (*named, *[ink for ink in _INKS[name] if ink not in named])[:6]
    if name == "ombre":
        return _faded(named)
    if name == "herringbone" and len(named) == 1:
        return first, mixed(LIGHT if brightness(first) < _LIGHT_FROM / 3 else _BLACK, first, 0.45)
    if name in ("flowers", "sprigs") and len(named) == 1:
        return (first, *seen_on(first, _PETALS[brightness(first) >= _PALE_FROM]))
    other = named[1] if len(named) > 1 else contrast(first)
    if name == "camouflage" and len(named) == 1:
        dark = mixed(first, _BLACK, 0.25)
        return first, mixed(first, _BLACK, 0.6), mixed(first, LIGHT, 0.45), dark
    if name == "galaxy":
        night, glow = _INKS[name][0], other if len(named) > 1 else mixed(first, LIGHT, 0.7)
        return night, mixed(first, night, 0.6), first, glow, _WHITE
    if name == "patchwork":
        tints = (
            mixed(first, other, 0.5),
            mixed(first, LIGHT, 0.7),
            mixed(first, _BLACK, 0.75),
            mixed(other, LIGHT, 0.7),
        )
        return (*named, *tints)[:6]
    if name == "argyle" and len(named) < 3:
        return (
            first,
            mixed(other, first, 0.4 if len(named) == 1 else 1.0),
            mixed(first, other, 0.7),
            contrast(first),
        )
    if name in _AS_NAMED:
        return (*named, other)[: max(2, len(named))][:6]
    if len(named) > 2:
        return (*named, mixed(first, other, 0.5))[:4]
    return first, other, mixed(other, LIGHT, 0.5), mixed(first, other, 0.5)


def _faded(named: Sequence[str]) -> tuple[str, ...]:
    """From above: as named, or from a pale shade of the one colour, or of a dark one that follows."""
    if len(named) > 2:
        return tuple(named[:3])
    if len(named) == 2:
        return named[0], mixed(named[0], named[1], 0.5), named[1]
    first = named[0]
    pale = brightness(first) >= _PALE_FROM
    top, low = (mixed(first, _WHITE, 0.5), _deepened(first)) if pale else (mixed(first, _WHITE, 0.12), first)
    return top, mixed(top, low, 0.5), low


def _deepened(color: str) -> str:
    """A pale colour as strong as the dye comes; navy of what is white."""
    hue, light, strength = colorsys.rgb_to_hls(*[int(color[k : k + 2], 16) / 255 for k in (1, 3, 5)])
    if strength < _COLORED or light > _ALL_BUT_WHITE:
        return DARK
    deep = colorsys.hls_to_rgb(hue, 0.55 * light, max(strength, 0.5))
    return "#" + "".join([f"{round(255 * part):02x}" for part in deep])


def tartan_inks(named: Sequence[str]) -> tuple[str, ...]:
    """Ground, bands and lines of a tartan, the first colour by far the most of it.

    Args:
        named: One or more, ``#rrggbb``.
    """
    first = named[0]
    light = brightness(first) >= _LIGHT_FROM
    band = named[1] if len(named) > 1 else mixed(first, DARK, 0.55 if light else 0.2)
    line = named[2] if len(named) > 2 else (INK if light else mixed(LIGHT, first, 0.75))
    return first, band, line


def tonal_check(color: str) -> tuple[str, ...]:
    """Ground, bands and lines of a check in shades of one colour, as suits and coats have it."""
    dark = brightness(color) < _LIGHT_FROM / 3
    return color, mixed(LIGHT, color, 0.28) if dark else mixed(color, _BLACK, 0.62), mixed(LIGHT, color, 0.32)


def _tied(named: Sequence[str]) -> tuple[str, ...]:
    """Two, three or six: the spiral goes through six colours (`drawn_dyes.LOOP`)."""
    light = [color for color in named if brightness(color) >= _LIGHT_FROM]
    if len(named) == 1:
        other = LIGHT if not light else contrast(named[0])
        return other, named[0], mixed(named[0], other, 0.55)
    if len(named) == 2:
        return tuple(named) if light else (named[0], LIGHT, named[1])
    between = light[0] if light else LIGHT
    three = [color for color in named if color != between][:3]
    return (between, *three) if len(three) == 2 else (between, three[0], between, three[1], between, three[2])


def _coat(name: str, named: Sequence[str]) -> tuple[str, ...]:
    own = _SKINS[name]
    if name in _PATCHED:
        both = sorted([*named[:2], *([contrast(named[0])] if len(named) == 1 else [])], key=brightness)
        return both[1], both[0], mixed(both[0], _BLACK, 0.7)
    marks = named[1] if len(named) > 1 else mixed(named[0], _BLACK, 0.2)
    if name == "tiger":
        return named[0], mixed(named[0], LIGHT, 0.55), marks
    if name == "crocodile":
        return mixed(named[0], _BLACK, 0.6), named[0], mixed(named[0], LIGHT, 0.75)
    dark = brightness(named[0]) < _LIGHT_FROM / 3 and len(named) == 1
    return named[0], own[0] if dark else marks, mixed(named[0], own[0] if dark else marks, 0.6)


def seen_on(ground: str, inks: Sequence[str]) -> tuple[str, ...]:
    """Inks of figures, those darker that would not be seen on a ground: rabbits are grey on white.

    On a dark ground they are lighter instead: anchors are pale on navy.

    Args:
        ground: ``#rrggbb``.
        inks: The same of each.
    """
    dark = brightness(ground) < _LIGHT_FROM / 3
    return tuple(
        [
            ink
            if _apart(ground, ink) >= _LEAST_APART
            else mixed(ink, LIGHT, 0.2)
            if dark
            else mixed(ink, _BLACK, 0.68)
            for ink in inks
        ]
    )


def _apart(one: str, other: str) -> int:
    """The most by which two colours differ in red, green or blue, 0 to 255."""
    return max(abs(int(one[k : k + 2], 16) - int(other[k : k + 2], 16)) for k in (1, 3, 5))


def contrast(color: str) -> str:
    """Off-white, or navy on what is light."""
    return LIGHT if brightness(color) < _LIGHT_FROM else DARK


def brightness(color: str) -> float:
    """Of a colour ``#rrggbb``, 0 to 255."""
    red, green, blue = (int(color[k : k + 2], 16) for k in (1, 3, 5))
    return 0.3 * red + 0.59 * green + 0.11 * blue


def mixed(one: str, other: str, share: float) -> str:
    """``#rrggbb`` with so much of the one, the rest of the other."""
    parts = [(1 - share) * int(other[k : k + 2], 16) + share * int(one[k : k + 2], 16) for k in (1, 3, 5)]
    return "#" + "".join([f"{round(part):02x}" for part in parts])

"""Patterns to print, made once in a process by fixed lots: motifs that repeat, graphics, and noise."""

from __future__ import annotations

from functools import cache

import numpy as np

from swifttailor.arrays import Array

SIDE = 128
"""Cells along each side of a motif."""
GRAPHIC_SIDE = 64
NOISE_SIDE = 256
MOTIFS, GRAPHICS = 40, 48
"""How many of each."""


NOISE_STEPS = 4096.0
"""Whole numbers in a unit of noise."""
SOFT, CREASES = 0, NOISE_SIDE**2
FIRST_MOTIF = 2 * NOISE_SIDE**2
FIRST_GRAPHIC = FIRST_MOTIF + MOTIFS * SIDE**2
"""Where in the bank each begins."""
BANDS = MOTIFS + GRAPHICS * GRAPHIC_SIDE**2 // SIDE**2
"""Number of the motif that lies behind the graphics: bands of figures, of which no lots are drawn.
The pictures that have names follow it, in their order (`named_pictures`); they do not lie in the bank."""


@cache
def bank() -> Array:
    """All patterns in one row of int16, the same in every process.

    Two pictures of noise that repeats (soft blotches; long creases), in steps, mean 0; then motifs of SIDE by
    SIDE numbers of colours, 0 to 3; then graphics of GRAPHIC_SIDE by GRAPHIC_SIDE: 0 the cloth, or a colour;
    then bands of knitted figures, as large as a motif.
    """
    chance = np.random.default_rng(20_240)
    makers = (_flowers, _leaves, _blotches, _spots, _shapes)
    motifs = [makers[k % len(makers)](chance) for k in range(MOTIFS)]
    graphics = [(_lettering, _badge, _picture)[k % 3](chance) for k in range(GRAPHICS)]
    noise = np.clip(np.round(_noise(chance) * NOISE_STEPS), -32_768, 32_767)
    parts = (noise, *motifs, *graphics, _bands())
    return np.concatenate([np.ravel(part).astype(np.int16) for part in parts])


def smooth_noise(chance: np.random.Generator, side: int, slope: float, stretch: float = 1.0) -> Array:
    """(side, side) noise that repeats, mean 0 and deviation 1.

    Args:
        chance: Where the lots come from.
        side: Cells.
        slope: By which power it fades from coarse to fine; more is smoother.
        stretch: How much longer than wide what is seen in it, along the rows.
    """
    fy, fx = np.fft.fftfreq(side)[:, None] * side, np.fft.rfftfreq(side)[None] * side
    size = np.hypot(fy, fx * stretch)
    size[0, 0] = 1.0
    strength = size**-slope
    strength[0, 0] = 0.0
    wave = strength * np.exp(2j * np.pi * chance.random(size.shape))
    picture = np.fft.irfft2(wave, (side, side))
    return picture / picture.std()


def _noise(chance: np.random.Generator) -> Array:
    soft = smooth_noise(chance, NOISE_SIDE, 1.7)
    # Creases: where two smooth fields cross zero, a ridge; long in one direction.
    ridged = np.zeros_like(soft)
    for stretch, share in ((2.2, 1.0), (3.2, 0.6)):
        field = smooth_noise(chance, NOISE_SIDE, 2.0, 1 / stretch)
        ridged += share * np.exp(-np.abs(field) * 2.2)
    ridged = ridged + 0.35 * smooth_noise(chance, NOISE_SIDE, 2.2)
    return np.stack([soft, (ridged - ridged.mean()) / ridged.std()]).astype(np.float32)


def _grid() -> tuple[Array, Array]:
    y, x = np.mgrid[0:SIDE, 0:SIDE]
    return x + 0.5, y + 0.5


def _around(x: Array, y: Array, cx: float, cy: float) -> tuple[Array, Array]:
    """Offsets from a point, the shortest way round."""
    return (x - cx + SIDE / 2) % SIDE - SIDE / 2, (y - cy + SIDE / 2) % SIDE - SIDE / 2


def _flowers(chance: np.random.Generator) -> Array:
    picture = np.zeros((SIDE, SIDE), np.uint8)
    x, y = _grid()
    size, petals = chance.uniform(7, 20), int(chance.integers(4, 8))
    for _ in range(int(2600 / size**1.45)):
        dx, dy = _around(x, y, *chance.uniform(0, SIDE, 2))
        grown = size * chance.uniform(0.55, 1.15)
        away, turn = np.hypot(dx, dy), np.arctan2(dy, dx) + chance.uniform(0, 7)
        leaf = (np.abs(np.sin(turn)) * away < 0.22 * grown) & (away < 1.6 * grown) & (np.cos(turn) > 0)
        petal = away < grown * (0.62 + 0.38 * np.abs(np.cos(turn * petals / 2)))
        picture[leaf] = 3
        picture[petal] = 1 if chance.random() < 0.65 else 2
        picture[away < 0.28 * grown] = 2 if chance.random() < 0.65 else 3
    return picture


def _leaves(chance: np.random.Generator) -> Array:
    picture = np.zeros((SIDE, SIDE), np.uint8)
    x, y = _grid()
    size = chance.uniform(14, 34)
    for _ in range(int(5200 / size**1.4)):
        dx, dy = _around(x, y, *chance.uniform(0, SIDE, 2))
        turn, grown = chance.uniform(0, 2 * np.pi), size * chance.uniform(0.6, 1.2)
        along, across = dx * np.cos(turn) + dy * np.sin(turn), dy * np.cos(turn) - dx * np.sin(turn)
        bend = across - 0.15 * along**2 / grown
        inside = np.abs(bend) < 0.3 * grown * (1 - np.clip(np.abs(along / grown), 0, 1) ** 2)
        picture[inside & (np.abs(along) < grown)] = int(chance.integers(1, 4))
        picture[inside & (np.abs(bend) < 0.035 * grown)] = 0
    return picture


def _blotches(chance: np.random.Generator) -> Array:
    """Camouflage, marble, water colours."""
    slope = chance.uniform(1.3, 2.3)
    field = smooth_noise(chance, SIDE, slope, float(chance.choice([1.0, 0.5, 2.0])))
    picture = np.zeros((SIDE, SIDE), np.uint8)
    picture[field > chance.uniform(0.0, 0.5)] = 1
    picture[smooth_noise(chance, SIDE, slope) > chance.uniform(0.6, 1.1)] = 2
    picture[smooth_noise(chance, SIDE, slope) > chance.uniform(0.9, 1.5)] = 3
    return picture


def _spots(chance: np.random.Generator) -> Array:
    """Leopard: rings that are not quite closed; or plain spots of different sizes."""
    picture = np.zeros((SIDE, SIDE), np.uint8)
    x, y = _grid()
    rings, size = chance.random() < 0.6, chance.uniform(4, 11)
    wave = smooth_noise(chance, SIDE, 1.6)
    for _ in range(int(3300 / size**1.6)):
        dx, dy = _around(x, y, *chance.uniform(0, SIDE, 2))
        grown = size * chance.uniform(0.6, 1.2)
        away = np.hypot(dx, dy * chance.uniform(0.7, 1.4)) + 0.16 * grown * wave
        picture[away < grown] = 1
        if rings:
            picture[away < 0.55 * grown] = 2
            open_to = chance.uniform(-np.pi, np.pi)
            gap = np.cos(np.arctan2(dy, dx) - open_to) > 0.8
            picture[gap & (away > 0.55 * grown) & (away < grown)] = 0
    return picture


def _shapes(chance: np.random.Generator) -> Array:
    """Stars, hearts, diamonds, triangles, crosses or waves in rows."""
    picture = np.zeros((SIDE, SIDE), np.uint8)
    x, y = _grid()
    kind, count = int(chance.integers(6)), int(chance.integers(2, 7))
    step = SIDE / count
    if kind == 5:
        wave = y + 0.25 * step * np.sin(2 * np.pi * x / step * max(1, count // 3))
        return ((wave / step * 2).astype(np.int64) % 4 * (np.abs(wave / step * 2 % 1) < 0.6)).astype(np.uint8)
    grown = step * chance.uniform(0.25, 0.42)
    shift = chance.random() < 0.6
    for row in range(count):
        for column in range(count):
            cx = (column + 0.5 + (0.5 if shift and row % 2 and count % 2 == 0 else 0)) * step
            dx, dy = _around(x, y, cx, (row + 0.5) * step)
            away, turn = np.hypot(dx, dy), np.arctan2(dy, dx)
            inside = (
                away < grown * (0.6 + 0.4 * np.cos(5 * turn)),
                (dx**2 + dy**2 - 0.4 * grown**2) ** 3 < -(dx**2) * dy**3 * grown * 1.1,
                np.abs(dx) + np.abs(dy) < grown,
                (dy < 0.5 * grown) & (np.abs(dx) * 1.6 < 0.5 * grown + dy * -1 + 0.5 * grown),
                (np.minimum(np.abs(dx), np.abs(dy)) < 0.25 * grown) & (away < grown),
            )[kind]
            picture[inside] = 1 + (row + column) % 2 * int(chance.random() < 0.5)
    return picture


def _bands() -> Array:
    """Bands of knitted figures, one above the other: diamonds, dots, snowflakes and zigzags, in stitches."""
    stitches = 32
    y, x = np.mgrid[0:stitches, 0:stitches]
    picture = np.zeros((stitches, stitches), np.uint8)
    picture[np.isin(y, (2, 10, 14, 26)) & (x % 2 == 0)] = 3
    from_middle = np.abs(x % 8 - 4), np.abs(y - 6)
    diamond = from_middle[0] + from_middle[1]
    band = np.abs(y - 6) <= 3
    picture[band & ((diamond == 3) | (diamond == 4))] = 1
    picture[band & (diamond <= 1)] = 2
    picture[(y == 12) & (x % 4 != 0)] = 3
    picture[np.isin(y, (11, 13)) & (x % 4 == 2)] = 3
    across, up = np.abs(x % 16 - 8), np.abs(y - 20)
    flake = (across <= 5) & (up <= 5)
    picture[flake & ((across == up) | (across * up == 0) | ((across + up == 5) & (across * up == 4)))] = 2
    picture[flake & (across + up == 1)] = 1
    picture[(across == 8) & (up <= 1)] = 1
    picture[(y == 28 + np.abs(x % 4 - 2)) | (y == 27 + np.abs(x % 4 - 2))] = 1
    return np.kron(picture, np.ones((SIDE // stitches, SIDE // stitches), np.uint8))


def _lettering(chance: np.random.Generator) -> Array:
    """Rows of strokes that look like letters from afar."""
    side = GRAPHIC_SIDE
    picture = np.zeros((side, side), np.uint8)
    rows = int(chance.integers(1, 4))
    tall = side / rows
    for row in range(rows):
        top, bottom = int((row + 0.12) * tall), int((row + 0.88) * tall)
        letters = int(chance.integers(3, 9))
        wide = side / letters
        stroke = max(1, int(wide * 0.22)), max(2, int((bottom - top) * 0.16))
        ink = 1 if chance.random() < 0.8 else 2
        for k in range(letters):
            left, right = int((k + 0.1) * wide), int((k + 0.86) * wide)
            parts = chance.random(6) < (0.85, 0.55, 0.6, 0.6, 0.6, 0.15)
            if parts[0]:
                picture[top:bottom, left : left + stroke[0]] = ink
            if parts[1]:
                picture[top:bottom, right - stroke[0] : right] = ink
            for bar, shown in zip(
                (top, (top + bottom - stroke[1]) // 2, bottom - stroke[1]), parts[2:5], strict=True
            ):
                if shown:
                    picture[bar : bar + stroke[1], left:right] = ink
            if parts[5]:
                for step in range(bottom - top):
                    at = left + (right - left - stroke[0]) * step // (bottom - top)
                    picture[top + step, at : at + stroke[0]] = ink
    return picture


def _badge(chance: np.random.Generator) -> Array:
    """A disc, shield, star or bar, with something on it."""
    side = GRAPHIC_SIDE
    y, x = (np.mgrid[0:side, 0:side] + 0.5 - side / 2) / (side / 2)
    away, turn = np.hypot(x, y), np.arctan2(y, x)
    points = int(chance.integers(3, 9))
    shapes = (
        away < 0.92,
        (np.abs(x) < 0.8) & (np.abs(y) < 0.9 - 0.5 * np.clip(np.abs(x) + y - 0.4, 0, 1)),
        away < 0.6 + 0.32 * np.cos(points * turn),
        (np.abs(x) < 0.95) & (np.abs(y) < chance.uniform(0.2, 0.6)),
    )
    picture = np.zeros((side, side), np.uint8)
    outer = shapes[int(chance.integers(len(shapes)))]
    picture[outer] = 1
    inner = int(chance.integers(4))
    if inner == 0:
        picture[outer & (away > 0.6) & (away < 0.75)] = 2
    elif inner == 1:
        picture[outer & ((y * 6).astype(np.int64) % 2 == 0)] = 2
    elif inner == 2:
        picture[outer & (away < 0.45 + 0.15 * np.cos(points * turn))] = 2
    else:
        letters = _lettering(chance)
        small = letters[::2, ::2]
        middle = side // 4
        part = picture[middle : middle + side // 2, middle : middle + side // 2]
        part[small > 0] = 2
    return picture


def _picture(chance: np.random.Generator) -> Array:
    """A block like a photograph or a drawing."""
    field = smooth_noise(chance, GRAPHIC_SIDE, chance.uniform(1.2, 2.0))
    picture = np.where(field > 0.5, 2, np.where(field > -0.4, 1, 0)).astype(np.uint8)
    if chance.random() < 0.6:
        y, x = np.mgrid[0:GRAPHIC_SIDE, 0:GRAPHIC_SIDE] / (GRAPHIC_SIDE - 1) * 2 - 1
        away = np.hypot(x, y) if chance.random() < 0.5 else np.maximum(np.abs(x), np.abs(y)) * 1.05
        picture[away > 0.95] = 0
        picture[(away > 0.85) & (away < 0.95)] = 1
    return picture

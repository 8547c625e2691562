"""Compiled loops of prints: what colour cloth has at a point, and how folds tilt it."""

from __future__ import annotations

import math

import numpy as np
from numba import njit

from swifttailor.render import cloth_table as _at
from swifttailor.render import motifs as _motifs
from swifttailor.render.compile_options import FAST
from swifttailor.render.ramps import NAMED_SIDE, RAMP
from swifttailor.render.raster_kernels import NOTHING, weigh

_SOFT_CM = 0.12
"""Over this much cloth one colour goes over into the next."""
_THREAD_CM = 0.35
_U64 = np.uint64
# Numbers of a row by short names, since the compiler takes plain globals only.
_COLORS, _SIZES, _WEAVE, _HOLE, _FOLDS = _at.COLORS, _at.SIZES, _at.WEAVE, _at.HOLE_COLOR, _at.FOLDS
_WEAR, _GRAPHIC, _INKS, _BLOCK, _FADE = _at.WEAR, _at.GRAPHIC, _at.GRAPHIC_COLORS, _at.BLOCK, _at.FADE
_MARKS, _MARK, _BLUR = _at.MARKS, _at.MARK, _at.BLUR
BANDS, CREASES, MOTIFS, GRAPHICS = _motifs.BANDS, _motifs.CREASES, _motifs.MOTIFS, _motifs.GRAPHICS
FIRST_MOTIF, FIRST_GRAPHIC, GRAPHIC_SIDE = _motifs.FIRST_MOTIF, _motifs.FIRST_GRAPHIC, _motifs.GRAPHIC_SIDE
NOISE_SIDE, NOISE_STEPS, SIDE, SOFT = _motifs.NOISE_SIDE, _motifs.NOISE_STEPS, _motifs.SIDE, _motifs.SOFT


@njit(**FAST)
def _hash(n, seed):
    """A value from -0.5 to 0.5 that looks random and depends on whole numbers alone."""
    mixed = (_U64(n) + _U64(seed * 1_000_003 + 12_345)) * _U64(0x9E3779B97F4A7C15)
    mixed ^= mixed >> _U64(29)
    mixed *= _U64(0xBF58476D1CE4E5B9)
    return np.float64(mixed >> _U64(40)) / 2.0**24 - 0.5


@njit(**FAST)
def _noise(bank, first, u, v):
    """Noise that begins at `first` in the bank, at cells u and v, between its cells linearly."""
    fu, fv = math.floor(u), math.floor(v)
    s, t = u - fu, v - fv
    i, j = int(fu) & (NOISE_SIDE - 1), int(fv) & (NOISE_SIDE - 1)
    k, m = (i + 1) & (NOISE_SIDE - 1), (j + 1) & (NOISE_SIDE - 1)
    upper, lower = first + j * NOISE_SIDE, first + m * NOISE_SIDE
    above = bank[upper + i] + s * (bank[upper + k] - bank[upper + i])
    below = bank[lower + i] + s * (bank[lower + k] - bank[lower + i])
    return (above + t * (below - above)) / NOISE_STEPS


@njit(**FAST)
def _cell(bank, first, side, u, v):
    """What a picture of the bank, repeated over the plane, has at u and v, each 0 to 1."""
    i, j = int(np.floor(u * side)) & (side - 1), int(np.floor(v * side)) & (side - 1)
    return int(bank[first + j * side + i])


@njit(**FAST)
def _named(bank, u, v, table):
    """Red, green and blue of the picture that ends the bank at u and v, each 0 to 1; linear between cells."""
    first, x, y = len(bank) - NAMED_SIDE * NAMED_SIDE, u * NAMED_SIDE - 0.5, v * NAMED_SIDE - 0.5
    fx, fy = math.floor(x), math.floor(y)
    s, t = x - fx, y - fy
    left, lower = int(fx) & (NAMED_SIDE - 1), first + (int(fy) & (NAMED_SIDE - 1)) * NAMED_SIDE
    right, upper = (left + 1) & (NAMED_SIDE - 1), first + ((int(fy) + 1) & (NAMED_SIDE - 1)) * NAMED_SIDE
    near = bank[lower + left]
    if near == bank[lower + right] and near == bank[upper + left] and near == bank[upper + right]:
        s = t = 0.0  # most of a figured print: one cell tells all
    r = g = b = 0.0
    for n in range(4):
        share = (s if n & 1 else 1.0 - s) * (t if n >> 1 else 1.0 - t)
        if share == 0.0:
            continue
        step = int(bank[(upper if n >> 1 else lower) + (right if n & 1 else left)])
        low, part = _COLORS + 3 * ((step // RAMP) % 6), (step % RAMP) / RAMP
        high = low + 3 if low < _COLORS + 15 else _COLORS
        r += share * (table[low] + part * (table[high] - table[low]))
        g += share * (table[low + 1] + part * (table[high + 1] - table[low + 1]))
        b += share * (table[low + 2] + part * (table[high + 2] - table[low + 2]))
    return r, g, b


@njit(**FAST)
def _covered(x, width, period):
    """How much of the line from somewhere left of all bands to x lies in bands, less a constant."""
    n = np.floor(x / period + 0.5)
    return n * width + min(max(x - n * period + width / 2, 0.0), width)


@njit(**FAST)
def _band(x, width, gap, blur):
    """Share of a band at x: 1 inside bands, 0 between; the mean over `blur` cm where that is more."""
    period = width + gap
    if blur > _SOFT_CM:
        return (_covered(x + blur / 2, width, period) - _covered(x - blur / 2, width, period)) / blur
    from_middle = abs(x - period * np.rint(x / period))
    return min(max((width / 2 - from_middle) / _SOFT_CM + 0.5, 0.0), 1.0)


@njit(**FAST)
def _relief(u, v, table):
    """Height of a weave, 0 to 1, 0 in its grooves."""
    kind, period = int(table[_WEAVE]), table[_WEAVE + 1]
    x, y = u / period, v / period
    if kind == 1 or kind == 8:  # rib, cord
        return 0.5 + 0.5 * math.cos(2 * math.pi * x)
    if kind == 2:  # jersey: small arrows
        return 0.5 + 0.5 * math.cos(2 * math.pi * x) * math.cos(2 * math.pi * (y + 0.5 * abs(x - np.rint(x))))
    if kind == 3:  # cable: two strands that cross, ribs between
        across = x - np.rint(x)
        if abs(across) < 0.28:
            strand = 0.15 * math.sin(2 * math.pi * y * 0.7)
            return max(1.0 - abs(across - strand) * 9, 1.0 - abs(across + strand) * 9, 0.0)
        return 0.5 + 0.4 * math.cos(8 * math.pi * x)
    if kind == 4:  # twill
        return 0.5 + 0.5 * math.cos(2 * math.pi * (x + y))
    if kind == 6:  # quilt: cushions in diamonds
        return math.sqrt(abs(math.sin(math.pi * (x + y)) * math.sin(math.pi * (x - y))))
    return 1.0


@njit(**FAST)
def _height(u, v, table, bank):
    """Height of folds and weave, in a unit that makes their slopes those of the row."""
    size, along = table[_FOLDS + 1], table[_FOLDS + 2]
    cells = 12.0
    i, j = u / size * cells + table[_FOLDS + 3], v / (size * along) * cells + table[_FOLDS + 4]
    height = table[_FOLDS] * size * _noise(bank, CREASES, i, j)
    if table[_WEAVE] > 0.0 and table[_WEAVE + 3] > 0.0:
        height += table[_WEAVE + 3] * table[_WEAVE + 1] / math.pi * _relief(u, v, table)
    return height


@njit(**FAST)
def _share(table, n, x, y, u, v):
    """How much of a point the mark that begins at number n covers."""
    kind = int(table[n])
    dx, dy, half, tall = x - table[n + 1], y - table[n + 2], table[n + 3] / 2, table[n + 4] / 2
    if abs(dx) > half + 0.5 or abs(dy) > tall + 0.5:
        return 0.0
    if kind == 0:
        return 0.75 if abs(dx) <= half and abs(dy) <= tall else 0.0
    if kind == 1:
        up = dy - table[n + 5] * np.rint(dy / table[n + 5])
        return min(max((half - math.hypot(dx, up)) * 4 + 0.5, 0.0), 1.0)
    edge = max(abs(dx) - half, abs(dy) - tall)
    if kind == 3 and (int(np.floor((u + v) * 2.5)) & 1):
        return 0.0
    return 0.6 if abs(edge) < 0.25 else 0.0


@njit(**FAST)
def color_at(u, v, x, y, z, table, layers, bank, out):
    """Linear colour (3,) of cloth at its point u, v, which lies at x, y, z of the standing body, cm."""
    # Colours are put over each other one by one: by number in the row, and how much of the point they cover.
    kind, color, share = int(table[0]), _COLORS, 1.0
    i, j = table[3] * u + table[4] * v, table[3] * v - table[4] * u
    a, b, c = table[_SIZES], table[_SIZES + 1], table[_SIZES + 2]
    blur = table[_BLUR]
    r, g, bl = np.float64(table[_COLORS]), np.float64(table[_COLORS + 1]), np.float64(table[_COLORS + 2])
    for layer in range(8 + int(table[_MARKS])):
        if not (layers >> layer) & 1:
            continue
        share = 0.0
        if layer == 0:
            color = _COLORS + 3
            if kind == 2:
                share = 1.0 - _band(j, a, b, blur)
            elif kind == 3:
                share = 1.0 - (_band(i, a, a, blur) + _band(j, a, a, blur)) / 2
            elif kind == 4:
                rise = a * 0.8660254
                row = np.rint(j / rise)
                across = i - 0.5 * a * (int(row) & 1)
                away = math.hypot(across - a * np.rint(across / a), j - rise * row)
                share = min(max((b - away) / _SOFT_CM + 0.5, 0.0), 1.0)
            elif kind == 5:
                share = (_band(i, a * b, a - a * b, blur) + _band(j, a * b, a - a * b, blur)) / 2
            elif kind == 6:
                number = int(a)
                if number > BANDS:
                    r, g, bl = _named(bank, i / b, j / b, table)
                else:
                    first = FIRST_MOTIF + (number if number == BANDS else number % MOTIFS) * SIDE * SIDE
                    color, share = _COLORS + 3 * _cell(bank, first, SIDE, i / b, j / b), 1.0
        elif layer == 1:
            if kind == 5:
                thin = a * c
                line = _band(i + a / 2, thin, a - thin, blur)
                line = max(line, _band(j + a / 2, thin, a - thin, blur))
                color, share = _COLORS + 6, 0.8 * line
        elif layer == 2:
            if table[_FADE] > 0.0:
                color = _FADE + 4
                share = (table[_FADE + 1] - y) / (table[_FADE + 1] - table[_FADE + 2])
                share += table[_FADE + 3] * _noise(bank, SOFT, u * 2.0, v * 2.0)
        elif layer == 3:
            block, at = int(table[_BLOCK]), table[_BLOCK + 1]
            color = _BLOCK + 3
            if (
                (block == 1 and y < at)
                or (block == 2 and y > at)
                or (block == 3 and x > at)
                or (block == 4 and abs(x) < at)
                or (block == 5 and abs(x) > at)
                or (block == 6 and y < at and y > table[_BLOCK + 2])
            ):
                share = 1.0
        elif layer == 4:
            if table[_WEAR] > 0.0:
                scale = 40.0 / table[_WEAR + 1]
                worn = 0.35 * _noise(bank, SOFT, u * scale, v * scale)
                thigh, knee = (abs(x) - 10.0) / 5.0, (y - 62.0) / 16.0
                worn += 1.1 * math.exp(-knee * knee - thigh * thigh)
                worn += 0.13 * _noise(bank, CREASES, u * 9.0, v * 9.0)
                color, share = _WEAR + 2, min(table[_WEAR] * worn, 0.8)
        elif layer == 5:
            side = table[_GRAPHIC + 5]
            if table[_GRAPHIC] >= 0.0 and (z - table[_GRAPHIC + 6]) * side > 0.0:
                du = (x - table[_GRAPHIC + 1]) * side / table[_GRAPHIC + 3] + 0.5
                dv = 0.5 - (y - table[_GRAPHIC + 2]) / table[_GRAPHIC + 4]
                if 0.0 <= du < 1.0 and 0.0 <= dv < 1.0:
                    first = FIRST_GRAPHIC + (int(table[_GRAPHIC]) % GRAPHICS) * GRAPHIC_SIDE * GRAPHIC_SIDE
                    ink = _cell(bank, first, GRAPHIC_SIDE, du, dv)
                    color, share = _INKS + 3 * max(ink - 1, 0), 0.93 if ink else 0.0
        elif layer == 6:
            factor = 1.0
            if table[1] > 0.0:
                seed = int(table[2])
                threads, rows = int(np.floor(u / _THREAD_CM)), int(np.floor(v / _THREAD_CM))
                factor += table[1] * (_hash(threads, 2 * seed) + _hash(rows, 2 * seed + 1))
            if table[_WEAVE] > 0.0:
                factor *= 1.0 - table[_WEAVE + 2] * (1.0 - _relief(u, v, table))
            r, g, bl = r * factor, g * factor, bl * factor
        elif layer == 7:
            hole = table[_WEAVE + 4]
            if table[_WEAVE] > 0.0 and hole > 0.0:
                period = table[_WEAVE + 1]
                if int(table[_WEAVE]) == 7:  # lace: a net between flowers
                    first = FIRST_MOTIF + 5 * (int(table[2]) % (MOTIFS // 5)) * SIDE * SIDE
                    if _cell(bank, first, SIDE, u / (12 * period), v / (12 * period)) > 0:
                        hole *= 0.12
                du, dv = u / period - np.rint(u / period), v / period - np.rint(v / period)
                color = _HOLE
                share = 0.9 * min((math.sqrt(hole / math.pi) - math.hypot(du, dv)) * 12 + 0.5, 1.0)
        else:
            n = _MARKS + 1 + _MARK * (layer - 8)
            color = n + 7
            if (z - table[_GRAPHIC + 6]) * table[n + 6] > 0.0:
                share = _share(table, n, x, y, u, v)
        if share > 0.0:
            share = min(share, 1.0)
            r += share * (table[color] - r)
            g += share * (table[color + 1] - g)
            bl += share * (table[color + 2] - bl)
    out[0], out[1], out[2] = r, g, bl


@njit(**FAST)
def color_points(points, table, layers, bank, colors):
    """Fills colours (n, 3) float32 at points (n, 5) float64: u, v, x, y, z of `color_at`."""
    color = np.zeros(3, np.float32)
    for n in range(len(points)):
        u, v, x, y, z = points[n, 0], points[n, 1], points[n, 2], points[n, 3], points[n, 4]
        color_at(u, v, x, y, z, table, layers, bank, color)
        for k in range(3):
            colors[n, k] = color[k]


@njit(**FAST)
def paint_samples(
    keys,
    front,
    points,
    faces,
    perspective,
    vertices,
    rest,
    part,
    print_at,
    table,
    layers,
    bank,
    paint,
    bumps,
    samples,
    few,
):
    """Fills what a print shows at the samples of its surface's right side.

    Args:
        keys: (H, W) int64, see `raster_kernels.fill`.
        front: (m,), see there.
        points: (n, 3), see `scene.Projection`.
        faces: (m, 3) int32.
        perspective: Whether near things look larger.
        vertices: (n, 3) in the world, cm.
        rest: (k, 3) of the surface's own vertices, see `Surface.rest`.
        part: Three numbers: the surface's first vertex, its first face and the face after its last.
        print_at: (f, 3, 2) float32, see `Surface.print_at`.
        table: See `cloth_table`.
        layers: See there.
        bank: See `prints.bank_of`.
        paint: (H, W, 3) float32 linear colours; of kind `COORDINATES` u, v and 1 or, on the wrong side, -1.
        bumps: (H, W, 3) float32 by which folds tilt unit normals; or (0, 0, 3).
        samples: Along each side of a pixel.
        few: Whether a pixel of 2 x 2 samples that shows only this side is looked at along its diagonal alone.
    """
    height, width = keys.shape[0] // samples, keys.shape[1] // samples
    before, first, last = part[0], part[1], part[2]
    folded = table[_FOLDS] > 0.0 and len(bumps) > 0
    color = np.zeros(3, np.float32)
    few = few and samples == 2 and table[0] != 0.0
    for row in range(height * samples):
        for column in range(width * samples):
            key = keys[row, column]
            t = np.int32(key)
            if key == NOTHING or t < first or t >= last:
                continue
            halved = False
            if few and front[t]:
                # The other samples of the pixel; of these, those on its diagonal stand for all.
                halved = True
                for n in range(1, 4):
                    key = keys[row ^ (n & 1), column ^ (n >> 1)]
                    other = np.int32(key)
                    if key == NOTHING or other < first or other >= last or not front[other]:
                        halved = False
                if halved and (row ^ column) & 1:
                    continue
            if not front[t]:
                if table[0] == 0.0:
                    paint[row, column, 2] = -1.0
                continue
            w0, w1, w2 = weigh(t, column + 0.5, row + 0.5, points, faces, perspective)
            f = t - first
            u = w0 * print_at[f, 0, 0] + w1 * print_at[f, 1, 0] + w2 * print_at[f, 2, 0]
            v = w0 * print_at[f, 0, 1] + w1 * print_at[f, 1, 1] + w2 * print_at[f, 2, 1]
            if table[0] == 0.0:
                paint[row, column, 0], paint[row, column, 1], paint[row, column, 2] = u, v, 1.0
                continue
            a, b, c = faces[t, 0], faces[t, 1], faces[t, 2]
            ra, rb, rc = a - before, b - before, c - before
            x = w0 * rest[ra, 0] + w1 * rest[rb, 0] + w2 * rest[rc, 0]
            y = w0 * rest[ra, 1] + w1 * rest[rb, 1] + w2 * rest[rc, 1]
            z = w0 * rest[ra, 2] + w1 * rest[rb, 2] + w2 * rest[rc, 2]
            color_at(u, v, x, y, z, table, layers, bank, color)
            for k in range(3):
                paint[row, column, k] = color[k]
                if halved:
                    paint[row, column ^ 1, k] = color[k]
            if not folded or (halved and not row & 1):
                continue
            # The gradient of the height over the surface, from those of u and v over the triangle.
            u1, v1 = print_at[f, 1, 0] - print_at[f, 0, 0], print_at[f, 1, 1] - print_at[f, 0, 1]
            u2, v2 = print_at[f, 2, 0] - print_at[f, 0, 0], print_at[f, 2, 1] - print_at[f, 0, 1]
            area = u1 * v2 - u2 * v1
            inverse = 1.0 / area if abs(area) > 1e-6 else 0.0
            # Differences at three points, by a loop so that the compiler sees the height once.
            here = there = hu = 0.0
            for n in range(3):
                height_n = _height(u + (0.08 if n == 1 else 0.0), v + (0.08 if n == 2 else 0.0), table, bank)
                if n == 0:
                    here = height_n
                elif n == 1:
                    hu = height_n - here
                else:
                    there = height_n - here
            hu, hv = hu * 12.5 * inverse, there * 12.5 * inverse
            for k in range(3):
                e1, e2 = vertices[b, k] - vertices[a, k], vertices[c, k] - vertices[a, k]
                bumps[row, column, k] = -(hu * (e1 * v2 - e2 * v1) + hv * (e2 * u1 - e1 * u2))


@njit(**FAST)
def add_shares(keys, surface, samples, shares, face):
    """Counts which surface the samples of each pixel show, and notes the triangle at its middle.

    Args:
        keys: (H, W) int64, see `raster_kernels.fill`.
        surface: (m,) int16 of each face.
        samples: Along each side of a pixel.
        shares: (h, w, surfaces) float32, zeros before.
        face: (h, w) int32, -1 before.
    """
    height, width = face.shape
    share = np.float32(1) / np.float32(samples * samples)
    middle = samples // 2
    for j in range(height):
        for i in range(width):
            for dj in range(samples):
                for di in range(samples):
                    key = keys[j * samples + dj, i * samples + di]
                    if key != NOTHING:
                        shares[j, i, surface[np.int32(key)]] += share
                        if dj == middle and di == middle:
                            face[j, i] = np.int32(key)

"""The renderer in plain numpy, to hold the compiled one against: the same picture, several times slower."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from plain_projection import Projection, triangles
from scipy.ndimage import gaussian_filter, map_coordinates

from swifttailor.arrays import Array
from swifttailor.render.camera import Camera
from swifttailor.render.lighting import STUDIO, Light, Lighting
from swifttailor.render.scene import Scene
from swifttailor.render.surface import LineSet

_BLOCK = 1 << 15
CHUNK = 1 << 20
"""Fragments worked on at once: what fits the caches, and bounds the memory."""
_DEPTH_STEPS = float(2**31 - 1)
_NOTHING = np.iinfo(np.int64).max


def rasterize(corners: Array, size: tuple[int, int]) -> Array:
    """Finds the nearest triangle at every pixel centre.

    Args:
        corners: (m, 3, 3) triangle corners: x right and y down in pixels, and a depth that is affine over the
            picture, larger farther away. Must be finite.
        size: Width and height in pixels.

    Returns:
        (height, width) int32 triangle indices, -1 where there is none. Of two triangles at the same depth
        the one listed first wins.
    """
    width, height = size
    nearest = np.full(width * height, _NOTHING)
    if len(corners):
        depth = _Depth(corners)
        rows = _rows(corners, width, height)
        for start, stop in _chunks(rows.count):
            _fill(nearest, rows.part(start, stop), depth, width)
    seen = nearest != _NOTHING
    return np.where(seen, nearest & 0xFFFFFFFF, -1).astype(np.int32).reshape(height, width)


def barycentric(corners: Array) -> Array:
    """Coefficients (m, 2, 3) c with weight_k = c[k, 0] x + c[k, 1] y + c[k, 2] of corners 1 and 2.

    Corner 0 has what remains to 1. Triangles without area get zeros, and so their corner 0 throughout.
    """
    x, y = corners[:, :, 0], corners[:, :, 1]
    x1, y1, x2, y2 = x[:, 1] - x[:, 0], y[:, 1] - y[:, 0], x[:, 2] - x[:, 0], y[:, 2] - y[:, 0]
    area = x1 * y2 - x2 * y1
    inverse = np.divide(1.0, area, out=np.zeros_like(area), where=np.abs(area) > 1e-12)
    first = np.stack([y2 * inverse, -x2 * inverse], axis=1)
    second = np.stack([-y1 * inverse, x1 * inverse], axis=1)
    slopes = np.stack([first, second], axis=1)
    constant = -(slopes[:, :, 0] * x[:, :1] + slopes[:, :, 1] * y[:, :1])
    return np.concatenate([slopes, constant[:, :, None]], axis=2)


def depth_at(corners: Array, face: Array, *, fill: float) -> Array:
    """Depth (height, width) of the triangles (m, 3, 3) that `rasterize` found; `fill` where none is."""
    depth = np.full(face.shape, fill)
    rows, columns = np.nonzero(face >= 0)
    seen = face[rows, columns]
    w = barycentric(corners)[seen]
    first = w[:, 0, 0] * (columns + 0.5) + w[:, 0, 1] * (rows + 0.5) + w[:, 0, 2]
    second = w[:, 1, 0] * (columns + 0.5) + w[:, 1, 1] * (rows + 0.5) + w[:, 1, 2]
    z = corners[seen, :, 2]
    value = z[:, 0] + first * (z[:, 1] - z[:, 0]) + second * (z[:, 2] - z[:, 0])
    depth[rows, columns] = np.clip(value, z.min(axis=1), z.max(axis=1))
    return depth


class _Rows:
    """Runs of pixels: one triangle on one row of the picture."""

    def __init__(self, triangle: Array, row: Array, first: Array, count: Array) -> None:
        self.triangle, self.row, self.first, self.count = triangle, row, first, count

    def part(self, start: int, stop: int) -> _Rows:
        s = slice(start, stop)
        return _Rows(self.triangle[s], self.row[s], self.first[s], self.count[s])


def _rows(corners: Array, width: int, height: int) -> _Rows:
    order = np.argsort(corners[:, :, 1], axis=1, kind="stable")
    x = np.take_along_axis(corners[:, :, 0], order, axis=1)
    y = np.take_along_axis(corners[:, :, 1], order, axis=1)
    # Row r has its pixel centres at r + 0.5 and is covered when y_min <= r + 0.5 < y_max.
    top = np.clip(np.ceil(y[:, 0] - 0.5), 0, height).astype(np.int64)
    bottom = np.clip(np.ceil(y[:, 2] - 0.5), 0, height).astype(np.int64)
    across = (x.max(axis=1) > 0.0) & (x.min(axis=1) < width)
    counts = np.where(across, bottom - top, 0)
    triangle = np.repeat(np.arange(len(corners)), counts)
    row = np.arange(len(triangle)) - np.repeat(np.cumsum(counts) - counts - top, counts)
    center = row + 0.5

    def slope(a: int, b: int) -> Array:
        rise = y[:, b] - y[:, a]
        return np.divide(x[:, b] - x[:, a], rise, out=np.zeros_like(rise), where=rise > 0.0)

    def crossing(a: int, b: int) -> Array:
        # Each edge runs from its upper to its lower end in every triangle that has it: equal bits.
        return x[triangle, a] + (center - y[triangle, a]) * slope(a, b)[triangle]

    long_side = crossing(0, 2)
    short_side = np.where(center < y[triangle, 1], crossing(0, 1), crossing(1, 2))
    left = np.ceil(np.minimum(long_side, short_side) - 0.5)
    right = np.ceil(np.maximum(long_side, short_side) - 0.5)
    first = np.clip(left, 0, width).astype(np.int64)
    count = np.clip(right, 0, width).astype(np.int64) - first
    keep = count > 0
    return _Rows(triangle[keep], row[keep], first[keep], count[keep])


def _chunks(counts: Array) -> list[tuple[int, int]]:
    """Ranges of rows with about `CHUNK` fragments each."""
    total = np.cumsum(counts)
    if not len(total):
        return []
    cuts = np.searchsorted(total, np.arange(CHUNK, total[-1], CHUNK), side="left") + 1
    bounds = np.unique(np.concatenate([[0], cuts, [len(counts)]]))
    return [(int(a), int(b)) for a, b in pairwise(bounds)]


def _fill(nearest: Array, rows: _Rows, depth: _Depth, width: int) -> None:
    """Lowers the depth keys of the pixels that the rows cover."""
    triangle, count = rows.triangle, rows.count
    slope, down, constant = depth.plane[triangle].T
    start = slope * (rows.first + 0.5) + down * (rows.row + 0.5) + constant
    ends = np.cumsum(count)
    along = np.arange(ends[-1]) - np.repeat(ends - count, count)
    z = np.repeat(start, count) + along * np.repeat(slope, count)
    # The plane of a sliver can leave the range of its corners within the row; hold it between them.
    z = np.clip(z, np.repeat(depth.low[triangle], count), np.repeat(depth.high[triangle], count))
    key = (z.astype(np.int64) << 32) | np.repeat(triangle, count)
    np.minimum.at(nearest, np.repeat(rows.row * width + rows.first, count) + along, key)


class _Depth:
    """Depth in whole steps as a plane over the picture, one for each triangle."""

    def __init__(self, corners: Array) -> None:
        z = corners[:, :, 2]
        z = (z - z.min()) * (_DEPTH_STEPS / max(float(np.ptp(z)), 1e-12))
        change = z[:, 1:] - z[:, :1]
        weights = barycentric(corners)
        self.plane = change[:, :1] * weights[:, 0] + change[:, 1:] * weights[:, 1]
        self.plane[:, 2] += z[:, 0]
        self.low = np.minimum(np.minimum(z[:, 0], z[:, 1]), z[:, 2])
        self.high = np.maximum(np.maximum(z[:, 0], z[:, 1]), z[:, 2])


@dataclass(frozen=True)
class Samples:
    """The visible points to be lit, n of them; float32 throughout."""

    normal: Array
    """(n, 3) unit normals turned towards the camera, in the camera's frame."""
    up: Array
    """(n,) the normal's upward part in the world."""
    facing: Array
    """(n,) cosine between the normal and the sight line, 0 to 1."""
    color: Array
    """(n, 3) linear colour of the surface."""
    sheen: Array
    """(n,) see `Surface.sheen`."""
    gloss: Array
    """(n,) see `Surface.gloss`."""
    shadow: Array
    """(n,) share of the key light that arrives."""
    open_sky: Array
    """(n,) share of the room's light that arrives."""


def shade(samples: Samples, lighting: Lighting = STUDIO) -> Array:
    """Linear-light colour (n, 3) of the samples."""
    key = _diffuse(samples.normal, lighting.key) * samples.shadow
    fill = _diffuse(samples.normal, lighting.fill) * samples.open_sky
    edge = (1.0 - samples.facing) ** 2
    rim = _diffuse(samples.normal, lighting.rim) * edge * samples.open_sky
    sky = (0.5 + 0.5 * samples.up) * samples.open_sky
    half = lighting.key.unit() + np.array([0.0, 0.0, 1.0])
    half = (half / max(float(np.linalg.norm(half)), 1e-6)).astype(np.float32)
    highlight = np.maximum(samples.normal @ half, 0.0) ** 24 * samples.gloss * samples.shadow
    sheen = edge * (1.0 - samples.facing) * samples.sheen * samples.open_sky
    lit = np.zeros_like(samples.color)
    for k in range(3):
        sky_part, ground = np.float32(lighting.sky[k] - lighting.ground[k]), np.float32(lighting.ground[k])
        light = key * np.float32(lighting.key.color[k]) + fill * np.float32(lighting.fill.color[k])
        light += sky * sky_part + samples.open_sky * ground
        lit[:, k] = samples.color[:, k] * light + rim * np.float32(lighting.rim.color[k]) * (
            0.35 + 0.65 * samples.color[:, k]
        )
        lit[:, k] += highlight + sheen * (0.3 + 0.7 * samples.color[:, k])
    return lit


def _diffuse(normal: Array, light: Light) -> Array:
    wrap = np.float32(light.wrap)
    return np.maximum((normal @ light.unit().astype(np.float32) + wrap) / (1 + wrap), 0.0)


_SCALES = ((1.1, 1.4, 0.50), (4.5, 6.0, 0.45))
"""Neighbourhood cm, depth in cm at which it is darkest, and how dark: for folds; for arms, hems and chin."""
_DARKEST = 0.3


def open_sky(depth: Array, covered: Array, pixels_per_cm: float) -> Array:
    """Share (h, w) of the room's light that reaches each pixel; see `swifttailor.render.open_sky`."""
    weight = covered.astype(float)
    value = np.where(covered, depth, 0).astype(float)
    dark = np.zeros_like(value)
    for radius, reach, strength in _SCALES:
        sigma = radius * pixels_per_cm
        if sigma < 0.4:
            continue
        step = max(1, int(sigma / 1.8))
        mean = _blur(value, sigma, step) / np.maximum(_blur(weight, sigma, step), 1e-6)
        dark += strength * np.clip((value - mean) / reach, 0, 1)
    return np.where(covered, np.maximum(1 - dark, _DARKEST), 1.0).astype(np.float32)


def _blur(picture: Array, sigma: float, step: int) -> Array:
    """Gaussian blur of sums over blocks of pixels, with nothing beyond the border, then between blocks."""
    height, width = picture.shape
    sums = np.add.reduceat(np.add.reduceat(picture, np.arange(0, height, step)), np.arange(0, width, step), 1)
    reach = int(2.5 * sigma / step + 0.5)
    wide = gaussian_filter(sums, sigma / step, mode="constant", radius=reach)
    at = [
        np.clip((np.arange(n) + 0.5) / step - 0.5, 0, m - 1)
        for n, m in zip(picture.shape, sums.shape, strict=True)
    ]
    return map_coordinates(wide, np.meshgrid(*at, indexing="ij"), order=1, mode="nearest")


def box_mean(picture: Array, step: int) -> Array:
    """Means of (h, w, ...) over blocks of `step` by `step`, which must fit; faster than a reduction."""
    total = np.zeros((picture.shape[0] // step, picture.shape[1] // step, *picture.shape[2:]), np.float32)
    for j in range(step):
        for i in range(step):
            total += picture[j::step, i::step]
    return total / np.float32(step * step)


_CELL = 0.6
"""Size of a cell, cm; grown for wide scenes."""
_MAX_CELLS = 450
_BIAS = 0.5
"""Distance behind the occluder at which shadow begins, cm."""
_FADE = 1.2
"""Distance over which it then becomes full, cm."""
_OFFSET = 0.7
"""Receivers are taken this far out along their normal, so that they do not shade themselves, cm."""


class ShadowMap:
    """The distance of what a distant light sees of a scene."""

    def __init__(self, triangles: Array, towards_light: Array) -> None:
        """Looks at world triangles (m, 3, 3), cm, from the unit direction `towards_light` (3,)."""
        self._axes = _axes_towards(towards_light).astype(np.float32)
        corners = triangles.reshape(-1, 3) @ self._axes.T
        low, high = corners[:, :2].min(axis=0), corners[:, :2].max(axis=0)
        self._cell = max(_CELL, float((high - low).max()) / _MAX_CELLS)
        self._low = low - 3 * self._cell
        width, height = (int(n) for n in np.ceil((high - low) / self._cell) + 6)
        corners[:, :2] = (corners[:, :2] - self._low) / self._cell
        corners[:, 2] *= -1.0
        corners = corners.reshape(-1, 3, 3)
        self._depth = depth_at(corners, rasterize(corners, (width, height)), fill=1e9).astype(np.float32)

    def light(self, points: Array, normals: Array) -> Array:
        """Share (n,) of the key light, 0 to 1, that arrives at world points with normals, both (n, 3), cm."""
        seen = (points + np.float32(_OFFSET) * normals).astype(np.float32) @ self._axes.T
        rows, columns = self._depth.shape
        x = np.clip((seen[:, 0] - self._low[0]) / self._cell - 0.5, 1.0, columns - 2.001)
        y = np.clip((seen[:, 1] - self._low[1]) / self._cell - 0.5, 1.0, rows - 2.001)
        i, j = x.astype(np.int32), y.astype(np.int32)
        # Sixteen comparisons around the point, weighted so that the sum changes smoothly between cells.
        across, down = _tent(x - i), _tent(y - j)
        limit = (-seen[:, 2] - np.float32(_BIAS)) / np.float32(_FADE)
        depth = (self._depth / np.float32(_FADE)).ravel()
        corner = (j - 1) * columns + (i - 1)
        arriving = np.zeros(len(points), np.float32)
        for row in range(4):
            line = np.zeros(len(points), np.float32)
            for column in range(4):
                ahead = depth[corner + (row * columns + column)] - limit
                line += across[column] * np.clip(1.0 + ahead, 0.0, 1.0)
            arriving += down[row] * line
        return arriving


def _tent(fraction: Array) -> list[Array]:
    """Weights of four neighbouring cells for a box of width 3 at `fraction` between the middle two."""
    third = np.float32(1 / 3)
    return [
        (1 - fraction) * third,
        np.full_like(fraction, third),
        np.full_like(fraction, third),
        fraction * third,
    ]


def _axes_towards(direction: Array) -> Array:
    """(3, 3) orthonormal rows whose last one is the unit `direction`."""
    helper = np.eye(3)[int(np.argmin(np.abs(direction)))]
    first = np.cross(helper, direction)
    first /= np.linalg.norm(first)
    return np.array([first, np.cross(direction, first), direction])


_LINE_STEP = 0.6
"""Distance between the points that make a line, pixels."""
_LINE_LIFT = 0.5
"""A line is seen when it lies less than this behind what the pixel shows, cm."""


def draw_lines(light: Array, pixels: Array, line: LineSet, depth: Array, lift: float, samples: int) -> None:
    """Takes light away along a set of edges, or adds some, in place.

    Args:
        light: (height, width) share of light kept at each sample.
        pixels: (n, 3) projected vertices: x, y in samples and distance from the camera, cm.
        line: The edges.
        depth: (height, width) distance at which what each sample shows is drawn, cm.
        lift: By how much nearer the surface of the line is drawn, cm.
        samples: Samples along a side of a finished pixel.
    """
    height, width = depth.shape
    edges = np.asarray(line.edges).reshape(-1, 2)
    start, end = pixels[edges[:, 0]], pixels[edges[:, 1]]
    low, high = np.minimum(start, end), np.maximum(start, end)
    inside = (high[:, 0] >= 0) & (low[:, 0] < width) & (high[:, 1] >= 0) & (low[:, 1] < height)
    inside &= low[:, 2] > 0
    start, end = start[inside], end[inside]
    length = np.hypot(*(end - start)[:, :2].T)
    count = np.minimum(np.ceil(length / _LINE_STEP).astype(np.int64), 4 * (width + height)) + 1
    which = np.repeat(np.arange(len(count)), count)
    along = np.arange(len(which)) - np.repeat(np.cumsum(count) - count, count)
    t = (along + 0.5) / np.repeat(count, count)
    points = start[which] + t[:, None] * (end - start)[which]
    radius = line.width * samples / 2
    reach = np.arange(-int(np.ceil(radius)), int(np.ceil(radius)) + 1)
    for dy in reach:
        for dx in reach:
            if dx * dx + dy * dy > radius * radius:
                continue
            x, y = (points[:, :2] + (dx, dy)).astype(np.int64).T
            on = (x >= 0) & (x < width) & (y >= 0) & (y < height)
            x, y, z = x[on], y[on], points[on, 2]
            shown = z - lift - _LINE_LIFT <= depth[y, x]
            stronger = np.minimum if line.strength > 0 else np.maximum
            light[y[shown], x[shown]] = stronger(light[y[shown], x[shown]], 1.0 - line.strength)


def draw_figure(
    scene: Scene,
    camera: Camera,
    size: tuple[int, int],
    *,
    lighting: Lighting = STUDIO,
    shadows: bool = True,
    samples: int = 2,
) -> tuple[Array, Array]:
    """See `swifttailor.render.view.draw_figure`."""
    width, height = size
    projection = Projection(scene, camera, (width * samples, height * samples))
    face = rasterize(projection.corners, projection.size)
    light = np.zeros((*face.shape, 3), np.float32)
    seen = _lit_once(projection, _find_visible(projection, face), face, samples)
    if len(seen.at):
        light.reshape(-1, 3)[seen.at] = _light(projection, seen, face.shape, samples, lighting, shadows)
    coverage = (face >= 0).astype(np.float32)[:, :, None]
    return box_mean(light, samples), box_mean(coverage, samples)


@dataclass(frozen=True)
class _Visible:
    """The samples that show something, n of them."""

    at: Array
    """(n,) position in the flattened picture of samples."""
    face: Array
    """(n,) triangle of the projection."""
    normal: Array
    """(n, 3) unit normals turned towards the camera, in its frame."""
    distance: Array
    """(n,) from the camera, cm."""
    print_at: Array | None
    """(n, 2) where on the cloth, cm; None where nothing has a print."""


def _find_visible(projection: Projection, face: Array) -> _Visible:
    at = np.flatnonzero(face.ravel() >= 0)
    seen = face.ravel()[at]
    row, column = np.divmod(at.astype(np.int32), np.int32(face.shape[1]))
    # Weights are taken from each triangle's own first corner: exact enough in float32 for slivers, too.
    slopes = barycentric(projection.corners)[:, :, :2].reshape(-1, 4)
    table = np.concatenate(
        [projection.corners[:, 0, :2], slopes, projection.distance, projection.normals.reshape(-1, 9)], axis=1
    ).astype(np.float32)
    turned = np.where(projection.front, np.float32(1), np.float32(-1))
    normal = np.zeros((len(at), 3), np.float32)
    distance = np.zeros(len(at), np.float32)
    print_at = None if projection.print_at is None else np.zeros((len(at), 2), np.float32)
    for part in _blocks(len(at)):
        values = table[seen[part]]
        x0, y0, ax, ay, bx, by, d0, d1, d2 = (np.ascontiguousarray(values[:, k]) for k in range(9))
        x, y = column[part] + np.float32(0.5) - x0, row[part] + np.float32(0.5) - y0
        w1, w2 = np.clip(ax * x + ay * y, 0, 1), np.clip(bx * x + by * y, 0, 1)
        w0 = np.clip(1 - w1 - w2, 0, 1)
        if projection.camera.perspective:
            w0, w1, w2 = w0 / d0, w1 / d1, w2 / d2
        total = 1 / (w0 + w1 + w2)
        w0, w1, w2 = w0 * total, w1 * total, w2 * total
        distance[part] = w0 * d0 + w1 * d1 + w2 * d2
        blend = (
            w0[:, None] * values[:, 9:12] + w1[:, None] * values[:, 12:15] + w2[:, None] * values[:, 15:18]
        )
        length = np.sqrt(np.einsum("ij,ij->i", blend, blend))
        normal[part] = blend * (turned[seen[part]] / np.maximum(length, np.float32(1e-6)))[:, None]
        if print_at is not None and projection.print_at is not None:
            corners = projection.print_at[seen[part]]
            print_at[part] = np.einsum("ki,ikj->ij", np.stack([w0, w1, w2]), corners)
    return _Visible(at, seen, normal, distance, print_at)


def _lit_once(projection: Projection, seen: _Visible, face: Array, samples: int) -> _Visible:
    """Pixels that show one triangle have the normal of their middle sample throughout.

    Where a pixel shows much of the world, those that show one side of one surface, too.
    """
    coarse = projection.camera.height / (face.shape[0] // samples) > 0.35
    kind = face
    if coarse:
        kind = np.where(face >= 0, 2 * projection.surface[face] + projection.front[face], -1)
    step = slice(samples // 2, None, samples)
    whole = np.repeat(np.repeat(kind[step, step], samples, 0), samples, 1) == kind
    whole = whole.reshape(kind.shape[0] // samples, samples, -1, samples).all(axis=(1, 3))
    row, column = np.divmod(seen.at, face.shape[1])
    index = np.full(face.shape, -1)
    index[row, column] = np.arange(len(seen.at))
    middle = index[row // samples * samples + samples // 2, column // samples * samples + samples // 2]
    once = whole[row // samples, column // samples]
    return replace(seen, normal=np.where(once[:, None], seen.normal[middle], seen.normal))


def _blocks(count: int) -> list[slice]:
    """Consecutive parts of `count` samples, small enough that work on one stays in the caches."""
    return [slice(k, min(k + _BLOCK, count)) for k in range(0, count, _BLOCK)]


def _light(
    projection: Projection,
    seen: _Visible,
    shape: tuple[int, int],
    samples: int,
    lighting: Lighting,
    shadows: bool,
) -> Array:
    """Linear light (n, 3) of the visible samples."""
    depth = np.full(shape, np.float32(np.inf))
    depth.ravel()[seen.at] = seen.distance
    key = room = np.ones(len(seen.at), np.float32)
    if shadows:
        key, room = _occlusion(projection, seen, depth, samples, lighting)
    up_axis = projection.camera.axes[:, 1].astype(np.float32)
    lit = np.zeros((len(seen.at), 3), np.float32)
    for part in _blocks(len(seen.at)):
        normal, face = seen.normal[part], seen.face[part]
        material = projection.materials[face]
        color = np.where(projection.front[face][:, None], material[:, 0:3], material[:, 3:6])
        if seen.print_at is not None:
            _print(projection, face, seen.print_at[part], color)
        facing = np.clip(normal[:, 2], 0, 1)
        lit[part] = shade(
            Samples(
                normal=normal,
                up=normal @ up_axis,
                facing=facing,
                color=color,
                sheen=material[:, 6],
                gloss=material[:, 7],
                shadow=key[part],
                open_sky=room[part],
            ),
            lighting,
        )
    if any(s.lines for s in projection.scene.surfaces):
        kept, drawn_at = np.ones(shape, np.float32), depth.copy()
        lifts = np.array([s.lift for s in projection.scene.surfaces])
        drawn_at.ravel()[seen.at] -= lifts[projection.surface[seen.face]]
        for surface, pixels in zip(projection.scene.surfaces, projection.pixels, strict=True):
            for line in surface.lines:
                draw_lines(kept, pixels, line, drawn_at, surface.lift, samples)
        lit *= kept.ravel()[seen.at][:, None]
    return lit


def _print(projection: Projection, face: Array, at: Array, color: Array) -> None:
    """Puts the colours of prints on the right sides, in place."""
    for k, surface in enumerate(projection.scene.surfaces):
        if surface.print is not None:
            shown = np.flatnonzero((projection.surface[face] == k) & projection.front[face])
            color[shown] = surface.print.colors(at[shown])


def _occlusion(
    projection: Projection, seen: _Visible, depth: Array, samples: int, lighting: Lighting
) -> tuple[Array, Array]:
    """Shares of the key light and of the room's light (n,) at the samples, found once per pixel."""
    camera, (width, height) = projection.camera, projection.size
    index = np.full(depth.shape, -1, np.int32)
    index.ravel()[seen.at] = np.arange(len(seen.at), dtype=np.int32)
    step = slice(samples // 2, None, samples)
    coarse, index = depth[step, step], index[step, step]
    there = index >= 0
    room = open_sky(coarse, there, coarse.shape[0] / camera.height)
    key = np.ones(coarse.shape, np.float32)
    j, i = np.nonzero(there)
    if len(j):
        middle = samples // 2 + 0.5
        origin, direction = camera.rays(i * samples + middle, j * samples + middle, (width, height))
        along = coarse[j, i] / -(direction @ camera.axes[2])
        normals = seen.normal[index[j, i]] @ camera.axes.astype(np.float32)
        shadow_map = ShadowMap(triangles(projection.scene), lighting.key.unit() @ camera.axes)
        key[j, i] = shadow_map.light(origin + direction * along[:, None], normals)
    row, column = np.divmod(seen.at.astype(np.int32), np.int32(width))
    pick = (row // samples) * np.int32(coarse.shape[1]) + column // samples
    return key.ravel()[pick], room.ravel()[pick]

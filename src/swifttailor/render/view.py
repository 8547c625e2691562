"""One picture of some surfaces: rasterised once, then lit where something is seen (deferred shading)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Array
from swifttailor.errors import InputError
from swifttailor.render.backdrop import wall
from swifttailor.render.camera import Camera
from swifttailor.render.color import BACKGROUND, Color, encode_srgb, to_linear
from swifttailor.render.lighting import STUDIO, Lighting, Samples, shade
from swifttailor.render.lines import draw_lines
from swifttailor.render.open_sky import box_mean, open_sky
from swifttailor.render.rasterize import barycentric, rasterize
from swifttailor.render.scene import Projection, Scene
from swifttailor.render.shadow_map import ShadowMap
from swifttailor.render.surface import Surface

MAX_SAMPLES = 64_000_000
"""Most samples in one picture."""
_BLOCK = 1 << 15


def render_view(
    surfaces: Sequence[Surface],
    camera: Camera,
    size: tuple[int, int],
    *,
    background: Color | Array | None = BACKGROUND,
    lighting: Lighting = STUDIO,
    shadows: bool = True,
    floor: bool = True,
    samples: int = 2,
) -> Array:
    """Draws surfaces as one camera sees them.

    Args:
        surfaces: What to draw.
        camera: From where.
        size: Width and height in pixels.
        background: Colour of the backdrop, or the backdrop itself (height, width, 3) in linear light. None:
            the picture gets a fourth channel, opaque where something is seen.
        lighting: Where light comes from.
        shadows: Whether the key light casts shadows and folds are darkened.
        floor: Whether what stands on the floor y = 0 darkens it.
        samples: Samples along each side of a pixel.

    Returns:
        (height, width, 3) uint8 sRGB, or (height, width, 4) without a background.

    Raises:
        InputError: The size is not positive or too large.
    """
    scene = Scene(surfaces)
    light, coverage = draw_figure(scene, camera, size, lighting=lighting, shadows=shadows, samples=samples)
    if background is None:
        alpha = np.round(coverage * 255.0).astype(np.uint8)
        return np.concatenate([encode_srgb(light / np.maximum(coverage, 1e-6)), alpha], axis=2)
    backdrop = _backdrop(background, size)
    if floor and scene.floor_shadow is not None:
        backdrop *= scene.floor_shadow.light(camera, size)
    return encode_srgb(light + (1.0 - coverage) * backdrop)


def _backdrop(background: Color | Array, size: tuple[int, int]) -> Array:
    if isinstance(background, np.ndarray):
        if background.shape != (size[1], size[0], 3):
            raise InputError(
                f"A backdrop for a picture of {size[0]} x {size[1]} has the shape ({size[1]}, {size[0]}, 3), "
                f"got {background.shape}."
            )
        return background.astype(np.float32)
    return wall(size, to_linear(background))


def draw_figure(
    scene: Scene,
    camera: Camera,
    size: tuple[int, int],
    *,
    lighting: Lighting = STUDIO,
    shadows: bool = True,
    samples: int = 2,
) -> tuple[Array, Array]:
    """Draws a scene before nothing.

    Args:
        scene: What to draw.
        camera: From where.
        size: Width and height in pixels.
        lighting: See `render_view`.
        shadows: See `render_view`.
        samples: See `render_view`.

    Returns:
        Linear light (height, width, 3) already multiplied by the coverage, and the coverage
        (height, width, 1) from 0 to 1; float32.
    """
    width, height = size
    if width < 1 or height < 1 or samples < 1 or width * height * samples**2 > MAX_SAMPLES:
        raise InputError(
            f"A picture has 1 to {MAX_SAMPLES} samples in all, got {width} x {height} pixels "
            f"with {samples} x {samples} samples each."
        )
    projection = Projection(scene, camera, (width * samples, height * samples))
    face = rasterize(projection.corners, projection.size)
    light = np.zeros((*face.shape, 3), np.float32)
    seen = _find_visible(projection, face)
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
        kept = np.ones(shape, np.float32)
        for surface, pixels in zip(projection.scene.surfaces, projection.pixels, strict=True):
            for line in surface.lines:
                draw_lines(kept, pixels, line, depth, samples)
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
        shadow_map = ShadowMap(projection.scene.triangles, lighting.key.unit() @ camera.axes)
        key[j, i] = shadow_map.light(origin + direction * along[:, None], normals)
    row, column = np.divmod(seen.at.astype(np.int32), np.int32(width))
    pick = (row // samples) * np.int32(coarse.shape[1]) + column // samples
    return key.ravel()[pick], room.ravel()[pick]

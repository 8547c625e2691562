"""One picture of some surfaces: rasterised once, then lit where something is seen (deferred shading)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from swifttailor.arrays import Array
from swifttailor.compiled_loop import CompiledLoop
from swifttailor.errors import InputError
from swifttailor.render.backdrop import wall
from swifttailor.render.camera import Camera
from swifttailor.render.color import BACKGROUND, Color, encode_srgb, to_linear
from swifttailor.render.lighting import STUDIO, Lighting
from swifttailor.render.lines import draw_lines
from swifttailor.render.open_sky import open_sky
from swifttailor.render.rasterize import rasterize
from swifttailor.render.scene import Projection, Scene
from swifttailor.render.shadow_map import ShadowMap
from swifttailor.render.surface import Surface

_interpolate = CompiledLoop("swifttailor.render.raster_kernels", "interpolate")
_light_samples = CompiledLoop("swifttailor.render.shading_kernels", "light_samples")
MAX_SAMPLES = 64_000_000
"""Most samples in one picture."""


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
    distance = np.full(face.shape, np.float32(np.inf))
    normal = np.zeros((*face.shape, 3), np.float32)
    weights = np.zeros((0, 0, 2) if projection.print_at is None else (*face.shape, 2), np.float32)
    _interpolate(
        face,
        projection.corners,
        projection.distance,
        projection.normals,
        projection.front,
        camera.perspective,
        distance,
        normal,
        weights,
    )
    key, room = (
        _occlusion(scene, camera, distance, normal, samples, lighting) if shadows else _all_light(size)
    )
    light, coverage = np.zeros((height, width, 3), np.float32), np.zeros((height, width, 1), np.float32)
    _light_samples(
        light,
        coverage,
        face,
        normal,
        projection.materials,
        projection.front,
        _printed(projection, face, weights),
        _kept(projection, distance, samples),
        key,
        room,
        camera.axes[:, 1].astype(np.float32),
        lighting.table(),
        samples,
        np.zeros(3, np.float32),
    )
    return light, coverage


def _all_light(size: tuple[int, int]) -> tuple[Array, Array]:
    lit = np.ones((size[1], size[0]), np.float32)
    return lit, lit


def _occlusion(
    scene: Scene, camera: Camera, distance: Array, normal: Array, samples: int, lighting: Lighting
) -> tuple[Array, Array]:
    """Shares (h, w) of the key light and of the room's light, found once per pixel."""
    step = slice(samples // 2, None, samples)
    coarse = np.ascontiguousarray(distance[step, step])
    there = np.isfinite(coarse)
    if not there.any():
        return _all_light((coarse.shape[1], coarse.shape[0]))
    room = open_sky(coarse, there, coarse.shape[0] / camera.height)
    shadow_map = ShadowMap(scene.triangles, lighting.key.unit() @ camera.axes)
    return shadow_map.light(camera, distance, normal, samples), room


def _kept(projection: Projection, distance: Array, samples: int) -> Array:
    """Share (H, W) of the light that seams and hems leave at each sample; (0, 0) without any."""
    surfaces = projection.scene.surfaces
    if not any(s.lines for s in surfaces):
        return np.zeros((0, 0), np.float32)
    kept = np.ones(distance.shape, np.float32)
    for surface, pixels in zip(surfaces, projection.pixels, strict=True):
        for line in surface.lines:
            draw_lines(kept, pixels, line, distance, samples)
    return kept


def _printed(projection: Projection, face: Array, weights: Array) -> Array:
    """Colours (H, W, 3) of the prints on right sides, negative elsewhere; (0, 0, 3) without any."""
    if projection.print_at is None:
        return np.zeros((0, 0, 3), np.float32)
    color = np.full((*face.shape, 3), np.float32(-1))
    for k, surface in enumerate(projection.scene.surfaces):
        if surface.print is not None:
            shown = (projection.surface == k) & projection.front
            rows, columns = np.nonzero((face >= 0) & shown[face])
            corners, (w1, w2) = projection.print_at[face[rows, columns]], weights[rows, columns].T
            w = np.stack([1 - w1 - w2, w1, w2])
            color[rows, columns] = surface.print.colors(np.einsum("ki,ikj->ij", w, corners))
    return color

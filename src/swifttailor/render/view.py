"""One picture of some surfaces: rasterised once, then lit where something is seen (deferred shading)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

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
from swifttailor.render.printing import paint_prints
from swifttailor.render.scene import Projection, Scene
from swifttailor.render.shadow_map import ShadowMap
from swifttailor.render.surface import Surface

_find_middles = CompiledLoop("swifttailor.render.raster_kernels", "find_middles")
_light_samples = CompiledLoop("swifttailor.render.shading_kernels", "light_samples")
_put_before = CompiledLoop("swifttailor.render.shading_kernels", "put_before")
MAX_SAMPLES = 64_000_000
"""Most samples in one picture."""
_COARSE_CM = 0.35
"""Where a pixel shows more than this, folds are as small as pixels, and light is found once for each."""


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
    return _finish(Scene(surfaces), camera, size, background, lighting, shadows, floor, samples)[0]


@dataclass(frozen=True, eq=False)
class Seen:
    """A picture and what is seen in it."""

    pixels: Array
    """As `render_view` gives them."""
    shares: Array
    """(height, width, surfaces) float32 share of each pixel that each surface covers, 0 to 1."""
    face: Array
    """(height, width) int32 the face at the middle of each pixel, counted through all surfaces; -1: none."""


def render_seen(
    surfaces: Sequence[Surface],
    camera: Camera,
    size: tuple[int, int],
    *,
    background: Color | Array | None = BACKGROUND,
    lighting: Lighting = STUDIO,
    shadows: bool = True,
    floor: bool = True,
    samples: int = 2,
) -> Seen:
    """Draws surfaces as `render_view` does, and says which is seen where; the arguments are the same."""
    from swifttailor.render.print_kernels import add_shares

    scene = Scene(surfaces)
    pixels, projection = _finish(scene, camera, size, background, lighting, shadows, floor, samples)
    keys = projection.nearest.keys
    shares = np.zeros((size[1], size[0], len(scene.surfaces)), np.float32)
    face = np.full((size[1], size[0]), np.int32(-1))
    add_shares(keys, scene.face_surface, samples, shares, face)
    return Seen(pixels, shares, face)


def _finish(
    scene: Scene,
    camera: Camera,
    size: tuple[int, int],
    background: Color | Array | None,
    lighting: Lighting,
    shadows: bool,
    floor: bool,
    samples: int,
) -> tuple[Array, Projection]:
    """The picture of `render_view` and the scene in it."""
    projection = project(scene, camera, size, samples)
    light, coverage = light_figure(projection, size, lighting=lighting, shadows=shadows, samples=samples)
    if background is None:
        alpha = np.round(coverage * 255.0).astype(np.uint8)
        return np.concatenate([encode_srgb(light / np.maximum(coverage, 1e-6)), alpha], axis=2), projection
    backdrop = _backdrop(background, size)
    kept = np.ones(coverage.shape, np.float32)
    if floor and camera.elevation > 0.0:
        shadow = scene.floor_shadow(camera.height / size[1])
        if shadow is not None:
            kept = shadow.light(camera, size)
    _put_before(backdrop, 0, light, coverage, kept, np.ones(size[0], np.float32))
    return encode_srgb(backdrop), projection


def _backdrop(background: Color | Array, size: tuple[int, int]) -> Array:
    if isinstance(background, np.ndarray):
        if background.shape != (size[1], size[0], 3):
            raise InputError(
                f"A backdrop for a picture of {size[0]} x {size[1]} has the shape ({size[1]}, {size[0]}, 3), "
                f"got {background.shape}."
            )
        return np.array(background, np.float32)
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
    return light_figure(
        project(scene, camera, size, samples), size, lighting=lighting, shadows=shadows, samples=samples
    )


def project(scene: Scene, camera: Camera, size: tuple[int, int], samples: int) -> Projection:
    """A scene in a picture of `size` pixels, each with samples along its sides.

    Raises:
        InputError: The size is not positive or too large.
    """
    width, height = size
    if width < 1 or height < 1 or samples < 1 or width * height * samples**2 > MAX_SAMPLES:
        raise InputError(
            f"A picture has 1 to {MAX_SAMPLES} samples in all, got {width} x {height} pixels "
            f"with {samples} x {samples} samples each."
        )
    return Projection(scene, camera, (width * samples, height * samples))


def light_figure(
    projection: Projection,
    size: tuple[int, int],
    *,
    lighting: Lighting = STUDIO,
    shadows: bool = True,
    samples: int = 2,
) -> tuple[Array, Array]:
    """Lights what a projection shows; arguments and result are those of `draw_figure`."""
    (width, height), scene, camera = size, projection.scene, projection.camera
    normal, distance = _middles(projection, size, samples)
    key, room = _all_light(size)
    if shadows:
        key, room = _occlusion(projection, distance, normal, samples, lighting)
    coarse = bool(camera.height / height > _COARSE_CM)
    prints = paint_prints(projection, samples, few=coarse)
    light, coverage = np.zeros((height, width, 3), np.float32), np.zeros((height, width, 1), np.float32)
    _light_samples(
        light,
        coverage,
        projection.nearest.keys,
        projection.nearest.front,
        projection.points,
        scene.faces,
        scene.normals,
        camera.perspective,
        scene.face_surface,
        scene.materials.table,
        scene.materials.place,
        prints.painted,
        prints.paint,
        prints.bumps,
        _kept(projection, samples),
        normal,
        key,
        room,
        camera.axes[2].astype(np.float32),
        lighting.table(camera.axes),
        samples,
        coarse,
        np.zeros((2, 3), np.float32),
    )
    return light, coverage


def _all_light(size: tuple[int, int]) -> tuple[Array, Array]:
    lit = np.ones((size[1], size[0]), np.float32)
    return lit, lit


def _middles(projection: Projection, size: tuple[int, int], samples: int) -> tuple[Array, Array]:
    """Normals (h, w, 3) in the world, and distances (h, w) from the camera, at the middles of pixels."""
    width, height = size
    distance = np.full((height, width), np.float32(np.inf))
    normal = np.zeros((height, width, 3), np.float32)
    _find_middles(
        projection.nearest.keys,
        projection.nearest.front,
        samples,
        projection.points,
        projection.scene.faces,
        projection.scene.normals,
        projection.camera.perspective,
        distance,
        normal,
    )
    return normal, distance


def _occlusion(
    projection: Projection, distance: Array, normal: Array, samples: int, lighting: Lighting
) -> tuple[Array, Array]:
    """Shares (h, w) of the key light and of the room's light, found once per pixel."""
    scene, camera, (height, width) = projection.scene, projection.camera, distance.shape
    if not len(scene.faces):
        return _all_light((width, height))
    room = open_sky(distance, height / camera.height)
    shadow_map = ShadowMap(scene, lighting.key.unit() @ camera.axes, camera.height / height)
    return shadow_map.light(camera, distance, normal, samples), room


def _kept(projection: Projection, samples: int) -> Array:
    """Share (H, W) of the light that seams and hems leave at each sample; (0, 0) without any."""
    surfaces = projection.scene.surfaces
    if not any(s.lines for s in surfaces):
        return np.zeros((0, 0), np.float32)
    kept = np.ones(projection.nearest.keys.shape, np.float32)
    for k, surface in enumerate(surfaces):
        for line in surface.lines:
            draw_lines(kept, projection, k, line, samples)
    return kept

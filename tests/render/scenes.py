"""Small scenes, and the plainest renderer there is to hold against the fast one."""

from __future__ import annotations

import numpy as np
from plain_renderer import Samples, shade

from swifttailor.render import Camera, Surface


def random_triangles(count: int, size: tuple[int, int], seed: int) -> np.ndarray:
    """(count, 3, 3) triangles over and beyond a picture, small, large and thin ones."""
    rng = np.random.default_rng(seed)
    center = rng.uniform(-0.1, 1.1, (count, 1, 2)) * size
    spread = 10.0 ** rng.uniform(-0.5, 2.0, (count, 1, 1)) * rng.uniform(0.02, 1, (count, 1, 2))
    xy = center + spread * rng.normal(size=(count, 3, 2))
    return np.concatenate([xy, rng.uniform(1, 9, (count, 3, 1))], axis=2)


def brute_force(corners: np.ndarray, size: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
    """Triangle seen at every pixel centre, one pixel and one triangle at a time.

    Returns:
        (h, w) triangle or -1, and (h, w) whether the answer is beyond doubt: no border of a triangle and no
        second triangle lies too close to call.
    """
    width, height = size
    face = np.full((height, width), -1)
    sure = np.ones((height, width), bool)
    for j in range(height):
        for i in range(width):
            x, y = i + 0.5, j + 0.5
            depths = []
            for k, ((x0, y0, z0), (x1, y1, z1), (x2, y2, z2)) in enumerate(corners):
                area = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
                if abs(area) < 1e-12:
                    continue
                w1 = ((x - x0) * (y2 - y0) - (x2 - x0) * (y - y0)) / area
                w2 = ((x1 - x0) * (y - y0) - (x - x0) * (y1 - y0)) / area
                w0 = 1 - w1 - w2
                inside = min(w0, w1, w2)
                if abs(inside) < 1e-9:
                    sure[j, i] = False
                if inside > 0:
                    depths.append((w0 * z0 + w1 * z1 + w2 * z2, k))
            depths.sort()
            if depths:
                face[j, i] = depths[0][1]
                if len(depths) > 1 and depths[1][0] - depths[0][0] < 1e-7:
                    sure[j, i] = False
    return face, sure


def ray_trace(surface: Surface, camera: Camera, size: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
    """Linear light (h, w, 3) of an unshadowed surface, one ray per pixel, and the triangles seen."""
    width, height = size
    x, y = (a.ravel() + 0.5 for a in np.meshgrid(np.arange(width), np.arange(height)))
    origins, directions = camera.rays(x, y, size)
    light, seen = np.zeros((width * height, 3)), np.full(width * height, -1)
    colors = np.broadcast_to(surface.color, (len(surface.faces), 3))
    a, b, c = (surface.vertices[surface.faces[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    total = (normals**2).sum(axis=1)
    for pixel, (origin, direction) in enumerate(zip(origins, directions, strict=True)):
        facing = normals @ direction
        with np.errstate(all="ignore"):
            along = ((a - origin) * normals).sum(axis=1) / facing
            hit = origin + along[:, None] * direction
            w0 = (np.cross(b - hit, c - hit) * normals).sum(axis=1) / total
            w1 = (np.cross(c - hit, a - hit) * normals).sum(axis=1) / total
            ok = (np.minimum(np.minimum(w0, w1), 1 - w0 - w1) >= 0) & (along > 0)
        if surface.back_color is None:
            ok &= facing < 0
        if not ok.any():
            continue
        k = int(np.where(ok, along, np.inf).argmin())
        seen[pixel] = k
        weights = np.array([w0[k], w1[k], 1 - w0[k] - w1[k]])
        front = facing[k] < 0
        smooth = weights @ surface.vertex_normals[surface.faces[k]]
        smooth = smooth / np.linalg.norm(smooth) * (1 if front else -1)
        in_view = (camera.axes @ smooth)[None]
        color = colors[k] if front or surface.back_color is None else surface.back_color
        one = np.ones(1)
        light[pixel] = shade(
            Samples(
                in_view,
                smooth[None, 1],
                np.clip(in_view[:, 2], 0, 1),
                np.array(color, float)[None],
                one * surface.sheen,
                one * surface.gloss,
                one,
                one,
            )
        )[0]
    return light.reshape(height, width, 3), seen.reshape(height, width)


def box(center: tuple[float, float, float], half: float, color=(0.5, 0.5, 0.5), **options) -> Surface:
    """A closed cube."""
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    faces = np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])
    return Surface(corners * half + center, faces, np.array(color), **options)


def ball(radius: float = 10.0, center=(0.0, 0.0, 0.0), count: int = 16, **options) -> Surface:
    """A closed sphere."""
    import trimesh

    mesh = trimesh.creation.uv_sphere(radius=radius, count=[count, count])
    return Surface(
        np.asarray(mesh.vertices) + center, np.asarray(mesh.faces), np.array([0.6, 0.3, 0.2]), **options
    )


def sheet(corner_a, corner_b, corner_c, color=(0.2, 0.5, 0.7), **options) -> Surface:
    """A parallelogram, right side where a, b, c run anticlockwise."""
    a, b, c = (np.array(p, float) for p in (corner_a, corner_b, corner_c))
    return Surface(
        np.array([a, b, c, a + c - b]), np.array([[0, 1, 2], [0, 2, 3]]), np.array(color), **options
    )

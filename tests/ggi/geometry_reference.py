"""Alg. 4 written down plainly: loops over pixels, edges and faces, for comparison with the fast way."""

from __future__ import annotations

from itertools import pairwise

import numpy as np


def geometry_image(layout, mesh, vertices):
    """Positions (N, N, 3) by Alg. 4; a pixel of the contour takes the nearest point of its mesh edges."""
    size, raster, outlines = layout.resolution, layout.raster, layout.outlines
    image = np.zeros((size, size, 3))
    flat = vertices[mesh.weld]
    at = np.array(
        [
            layout.to_pixels(layout.pattern.panel_index(mesh.pattern.panels[k].name), p[None])[0]
            for k, p in zip(mesh.flat_panel, mesh.flat_vertices, strict=True)
        ]
    )
    runs = {}
    for panel, edges in zip(mesh.pattern.panels, mesh.edge_vertices, strict=True):
        first = outlines.first_edge[layout.pattern.panel_index(panel.name)]
        for k, run in enumerate(edges):
            runs[int(first) + k] = run
    faces_of = {k: [] for k in range(len(layout.pattern.panels))}
    for face in mesh.flat_faces:
        name = mesh.pattern.panels[mesh.flat_panel[face[0]]].name
        corners = np.vstack([at[face].T, np.ones(3)])
        flat_face = abs(np.linalg.det(corners)) < 1e-12
        inverse = np.full((3, 3), -np.inf) if flat_face else np.linalg.inv(corners)
        faces_of[layout.pattern.panel_index(name)].append((face, inverse))
    for pixel, panel, point, edge in zip(
        raster.pixels, raster.pixel_panel, raster.points, raster.edge, strict=True
    ):
        value = _on_edge(runs[int(edge)], at, flat, point) if edge >= 0 else None
        if edge < 0:
            value = _in_faces(faces_of[int(panel)], at, flat, point)
        image[pixel // size, pixel % size] = value
    return image


def _on_edge(run, at, flat, point):
    best, value = np.inf, None
    for a, b in pairwise(run):
        step = at[b] - at[a]
        length = np.linalg.norm(step)
        alpha = np.clip((point - at[a]) @ step / length**2, 0, 1) if length > 0 else 0.0
        distance = np.linalg.norm(point - at[a] - alpha * step)
        if distance < best:
            best, value = distance, (1 - alpha) * flat[a] + alpha * flat[b]
    return value


def _in_faces(faces, at, flat, point):
    """In the face that holds the point, or, beside the mesh, at the nearest place of a face."""
    for face, inverse in faces:
        share = inverse @ [*point, 1.0]
        if share.min() >= -1e-7:
            return share @ flat[face]
    best, value = np.inf, None
    for face, _ in faces:
        for a, b in zip(face, np.roll(face, 1), strict=True):
            step = at[b] - at[a]
            alpha = np.clip((point - at[a]) @ step / max(step @ step, 1e-30), 0, 1)
            distance = np.linalg.norm(point - at[a] - alpha * step)
            if distance < best:
                best, value = distance, (1 - alpha) * flat[a] + alpha * flat[b]
    return value

"""Cloth comes out of the cleft of the seat."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np

from swifttailor.body import Body
from swifttailor.garment_sewer.covering import CLEFT_CM, cover_cleft
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance

BODY = Body.default()


def sheet(height: float) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and faces of cloth behind the body around a height, all but on the skin."""
    across, up = np.meshgrid(np.linspace(-2.4, 2.4, 5), height + np.linspace(-6.0, 6.0, 9))
    vertices = np.stack([across, up, np.full_like(up, -20.0)], axis=-1).reshape(-1, 3)
    field, none = BodyDistance.of(BODY), np.ones(len(vertices), dtype=bool)
    for _ in range(30):
        distance, _ = field.sample(vertices, none)
        vertices[:, 2] += 0.7 * (distance - 0.1)
    at = np.arange(45).reshape(9, 5)
    corners = at[:-1, :-1], at[:-1, 1:], at[1:, :-1], at[1:, 1:]
    low, right, left, high = (corner.ravel() for corner in corners)
    return vertices, np.concatenate([np.stack([low, right, left], 1), np.stack([right, high, left], 1)])


def test_a_seat_seam_comes_out_of_the_cleft():
    vertices, faces = sheet(BODY.measurements.hips_level)
    mesh: Any = SimpleNamespace(faces=faces, vertex_count=len(vertices))
    moved = cover_cleft(mesh, vertices, BODY)
    middles = np.sort(faces[:, :2], axis=1)

    def clear(points: np.ndarray) -> float:
        ends = points[middles].mean(axis=1)
        return float(BodyDistance.of(BODY).sample(ends, np.ones(len(ends), dtype=bool))[0].min())

    assert clear(moved) > max(clear(vertices), 0.0) + 0.1
    assert np.linalg.norm(moved - vertices, axis=1).max() < 3 * CLEFT_CM


def test_what_lies_elsewhere_is_left_alone():
    vertices, faces = sheet(BODY.measurements.waist_level + 6.0)
    mesh: Any = SimpleNamespace(faces=faces, vertex_count=len(vertices))
    assert cover_cleft(mesh, vertices, BODY) is vertices

"""Points drawn from a surface, as metrics between surfaces compare them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.spatial import KDTree

from swifttailor.arrays import Floats, Ints
from swifttailor.errors import GeometryError


@dataclass(frozen=True, eq=False)
class PointCloud:
    """Points (n, 3) in no order: any first part of them is a smaller sample of the same surface."""

    points: Floats

    @cached_property
    def tree(self) -> KDTree:
        """For nearest points."""
        return KDTree(self.points)

    def first(self, count: int) -> PointCloud:
        """The first points only.

        Raises:
            GeometryError: There are fewer.
        """
        if count > len(self.points):
            raise GeometryError(f"A cloud of {len(self.points)} points has no first {count}.")
        return PointCloud(self.points[:count])

    def in_unit_box(self) -> PointCloud:
        """Moved and scaled, the same along all axes, so that its box is centred and reaches from -1 to 1.

        That is how point clouds are usually compared (`shape_bbox` of Luo and Hu's code, 2021): the size and
        place of a shape count for nothing.
        """
        low, high = self.points.min(axis=0), self.points.max(axis=0)
        half = float((high - low).max()) / 2
        return PointCloud((self.points - (low + high) / 2) / (half if half > 0 else 1.0))


def sample_surface(vertices: Floats, faces: Ints, count: int, seed: int | list[int]) -> PointCloud:
    """Draws points uniformly by area, each independent of the others.

    Args:
        vertices: (v, 3) cm.
        faces: (f, 3)
        count: How many points.
        seed: Of the draw.

    Raises:
        GeometryError: The surface has no area, or is not finite.
    """
    corners = vertices[faces]
    sides = corners[:, 1:] - corners[:, :1]
    area = np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1) / 2
    if not (len(area) and np.isfinite(area).all() and area.sum() > 0):
        raise GeometryError(
            f"Points can only be drawn from a surface with an area; this one has {len(faces)} faces of "
            f"{float(area.sum()) if len(area) else 0.0:g} cm^2."
        )
    chance = np.random.default_rng(seed)
    chosen = chance.choice(len(faces), count, p=area / area.sum())
    # The square root makes the density even over a triangle (Osada et al. 2002, sec. 3.2).
    root, along = np.sqrt(chance.random(count)), chance.random(count)
    weights = np.stack([1 - root, root * (1 - along), root * along], axis=1)
    return PointCloud((weights[:, :, None] * corners[chosen]).sum(axis=1))

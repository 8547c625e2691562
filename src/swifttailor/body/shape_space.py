"""Bodies of other shapes: directions around the default body, and where women, men and children lie there.

Made offline from the parametric model Anny by ``scripts/make_body_shapes.py`` (docs/sizes.md); here nothing
but numpy is needed.
"""

from __future__ import annotations

import functools
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from swifttailor.arrays import Array, read_only
from swifttailor.body.body import Body
from swifttailor.errors import InputError

SHAPES_FILE = Path(__file__).with_name("body_shapes.npz")


@dataclass(frozen=True, eq=False)
class ShapeSpace:
    """All bodies ``default + coordinates @ directions``; left and right alike, cm."""

    base: Array
    """(N, 3) vertices of the default body, cm."""
    directions: Array
    """(K, N, 3) float32: how far a unit along each direction moves every vertex, cm."""
    groups: tuple[str, ...]
    """``women``, ``men`` and ``children``."""
    means: Array
    """(G, K) coordinates of the mean body of each group."""
    covariances: Array
    """(G, K, K) how the bodies of each group are spread about it."""

    @staticmethod
    def default() -> ShapeSpace:
        """The shapes that come with the package."""
        return _shipped()

    @property
    def count(self) -> int:
        """K."""
        return len(self.directions)

    def vertices(self, coordinates: Array) -> Array:
        """(N, 3) of one body, its soles on the floor, cm.

        Args:
            coordinates: (K,).
        """
        moved = self.base + np.tensordot(np.asarray(coordinates, np.float32), self.directions, axes=1)
        moved[:, 1] -= moved[:, 1].min()
        return moved

    def prior(self, group: str | None) -> tuple[Array, Array]:
        """Mean (K,) and covariance (K, K) of a group; of all adults about the default body when None.

        Raises:
            InputError: There is no such group.
        """
        if group is None:
            adults = [k for k, name in enumerate(self.groups) if name != "children"]
            inner = self.covariances[adults].mean(axis=0)
            apart = np.cov(self.means[adults].T, bias=True)
            return np.zeros(self.count), inner + apart
        if group not in self.groups:
            raise InputError(f"There is no figure '{group}'; there are {', '.join(self.groups)}.")
        k = self.groups.index(group)
        return self.means[k], self.covariances[k]


@functools.cache
def _shipped() -> ShapeSpace:
    default = Body.default()
    with np.load(SHAPES_FILE, allow_pickle=False) as stored:
        half = stored["half"].astype(np.int64)
        moves = stored["directions"].astype(np.float32) * stored["scale"].astype(np.float32)[:, None, None]
        directions = np.zeros((len(moves), len(default.vertices), 3), np.float32)
        directions[:, _mirrors(default.vertices, half)] = moves * np.array([-1, 1, 1], np.float32)
        directions[:, half] = moves
        middle = half[np.abs(default.vertices[half, 0]) < 1e-6]
        directions[:, middle, 0] = 0.0
        return ShapeSpace(
            base=default.vertices,
            directions=read_only(directions),
            groups=tuple(str(name) for name in stored["groups"]),
            means=read_only(stored["means"].astype(np.float64)),
            covariances=read_only(stored["covariances"].astype(np.float64)),
        )


def _mirrors(vertices: Array, half: Array) -> Array:
    """(H,) the mirror image of each vertex of the left half."""
    from scipy.spatial import KDTree

    return KDTree(vertices).query(vertices[half] * [-1.0, 1.0, 1.0])[1]

"""Panels grown: each place of the cloth by its own amounts around and along the body, in one piece."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import factorized

from swifttailor.arrays import Bools, Floats, Ints


class PanelSheet:
    """One panel's flat mesh, and the equations of what is spread over it."""

    def __init__(self, vertices: Floats, faces: Ints) -> None:
        """Prepares a panel.

        Args:
            vertices: (n, 2) cm.
            faces: (f, 3) of these vertices.
        """
        self.vertices, self.faces = vertices, faces
        corners = vertices[faces]
        edge = np.roll(corners, -2, axis=1) - np.roll(corners, -1, axis=1)  # opposite of each corner
        a, b = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
        double = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
        double = np.where(np.abs(double) < 1e-9, 1e-9, double)
        self.area = np.abs(double) / 2
        # Of each corner's hat function, (f, 3, 2).
        self.gradients = np.stack([-edge[..., 1], edge[..., 0]], axis=-1) / double[:, None, None]
        products = np.einsum("fia,fja,f->fij", self.gradients, self.gradients, self.area)
        rows, columns = np.repeat(faces, 3, axis=1).ravel(), np.tile(faces, (1, 3)).ravel()
        shape = (len(vertices), len(vertices))
        self.stiffness = sparse.coo_array((products.ravel(), (rows, columns)), shape=shape).tocsr()
        self.mass = np.bincount(faces.ravel(), np.repeat(self.area / 3, 3), len(vertices)) + 1e-9
        self._smoothing: dict[float, Callable[[Floats], Floats]] = {}

    @cached_property
    def _held(self) -> Callable[[Floats], Floats]:
        """Solves for all vertices but the first, which is held: the equations leave the place open."""
        return factorized(self.stiffness[1:, 1:].tocsc())

    def smoothed(self, values: Floats, reach: float) -> Floats:
        """Values (n, k) at the vertices, evened out over about so many cm."""
        if reach not in self._smoothing:
            system = sparse.diags_array(self.mass) + reach**2 / 2 * self.stiffness
            self._smoothing[reach] = factorized(system.tocsc())
        solve = self._smoothing[reach]
        return np.stack([solve(self.mass * column) for column in values.T], axis=1)

    def slopes(self, values: Floats) -> Floats:
        """(f, 2) gradient in each face of values (n,) at the vertices."""
        return np.einsum("fia,fi->fa", self.gradients, values[self.faces])

    def grown(self, stretch: Floats) -> Floats:
        """Positions (n, 2) whose faces are stretched as nearly as possible as wanted, about the same middle.

        Args:
            stretch: (f, 2, 2) symmetric: what each face is multiplied by.
        """
        wanted = np.einsum("fia,fba,f->fib", self.gradients, stretch, self.area)
        moved = np.zeros_like(self.vertices)
        for k in (0, 1):
            right = np.zeros(len(self.vertices))
            np.add.at(right, self.faces.ravel(), wanted[..., k].ravel())
            moved[1:, k] = self._held(right[1:])
        weight = self.mass[:, None] / self.mass.sum()
        return moved + ((self.vertices - moved) * weight).sum(axis=0)

    def spread(self, values: Floats, border: Bools) -> Floats:
        """Values (n, k) that are known at border vertices (n,) evened out over the rest."""
        inner = ~border
        result = values.copy()
        if inner.any():
            solve = factorized(self.stiffness[inner][:, inner].tocsc())
            right = -(self.stiffness[inner][:, border] @ values[border])
            result[inner] = np.stack([solve(column) for column in right.T], axis=1)
        return result

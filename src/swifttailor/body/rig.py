"""The skeleton in the body, and how much each of its joints carries any point in space around it.

The weights are a field in space, not values at the body's vertices: the body, its mannequin, a garment and
hair ask the same field, so what lies outside stays outside when all of it is carried (see `carrying`).
"""

from __future__ import annotations

import functools
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from swifttailor.arrays import Array, read_only
from swifttailor.errors import GeometryError, InputError

RIG_FILE = Path(__file__).with_name("default_rig.npz")

CARRIERS = 6
"""So many of them carry one point at most."""
SOFTENED = (
    *(f"{side}_{joint}" for side in ("left", "right") for joint in ("clavicle", "arm", "forearm", "hand")),
    *(f"{side}_{joint}" for side in ("left", "right") for joint in ("thigh", "shin", "foot")),
    *("spine", "chest", "neck", "head"),
)
"""Joints that bend over a carrier of their own, which turns half as far: elbows keep their girth."""
HANGING = tuple(f"{side}_{joint}" for side in ("left", "right") for joint in ("thigh", "shin"))
"""Joints with a carrier that follows them and stays upright, for skirts (see `worn`)."""


@dataclass(frozen=True, eq=False)
class Weights:
    """Who carries each of some points, and how much of it."""

    carrier: Array
    """(P, CARRIERS) uint8: first the joints of the rig, then the halves of `SOFTENED`, then `HANGING`."""
    share: Array
    """(P, CARRIERS) float32 from 0 to 1; each row sums to 1."""

    def __len__(self) -> int:
        return len(self.carrier)


@dataclass(frozen=True, eq=False)
class Rig:
    """Joints and the field of their weights; made for the default body, cm."""

    names: tuple[str, ...]
    """Of the joints; a parent comes before its children."""
    parents: tuple[int, ...]
    """Index of the joint that each hangs on; -1 for the first."""
    joints: Array
    """(J, 3) float64 positions, cm."""
    axes: tuple[Array, Array, Array]
    """Where the field's nodes stand along X, Y and Z; the first are 0 or more, the other half is mirrored."""
    field: Array
    """(X, Y, Z, J) float32 weights at the nodes; each sums to 1."""

    @staticmethod
    def default() -> Rig:
        """The rig of `Body.default` and its mannequin."""
        return _default_rig()

    @property
    def joint_count(self) -> int:
        """J."""
        return len(self.names)

    def index(self, name: str) -> int:
        """Position of a joint in `names`.

        Raises:
            InputError: There is no such joint.
        """
        if name not in self.names:
            raise InputError(f"The rig has no joint {name!r}; it has {', '.join(self.names)}.")
        return self.names.index(name)

    @functools.cached_property
    def mirrored(self) -> Array:
        """(J,) joint on the other side of each; a joint in the middle is its own."""
        return read_only(np.array([self.names.index(mirrored_name(name)) for name in self.names]))

    @functools.cached_property
    def softened(self) -> Array:
        """(S,) joints that have a half, in the order of their halves."""
        return read_only(np.array([k for k, name in enumerate(self.names) if name in SOFTENED]))

    def weights_at(self, points: Array, *, without: tuple[str, ...] = ()) -> Weights:
        """Who carries points of the standing body, of what it wears, and of the space around it.

        Args:
            points: (P, 3) positions, cm.
            without: Names of joints that carry none of them, as arms do not carry trousers.

        Returns:
            Their weights, to be kept: they hold for every pose and shape.

        Raises:
            GeometryError: The positions have another shape or are not finite.
        """
        dense = self.dense_weights_at(points)
        if without:
            dense[:, [self.index(name) for name in without]] = 0.0
            dense[dense.sum(axis=1) < 1e-3, self.index("pelvis")] = 1.0
            dense /= dense.sum(axis=1, keepdims=True)
        return self.strongest(dense, np.zeros((len(points), len(HANGING))))

    def dense_weights_at(self, points: Array) -> Array:
        """(P, J) float32 weights of all joints, unsoftened; see `weights_at`."""
        points = np.asarray(points, np.float64)
        if points.ndim != 2 or points.shape[1:] != (3,) or not np.isfinite(points).all():
            raise GeometryError(f"points must be finite and of the shape (P, 3), received {points.shape}.")
        return self._interpolated(points)

    def strongest(self, dense: Array, hanging: Array) -> Weights:
        """The carriers with the largest shares.

        Args:
            dense: (P, J) weights of the joints.
            hanging: (P, 4) weights of the carriers `HANGING`.
        """
        dense = np.concatenate([self._with_halves(dense), hanging], axis=1)
        carrier = np.argpartition(-dense, CARRIERS, axis=1)[:, :CARRIERS]
        share = np.take_along_axis(dense, carrier, axis=1)
        share /= share.sum(axis=1, keepdims=True)
        return Weights(carrier.astype(np.uint8), share.astype(np.float32))

    def _interpolated(self, points: Array) -> Array:
        """(P, J) weights between the nodes; beyond the last node those of the last."""
        corner, part = [], []
        for axis, place in zip(self.axes, (np.abs(points[:, 0]), points[:, 1], points[:, 2]), strict=True):
            low = np.clip(np.searchsorted(axis, place, side="right") - 1, 0, len(axis) - 2)
            corner.append(low)
            part.append(np.clip((place - axis[low]) / (axis[low + 1] - axis[low]), 0.0, 1.0))
        dense = np.zeros((len(points), self.joint_count), np.float32)
        for i in (0, 1):
            for j in (0, 1):
                for k in (0, 1):
                    share = np.ones(len(points), np.float32)
                    for step, t in zip((i, j, k), part, strict=True):
                        share *= t if step else 1.0 - t
                    dense += share[:, None] * self.field[corner[0] + i, corner[1] + j, corner[2] + k]
        right = points[:, 0] < 0.0
        dense[right] = dense[right][:, self.mirrored]
        return dense

    def _with_halves(self, dense: Array) -> Array:
        """(P, J + S): where a joint and its parent share a point, their half takes most of the overlap."""
        above = np.asarray(self.parents)[self.softened]
        halves = 2.0 * dense[:, self.softened] * dense[:, above]
        whole = dense.copy()
        # s^2, 2 s (1 - s) and (1 - s)^2 of two that share a point: still 1 together, and never below 0.
        for k, (joint, parent) in enumerate(zip(self.softened, above, strict=True)):
            whole[:, joint] -= halves[:, k] / 2
            whole[:, parent] -= halves[:, k] / 2
        return np.concatenate([np.maximum(whole, 0.0), halves], axis=1)


def mirrored_name(name: str) -> str:
    """The joint on the other side."""
    side, _, rest = name.partition("_")
    return {"left": f"right_{rest}", "right": f"left_{rest}"}.get(side, name)


@functools.cache
def _default_rig() -> Rig:
    with np.load(RIG_FILE, allow_pickle=False) as stored:
        field = stored["field"].astype(np.float32)
        field /= field.sum(axis=-1, keepdims=True)
        return Rig(
            names=tuple(str(name) for name in stored["names"]),
            parents=tuple(int(parent) for parent in stored["parents"]),
            joints=read_only(stored["joints"].astype(np.float64)),
            axes=(
                read_only(stored["x"].astype(np.float64)),
                read_only(stored["y"].astype(np.float64)),
                read_only(stored["z"].astype(np.float64)),
            ),
            field=read_only(field),
        )

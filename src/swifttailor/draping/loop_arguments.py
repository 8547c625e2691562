"""What the compiled loops are told of body and time: tuples of arrays and numbers."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

FRAME_RATE = 60.0
GRAVITY = 981.0


class FieldArrays(NamedTuple):
    """Distance fields of the body for the solver (see `swifttailor.body.DistanceField`)."""

    full: np.ndarray
    """(nx, ny, nz) float32, cm, the whole body."""
    armless: np.ndarray
    """The same without arms, for vertices of panels that cover the legs."""
    origin: np.ndarray
    """(3,) of both fields, cm."""
    spacing: float
    ignores_arms: np.ndarray
    """(v,) uint8"""


class HeldArrays(NamedTuple):
    """Vertices that may not slide down."""

    vertices: np.ndarray
    """(k,)"""
    levels: np.ndarray
    """(k,) lowest height of each, cm."""


class StepSettings(NamedTuple):
    """Numbers of one frame."""

    substeps: int
    step: float
    """Substep length, s."""
    gravity: float
    """cm/s^2"""
    damping: float
    """Velocity decay, 1/s."""
    friction: float
    thickness: float
    """Distance kept from the body, cm."""
    max_speed: float
    """cm/s"""
    bending_factor: float
    """Multiplies the bending stiffness (the sewing stage keeps panels flat)."""
    lowest_level: float
    """Below this height the body is continued straight down, cm."""
    long_edges: bool
    """Whether stretched edges are also held off the body between their vertices."""
    self_collision: bool
    untangling: float
    """Largest motion of a crossing edge against the face per substep, cm."""
    contact_interval: int
    """Substeps between searches for contacts."""
    still: float
    """A vertex that moves less than this per frame is at rest, cm."""


class CoarseWork(NamedTuple):
    """What the coarse drape works with besides positions; all but velocities is overwritten."""

    v: np.ndarray
    """(n, 3) velocities, cm/s."""
    previous: np.ndarray
    """(n, 3) positions before a substep, cm."""
    clearance: np.ndarray
    """(n,) how far a vertex may move before it can touch the body, cm."""
    shares: np.ndarray
    """(e,) see `spring_shares`."""
    pulls: np.ndarray
    """(h, 4) see `hinge_pulls`."""
    initial: np.ndarray
    """(e,) lengths of the edges in the beginning, cm."""


class ContactArrays(NamedTuple):
    """Buffers for self-collision, filled and emptied by the kernels."""

    vertex: np.ndarray
    face: np.ndarray
    side: np.ndarray
    crossing_edge: np.ndarray
    crossing_face: np.ndarray
    crossing_push: np.ndarray
    """(k, 3) direction in which the edge has to move."""
    tangled: np.ndarray
    """(v,) uint8, vertices next to a crossing."""


def coarse_work(vertices: int, edges: int, hinges: int) -> CoarseWork:
    """At rest."""
    return CoarseWork(
        v=np.zeros((vertices, 3)),
        previous=np.zeros((vertices, 3)),
        clearance=np.zeros(vertices),
        shares=np.zeros(edges),
        pulls=np.zeros((hinges, 4)),
        initial=np.zeros(edges),
    )

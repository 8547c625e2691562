"""The inner loops of the XPBD cloth solver, compiled by numba.

M. Macklin, M. Mueller, N. Chentanez, "XPBD: position-based simulation of compliant constrained dynamics",
2016, in the small-substep form of "Small steps in physics simulation", 2019: one sweep over all constraints
per substep. Lengths in cm, masses in kg, times in s.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numba import njit

from swifttailor.draping.contact_kernels import (
    FAST,
    find_contacts,
    find_crossings,
    has_moved,
    list_neighbors,
    resolve_contacts,
    shrink_crossings,
)

ON_BODY, NEAR_BODY = 0.3, 1.2
"""Edges are held off the body when one end is nearer to contact than the first and the other than the second,
cm."""
EDGE_DISTANCE = 0.15
"""Distance from the body kept by edges between their ends, cm."""


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


@njit(**FAST)
def sample_field(values, origin, spacing, x, y, z):
    """Distance and unit gradient by trilinear interpolation; far outside, a large distance."""
    fx = (x - origin[0]) / spacing
    fy = (y - origin[1]) / spacing
    fz = (z - origin[2]) / spacing
    if fy < 0.0:
        fy = 0.0
    nx, ny, nz = values.shape
    i, j, k = math.floor(fx), math.floor(fy), math.floor(fz)
    if i < 0 or k < 0 or i >= nx - 1 or j >= ny - 1 or k >= nz - 1:
        return 1e3, 0.0, 0.0, 0.0
    u, v, w = fx - i, fy - j, fz - k
    c000, c001 = values[i, j, k], values[i, j, k + 1]
    c010, c011 = values[i, j + 1, k], values[i, j + 1, k + 1]
    c100, c101 = values[i + 1, j, k], values[i + 1, j, k + 1]
    c110, c111 = values[i + 1, j + 1, k], values[i + 1, j + 1, k + 1]
    a00, a10 = c000 + u * (c100 - c000), c010 + u * (c110 - c010)
    a01, a11 = c001 + u * (c101 - c001), c011 + u * (c111 - c011)
    b0, b1 = a00 + v * (a10 - a00), a01 + v * (a11 - a01)
    gx = ((c100 - c000) * (1 - v) + (c110 - c010) * v) * (1 - w) + (
        (c101 - c001) * (1 - v) + (c111 - c011) * v
    ) * w
    gy = (a10 - a00) * (1 - w) + (a11 - a01) * w
    gz = b1 - b0
    norm = math.sqrt(gx * gx + gy * gy + gz * gz) + 1e-12
    return b0 + w * (b1 - b0), gx / norm, gy / norm, gz / norm


@njit(**FAST)
def body_distance(field, a, b, x, y, z, lowest):
    """Distance to the part of the body that vertices a and b (equal for one vertex) may touch."""
    if y < lowest:
        y = lowest
    if field.ignores_arms[a] == 1 and field.ignores_arms[b] == 1:
        return sample_field(field.armless, field.origin, field.spacing, x, y, z)
    return sample_field(field.full, field.origin, field.spacing, x, y, z)


@njit(**FAST)
def predict(x, v, previous, settings):
    """Moves every vertex by its damped velocity and gravity; remembers where it was."""
    keep = math.exp(-settings.damping * settings.step)
    dt = settings.step
    for i in range(x.shape[0]):
        vx = v[i, 0] * keep
        vy = (v[i, 1] - settings.gravity * dt) * keep
        vz = v[i, 2] * keep
        speed = math.sqrt(vx * vx + vy * vy + vz * vz)
        if speed > settings.max_speed:
            r = settings.max_speed / speed
            vx *= r
            vy *= r
            vz *= r
        previous[i, 0], previous[i, 1], previous[i, 2] = x[i, 0], x[i, 1], x[i, 2]
        x[i, 0] += vx * dt
        x[i, 1] += vy * dt
        x[i, 2] += vz * dt


@njit(**FAST)
def solve_springs(x, cloth, inverse_dt2):
    """One Gauss-Seidel sweep, always in the same order: alternating it never comes to rest."""
    edges, rest, compliance, im = cloth.edges, cloth.rest, cloth.compliance, cloth.inverse_mass
    for e in range(edges.shape[0]):
        a, b = edges[e, 0], edges[e, 1]
        dx, dy, dz = x[b, 0] - x[a, 0], x[b, 1] - x[a, 1], x[b, 2] - x[a, 2]
        length = math.sqrt(dx * dx + dy * dy + dz * dz) + 1e-12
        s = (length - rest[e]) / ((im[a] + im[b] + compliance[e] * inverse_dt2) * length)
        wa, wb = s * im[a], s * im[b]
        x[a, 0] += wa * dx
        x[a, 1] += wa * dy
        x[a, 2] += wa * dz
        x[b, 0] -= wb * dx
        x[b, 1] -= wb * dy
        x[b, 2] -= wb * dz


@njit(**FAST)
def solve_hinges(x, cloth, inverse_dt2, factor):
    """Pulls every pair of neighbouring triangles towards the plane."""
    hinges, weights, im = cloth.hinges, cloth.hinge_weights, cloth.inverse_mass
    for e in range(hinges.shape[0]):
        a, b, c, d = hinges[e, 0], hinges[e, 1], hinges[e, 2], hinges[e, 3]
        wa, wb, wc, wd = weights[e, 0], weights[e, 1], weights[e, 2], weights[e, 3]
        dx = wa * x[a, 0] + wb * x[b, 0] + wc * x[c, 0] + wd * x[d, 0]
        dy = wa * x[a, 1] + wb * x[b, 1] + wc * x[c, 1] + wd * x[d, 1]
        dz = wa * x[a, 2] + wb * x[b, 2] + wc * x[c, 2] + wd * x[d, 2]
        total = im[a] * wa * wa + im[b] * wb * wb + im[c] * wc * wc + im[d] * wd * wd
        s = -1.0 / (total + cloth.hinge_compliance[e] * inverse_dt2 / factor)
        t = s * im[a] * wa
        x[a, 0] += t * dx
        x[a, 1] += t * dy
        x[a, 2] += t * dz
        t = s * im[b] * wb
        x[b, 0] += t * dx
        x[b, 1] += t * dy
        x[b, 2] += t * dz
        t = s * im[c] * wc
        x[c, 0] += t * dx
        x[c, 1] += t * dy
        x[c, 2] += t * dz
        t = s * im[d] * wd
        x[d, 0] += t * dx
        x[d, 1] += t * dy
        x[d, 2] += t * dz


@njit(**FAST)
def hold_up(x, held, inverse_dt2, inverse_mass):
    """Keeps held vertices from sliding below their level (a waistband, a strapless top)."""
    for q in range(held.vertices.shape[0]):
        i = held.vertices[q]
        gap = held.levels[q] - x[i, 1]
        if gap > 0:
            x[i, 1] += gap * inverse_mass[i] / (inverse_mass[i] + 1e-3 * inverse_dt2)


@njit(**FAST)
def push_long_edges(x, cloth, field, settings):
    """Holds stretched edges off the body between their vertices, sampled every 1.5 cm.

    Without it an arm or a leg slips through the 20 cm triangles that bridge two panels before they meet.
    """
    edges = cloth.edges
    for e in range(edges.shape[0]):
        a, b = edges[e, 0], edges[e, 1]
        dx, dy, dz = x[b, 0] - x[a, 0], x[b, 1] - x[a, 1], x[b, 2] - x[a, 2]
        length = math.sqrt(dx * dx + dy * dy + dz * dz)
        if length < 3.0:
            continue
        count = min(int(length / 1.5), 200)
        for q in range(1, count):
            t = q / count
            px = x[a, 0] + t * (x[b, 0] - x[a, 0])
            py = x[a, 1] + t * (x[b, 1] - x[a, 1])
            pz = x[a, 2] + t * (x[b, 2] - x[a, 2])
            d, nx, ny, nz = body_distance(field, a, b, px, py, pz, settings.lowest_level)
            depth = settings.thickness - d
            if depth > 0:
                depth = min(depth, 1.0) / ((1 - t) * (1 - t) + t * t)
                x[a, 0] += depth * (1 - t) * nx
                x[a, 1] += depth * (1 - t) * ny
                x[a, 2] += depth * (1 - t) * nz
                x[b, 0] += depth * t * nx
                x[b, 1] += depth * t * ny
                x[b, 2] += depth * t * nz


@njit(**FAST)
def push_edges_off_body(x, previous, cloth, field, clearance, settings):
    """Keeps edges outside the body between their ends, where it is more curved than the mesh.

    Looked at in three places, and only where an end lies on the body and the other is not far from it.
    Like all lifting, this is no velocity.
    """
    edges = cloth.edges
    for e in range(edges.shape[0]):
        a, b = edges[e, 0], edges[e, 1]
        near, far = clearance[a], clearance[b]
        if near > far:
            near, far = far, near
        if near > ON_BODY or far > NEAR_BODY:
            continue
        for q in range(1, 4):
            t = 0.25 * q
            px = x[a, 0] + t * (x[b, 0] - x[a, 0])
            py = x[a, 1] + t * (x[b, 1] - x[a, 1])
            pz = x[a, 2] + t * (x[b, 2] - x[a, 2])
            d, nx, ny, nz = body_distance(field, a, b, px, py, pz, settings.lowest_level)
            depth = EDGE_DISTANCE - d
            if depth > 0:
                depth = min(depth, 0.1)
                for i in (a, b):
                    x[i, 0] += depth * nx
                    x[i, 1] += depth * ny
                    x[i, 2] += depth * nz
                    previous[i, 0] += depth * nx
                    previous[i, 1] += depth * ny
                    previous[i, 2] += depth * nz


@njit(**FAST)
def push_off_body(x, previous, field, clearance, settings):
    """Moves vertices to the surface and takes their sliding back as far as Coulomb friction allows.

    A distance changes by no more than the vertex moves, so a vertex is looked at again only when it has
    moved as far as it was away (``clearance``, per vertex, cm).
    """
    for i in range(x.shape[0]):
        if clearance[i] > 0:
            dx, dy, dz = x[i, 0] - previous[i, 0], x[i, 1] - previous[i, 1], x[i, 2] - previous[i, 2]
            clearance[i] -= math.sqrt(dx * dx + dy * dy + dz * dz)
            if clearance[i] > 0:
                continue
        d, nx, ny, nz = body_distance(field, i, i, x[i, 0], x[i, 1], x[i, 2], settings.lowest_level)
        depth = settings.thickness - d
        clearance[i] = -depth if d < 900.0 else 0.0
        if depth <= 0:
            continue
        depth = min(depth, 1.0)  # a vertex deep inside comes out over several substeps
        dx, dy, dz = x[i, 0] - previous[i, 0], x[i, 1] - previous[i, 1], x[i, 2] - previous[i, 2]
        along = dx * nx + dy * ny + dz * nz
        tx, ty, tz = dx - along * nx, dy - along * ny, dz - along * nz
        x[i, 0] += depth * nx
        x[i, 1] += depth * ny
        x[i, 2] += depth * nz
        # The push stops the approach but must not throw the vertex off: the rest of it is no velocity.
        lift = depth - max(-along, 0.0)
        if lift > 0:
            previous[i, 0] += lift * nx
            previous[i, 1] += lift * ny
            previous[i, 2] += lift * nz
        slide = math.sqrt(tx * tx + ty * ty + tz * tz) + 1e-15
        r = min(settings.friction * depth / slide, 1.0)
        x[i, 0] -= r * tx
        x[i, 1] -= r * ty
        x[i, 2] -= r * tz


@njit(**FAST)
def advance_frame(x, v, cloth, field, held, contacts, lists, clearance, settings):
    """Advances positions x and velocities v (both (n, 3), changed in place) by one frame.

    Returns:
        The share of vertices that moved more than ``settings.still`` (sum of absolute components), the
        number of contacts and of edges that cross a face at the last search, and the neighbour lists for
        the next frame.
    """
    n = x.shape[0]
    start = x.copy()
    previous = x.copy()
    inverse_dt2 = 1.0 / (settings.step * settings.step)
    contact_count, crossing_count = 0, 0
    for s in range(settings.substeps):
        if settings.self_collision and s % settings.contact_interval == 0:
            if has_moved(x, cloth, lists):
                lists = list_neighbors(x, cloth, lists)
            if s % (2 * settings.contact_interval) == 0:
                crossing_count = find_crossings(x, cloth, contacts, lists)
            contact_count = find_contacts(x, cloth, contacts, lists)
        predict(x, v, previous, settings)
        solve_springs(x, cloth, inverse_dt2)
        solve_hinges(x, cloth, inverse_dt2, settings.bending_factor)
        hold_up(x, held, inverse_dt2, cloth.inverse_mass)
        if settings.self_collision:
            resolve_contacts(x, previous, cloth, contacts, contact_count)
            shrink_crossings(x, previous, cloth, contacts, crossing_count, settings.untangling)
        if settings.long_edges and s % 2 == 0:
            push_long_edges(x, cloth, field, settings)
        push_off_body(x, previous, field, clearance, settings)
        # The last substep is among them, so that a frame ends with edges clear of the body.
        if not settings.long_edges and (settings.substeps - 1 - s) % settings.contact_interval == 0:
            push_edges_off_body(x, previous, cloth, field, clearance, settings)
        for i in range(n):
            v[i, 0] = (x[i, 0] - previous[i, 0]) / settings.step
            v[i, 1] = (x[i, 1] - previous[i, 1]) / settings.step
            v[i, 2] = (x[i, 2] - previous[i, 2]) / settings.step
    moving = 0
    for i in range(n):
        moved = abs(x[i, 0] - start[i, 0]) + abs(x[i, 1] - start[i, 1]) + abs(x[i, 2] - start[i, 2])
        if moved > settings.still:
            moving += 1
    return moving / n, contact_count, crossing_count, lists

"""The inner loops of the XPBD cloth solver, compiled by numba.

M. Macklin, M. Mueller, N. Chentanez, "XPBD: position-based simulation of compliant constrained dynamics",
2016, in the small-substep form of "Small steps in physics simulation", 2019: one sweep over all constraints
per substep. Lengths in cm, masses in kg, times in s.
"""

from __future__ import annotations

import math

import numpy as np
from numba import njit

from swifttailor.draping.compile_options import FAST
from swifttailor.draping.contact_kernels import (
    find_contacts,
    find_crossings,
    resolve_contacts,
    shrink_crossings,
)
from swifttailor.draping.field_kernels import body_distance, sample_distance, sample_field
from swifttailor.draping.loop_arguments import ContactArrays, HeldArrays, StepSettings
from swifttailor.draping.neighbor_lists import has_moved, list_neighbors

# numba reads what an older version has compiled before it finds it out of date; there they are named so.
__all__ = ["ContactArrays", "HeldArrays", "StepSettings", "advance_frame"]

ON_BODY, NEAR_BODY = 0.3, 1.2
"""Edges are held off the body when one end is nearer to contact than the first and the other than the second,
cm."""
EDGE_DISTANCE = 0.15
"""Distance from the body kept by edges between their ends, cm."""


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
def spring_shares(cloth, inverse_dt2):
    """(e,) share of a spring's error that a unit of inverse mass takes: divisions done once for all."""
    shares = np.zeros(cloth.edges.shape[0])
    find_spring_shares(shares, cloth, inverse_dt2)
    return shares


@njit(**FAST)
def find_spring_shares(shares, cloth, inverse_dt2):
    """Fills the `spring_shares`."""
    edges, compliance, im = cloth.edges, cloth.compliance, cloth.inverse_mass
    for e in range(edges.shape[0]):
        shares[e] = 1.0 / (im[edges[e, 0]] + im[edges[e, 1]] + compliance[e] * inverse_dt2)


@njit(**FAST)
def hinge_pulls(cloth, inverse_dt2, factor):
    """(h, 4) how far each vertex of a hinge moves for a unit of bending; `factor` times as stiff."""
    pulls = np.zeros(cloth.hinge_weights.shape)
    find_hinge_pulls(pulls, cloth, inverse_dt2, factor)
    return pulls


@njit(**FAST)
def find_hinge_pulls(pulls, cloth, inverse_dt2, factor):
    """Fills the `hinge_pulls`."""
    hinges, weights, im = cloth.hinges, cloth.hinge_weights, cloth.inverse_mass
    for e in range(hinges.shape[0]):
        total = cloth.hinge_compliance[e] * inverse_dt2 / factor
        for k in range(4):
            total += im[hinges[e, k]] * weights[e, k] * weights[e, k]
        for k in range(4):
            pulls[e, k] = -im[hinges[e, k]] * weights[e, k] / total


@njit(**FAST)
def solve_springs(x, cloth, shares):
    """One Gauss-Seidel sweep, always in the same order: alternating it never comes to rest."""
    edges, rest, im = cloth.edges, cloth.rest, cloth.inverse_mass
    for e in range(edges.shape[0]):
        a, b = edges[e, 0], edges[e, 1]
        dx, dy, dz = x[b, 0] - x[a, 0], x[b, 1] - x[a, 1], x[b, 2] - x[a, 2]
        length = math.sqrt(dx * dx + dy * dy + dz * dz) + 1e-12
        s = (length - rest[e]) * shares[e] / length
        wa, wb = s * im[a], s * im[b]
        x[a, 0] += wa * dx
        x[a, 1] += wa * dy
        x[a, 2] += wa * dz
        x[b, 0] -= wb * dx
        x[b, 1] -= wb * dy
        x[b, 2] -= wb * dz


@njit(**FAST)
def solve_hinges(x, cloth, pulls):
    """Pulls every pair of neighbouring triangles towards the plane."""
    hinges, weights = cloth.hinges, cloth.hinge_weights
    for e in range(hinges.shape[0]):
        a, b, c, d = hinges[e, 0], hinges[e, 1], hinges[e, 2], hinges[e, 3]
        wa, wb, wc, wd = weights[e, 0], weights[e, 1], weights[e, 2], weights[e, 3]
        pa, pb, pc, pd = pulls[e, 0], pulls[e, 1], pulls[e, 2], pulls[e, 3]
        dx = wa * x[a, 0] + wb * x[b, 0] + wc * x[c, 0] + wd * x[d, 0]
        dy = wa * x[a, 1] + wb * x[b, 1] + wc * x[c, 1] + wd * x[d, 1]
        dz = wa * x[a, 2] + wb * x[b, 2] + wc * x[c, 2] + wd * x[d, 2]
        x[a, 0] += pa * dx
        x[a, 1] += pa * dy
        x[a, 2] += pa * dz
        x[b, 0] += pb * dx
        x[b, 1] += pb * dy
        x[b, 2] += pb * dz
        x[c, 0] += pc * dx
        x[c, 1] += pc * dy
        x[c, 2] += pc * dz
        x[d, 0] += pd * dx
        x[d, 1] += pd * dy
        x[d, 2] += pd * dz


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
        values = field.full
        if field.ignores_arms[a] == 1 and field.ignores_arms[b] == 1:
            values = field.armless
        for q in range(1, 4):
            t = 0.25 * q
            px = x[a, 0] + t * (x[b, 0] - x[a, 0])
            py = x[a, 1] + t * (x[b, 1] - x[a, 1])
            pz = x[a, 2] + t * (x[b, 2] - x[a, 2])
            py = max(py, settings.lowest_level)
            # Most are clear of the body, so the gradient is worked out only for those that are not.
            if sample_distance(values, field.origin, field.spacing, px, py, pz) >= EDGE_DISTANCE:
                continue
            d, nx, ny, nz = sample_field(values, field.origin, field.spacing, px, py, pz)
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
    shares, pulls = (
        spring_shares(cloth, inverse_dt2),
        hinge_pulls(cloth, inverse_dt2, settings.bending_factor),
    )
    contact_count, crossing_count = 0, 0
    for s in range(settings.substeps):
        if settings.self_collision and s % settings.contact_interval == 0:
            if has_moved(x, lists):
                lists = list_neighbors(x, v, cloth, lists)
            if s % (2 * settings.contact_interval) == 0:
                crossing_count = find_crossings(x, cloth, contacts, lists)
            contact_count = find_contacts(x, cloth, contacts, lists)
        predict(x, v, previous, settings)
        solve_springs(x, cloth, shares)
        solve_hinges(x, cloth, pulls)
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

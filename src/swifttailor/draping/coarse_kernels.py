"""A garment sewn and hung in one go on a coarse mesh, compiled by numba: no self-collision."""

from __future__ import annotations

import math

import numpy as np
from numba import njit

from swifttailor.draping.compile_options import FAST
from swifttailor.draping.xpbd_kernels import (
    find_hinge_pulls,
    find_spring_shares,
    hold_up,
    predict,
    push_edges_off_body,
    push_long_edges,
    push_off_body,
    solve_hinges,
    solve_springs,
)


@njit(**FAST)
def advance_freely(x, cloth, field, held, settings, work):
    """Advances positions x (n, 3) and velocities by one frame, in place; `work` is a `CoarseWork`."""
    v, previous, clearance, shares, pulls = work.v, work.previous, work.clearance, work.shares, work.pulls
    inverse_dt2 = 1.0 / (settings.step * settings.step)
    find_spring_shares(shares, cloth, inverse_dt2)
    bends = settings.bending_factor > 0.0
    if bends:
        find_hinge_pulls(pulls, cloth, inverse_dt2, settings.bending_factor)
    for s in range(settings.substeps):
        predict(x, v, previous, settings)
        solve_springs(x, cloth, shares)
        if bends:
            solve_hinges(x, cloth, pulls)
        hold_up(x, held, inverse_dt2, cloth.inverse_mass)
        if settings.long_edges and s % 4 == 0:
            push_long_edges(x, cloth, field, settings)
        push_off_body(x, previous, field, clearance, settings)
        if not settings.long_edges and (settings.substeps - 1 - s) % settings.contact_interval == 0:
            push_edges_off_body(x, previous, cloth, field, clearance, settings)
        for i in range(x.shape[0]):
            v[i, 0] = (x[i, 0] - previous[i, 0]) / settings.step
            v[i, 1] = (x[i, 1] - previous[i, 1]) / settings.step
            v[i, 2] = (x[i, 2] - previous[i, 2]) / settings.step


@njit(**FAST)
def sew_and_hang(x, cloth, rest, field, held, at_first, frames, sewing, catching, hanging, work):
    """Moves x (n, 3) from the placed panels to about where the garment comes to rest.

    Args:
        x: Changed in place.
        cloth: Its rest lengths are overwritten.
        rest: (e,) true rest lengths.
        field: Of the body.
        held: Its levels are overwritten.
        at_first: (k,) held vertices that are let go half-way.
        frames: Numbers of frames: while seams close, then calming, then hanging with long edges watched,
            then hanging without.
        sewing: Settings of the first two.
        catching: Of the third.
        hanging: Of the fourth.
        work: A `CoarseWork`.
    """
    edges, initial, clearance = cloth.edges, work.initial, work.clearance
    for e in range(edges.shape[0]):
        a, b = edges[e, 0], edges[e, 1]
        dx, dy, dz = x[a, 0] - x[b, 0], x[a, 1] - x[b, 1], x[a, 2] - x[b, 2]
        initial[e] = math.sqrt(dx * dx + dy * dy + dz * dz)
    closing, calming, caught, free = frames
    for f in range(closing + calming):
        share = min(1.0, (f + 1) / closing)
        for e in range(edges.shape[0]):
            cloth.rest[e] = max(rest[e], initial[e] * (1 - share) + rest[e] * share)
        clearance[:] = 0.0
        advance_freely(x, cloth, field, held, sewing, work)
    for q in range(held.vertices.shape[0]):
        held.levels[q] = min(held.levels[q], x[held.vertices[q], 1])
    for f in range(caught + free):
        if f == (caught + free) // 2:
            for q in range(held.vertices.shape[0]):
                if at_first[q]:
                    held.levels[q] = -np.inf
        clearance[:] = 0.0
        advance_freely(x, cloth, field, held, catching if f < caught else hanging, work)

"""Wide sleeves that were predicted crumpled, laid around the arm: arms come through the cloth of them else.

The network has seen few of them. A sleeve is laid over the upper side of the arm, and what is left hangs
down before and behind it to the seam below, as long and as wide as it was cut.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Bools, Floats
from swifttailor.body import Body
from swifttailor.body.parts import BodyPart
from swifttailor.garment_sewer.crumpling import is_crumpled
from swifttailor.garment_sewer.pixels.rest_shape import rest_shape
from swifttailor.panel_mesh.pattern_mesh import PatternMesh

LAID_CM, _FADE_CM = 6.0, 10.0
"""So far below the underarm a sleeve begins to be laid, and over so much more it is laid more and more."""
WIDE = 1.5
"""Sleeves are wide whose ends are so many times as wide as the arm is there."""
CRUMPLED_SLEEVE = 0.08
"""Share of crumpled cloth from which a wide sleeve is laid."""
_OFF_ARM_CM = 0.8
_SLICE_CM, _LEAST_POINTS = 2.0, 6
_NAMES = ("sleeve_f", "sleeve_b")


@dataclass(frozen=True)
class _Arm:
    """An arm: where its axis is, and how thick it is around that."""

    along: Floats
    """(3,) unit vector down the arm."""
    up: Floats
    """(3,) unit vector across it, upward."""
    stations: Floats
    """(k,) places along it, cm."""
    middles: Floats
    """(k, 3) on its axis, cm."""
    radii: Floats
    """(k,) cm."""

    @staticmethod
    def of(body: Body, part: BodyPart) -> _Arm:
        points = body.vertices[body.vertex_part == part].astype(float)
        along = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2][0]
        along = along if along[1] < 0 else -along
        up = np.array([0.0, 1.0, 0.0]) - along[1] * along
        up /= np.linalg.norm(up)
        at = points @ along
        rows = np.arange(at.min() + _SLICE_CM, at.max(), _SLICE_CM)
        slices = [points[np.abs(at - row) < _SLICE_CM] for row in rows]
        kept = [(row, one) for row, one in zip(rows, slices, strict=True) if len(one) >= _LEAST_POINTS]
        middles = np.array([one.mean(axis=0) for _, one in kept])
        radii = [
            float(np.linalg.norm(_across(one - middle, along), axis=1).mean())
            for (_, one), middle in zip(kept, middles, strict=True)
        ]
        return _Arm(along, up, np.array([row for row, _ in kept]), middles, np.array(radii))

    def middle(self, at: Floats) -> Floats:
        """(n, 3) points of the axis at places along it, which may lie beyond the fingers."""
        found = np.stack([np.interp(at, self.stations, self.middles[:, k]) for k in range(3)], axis=1)
        return found + (at - found @ self.along)[:, None] * self.along

    def radius(self, at: Floats) -> Floats:
        """(n,) cm."""
        return np.interp(at, self.stations, self.radii)


def sleeves_laid(mesh: PatternMesh, vertices: Floats, body: Body) -> Floats | None:
    """A garment with its crumpled wide sleeves laid around the arms.

    Args:
        mesh: Of the garment.
        vertices: (v, 3) where it lies, cm.
        body: What it is worn by.

    Returns:
        (v, 3) cm; None where it has no such sleeves.
    """
    crumpled, area = is_crumpled(mesh, vertices[mesh.weld]), rest_shape(mesh).area
    of_face = mesh.flat_panel[rest_shape(mesh).corners[:, 0]]
    laid = None
    for side, part in (("left", BodyPart.LEFT_ARM), ("right", BodyPart.RIGHT_ARM)):
        names = [f"{side}_{name}" for name in _NAMES]
        panels = [k for k, panel in enumerate(mesh.pattern.panels) if panel.name in names]
        own = np.isin(of_face, panels)
        if len(panels) != len(_NAMES) or area[own & crumpled].sum() < CRUMPLED_SLEEVE * area[own].sum():
            continue
        found = _laid(mesh, vertices if laid is None else laid, panels, _Arm.of(body, part))
        laid = laid if found is None else found
    return laid


def _laid(mesh: PatternMesh, vertices: Floats, panels: list[int], arm: _Arm) -> Floats | None:
    """One sleeve laid; None where it is not wide, or ends in a cuff."""
    flat = [np.flatnonzero(mesh.flat_panel == k) for k in panels]
    placed = [
        mesh.pattern.panels[k].placement.apply(mesh.flat_vertices[own])
        for k, own in zip(panels, flat, strict=True)
    ]
    every = np.concatenate(flat)
    station = np.concatenate(placed) @ arm.along
    if _goes_on(mesh, every, station):
        return None
    under = max(float((points @ arm.along)[_is_low(points, arm)].min()) for points in placed)
    upper = (station > under) & (station < under + LAID_CM + _FADE_CM)
    if not upper.any():
        return None
    moved_on = float(np.median((vertices[mesh.weld[every]] @ arm.along - station)[upper]))
    aside = np.cross(arm.along, arm.up)
    aside *= np.sign(aside[2])
    laid, end = [], 0.0
    for points in placed:
        at, height = points @ arm.along, points @ arm.up
        low, high = _edges_at(at, height)
        end += float((high - low)[at > at.max() - _SLICE_CM].mean())
        at = at + moved_on
        beside, above = _around(high - height, high - low, arm.radius(at) + _OFF_ARM_CM)
        beside *= np.sign(points[:, 2].mean())  # the front before the arm
        laid.append(arm.middle(at) + beside[:, None] * aside + above[:, None] * arm.up)
    if end < WIDE * 2 * math.pi * float(arm.radius(np.array([station.max() + moved_on]))[0]):
        return None
    own = mesh.weld[every]
    total, count, share = (
        np.zeros((mesh.vertex_count, 3)),
        np.zeros(mesh.vertex_count),
        np.zeros(len(vertices)),
    )
    np.add.at(total, own, np.concatenate(laid))
    np.add.at(count, own, 1.0)
    np.maximum.at(share, own, np.clip((station - under - LAID_CM) / _FADE_CM, 0.0, 1.0))
    mean = total / np.maximum(count, 1.0)[:, None]
    return vertices + share[:, None] * (mean - vertices)


def _around(from_top: Floats, wide: Floats, radius: Floats) -> tuple[Floats, Floats]:
    """Where cloth lies across an arm (n,): how far beside its axis, and how far above it, cm.

    Args:
        from_top: (n,) way from the seam on top, cm.
        wide: (n,) way from there to the seam below, cm.
        radius: (n,) of the arm, cm; of cloth that is narrower around it, its own counts.
    """
    radius = np.minimum(radius, wide / math.pi)
    quarter = 0.5 * math.pi * radius
    angle = np.minimum(from_top, quarter) / np.maximum(radius, 1e-6)
    hanging = np.maximum(wide - quarter, 1e-6)
    fall = np.sqrt(np.maximum(hanging**2 - radius**2, 0.0))
    share = np.clip((from_top - quarter) / hanging, 0.0, 1.0)
    on_arm = from_top <= quarter
    beside = np.where(on_arm, radius * np.sin(angle), (1.0 - share) * radius)
    return beside, np.where(on_arm, radius * np.cos(angle), -share * fall)


def _edges_at(station: Floats, height: Floats) -> tuple[Floats, Floats]:
    """(n,) the lowest and the highest that a panel is, flat, at each point's place along the arm, cm."""
    rows: NDArray[np.int64] = np.floor((station - station.min()) / _SLICE_CM).astype(np.int64)
    count = int(rows.max()) + 1
    low, high, at = np.full(count, np.inf), np.full(count, -np.inf), np.zeros(count)
    np.minimum.at(low, rows, height)
    np.maximum.at(high, rows, height)
    np.add.at(at, rows, station)
    filled = np.isfinite(low)
    at = at[filled] / np.bincount(rows, minlength=count)[filled]
    return np.interp(station, at, low[filled]), np.interp(station, at, high[filled])


def _is_low(points: Floats, arm: _Arm) -> Bools:
    """(n,) which points of a flat panel are near its lower seam."""
    height = points @ arm.up
    return np.asarray(height < height.min() + 0.25 * np.ptp(height))


def _goes_on(mesh: PatternMesh, own: NDArray[np.int64], station: Floats) -> bool:
    """Whether something is sewn to the end of the sleeve."""
    others = np.zeros(mesh.vertex_count, dtype=bool)
    elsewhere = np.ones(len(mesh.flat_vertices), dtype=bool)
    elsewhere[own] = False
    others[mesh.weld[elsewhere]] = True
    ends = station > station.max() - 1.0
    return bool(others[mesh.weld[own[ends]]].any())


def _across(points: Floats, along: Floats) -> Floats:
    return points - (points @ along)[:, None] * along

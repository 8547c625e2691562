"""Garments as a GarmentSewer learns them: drawn once, then read from memory-mapped files."""

from __future__ import annotations

import zlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from scipy.ndimage import distance_transform_edt

from swifttailor.body import Body
from swifttailor.data.array_cache import ArrayCache, Arrays, name_with_code
from swifttailor.data.reader import SplitReader
from swifttailor.data.sample import Sample
from swifttailor.errors import InputError
from swifttailor.garment_sewer.conditioning import PriorKind
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance, panels_ignoring_arms
from swifttailor.garment_sewer.pixels.pixel_table import Array, PixelTable, mirror_partners, tabulate
from swifttailor.ggi import Layout, lay_out
from swifttailor.ggi.file import STEPS
from swifttailor.ggi.geometry import geometry_raster
from swifttailor.ggi.panel_cells import LayoutKind, lay_out_as
from swifttailor.ggi.panel_colors import PANEL_COLORS
from swifttailor.ggi.semantic import panel_type
from swifttailor.ggi.stitching import stitching_image

FORMAT = 2
COARSEST = 1.25
"""Further layouts of a garment are up to this much coarser than the finest possible."""
SIDE_POINTS = 64
"""Pixels that are kept of each side of a stitch for the stitching loss, evenly spread."""
_DISTANCE_STEP = 0.01
_PANEL_ARRAYS = (
    *("panel_origin", "panel_sign", "panel_cm", "panel_log_cm"),
    *("panel_axes", "panel_offset", "panel_normal", "panel_box"),
)


@dataclass(frozen=True, eq=False)
class SewerSample:
    """A garment to learn from: numpy arrays or torch tensors."""

    table: PixelTable
    target: Array
    """(n, 3) cm, where each pixel is in the drape."""
    edge_distance: Array
    """(n,) pixels to the nearest pixel of the contour, at most 255."""
    ignores_arms: Array
    """(p,) whether a panel passes through the arms."""
    sides: Array
    """(s, 2, `SIDE_POINTS`) index into the table of pixels along both sides of each stitch; -1 fills up."""

    def map(self, change: Callable[[Array], Array]) -> SewerSample:
        """This sample with all its arrays changed."""
        names = ("target", "edge_distance", "ignores_arms", "sides")
        arrays = {name: change(getattr(self, name)) for name in names}
        return replace(self, table=self.table.map(change), **arrays)


class SewerSamples:
    """The garments of a split, `layouts` images of each."""

    def __init__(
        self,
        reader: SplitReader,
        folder: Path | str,
        resolution: int,
        prior: PriorKind,
        layouts: int = 1,
        *,
        kind: LayoutKind = "packed",
    ) -> None:
        """Opens them; nothing is drawn yet.

        Args:
            reader: The split.
            folder: Where to keep what was drawn: about 0.8 MB an image at 256 pixels.
            resolution: Pixels along each side.
            prior: Of the conditioning.
            layouts: Images of each garment; see `SewerConfig.layouts`.
            kind: How panels lie in them.
        """
        self.reader = reader
        self.resolution = resolution
        self.kind: LayoutKind = kind
        self.caches = []
        for layout in range(layouts):
            of_kind = "" if kind == "packed" else f"-{kind}"
            stem = f"sewer{FORMAT}-{resolution}-{prior}{of_kind}-{layout}"
            rooms = ("garment_sewer/pixels", "ggi", "panel_mesh", "pattern", "body", "draping")
            name = name_with_code(stem, *rooms)
            compute = partial(draw, resolution=resolution, prior=prior, layout_number=layout, kind=kind)
            self.caches.append(ArrayCache(reader, folder, name, compute))

    def prepare(self, *, workers: int = 1) -> Iterator[tuple[int, int]]:
        """Draws what was not drawn yet; yields how many shards are done, and of how many."""
        for k, cache in enumerate(self.caches):
            for done, total in cache.prepare(workers=workers):
                yield done + k * total, len(self.caches) * total

    def __len__(self) -> int:
        return len(self.reader)

    def get(self, k: int, layout: int = 0) -> SewerSample:
        """Garment number k in one of its layouts."""
        return sample_from(self.caches[layout][k], self.resolution)


def draw(
    sample: Sample, resolution: int, prior: PriorKind, layout_number: int, kind: LayoutKind = "packed"
) -> Arrays:
    """A garment's arrays in few bytes: positions in 16 bits over their range, distances in 0.1 mm."""
    layout = choose_layout(sample, resolution, layout_number, kind)
    if len(layout.pattern.panels) > 256:
        raise InputError(
            f"Sample '{sample.id}' has {len(layout.pattern.panels)} panels; at most 256 are kept."
        )
    stitching = stitching_image(layout)
    body = BodyDistance.of(Body.default()) if prior != "none" else None
    table = tabulate(layout, prior, body, stitching=stitching)
    target = geometry_raster(layout, sample.mesh).values(sample.vertices)
    on_contour = layout.raster.spread(np.asarray(table.contour), False)
    # A panel's own outline is always nearer than another panel's.
    to_edge = distance_transform_edt(~on_contour) if on_contour.any() else np.full(on_contour.shape, 255.0)
    cell = np.stack([table.pixels % resolution, table.pixels // resolution], axis=1)
    panels = layout.pattern.panels
    types = np.array([panel_type(p.name, p.label) for p in panels], np.uint8)
    arrays = {
        "occupancy": np.packbits(layout.raster.occupancy),
        "panel": table.panel.astype(np.uint8),
        "point": np.round((table.point - cell) * 255).clip(0, 255).astype(np.uint8),
        "edge_distance": np.ceil(to_edge.ravel()[table.pixels]).clip(0, 255).astype(np.uint8),
        "partner": table.partner.astype(np.int32),
        "distance": np.round(table.distance / _DISTANCE_STEP).clip(-32768, 32767).astype(np.int16),
        "direction": np.round(table.direction * 127).astype(np.int8),
        "cm_per_pixel": np.array([layout.cm_per_pixel]),
        "panel_type": types,
        "mirror_type": types[mirror_partners(layout.pattern)],
        "ignores_arms": panels_ignoring_arms(layout.pattern),
        "side": np.searchsorted(layout.raster.pixels, stitching.pixels).astype(np.int32),
        "side_start": stitching.start,
    }
    for name in _PANEL_ARRAYS:
        arrays[name] = getattr(table, name)
    arrays["prior"], arrays["prior_range"] = _quantize(table.prior)
    arrays["target"], arrays["target_range"] = _quantize(target)
    return arrays


def choose_layout(sample: Sample, resolution: int, number: int, kind: LayoutKind = "packed") -> Layout:
    """The layout of a garment as at use (number 0), or one with a scale by chance, the same every time.

    Panels in cells of their own have no scale to choose: only number 0 is theirs.
    """
    layout = lay_out_as(kind, sample.pattern, resolution)
    if number == 0 or kind != "packed":
        return layout
    chance = np.random.default_rng([zlib.crc32(sample.id.encode()), number])
    scale = layout.cm_per_pixel * chance.uniform(1.0, COARSEST)
    return lay_out(sample.pattern, resolution, cm_per_pixel=scale)


def sample_from(arrays: Arrays, resolution: int) -> SewerSample:
    """The sample that `draw` packed."""
    pixels = np.flatnonzero(np.unpackbits(arrays["occupancy"], count=resolution**2))
    cell = np.stack([pixels % resolution, pixels // resolution], axis=1)
    color = (PANEL_COLORS / 127.5 - 1).astype(np.float32)
    given: dict[str, Any] = {name: np.array(arrays[name]) for name in _PANEL_ARRAYS}
    table = PixelTable(
        resolution=resolution,
        cm_per_pixel=float(arrays["cm_per_pixel"][0]),
        pixels=pixels,
        panel=arrays["panel"].astype(np.int64),
        point=(cell + arrays["point"] / 255.0).astype(np.float32),
        contour=arrays["edge_distance"] == 0,
        partner=arrays["partner"].astype(np.int64),
        prior=_dequantize(arrays["prior"], arrays["prior_range"]),
        distance=arrays["distance"].astype(np.float32) * np.float32(_DISTANCE_STEP),
        direction=arrays["direction"].astype(np.float32) / np.float32(127),
        panel_color=color[arrays["panel_type"]],
        mirror_color=color[arrays["mirror_type"]],
        **given,
    )
    return SewerSample(
        table,
        _dequantize(arrays["target"], arrays["target_range"]),
        np.array(arrays["edge_distance"]),
        np.array(arrays["ignores_arms"]),
        _spread_sides(arrays["side"].astype(np.int64), arrays["side_start"].astype(np.int64)),
    )


def _spread_sides(slots: np.ndarray[Any, Any], start: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """(s, 2, `SIDE_POINTS`): of each side as many pixels, its first and last among them, as fit."""
    length = np.diff(start)
    step = np.arange(SIDE_POINTS)
    kept = np.minimum(length, SIDE_POINTS)[:, None]
    place = np.round(step * np.maximum(length - 1, 0)[:, None] / np.maximum(kept - 1, 1)).astype(np.int64)
    index = np.minimum(start[:-1, None] + place, max(len(slots) - 1, 0))
    sides = np.where(step < kept, slots[index] if len(slots) else -1, -1)
    return sides.reshape(-1, 2, SIDE_POINTS)


def _quantize(values: np.ndarray[Any, Any]) -> tuple[np.ndarray[Any, Any], np.ndarray[Any, Any]]:
    values = np.asarray(values, np.float64)
    low, high = values.min(axis=0), values.max(axis=0)
    step = np.maximum(high - low, 1e-9) / STEPS
    return np.round((values - low) / step).astype(np.uint16), np.stack([low, step])


def _dequantize(levels: np.ndarray[Any, Any], low_step: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    return (low_step[0] + low_step[1] * levels).astype(np.float32)

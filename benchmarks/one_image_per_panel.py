"""One square for all panels beside one image per panel: what drapes lose in each, and what each costs.

``python benchmarks/one_image_per_panel.py SPLIT [--limit 40] [--resolutions 128 256 512]``

SPLIT is a split of a data set; its drapes are drawn in both layouts (`swifttailor.ggi.panel_cells`) into as
many pixels, rounded to 16-bit floats within the box of their panel, and read back at the vertices of the
drape's own mesh. No network takes part. Means over garments of:

* error: distance of the welded vertices from where the drape has them, mean and 95th percentile of a
  garment; the mean also without rounding, and for the vertices of panels of less than a tenth of the largest
  panel's area, and for the others;
* seam gap: between vertices that a stitch joins, before seams are closed, median and 95th percentile of a
  garment;
* used: share of the pixels that show cloth;
* bytes: of three 16-bit numbers and a bit a pixel, with the layout; raw, and compressed by zip;
* time: processor milliseconds of one core, least of three runs, median of the garments: encode is layout,
  raster and values, decode the mesh's weights and positions.
"""

from __future__ import annotations

import argparse
import io
from dataclasses import dataclass, fields
from pathlib import Path

import numpy as np

from machine import describe
from swifttailor.data.reader import SplitReader
from swifttailor.data.sample import Sample
from swifttailor.evaluation.spread import spread
from swifttailor.garment_sewer.closing import seam_gaps
from swifttailor.ggi import Layout
from swifttailor.ggi.geometry import geometry_raster
from swifttailor.ggi.outline_decode import outline_sampler
from swifttailor.ggi.panel_cells import LAYOUT_KINDS, LayoutKind, lay_out_as
from timing import least

MM = 10.0
PANELS = ((1, 8), (9, 16), (17, 99))
"""Numbers of panels whose garments are also reported by themselves."""
SMALL = 0.1
"""Panels of less than this share of the largest one's area are counted as small."""


@dataclass(frozen=True, kw_only=True)
class Measured:
    """One garment in one layout; lengths in mm."""

    mean: float
    p95: float
    unrounded: float
    small: float
    """NaN where no panel is small."""
    large: float
    gap: float
    gap_p95: float
    used: float
    raw: float
    zipped: float
    encode: float
    decode: float


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("split", type=Path)
    parser.add_argument("--limit", type=int, default=40)
    parser.add_argument("--resolutions", type=int, nargs="+", default=[128, 256, 512])
    options = parser.parse_args()
    reader = SplitReader(options.split)
    samples = [reader[k] for k in spread(range(len(reader)), options.limit)]
    panels = [len(s.pattern.panels) for s in samples]
    print(describe())
    print(f"{len(samples)} drapes of {min(panels)} to {max(panels)} panels, median {np.median(panels):g}")
    columns = [f.name for f in fields(Measured)]
    print(" ".join(f"{text:>10}" for text in ("pixels", "layout", *columns)))
    for resolution in options.resolutions:
        found = {kind: [measure(sample, kind, resolution) for sample in samples] for kind in LAYOUT_KINDS}
        for kind, rows in found.items():
            print(f"{resolution:>10} {kind:>10} " + " ".join(f"{summary(rows, c):>10.4g}" for c in columns))
        for fewest, most in PANELS:
            chosen = [k for k, n in enumerate(panels) if fewest <= n <= most]
            if chosen:
                means = [np.mean([rows[k].mean for k in chosen]) for rows in found.values()]
                text = " / ".join(f"{m:.3f}" for m in means)
                print(f"{'':>10} {len(chosen)} of {fewest} to {most} panels: mean {text}")
        packed, cells = (np.array([r.mean for r in rows]) for rows in found.values())
        print(f"{'':>10} {np.sum(packed < cells)} of {len(packed)} nearer to the drape when packed")


def summary(rows: list[Measured], column: str) -> float:
    values = np.array([getattr(r, column) for r in rows])
    return float(np.median(values) if column in ("encode", "decode") else np.nanmean(values))


def measure(sample: Sample, kind: LayoutKind, resolution: int) -> Measured:
    """Draws a drape, rounds it, and reads it back."""
    encoding, (layout, values) = least(lambda: encode(sample, kind, resolution))
    rounded, boxes = round_in_boxes(layout, values)
    decoding, flat = least(lambda: outline_sampler(layout, sample.mesh).weights @ rounded)
    exact = outline_sampler(layout, sample.mesh).weights @ values
    error, unrounded = away(sample, flat), away(sample, exact)
    area = np.abs(layout.outlines.signed_area)
    small = np.zeros(sample.mesh.vertex_count, bool)
    small[sample.mesh.weld] = (area < SMALL * area.max())[sample.mesh.flat_panel]
    gaps = seam_gaps(sample.mesh, flat) * MM
    raw, zipped = sizes(layout, rounded, boxes)
    return Measured(
        mean=error.mean(),
        p95=float(np.percentile(error, 95)),
        unrounded=unrounded.mean(),
        small=error[small].mean() if small.any() else np.nan,
        large=error[~small].mean(),
        gap=float(np.median(gaps)),
        gap_p95=float(np.percentile(gaps, 95)),
        used=layout.raster.occupancy.mean(),
        raw=raw,
        zipped=zipped,
        encode=encoding * 1e3,
        decode=decoding * 1e3,
    )


def encode(sample: Sample, kind: LayoutKind, resolution: int) -> tuple[Layout, np.ndarray]:
    layout = lay_out_as(kind, sample.pattern, resolution)
    return layout, geometry_raster(layout, sample.mesh).values(sample.vertices)


def away(sample: Sample, flat: np.ndarray) -> np.ndarray:
    """(v,) mm from the drape."""
    return np.linalg.norm(sample.mesh.welded_mean(flat) - sample.vertices, axis=1) * MM


def round_in_boxes(layout: Layout, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Positions (n, 3) as 16-bit floats from -1 to 1 in their panel's box give back, and the boxes."""
    panel = layout.raster.pixel_panel.astype(np.int64)
    count = len(layout.pattern.panels)
    low, high = np.full((count, 3), np.inf), np.full((count, 3), -np.inf)
    np.minimum.at(low, panel, values)
    np.maximum.at(high, panel, values)
    middle, half = (low + high) / 2, np.maximum((high - low) / 2, 1e-6)
    stored = ((values - middle[panel]) / half[panel]).astype(np.float16)
    boxes = np.concatenate([middle, half], axis=1).astype(np.float32)
    return middle[panel] + stored.astype(np.float64) * half[panel], boxes


def sizes(layout: Layout, values: np.ndarray, boxes: np.ndarray) -> tuple[int, int]:
    """Bytes of the images and of what is needed to read them, raw and compressed."""
    panel = layout.raster.pixel_panel.astype(np.int64)
    stored = ((values - boxes[panel, :3]) / boxes[panel, 3:]).astype(np.float16)
    arrays = {
        "positions": layout.raster.spread(stored, 0.0),
        "occupancy": np.packbits(layout.raster.occupancy),
        "boxes": boxes,
        "origins": layout.origins.astype(np.float32),
        "cm_per_pixel": np.array([layout.cm_per_pixel], np.float32),
    }
    if layout.stretch is not None:
        arrays["stretch"] = layout.stretch.astype(np.float32)
    content = io.BytesIO()
    np.savez_compressed(content, **arrays)
    return sum(a.nbytes for a in arrays.values()), len(content.getvalue())


if __name__ == "__main__":
    main()

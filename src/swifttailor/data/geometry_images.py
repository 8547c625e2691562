"""The geometry images of a split, drawn once and then read at the speed of the disk."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from pathlib import Path

import numpy as np

from swifttailor.data.array_cache import ArrayCache, Arrays, name_with_code
from swifttailor.data.reader import SplitReader
from swifttailor.data.sample import Sample
from swifttailor.ggi import GarmentGeometryImage, encode
from swifttailor.ggi.file import dequantize, quantize
from swifttailor.ggi.stitching import StitchingImage


class GeometryImages:
    """The geometry images of a split at one resolution.

    Drawing takes about 35 ms a garment (most of it for the panel mesh), reading what was drawn about 1 ms.
    Positions are kept in 16 bits over each garment's own box.
    """

    def __init__(self, reader: SplitReader, folder: Path | str, resolution: int = 256) -> None:
        """Opens the images; nothing is drawn yet.

        Args:
            reader: The split.
            folder: Where to keep what was drawn: about 0.25 MB a garment at 256 pixels.
            resolution: Pixels along each side.
        """
        self.resolution = resolution
        name = name_with_code(f"images-{resolution}", "ggi", "panel_mesh", "pattern")
        self.cache = ArrayCache(reader, folder, name, partial(draw, resolution=resolution))

    def prepare(self, *, workers: int = 1) -> Iterator[tuple[int, int]]:
        """Draws what was not drawn yet; see `ArrayCache.prepare`."""
        return self.cache.prepare(workers=workers)

    def __len__(self) -> int:
        return len(self.cache)

    def __getitem__(self, k: int) -> GarmentGeometryImage:
        """The images of sample number k, without the layout (`lay_out` of its pattern gives that)."""
        return images_from(self.cache[k], self.resolution)


def draw(sample: Sample, resolution: int) -> Arrays:
    """The images of a sample as arrays that hold only what is needed to give them back."""
    images = encode(sample.garment, resolution)
    assert images.geometry is not None
    occupied = np.flatnonzero(images.occupancy)
    steps, low_step = quantize(images.geometry, images.occupancy)
    sewn = np.flatnonzero(images.stitching.ids)
    return {
        "occupancy": np.packbits(images.occupancy),
        "panel": images.panel.ravel()[occupied].astype(np.uint8),
        "semantic": images.semantic.ravel()[occupied],
        "geometry": steps.reshape(-1, 3)[occupied],
        "low_step": low_step,
        "sewn": sewn.astype(np.int32),
        "sewn_id": images.stitching.ids.ravel()[sewn],
        "seam_pixels": images.stitching.pixels,
        "seam_fraction": images.stitching.fraction,
        "seam_start": images.stitching.start,
    }


def images_from(arrays: Arrays, resolution: int) -> GarmentGeometryImage:
    """The images that `draw` took apart."""
    shape = resolution, resolution
    occupancy = np.unpackbits(arrays["occupancy"], count=resolution**2).view(np.bool_).reshape(shape)
    panel = np.full(shape, -1, np.int16)
    panel[occupancy] = arrays["panel"]
    semantic = np.zeros(shape, np.uint8)
    semantic[occupancy] = arrays["semantic"]
    steps = np.zeros((*shape, 3), np.uint16)
    steps[occupancy] = arrays["geometry"]
    ids = np.zeros(resolution**2, np.uint16)
    ids[arrays["sewn"]] = arrays["sewn_id"]
    stitching = StitchingImage(
        ids.reshape(shape), arrays["seam_pixels"], arrays["seam_fraction"], arrays["seam_start"]
    )
    geometry = dequantize(steps, arrays["low_step"], occupancy)
    return GarmentGeometryImage(None, occupancy, panel, semantic, stitching, geometry)

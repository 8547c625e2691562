"""Pictures: PNG, JPEG, WebP, GIF, BMP and TIFF."""

from __future__ import annotations

import io
from collections.abc import Sequence
from pathlib import Path
from random import Random

import numpy as np

from fuzzing.mutation.picture_mutations import mutate_picture
from fuzzing.target import Feed, File, Target

_KINDS = {
    ".png": ("RGB", "RGBA", "P", "L", "I;16", "1"),
    ".jpg": ("RGB", "L", "CMYK"),
    ".webp": ("RGB", "RGBA"),
    ".gif": ("P",),
    ".bmp": ("RGB", "P"),
    ".tif": ("RGB", "L", "I;16", "F", "CMYK"),
}
_FORMATS = {".png": "PNG", ".jpg": "JPEG", ".webp": "WEBP", ".gif": "GIF", ".bmp": "BMP", ".tif": "TIFF"}
_OPTIONS = {
    ".png": ({}, {"interlace": 1}),
    ".jpg": ({"quality": 60}, {"progressive": True}),
    ".webp": ({"lossless": True}, {"quality": 40}),
    ".tif": ({}, {"compression": "tiff_lzw"}, {"compression": "tiff_adobe_deflate"}),
}


def seeds() -> Sequence[File]:
    """Small pictures of every format and mode."""
    from PIL import Image

    down, across = np.mgrid[0:24, 0:32]
    colours = np.stack([across * 8, down * 10, (across * down) % 256], axis=-1).astype(np.uint8)
    files = []
    for ending, modes in _KINDS.items():
        for mode in modes:
            for options in _OPTIONS.get(ending, ({},)):
                if mode == "I;16":
                    image = Image.fromarray(colours[..., 2].astype(np.uint16) * 257)
                else:
                    image = Image.fromarray(colours).convert(mode)
                if options.get("compression") and mode in ("F", "CMYK"):
                    continue
                out = io.BytesIO()
                image.save(out, _FORMATS[ending], **options)
                files.append(File(out.getvalue(), ending))
    frames = [Image.fromarray(np.roll(colours, k, axis=0)) for k in range(3)]
    for ending in (".gif", ".webp", ".png"):
        out = io.BytesIO()
        frames[0].save(out, _FORMATS[ending], save_all=True, append_images=frames[1:])
        files.append(File(out.getvalue(), ending))
    return files


def mutate(file: File, random: Random) -> bytes:
    """Damage to chunks, segments, pixels or bytes."""
    return mutate_picture(file.data, random)


def _load_feed() -> Feed:
    from swifttailor.render.picture_file import LONGEST_SIDE, read_picture

    def feed(path: Path) -> None:
        pixels = read_picture(path)
        if pixels.dtype != np.uint8 or pixels.ndim != 3 or pixels.shape[2] != 3 or not pixels.size:
            raise AssertionError(f"{pixels.dtype} of shape {pixels.shape} is no picture")
        if max(pixels.shape[:2]) > LONGEST_SIDE:
            raise AssertionError(f"the picture is larger than promised: {pixels.shape}")

    return feed


TARGETS = (
    Target("picture", "PNG, JPEG, WebP, GIF, BMP, TIFF", seeds, mutate, _load_feed, 10.0, 1500, in_ci=1000),
)

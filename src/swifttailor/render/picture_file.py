"""Files of pictures, whatever is in them, as arrays."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Pixels
from swifttailor.errors import InputError

FORMATS = ("PNG", "JPEG", "WEBP", "BMP", "GIF", "TIFF")
MOST_PIXELS = 50_000_000
"""Of a file: what decoding them takes stays below a gigabyte."""
MOST_BYTES = 256 * 2**20
LONGEST_SIDE = 1024
"""Larger pictures are made smaller when they are read; networks see a fraction of that."""

_BACKDROPS = (255, 216, 138)
"""Greys behind what is transparent."""
_NEAR = 20
_FEW = 0.02
"""Share of the visible pixels that may be as light as the backdrop, within `_NEAR` levels."""


def read_picture(path: Path | str) -> Pixels:
    """A picture file as (h, w, 3) sRGB, upright, row 0 at the top, at most `LONGEST_SIDE` high and wide.

    Any mode is read: palettes, greys of 8 and 16 bits, CMYK; of several frames the first. What is transparent
    becomes white, or grey where the visible part is white itself.

    Raises:
        InputError: It is missing, damaged, too large or no picture.
    """
    from PIL import Image

    _require_file(path)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # Pillow's remarks about what it can read all the same
            warnings.simplefilter("error", Image.DecompressionBombWarning)
            with Image.open(path, formats=FORMATS) as opened:
                width, height = opened.size
                if width * height > MOST_PIXELS:
                    raise InputError(_too_large(path, f"{width} x {height} pixels"))
                opened.draft("RGB", (LONGEST_SIDE, LONGEST_SIDE))  # JPEG alone can be decoded smaller
                image = _with_alpha(_upright(opened))
    except InputError:
        raise
    except (Image.DecompressionBombWarning, Image.DecompressionBombError) as error:
        raise InputError(_too_large(path, f"more than {MOST_PIXELS:,} pixels")) from error
    except Exception as error:  # a damaged file ends wherever Pillow's readers happen to stumble
        raise InputError(
            f"'{path}' is not a readable picture ({error}). Give a {', '.join(FORMATS)} file."
        ) from error
    image.thumbnail((LONGEST_SIDE, LONGEST_SIDE), Image.Resampling.LANCZOS)
    return _on_backdrop(np.asarray(image))


def _require_file(path: Path | str) -> None:
    try:
        status = Path(path).stat()
        is_file = Path(path).is_file()
    except FileNotFoundError as error:
        raise InputError(f"There is no picture '{path}'.") from error
    except (OSError, ValueError) as error:  # ValueError: a name with a zero byte in it
        why = getattr(error, "strerror", None) or error
        raise InputError(f"Cannot read the picture {str(path)!r}: {why}.") from error
    if not is_file:
        raise InputError(f"'{path}' is not a file. Give a {', '.join(FORMATS)} file.")
    if status.st_size > MOST_BYTES:
        raise InputError(_too_large(path, f"{status.st_size / 2**20:.0f} MB"))


def _too_large(path: Path | str, size: str) -> str:
    return (
        f"The picture '{path}' is too large: {size}; {MOST_PIXELS:,} pixels and {MOST_BYTES // 2**20} MB are "
        f"accepted. Make it smaller; {LONGEST_SIDE} pixels along each side are plenty."
    )


def _upright(image: Any) -> Any:
    """As a camera held it, where the file says how."""
    from PIL import ImageOps

    image.load()
    try:
        return ImageOps.exif_transpose(image)
    except Exception:  # damaged EXIF data does not make a picture useless
        return image


def _with_alpha(image: Any) -> Any:
    """In mode RGBA."""
    from PIL import Image

    if image.mode.startswith(("I", "F")):
        return Image.fromarray(_eight_bits(np.asarray(image), image.mode)).convert("RGBA")
    if image.mode in ("CMYK", "YCbCr", "LAB", "HSV"):
        image = image.convert("RGB")
    return image.convert("RGBA")


def _eight_bits(values: NDArray[Any], mode: str) -> Pixels:
    """Greys of other kinds of numbers: 16 bits, or floating-point numbers up to 1, 255 or 65535."""
    values = np.nan_to_num(values.astype(np.float64))
    top = float(values.max(initial=0.0))
    if mode.startswith("I;16") or top > 255:
        full = 65535.0
    else:
        full = 1.0 if mode == "F" and top <= 1 else 255.0
    return np.round(values.clip(0, full) / full * 255).astype(np.uint8)


def _on_backdrop(image: Pixels) -> Pixels:
    """(h, w, 3) of a picture (h, w, 4), before the lightest grey that sets off what is visible."""
    alpha = image[..., 3:].astype(np.float32) / 255
    colors = image[..., :3].astype(np.float32)
    grey = _BACKDROPS[0]
    if alpha.min(initial=1.0) < 0.5:
        seen = colors[alpha[..., 0] > 0.5]
        merged = [
            float((np.abs(seen - g).max(axis=1) < _NEAR).mean()) if len(seen) else 0.0 for g in _BACKDROPS
        ]
        fit = [g for g, share in zip(_BACKDROPS, merged, strict=True) if share < _FEW]
        grey = fit[0] if fit else _BACKDROPS[int(np.argmin(merged))]
    return np.round(colors * alpha + grey * (1 - alpha)).astype(np.uint8)

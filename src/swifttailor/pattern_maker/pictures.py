"""Pictures as the network sees them."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.errors import InputError

_MEAN = np.array([0.485, 0.456, 0.406], np.float32)
_SPREAD = np.array([0.229, 0.224, 0.225], np.float32)
"""InternVL's, of ImageNet."""
FORMATS = ("PNG", "JPEG", "WEBP", "BMP", "GIF", "TIFF")


def picture_for_network(pixels: NDArray[np.uint8], size: int) -> NDArray[np.float32]:
    """A picture of any size as the network takes it: made square, resized, its colours normalised.

    Args:
        pixels: (h, w, 3) sRGB, row 0 at the top.
        size: Pixels along each side of the result; what a picture lacks to a square is filled with the
            middle colour of its border.

    Returns:
        (3, size, size).

    Raises:
        InputError: It is no picture of three colours.
    """
    from PIL import Image

    if pixels.ndim != 3 or pixels.shape[2] != 3 or min(pixels.shape) < 1 or pixels.dtype != np.uint8:
        raise InputError(f"A picture is (h, w, 3) of bytes; got {pixels.shape} of {pixels.dtype}.")
    height, width, _ = pixels.shape
    image: Any = Image.fromarray(pixels)
    if height != width:
        border = np.concatenate([pixels[0], pixels[-1], pixels[:, 0], pixels[:, -1]])
        side = max(height, width)
        fill = tuple(int(c) for c in np.median(border, axis=0))
        square = Image.new("RGB", (side, side), fill)
        square.paste(image, ((side - width) // 2, (side - height) // 2))
        image = square
    if image.size != (size, size):
        image = image.resize((size, size), Image.Resampling.BICUBIC)
    values = (np.asarray(image, np.float32) / 255 - _MEAN) / _SPREAD
    return np.ascontiguousarray(values.transpose(2, 0, 1), np.float32)


def read_picture(path: Path | str) -> NDArray[np.uint8]:
    """A picture file as (h, w, 3) sRGB, row 0 at the top; what is transparent becomes white.

    Raises:
        InputError: It is missing, damaged, too large or no picture.
    """
    from PIL import Image, ImageOps

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error", Image.DecompressionBombWarning)
            with Image.open(path, formats=FORMATS) as opened:
                image = ImageOps.exif_transpose(opened).convert("RGBA")
    except (Image.DecompressionBombWarning, Image.DecompressionBombError) as error:
        raise InputError(f"The picture '{path}' is too large: {error}. Give a smaller one.") from error
    except FileNotFoundError as error:
        raise InputError(f"There is no picture '{path}'.") from error
    except (OSError, ValueError, SyntaxError) as error:
        raise InputError(
            f"'{path}' is no picture that can be read ({error}). Give a {', '.join(FORMATS)} file."
        ) from error
    white = Image.new("RGBA", image.size, "white")
    return np.array(Image.alpha_composite(white, image).convert("RGB"))

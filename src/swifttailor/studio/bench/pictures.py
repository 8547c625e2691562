"""Tasks of pictures: taking them in, showing what is looked at."""

from __future__ import annotations

import tempfile
from pathlib import Path

from swifttailor.arrays import Pixels
from swifttailor.errors import InputError, NothingSeenError, SwiftTailorError
from swifttailor.render.picture_file import read_picture
from swifttailor.render.png import encode_png
from swifttailor.studio.bench.documents import Work
from swifttailor.studio.bench.tasks import tailor
from swifttailor.studio.worker.link import Link


def take_in(link: Link, *, content: bytes) -> Work:
    """A picture's pixels, upright and at most 1,024 pixels along each side, and a PNG of them."""
    with tempfile.TemporaryDirectory(prefix="swifttailor-studio-") as folder:
        path = Path(folder) / "picture"
        path.write_bytes(content)
        try:
            pixels = read_picture(path)
        except SwiftTailorError as error:
            raise InputError(
                str(error).replace(f"'{path}'", "that was uploaded").replace(str(path), "it")
            ) from None
    return Work((pixels, encode_png(pixels)))


def seen(link: Link, *, pixels: Pixels) -> Work:
    """A PNG of what is looked at in a picture: the garment set off, its panels named.

    Raises:
        NothingSeenError: No garment is seen.
    """
    from swifttailor.tailor.looking import parts_seen
    from swifttailor.tailor.seen_sheet import draw_seen

    picture = tailor().look(pixels)
    parts = parts_seen([picture])
    if not parts:
        raise NothingSeenError("No garment was found in the picture.")
    return Work(encode_png(draw_seen([picture], parts[0])))

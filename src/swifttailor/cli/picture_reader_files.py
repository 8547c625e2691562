"""Which model files read pictures."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from swifttailor.errors import InputError

if TYPE_CHECKING:
    from swifttailor.picture_reader.reader import PictureReader


def chosen_reader(
    weights: Path | None, close_ups: Sequence[Path], plain: Sequence[Path]
) -> Path | PictureReader | None:
    """What a tailor is given to read pictures with.

    Args:
        weights: Model file; the ones of the package when None.
        close_ups: Model files of networks that look at details.
        plain: Model files of the network that reads plain pictures, and of those that look at their details.

    Raises:
        InputError: `close_ups` or `plain` are given without `weights`, or a file cannot be used.
    """
    if not close_ups and not plain:
        return weights
    if weights is None:
        option, file = (
            ("--close-up-weights", close_ups[0]) if close_ups else ("--plain-reader-weights", plain[0])
        )
        raise InputError(
            f"{option} '{file}' goes with a picture reader of your own; give its model file as "
            "--picture-reader-weights."
        )
    from swifttailor.picture_reader.reader import PictureReader

    reader = PictureReader.load(weights, close_ups=close_ups, plain=plain)
    if reader.plain is not None:
        reader.plain()  # a file that cannot be used is refused before any work
    return reader

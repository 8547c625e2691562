"""Which model files read pictures."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from swifttailor.errors import InputError

if TYPE_CHECKING:
    from swifttailor.picture_reader.reader import PictureReader


def chosen_reader(weights: Path | None, close_ups: Path | None) -> Path | PictureReader | None:
    """What a tailor is given to read pictures with.

    Args:
        weights: Model file; the one of the package when None.
        close_ups: Model file of the network that looks at details, of which there is one in the package too.

    Raises:
        InputError: `close_ups` are given without `weights`, or a file cannot be used.
    """
    if close_ups is None:
        return weights
    if weights is None:
        raise InputError(
            f"--close-up-weights '{close_ups}' goes with a picture reader of your own; give its model file "
            "as --picture-reader-weights."
        )
    from swifttailor.picture_reader.reader import PictureReader

    return PictureReader.load(weights, close_ups=close_ups)

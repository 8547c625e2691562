"""Which model files read pictures."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from swifttailor.errors import InputError

if TYPE_CHECKING:
    from swifttailor.picture_reader.reader import PictureReader


def chosen_reader(
    weights: Path | None,
    close_ups: Sequence[Path],
    plain: Sequence[Path],
    laid: Path | None = None,
    shop: Path | None = None,
) -> Path | PictureReader | None:
    """What a tailor is given to read pictures with.

    Args:
        weights: Model file; the ones of the package when None.
        close_ups: Model files of networks that look at details.
        plain: Model files of the network that reads plain pictures, and of those that look at their details.
        laid: Model file of the network that reads garments that nobody wears.
        shop: Model file of the network that reads shops' photographs of people.

    Raises:
        InputError: Any of the others are given without `weights`, or a file cannot be used.
    """
    given = {
        "--close-up-weights": tuple(close_ups),
        "--plain-reader-weights": tuple(plain),
        "--laid-reader-weights": () if laid is None else (laid,),
        "--shop-reader-weights": () if shop is None else (shop,),
    }
    if not any(given.values()):
        return weights
    if weights is None:
        option, file = next((option, files[0]) for option, files in given.items() if files)
        raise InputError(
            f"{option} '{file}' goes with a picture reader of your own; give its model file as "
            "--picture-reader-weights."
        )
    from swifttailor.picture_reader.reader import PictureReader

    reader = PictureReader.load(weights, close_ups=close_ups, plain=plain, laid=laid, shop=shop)
    for opened in (reader.plain, reader.laid, reader.shop):
        if opened is not None:
            opened()  # a file that cannot be used is refused before any work
    return reader

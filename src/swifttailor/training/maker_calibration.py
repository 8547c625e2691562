"""What is usual for a trained PatternMaker, by the pictures of the data set that it was trained on."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
from scipy.ndimage import zoom

from swifttailor.arrays import Pixels
from swifttailor.body import Body
from swifttailor.data.index import split_folders
from swifttailor.data.reader import SplitReader
from swifttailor.data.renders.files import SplitRenders
from swifttailor.errors import InputError
from swifttailor.looks.draw import draw_body
from swifttailor.looks.look import VIEWS, random_look
from swifttailor.pattern_maker.asking.calibration import calibrate
from swifttailor.pattern_maker.asking.confidence import Calibration
from swifttailor.pattern_maker.maker import PatternMaker

LEARNT, KNOWN, STRANGERS = 2000, 400, 64
"""Pictures of the training split, of the validation split, and of each kind that shows no garment."""
TILES = 4
"""Along each side of a picture whose parts are exchanged."""

Report = Callable[[str], None]


def calibrate_by_renders(
    maker: PatternMaker,
    data: Path,
    *,
    learnt: int = LEARNT,
    known: int = KNOWN,
    strangers: int = STRANGERS,
    seed: int = 0,
    report: Report | None = None,
) -> Calibration:
    """Shows a network pictures of a data set, and pictures made here that show no garment.

    The latter: bodies without clothes, pictures of garments cut into tiles that are exchanged, and colours
    that flow into each other.

    Args:
        maker: The network.
        data: Data set with splits train and validation, and their renders.
        learnt: Pictures of the training split, at most.
        known: Pictures of the validation split, at most.
        strangers: Pictures of each kind without a garment.
        seed: Which pictures are taken, and what is made.
        report: Called with lines to show.

    Raises:
        InputError: The data set lacks a split or its renders, or has too few pictures.
    """
    folders = split_folders(data)
    for split in ("train", "validation"):
        if split not in folders:
            raise InputError(
                f"'{data}' has no split '{split}'; both train and validation are needed, with renders."
            )
    splits = {name: SplitRenders(SplitReader(folders[name])) for name in ("train", "validation")}
    chance = np.random.default_rng([seed, 8])
    there = {name: len(split) * len(split.settings.names()) for name, split in splits.items()}
    total = min(learnt, there["train"]) + min(known, there["validation"])
    total, done = total + min(strangers, there["validation"]) + 2 * strangers, 0

    def progress(count: int) -> None:
        nonlocal done
        before, done = done, done + count
        if report is not None and (done // 100 > before // 100 or done == total):
            report(f"looking at pictures: {done} of {total}")

    size = splits["validation"].settings.size
    return calibrate(
        maker,
        _some(splits["train"], learnt, chance),
        _some(splits["validation"], known, chance),
        {
            "bare bodies": _bodies(strangers, size, chance),
            "exchanged tiles": (
                exchange_tiles(p, chance) for p in _some(splits["validation"], strangers, chance)
            ),
            "flowing colours": (flowing_colours(size, chance) for _ in range(strangers)),
        },
        progress=progress,
    )


def exchange_tiles(picture: Pixels, chance: np.random.Generator) -> Pixels:
    """A picture in which no part is where it was."""
    height, width = (n // TILES * TILES for n in picture.shape[:2])
    rows = picture[:height, :width].reshape(TILES, height // TILES, TILES, width // TILES, 3)
    tiles = rows.swapaxes(1, 2).reshape(TILES * TILES, height // TILES, width // TILES, 3)
    order = chance.permutation(len(tiles))
    # Each tile goes where the next one of a random order was: none stays.
    moved = tiles.copy()
    moved[order] = tiles[np.roll(order, 1)]
    together = moved.reshape(TILES, TILES, height // TILES, width // TILES, 3).swapaxes(1, 2)
    return together.reshape(height, width, 3)


def flowing_colours(size: int, chance: np.random.Generator) -> Pixels:
    """(size, size, 3) random colours, coarse or fine."""
    cells = int(chance.integers(2, max(3, size // 4)))
    grid = chance.uniform(0, 255, (cells, cells, 3))
    wide = zoom(grid, (size / cells, size / cells, 1), order=1, mode="nearest", grid_mode=True)
    return wide[:size, :size].clip(0, 255).astype(np.uint8)


def _bodies(count: int, size: int, chance: np.random.Generator) -> Iterator[Pixels]:
    body = Body.default()
    for k in range(count):
        yield draw_body(body, random_look(chance, VIEWS[k % len(VIEWS)]), size)


def _some(renders: SplitRenders, most: int, chance: np.random.Generator) -> Iterator[Pixels]:
    """Pictures of a split by lot, of as many garments as possible; all of them where there are no more."""
    names = len(renders.settings.names())
    garments = chance.permutation(len(renders))
    orders = np.argsort(chance.random((len(renders), names)), axis=1)
    places = [(int(k), int(orders[k, turn])) for turn in range(names) for k in garments]
    for k, number in places[:most]:
        yield renders[k][number].pixels()

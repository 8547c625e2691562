"""Photographs of clothes that are laid or hung, to learn to read from, of which only the kind is known."""

from __future__ import annotations

import csv
import hashlib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Pixels
from swifttailor.data.pictures.odd_scenes import unread
from swifttailor.data.pictures.photograph_labels import KINDS, NOTHING, PhotographKind
from swifttailor.data.pictures.scenes import Chance, Scene, linear_light
from swifttailor.errors import InputError
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.picture_reader.cut_square import cut_square
from swifttailor.picture_reader.labels import BOX, PARTS, measure_labels
from swifttailor.picture_reader.view import view_of
from swifttailor.render import Camera
from swifttailor.render.picture_file import read_picture

SPLITS = ("train", "validation", "test")
_TENTHS = {8: "validation", 9: "test"}
_LABELS = {*KINDS, *NOTHING}
_EVENER = 0.5
"""Power of how many photographs of a label there are, by which labels are drawn."""
_SIDES, _AWAY = (0.8, 1.12), 0.05
"""Of what is shown of a photograph, in its longer sides, and by how much it is off the middle."""
_PARTS_OF_NOTHING, _FAR_AWAY = (0.4, 1.12), 0.12
"""The same where there is nothing to read: any part will do."""
_CORNER = (0.12, 0.35)
"""Side of a corner that shows what a garment lies on, in shorter sides."""
_KIND_NAMES = tuple(KINDS)


@dataclass(frozen=True)
class Photograph:
    """One of them."""

    path: Path
    label: str

    @property
    def kind(self) -> PhotographKind | None:
        """None where there is nothing to read."""
        return KINDS.get(self.label)

    def pixels(self) -> Pixels:
        """(h, w, 3), as pictures are read that a user gives.

        Raises:
            InputError: It cannot be read.
        """
        return read_picture(self.path)


class Photographs:
    """Those of a split of the clothing dataset, and of others like it."""

    def __init__(self, folders: Sequence[Path], split: str) -> None:
        """Lists them.

        Args:
            folders: Each holds ``images.csv``, with the columns ``image`` and ``label``, and
                ``images/IMAGE.jpg``.
            split: One of `SPLITS`: by a hash of the image's name, so that the same photographs are always
                kept apart.

        Raises:
            InputError: There is no such folder, or no photograph of a known kind in it.
        """
        assert split in SPLITS
        self.photographs = tuple(one for folder in folders for one in _listed(folder, split))
        if not self.photographs:
            named = ", ".join(f"'{folder}'" for folder in folders)
            raise InputError(
                f"{named} has no photographs of the split '{split}'. It needs images.csv, with the "
                f"columns image and label (one of {', '.join(sorted(_LABELS))}), and images/IMAGE.jpg for "
                "each."
            )
        self._of_label = {
            label: [k for k, one in enumerate(self.photographs) if one.label == label]
            for label in sorted({one.label for one in self.photographs})
        }
        share = np.array([len(some) for some in self._of_label.values()], np.float64) ** _EVENER
        self._shares = share / share.sum()

    def __len__(self) -> int:
        return len(self.photographs)

    def checksum(self) -> str:
        """SHA-256 of names and labels."""
        rows = [f"{one.path.name} {one.label}" for one in self.photographs]
        return hashlib.sha256("\n".join(sorted(rows)).encode()).hexdigest()

    def ground(self, chance: Chance, size: int) -> NDArray[np.float32]:
        """(size, size, 3) linear light of a corner of one by lot: what garments lie on."""
        photograph = self.photographs[int(chance.integers(len(self)))]
        pixels = photograph.pixels()[:: int(chance.choice([-1, 1])), :: int(chance.choice([-1, 1]))]
        side = max(round(min(pixels.shape[:2]) * float(chance.uniform(*_CORNER))), 1)
        return linear_light(cut_square(np.ascontiguousarray(pixels), (0, 0, side), size))

    def shown(self, chance: Chance, size: int, behind: int) -> Scene:
        """One of them by lot, cut and mirrored by lot, as a picture to learn from.

        Args:
            chance: Decides.
            size: Pixels along each side.
            behind: How many garments a bank has: the kinds are numbered behind them, see `kind_truths`.
        """
        label = list(self._of_label)[int(chance.choice(len(self._of_label), p=self._shares))]
        some = self._of_label[label]
        photograph = self.photographs[some[int(chance.integers(len(some)))]]
        pixels = photograph.pixels()
        if chance.random() < 0.5:
            pixels = pixels[:, ::-1]
        height, width = pixels.shape[:2]
        longer = max(height, width)
        kind = photograph.kind
        side = round(longer * float(chance.uniform(*(_SIDES if kind else _PARTS_OF_NOTHING))))
        right, down = chance.normal(0, _AWAY if kind else _FAR_AWAY, 2) * longer
        left, top = round((width - side) / 2 + right), round((height - side) / 2 + down)
        scene = unread(cut_square(pixels, (left, top, side), size), "one" if kind else "none")
        if kind is None:
            return scene
        camera = Camera((0.0, kind.middle, 0.0), kind.seen * side / longer, 0.0, 0.0, 14.0)
        garments = np.full(len(PARTS), -1)
        garments[PARTS.index(kind.part)] = behind + _KIND_NAMES.index(photograph.label)
        return scene._replace(views=view_of(camera, size), garments=garments, placed=False)


def kind_truths() -> dict[str, NDArray[Any]]:
    """What is true of each of `KINDS`, as `PictureBank.truths` has it of garments; measures are unknown."""
    count = len(KINDS)
    return {
        "part": np.array([PARTS.index(kind.part) for kind in KINDS.values()], np.uint8),
        "statements": np.stack([kind.statements() for kind in KINDS.values()]),
        "measures": np.full((count, len(measure_labels())), np.nan, np.float32),
        "panels": np.zeros((count, len(PANEL_NAMES)), np.uint8),
        "boxes": np.zeros((count, len(PANEL_NAMES), len(BOX)), np.float32),
    }


def split_of(image: str) -> str:
    """One of `SPLITS`, by the name of an image."""
    tenth = int(hashlib.sha256(image.encode()).hexdigest()[:8], 16) % 10
    return _TENTHS.get(tenth, "train")


def _listed(folder: Path, split: str) -> Iterator[Photograph]:
    table = folder / "images.csv"
    try:
        rows = list(csv.DictReader(table.read_text(encoding="utf-8").splitlines()))
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"The list of photographs '{table}' cannot be read: {error}.") from error
    for row in rows:
        image, label = row.get("image") or "", row.get("label") or ""
        path = folder / "images" / f"{image}.jpg"
        known = label in _LABELS and Path(image).name == image and split_of(image) == split
        if known and path.is_file():
            yield Photograph(path, label)

"""Photographs of clothes to learn to read from, of which a few claims are known: see `photograph_lists`."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Pixels
from swifttailor.data.pictures.cut_outs import shown_person
from swifttailor.data.pictures.linear_light import linear_light
from swifttailor.data.pictures.odd_scenes import unread
from swifttailor.data.pictures.photograph_lists import LISTS, listed
from swifttailor.data.pictures.scenes import UNTOLD, Chance, Scene
from swifttailor.errors import InputError
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.picture_reader.cut_square import cut_square
from swifttailor.picture_reader.labels import BOX, PARTS, measure_labels, statement_labels
from swifttailor.picture_reader.view import view_of
from swifttailor.render import Camera

_EVENER = 0.5
"""Power of how many photographs of a label there are, by which labels are drawn."""
_SIDES, _AWAY = (0.8, 1.12), 0.05
"""Of what is shown of clothes that nobody wears, in a photograph's longer sides; how far off the middle."""
_PARTS_OF_NOTHING, _FAR_AWAY = (0.4, 1.12), 0.12
"""The same where there is nothing to read: any part will do."""
_PORTRAITS = 0.2
"""Of people with a garment on their shoulders so many are shown down to the chest alone."""
_CORNER = (0.12, 0.35)
"""Side of a corner that shows what a garment lies on, in shorter sides."""
_FIELD_OF_VIEW = 14.0


class Photographs:
    """Those of a split of some folders."""

    def __init__(self, folders: Sequence[Path], split: str) -> None:
        """Lists them.

        Args:
            folders: Each is listed as `photograph_lists.listed` has it.
            split: One of `SPLITS`.

        Raises:
            InputError: There is no such folder, or no photograph with known claims in it.
        """
        self.photographs = tuple(one for folder in folders for one in listed(folder, split))
        if not self.photographs:
            named = ", ".join(f"'{folder}'" for folder in folders)
            raise InputError(f"{named} has no photographs of the split '{split}'. {LISTS}")
        worn = [kind for one in self.photographs for kind in one.kinds if kind]
        self.kinds = tuple({id(kind): kind for kind in worn}.values())
        number = {id(kind): k for k, kind in enumerate(self.kinds)}
        self._numbers = [[number.get(id(kind)) for kind in one.kinds] for one in self.photographs]
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

    def shown(self, chance: Chance, size: int, behind: int, cut_out: float = 0.0) -> Scene:
        """One of them by lot, cut and mirrored by lot, as a picture to learn from.

        Args:
            chance: Decides.
            size: Pixels along each side.
            behind: How many garments a bank has: `kinds` are numbered behind them.
            cut_out: Share of people on white that are shown as if cut out, see `shown_person`.
        """
        label = list(self._of_label)[int(chance.choice(len(self._of_label), p=self._shares))]
        some = self._of_label[label]
        chosen = some[int(chance.integers(len(some)))]
        photograph = self.photographs[chosen]
        pixels = photograph.pixels()
        if chance.random() < 0.5:
            pixels = pixels[:, ::-1]
        kind = photograph.main
        near = False
        if photograph.is_worn:
            near = kind is not None and kind.part == "upper" and chance.random() < _PORTRAITS
            shown, side = shown_person(pixels, size, chance, near=near, cut_out=cut_out)
        else:
            shown, side = _cut_by_lot(pixels, size, chance, all_of_it=kind is not None)
        scene = unread(shown, "one" if kind else "none")
        if kind is None:
            return scene
        seen = kind.seen * side / max(pixels.shape[:2])
        camera = Camera((0.0, kind.middle, 0.0), seen, photograph.azimuth, 0.0, _FIELD_OF_VIEW)
        garments = np.array(
            [
                behind + number if number is not None else -1 if told else UNTOLD
                for number, told in zip(self._numbers[chosen], photograph.told, strict=True)
            ]
        )
        if near:
            garments = np.array([garments[0] + len(self.kinds), -1])
        return scene._replace(views=view_of(camera, size), garments=garments, placed=False)

    def truths(self) -> dict[str, NDArray[Any]]:
        """What is true of each of `kinds`, then of what a portrait shows of each; measures are unknown.

        As `PictureBank.truths` has it.
        """
        kinds = (*self.kinds, *(kind.of_a_portrait() for kind in self.kinds))
        count = len(kinds)
        statements = [kind.statements() for kind in kinds]
        return {
            "part": np.array([PARTS.index(kind.part) for kind in kinds], np.uint8),
            "statements": np.array(statements, np.uint8).reshape(count, len(statement_labels())),
            "measures": np.full((count, len(measure_labels())), np.nan, np.float32),
            "panels": np.zeros((count, len(PANEL_NAMES)), np.uint8),
            "boxes": np.zeros((count, len(PANEL_NAMES), len(BOX)), np.float32),
        }


def _cut_by_lot(pixels: Pixels, size: int, chance: Chance, *, all_of_it: bool) -> tuple[Pixels, int]:
    """A square of a photograph, (size, size, 3), and its side."""
    height, width = pixels.shape[:2]
    longer = max(height, width)
    side = round(longer * float(chance.uniform(*(_SIDES if all_of_it else _PARTS_OF_NOTHING))))
    right, down = chance.normal(0, _AWAY if all_of_it else _FAR_AWAY, 2) * longer
    square = round((width - side) / 2 + right), round((height - side) / 2 + down), side
    return cut_square(pixels, square, size), side

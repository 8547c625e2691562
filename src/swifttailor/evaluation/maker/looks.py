"""Pictures to show to a PatternMaker in looks of one family, from one side: drawn of sewn garments."""

from __future__ import annotations

from pathlib import Path
from typing import Any, get_args

import numpy as np

from swifttailor.arrays import Pixels
from swifttailor.data.index import split_folders
from swifttailor.data.pictures.bank import PictureBank
from swifttailor.data.pictures.blocks import Family, draw
from swifttailor.data.pictures.scenes import View, Wardrobe
from swifttailor.errors import InputError
from swifttailor.evaluation.maker.pictures import GarmentPictures
from swifttailor.evaluation.maker.questions import seed_of
from swifttailor.evaluation.pictures.visible import PICTURE_SIZE, ShownFrom

_NOTHING_ASKED = ("photograph", "nothing", "several", "unlike", "worn")
LOOKS: tuple[Family, ...] = tuple(f for f in get_args(Family) if f not in _NOTHING_ASKED)
_SIDES: dict[str, tuple[View, ...]] = {
    "front": ("front",),
    "back": ("back",),
    "free": ("free",),
    "both": ("front", "back"),
}


class LookPictures(GarmentPictures):
    """The picture of each garment of a data set in one look: one, or its front and its back."""

    def __init__(self, data: Path, seed: int, look: Family, view: ShownFrom) -> None:
        """Opens a data set.

        Args:
            data: A split, or a data set of several.
            seed: Decides everything else about a picture.
            look: How the pictures look.
            view: From where; with ``both`` the same person is seen from two sides.

        Raises:
            InputError: It is no data set, or there is no such look or view.
        """
        if look not in LOOKS or view not in _SIDES:
            raise InputError(
                f"The look is '{look}' and the view '{view}'; {', '.join(LOOKS)} and {', '.join(_SIDES)} are "
                "accepted."
            )
        super().__init__(data, seed)
        self.look, self.view = look, view
        banks = {name: PictureBank([folder]) for name, folder in split_folders(data).items()}
        for bank in banks.values():
            bank.prepare()
        self._wardrobes = {name: Wardrobe(bank) for name, bank in banks.items()}

    def picture(self, id: str) -> tuple[str, tuple[Pixels, ...]]:
        """The look and the pixels of the pictures of a garment: one, or front and back.

        Raises:
            InputError: The data set is damaged.
        """
        split, number = self._places[id]
        lot = seed_of(self.seed, id, "picture")
        shown = (
            draw(self._wardrobes[split], number, self.look, side, np.random.default_rng(lot), PICTURE_SIZE)
            for side in _SIDES[self.view]
        )
        return f"{self.look}, {self.view}", tuple(scene.pixels for scene in shown)

    @property
    def drawn(self) -> tuple[str, ...]:
        """Names of the splits whose pictures are drawn: all."""
        return tuple(self._readers)

    def identity(self) -> dict[str, Any]:
        """What decides the pictures of a garment beside its shape, as JSON values."""
        return {"look": self.look, "view": self.view, "size": PICTURE_SIZE}

"""Pictures to show to a PatternMaker: renders of a data set, or, where it has none, drawn of its drapes."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Any

from swifttailor.arrays import Pixels
from swifttailor.data.index import split_folders
from swifttailor.data.reader import SplitReader
from swifttailor.data.renders.files import FOLDER, INDEX, RenderSettings, SplitRenders, draw_render
from swifttailor.data.sample import Sample
from swifttailor.evaluation.maker.questions import seed_of


class GarmentPictures:
    """One picture of each garment of a data set; which of its looks, the seed decides."""

    def __init__(self, data: Path, seed: int) -> None:
        """Opens a data set.

        Args:
            data: A split, or a data set of several.
            seed: Decides which of the pictures of a garment is shown.

        Raises:
            InputError: It is no data set, or its renders are damaged.
        """
        self.seed = seed
        self._readers = {name: SplitReader(folder) for name, folder in split_folders(data).items()}
        self._renders = {
            name: SplitRenders(reader) if (reader.folder / FOLDER / INDEX).is_file() else None
            for name, reader in self._readers.items()
        }
        self._places: dict[str, tuple[str, int]] = {}
        for name, reader in self._readers.items():
            for number, id in enumerate(reader.ids):
                self._places.setdefault(id, (name, number))

    def __contains__(self, id: str) -> bool:
        """Whether there is a garment of that id."""
        return id in self._places

    def sample(self, id: str) -> Sample | None:
        """The drape of a garment; None where there is none of that id.

        Raises:
            InputError: The data set is damaged.
        """
        if id not in self._places:
            return None
        split, number = self._places[id]
        return self._readers[split][number]

    def picture(self, id: str) -> tuple[str, tuple[Pixels, ...]]:
        """The look and the pixels of the pictures of a garment, here one.

        Raises:
            InputError: The data set is damaged, or its renders were not drawn to the end.
        """
        split, number = self._places[id]
        renders = self._renders[split]
        settings = RenderSettings() if renders is None else renders.settings
        names = settings.names()
        place = seed_of(self.seed, id, "picture") % len(names)
        if renders is not None:
            return names[place], (renders[number][place].pixels(),)
        sample = self._readers[split][number]
        return names[place], (draw_render(sample, names[place], settings).pixels(),)

    @property
    def drawn(self) -> tuple[str, ...]:
        """Names of the splits without renders, whose pictures are drawn when they are asked for."""
        return tuple(name for name, renders in self._renders.items() if renders is None)

    def identity(self) -> dict[str, Any]:
        """What decides the pictures of a garment beside its drape, as JSON values by split."""
        chosen = {n: RenderSettings() if r is None else r.settings for n, r in self._renders.items()}
        return {name: asdict(settings) for name, settings in chosen.items()}

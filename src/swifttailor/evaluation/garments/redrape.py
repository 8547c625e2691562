"""Drapes the patterns of a split once more: how far two drapes of one pattern are apart by chance.

No method that knows the pattern alone can be nearer to the drapes than that, but by averaging. It takes some
seconds a garment, so every drape is kept in a folder, and the work goes on where it stopped.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.atomic_files import write_atomically, write_text
from swifttailor.body import Body
from swifttailor.data.builder.code_version import code_version
from swifttailor.data.builder.settings import body_identity
from swifttailor.data.reader import SplitReader
from swifttailor.data.sample import Sample
from swifttailor.draping import drape
from swifttailor.errors import InputError, SwiftTailorError
from swifttailor.evaluation.garments.score import Scored, draw_clouds, score_garment, score_of_json
from swifttailor.evaluation.garments.sew_split import Made
from swifttailor.evaluation.kept_settings import keep_settings
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.progress import CountProgress, unwatched

SETTINGS, RECORDS = "redrapes.json", "redrapes"
_SETTINGS = ("fabric", "engine")


class Redraper:
    """Drapes again, into a folder that keeps what is done."""

    def __init__(self, reader: SplitReader, folder: Path, *, drape_seed: int = 1, seed: int = 0) -> None:
        """Opens the folder, or makes it.

        Args:
            reader: The split.
            folder: For the drapes.
            drape_seed: What starting positions are shaken by (`swifttailor.drape`).
            seed: Of the points that surfaces are compared by.

        Raises:
            InputError: The split was draped by other means, with the same seed or on another body, or the
                folder holds drapes that were made in another way.
        """
        self._reader, self._folder = reader, folder
        self._drape_seed, self._seed = drape_seed, seed
        settings = reader.index.settings
        body = Body.default()
        if "seed" not in settings or settings.get("body") != body_identity(body):
            made_on = settings.get("body", {}).get("name", "unknown")
            raise InputError(
                f"The drapes in '{reader.folder}' were not made by SwiftTailor on its default body (theirs: "
                f"{made_on}), so they cannot be made again. Give a split of swifttailor data build."
            )
        if settings["seed"] == drape_seed:
            raise InputError(
                f"The drapes in '{reader.folder}' were made with the seed {drape_seed} as well, and would "
                "come out the same. Choose another --drape-seed."
            )
        self._body = BodyDistance.of(body)
        self._settings = {name: settings[name] for name in _SETTINGS}
        identity = {
            "split": reader.index.split,
            "settings": settings,
            "drape_seed": drape_seed,
            "seed": seed,
            "code": code_version()["code"],
        }
        keep_settings(folder / SETTINGS, identity, "drapes", (RECORDS,))

    def run(self, numbers: Sequence[int], progress: CountProgress = unwatched) -> tuple[Made, int]:
        """Drapes what is missing and measures all.

        Args:
            numbers: Of the samples.
            progress: Called with 1 after each.

        Returns:
            What was made, and how many of the new drapes are beyond the limits of quality.
        """
        made, rejected = Made(), 0
        for k in numbers:
            sample = self._reader[k]
            record = self._read(k) or self._make(sample, k)
            if "error" in record:
                made.lose(sample, k, record["error"], self._seed)
            else:
                vertices = self._vertices(k, sample)
                made.vertices[k] = vertices
                clouds = draw_clouds(vertices, sample.garment, seed=self._seed, number=k)
                made.scored.append(Scored(score_of_json(record["score"]), clouds))
                rejected += not record["accepted"]
            progress(1)
        return made, rejected

    def _make(self, sample: Sample, number: int) -> dict[str, Any]:
        try:
            garment = drape(
                sample.pattern, edge_length=sample.edge_length, seed=self._drape_seed, **self._settings
            )
        except SwiftTailorError as error:
            record: dict[str, Any] = {"id": sample.id, "error": str(error)}
        else:
            scored = score_garment(
                sample.id, garment, sample.garment, self._body, seed=self._seed, number=number
            )
            quality = garment.report["quality"]
            record = {"score": asdict(scored.score), "accepted": quality["accepted"]}
            record |= {"id": sample.id, "reasons": list(quality["reasons"])}
            write_atomically(
                self._path(number, ".npy"), lambda path: np.save(path, garment.vertices), overwrite=True
            )
        write_text(self._path(number, ".json"), json.dumps(record) + "\n")
        return record

    def _read(self, number: int) -> dict[str, Any] | None:
        path = self._path(number, ".json")
        if not path.is_file():
            return None
        try:
            record = json.loads(path.read_text(encoding="utf-8"))
            if not isinstance(record, dict):
                raise ValueError("it is not a JSON object")
        except (OSError, ValueError, RecursionError) as error:
            raise InputError(
                f"'{path}' is damaged: {error}. Delete it to drape that garment again."
            ) from error
        if record.get("id") != self._reader.ids[number]:
            raise InputError(
                f"'{path}' is of the garment {record.get('id')!r}, number {number} of the split is now "
                f"{self._reader.ids[number]!r}. Choose another --out."
            )
        return record

    def _vertices(self, number: int, sample: Sample) -> np.ndarray:
        path = self._path(number, ".npy")
        try:
            return Garment(sample.mesh, np.load(path, allow_pickle=False)).vertices
        except (OSError, ValueError, SwiftTailorError) as error:
            record = self._path(number, ".json")
            raise InputError(
                f"'{path}' is missing or damaged: {error}. Delete '{record}' to drape that garment again."
            ) from error

    def _path(self, number: int, ending: str) -> Path:
        return self._folder / RECORDS / f"{number:06d}{ending}"

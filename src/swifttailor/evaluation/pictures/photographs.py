"""How well photographs of clothes are read of which only the kind is known."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from swifttailor.data.pictures.photograph_labels import PhotographKind
from swifttailor.data.pictures.photographs import Photograph
from swifttailor.picture_reader.reader import LEAST_PRESENT, PictureReader
from swifttailor.picture_reader.reading import PictureReading

TOLD = ("kind", "sleeves", "hood", "collar", "leg_hem")
"""Claims that are compared, of kinds of which they are known."""
PARTS_RIGHT, NOTHING, ONE = "parts", "nothing", "one"


@dataclass
class PhotographScores:
    """What was found of some photographs."""

    found: dict[str, list[bool]] = field(default_factory=dict)

    def add_kind(self, kind: PhotographKind, parts: Sequence[str], likeliest: Mapping[str, str]) -> None:
        """Adds what was read of a photograph of a kind.

        Args:
            kind: What it shows.
            parts: Of the body on which something was seen.
            likeliest: Of each claim the likeliest word of the part that the kind covers; without those of
                which nothing was said.
        """
        self.add(PARTS_RIGHT, list(parts) == [kind.part])
        for claim in TOLD:
            if claim in kind.are or claim in kind.may_be:
                self.add(claim, claim in likeliest and kind.likely(claim, likeliest[claim]))

    def add(self, name: str, good: bool) -> None:
        """Adds one answer, right or wrong."""
        self.found.setdefault(name, []).append(good)

    def shares(self) -> dict[str, float]:
        """Of each name the share that is right."""
        return {name: round(float(np.mean(good)), 4) for name, good in self.found.items()}

    def counts(self) -> dict[str, int]:
        """Of each name how many answers there are."""
        return {name: len(good) for name, good in self.found.items()}


def read_photographs(
    reader: PictureReader, photographs: Sequence[Photograph], done: Callable[[int], None] | None = None
) -> dict[str, PhotographScores]:
    """Reads photographs as a picture is read that a user gives.

    Returns:
        Of each label, and of ``all`` but those of nothing, what was found; ``laid`` beside the names of
        `PhotographScores`: whether it was seen that nobody wears it; of labels of nothing only ``left
        alone``: whether the reader of laid garments left them to others.
    """
    scores = {"all": PhotographScores()}
    for one in photographs:
        reading = reader.read(one.pixels())
        of_label = scores.setdefault(one.label, PhotographScores())
        kind = one.kind
        if kind is None:
            of_label.add("left alone", not reading.is_laid)
        else:
            for each in (of_label, scores["all"]):
                each.add("laid", reading.is_laid)
                each.add_kind(kind, _parts(reading), _likeliest(reading, kind))
        if done is not None:
            done(1)
    return scores


def _parts(reading: PictureReading) -> list[str]:
    return [part.part for part in reading.parts if part.certainty >= LEAST_PRESENT]


def _likeliest(reading: PictureReading, kind: PhotographKind) -> dict[str, str]:
    part = next((part for part in reading.parts if part.part == kind.part), None)
    found: dict[str, str] = {}
    for statement in part.statements if part else ():  # surest first
        found.setdefault(statement.claim.name, str(statement.claim.value))
    return found

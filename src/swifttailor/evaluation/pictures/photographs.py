"""How well photographs of clothes are read of which some claims are known."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from swifttailor.data.pictures.photograph_lists import Photograph
from swifttailor.describing import Claim, measure_facts
from swifttailor.errors import SwiftTailorError
from swifttailor.picture_reader.labels import PARTS
from swifttailor.picture_reader.reader import PictureReader
from swifttailor.picture_reader.reading import PictureReading
from swifttailor.picture_reader.said import LEAST_PRESENT

if TYPE_CHECKING:
    from swifttailor.tailor import Tailor
    from swifttailor.tailor.order import Part

TOLD = ("kind", "fit", "sleeves", "hood", "collar", "neckline", "top_hem", "skirt_hem", "leg_hem", "legs")
"""Claims that are compared, of kinds of which they are known."""
PARTS_RIGHT, NOTHING, ONE = "parts", "nothing", "one"


@dataclass
class PhotographScores:
    """What was found of some photographs."""

    found: dict[str, list[bool]] = field(default_factory=dict)

    def add_photograph(
        self, photograph: Photograph, parts: Sequence[str], likeliest: Callable[[str], Mapping[str, str]]
    ) -> None:
        """Adds what was read of one.

        Args:
            photograph: What it shows.
            parts: Of the body on which something was seen.
            likeliest: Gives of each claim the likeliest word of a part, without claims of which nothing was
                said.
        """
        told = [part for part, known in zip(PARTS, photograph.told, strict=True) if known]
        there = [kind.part for kind in photograph.kinds if kind]
        self.add(PARTS_RIGHT, {part for part in parts if part in told} == set(there))
        for kind in filter(None, photograph.kinds):
            words = likeliest(kind.part)
            for claim in TOLD:
                if claim in kind.are or claim in kind.may_be:
                    self.add(claim, claim in words and kind.likely(claim, words[claim]))

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
        if one.main is None:
            of_label.add("left alone", not reading.is_laid)
        else:
            for each in (of_label, scores["all"]):
                each.add("laid", reading.is_laid)
                each.add_photograph(one, _parts(reading), partial(_likeliest, reading))
        if done is not None:
            done(1)
    return scores


def made_of_photographs(
    tailor: Tailor, photographs: Sequence[Photograph], done: Callable[[int], None] | None = None
) -> dict[str, PhotographScores]:
    """Makes what photographs show, part by part, and measures the patterns.

    Returns:
        Of each label and of ``all`` what was found; ``made``: whether anything was.
    """
    scores = {"all": PhotographScores()}
    for one in photographs:
        seen = tailor.look(one.pixels())
        for kind in filter(None, one.kinds):
            part: Part = "upper" if kind.part == "upper" else "lower"
            try:
                facts = measure_facts(tailor.generate(image=seen, part=part).pattern)
            except SwiftTailorError:
                facts = None
            for each in (scores.setdefault(one.label, PhotographScores()), scores["all"]):
                each.add("made", facts is not None)
                for claim in TOLD:
                    words = (*kind.are.get(claim, ()), *kind.may_be.get(claim, ()))
                    if words:
                        held = facts is not None and any(Claim(claim, word).holds(facts) for word in words)
                        each.add(claim, held)
        if done is not None:
            done(1)
    return scores


def _parts(reading: PictureReading) -> list[str]:
    return [part.part for part in reading.parts if part.certainty >= LEAST_PRESENT]


def _likeliest(reading: PictureReading, name: str) -> dict[str, str]:
    part = next((part for part in reading.parts if part.part == name), None)
    found: dict[str, str] = {}
    for statement in part.statements if part else ():  # surest first
        found.setdefault(statement.claim.name, str(statement.claim.value))
    return found

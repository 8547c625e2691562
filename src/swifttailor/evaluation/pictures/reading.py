"""Pictures of garments, read, beside what is true of them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.data.pictures.bank import PictureBank
from swifttailor.data.pictures.blocks import Family, draw
from swifttailor.data.pictures.scenes import Scene, View, Wardrobe
from swifttailor.evaluation.pictures.visible import PICTURE_SIZE
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.picture_reader.labels import MASK_STRIDE, PARTS, measure_labels, statement_labels
from swifttailor.picture_reader.reader import PictureReader
from swifttailor.picture_reader.reading import PartReading
from swifttailor.picture_reader.truth import FALSE, TRUE, Truth

SHOWN: tuple[tuple[Family, View], ...] = (
    ("plain", "front"),
    ("plain", "back"),
    ("studio", "front"),
    ("studio", "back"),
    ("studio", "free"),
    ("people", "front"),
    ("people", "back"),
    ("people", "free"),
    ("held out", "front"),
    ("held out", "back"),
    ("held out", "free"),
    ("laid", "front"),
    ("laid", "back"),
)
"""The pictures of each garment: how it looks, and from where."""


@dataclass(frozen=True, eq=False)
class ReadPicture:
    """What was read of one garment in one picture."""

    garment: int
    """Its number in the bank."""
    look: Family
    view: View
    found: bool
    """Whether anything was seen on that part of the body."""
    certain: NDArray[np.float32]
    """(S,) certainty of each statement."""
    judged: NDArray[np.uint8]
    """(S,) `truth.FALSE`, `TRUE` or `UNCLEAR`."""
    panels: bool
    """Whether exactly the right panel names were read."""
    mask: float
    """Intersection of its mask with the true one, over their union."""
    off: dict[str, float]
    """By dimension: how far the measure is off, where the garment has it and it was read."""


def read_pictures(
    reader: PictureReader,
    bank: PictureBank,
    numbers: list[int],
    *,
    size: int = PICTURE_SIZE,
    seed: int = 0,
    done: Callable[[int], None] | None = None,
) -> Iterator[ReadPicture]:
    """Draws garments, shows them to a reader, and compares.

    Args:
        reader: Sees a picture as `swifttailor` shows it: of any size, looked at twice.
        bank: Garments.
        numbers: Which of them.
        size: Pixels along each side of the pictures.
        seed: Of the looks.
        done: Called with the number of pictures that were read since it was called before.
    """
    wardrobe = Wardrobe(bank)
    for number in numbers:
        truth = bank[number].truth
        for k, (look, view) in enumerate(SHOWN):
            chance = np.random.default_rng([seed, 11, number, k])
            scene = draw(wardrobe, number, look, view, chance, size)
            yield _compared(reader, scene, number, truth, look, view)
            if done is not None:
                done(1)


def _compared(
    reader: PictureReader, scene: Scene, number: int, truth: Truth, look: Family, view: View
) -> ReadPicture:
    name = PARTS[truth.part]
    part = next((p for p in reader.read(scene.pixels).parts if p.part == name), None)
    certain = np.zeros(len(statement_labels()), np.float32)
    if part is None:
        return ReadPicture(number, look, view, False, certain, truth.statements, False, 0.0, {})
    for k, label in enumerate(statement_labels()):
        certain[k] = part.certainty_of(*label)
    true_names = {PANEL_NAMES[k] for k in np.flatnonzero(truth.panels)}
    names = {p.name for p in part.panels if p.certainty > 0.5}
    return ReadPicture(
        number,
        look,
        view,
        True,
        certain,
        truth.statements,
        names == true_names,
        _overlap(part, scene, truth.part),
        _off(part, truth),
    )


def _overlap(part: PartReading, scene: Scene, number: int) -> float:
    cells = scene.masks.shape[0]
    seen = part.mask.reshape(cells, MASK_STRIDE, cells, MASK_STRIDE).mean(axis=(1, 3)) > 0.5
    shown = scene.masks[:, :, number] > 127
    return float((seen & shown).sum() / max((seen | shown).sum(), 1))


def _off(part: PartReading, truth: Truth) -> dict[str, float]:
    true = dict(zip(measure_labels(), truth.measures, strict=True))
    return {m.name: abs(m.value - float(true[m.name])) for m in part.measures if np.isfinite(true[m.name])}


@dataclass(frozen=True)
class Share:
    """So many of so many."""

    good: int
    of: int

    @property
    def value(self) -> float:
        """0 to 1; NaN of none."""
        return self.good / self.of if self.of else float("nan")


def claim_shares(pictures: list[ReadPicture]) -> dict[str, Share]:
    """`claims_read` of some pictures, as shares."""
    certain, judged = np.stack([p.certain for p in pictures]), np.stack([p.judged for p in pictures])
    found = np.array([p.found for p in pictures])
    return {
        claim: Share(int((good & found[asked]).sum()), len(asked))
        for claim, (asked, good) in claims_read(certain, judged).items()
    }


def claims_read(
    certain: NDArray[Any], judged: NDArray[np.uint8]
) -> dict[str, tuple[NDArray[np.intp], NDArray[np.bool_]]]:
    """How each claim is read, of the pictures of garments of which one of its words is clearly true.

    Args:
        certain: (n, S) certainties or logits of the statements.
        judged: (n, S) `truth.FALSE`, `TRUE` or `UNCLEAR`.

    Returns:
        By claim: which pictures those are, and whether the likeliest word is not false in each.
    """
    claims = np.array([claim for claim, _ in statement_labels()])
    read = {}
    for claim in dict.fromkeys(claims):
        columns = np.flatnonzero(claims == claim)
        asked = np.flatnonzero((judged[:, columns] == TRUE).any(axis=1))
        if len(asked):
            said = columns[certain[asked][:, columns].argmax(axis=1)]
            read[str(claim)] = asked, judged[asked, said] != FALSE
    return read


def stated_shares(pictures: list[ReadPicture], least: float) -> tuple[Share, Share]:
    """Of all statements that are at least so certain those that hold; of all that are true those said."""
    said = np.stack([p.certain for p in pictures]) >= least
    judged = np.stack([p.judged for p in pictures])
    held = Share(int((said & (judged != FALSE)).sum()), int(said.sum()))
    return held, Share(int((said & (judged == TRUE)).sum()), int((judged == TRUE).sum()))

"""How well photographs of clothes are read of which only the kind is known. It loads torch."""

from __future__ import annotations

import numpy as np
import torch

from swifttailor.data.pictures.photographs import Photograph, Photographs
from swifttailor.picture_reader.cut_square import cut_square
from swifttailor.picture_reader.figures import FIGURES
from swifttailor.picture_reader.labels import GUESS, PARTS, statement_labels
from swifttailor.picture_reader.network_torch import EyesNetwork, Reading

SHOWN = ("kind", "sleeves", "hood", "collar", "leg_hem")
"""Claims that are told."""
_BATCH = 64


@torch.no_grad()
def judge_photographs(
    network: EyesNetwork, photographs: Photographs, size: int, device: torch.device
) -> dict[str, float]:
    """How well a network reads photographs at one look.

    Returns:
        ``parts``: share in which exactly the part of the body is said that the garment covers; of each of
        `SHOWN` the share whose likeliest word may be true of the kind, of those of which it is known;
        ``nothing``: share of those without clothes that are said to show none; ``one``: share of the others
        that are said to show one. A share of nothing is left out.
    """
    found: dict[str, list[bool]] = {name: [] for name in ("parts", *SHOWN, "nothing", "one")}
    some = photographs.photographs
    for start in range(0, len(some), _BATCH):
        batch = some[start : start + _BATCH]
        shown = torch.from_numpy(np.stack([_square(one, size) for one in batch]))
        pictures = shown.permute(0, 3, 1, 2).float().to(device) / 255
        pictures = pictures.contiguous(memory_format=torch.channels_last)
        reading = Reading(*network(pictures, torch.zeros(len(batch), len(GUESS), device=device)))
        said = (
            reading.present.float().cpu().numpy(),
            reading.statements.float().cpu().numpy(),
            reading.figures.float().argmax(1).cpu().numpy(),
        )
        for one, present, statements, figures in zip(batch, *said, strict=True):
            _judge(one, present, statements, FIGURES[int(figures)], found)
    return {name: round(float(np.mean(good)), 4) for name, good in found.items() if good}


def _judge(
    photograph: Photograph,
    present: np.ndarray,
    statements: np.ndarray,
    figures: str,
    found: dict[str, list[bool]],
) -> None:
    kind = photograph.kind
    if kind is None:
        found["nothing"].append(figures == "none")
        return
    found["one"].append(figures == "one")
    part = PARTS.index(kind.part)
    found["parts"].append(bool(np.array_equal(present > 0, np.arange(len(PARTS)) == part)))
    for claim in SHOWN:
        if claim in kind.are or claim in kind.may_be:
            words = [(k, word) for k, (name, word) in enumerate(statement_labels()) if name == claim]
            _, likeliest = max(words, key=lambda one: float(statements[part, one[0]]))
            found[claim].append(kind.likely(claim, likeliest))


def _square(photograph: Photograph, size: int) -> np.ndarray:
    pixels = photograph.pixels()
    height, width = pixels.shape[:2]
    side = max(height, width)
    return cut_square(pixels, ((width - side) // 2, (height - side) // 2, side), size)

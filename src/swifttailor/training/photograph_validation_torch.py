"""How well photographs of clothes are read of which some claims are known. It loads torch."""

from __future__ import annotations

import numpy as np
import torch

from swifttailor.data.pictures.photograph_lists import Photograph
from swifttailor.data.pictures.photographs import Photographs
from swifttailor.evaluation.pictures.photographs import NOTHING, ONE, PhotographScores
from swifttailor.picture_reader.cut_square import cut_square
from swifttailor.picture_reader.figures import FIGURES
from swifttailor.picture_reader.labels import GUESS, PARTS, statement_labels
from swifttailor.picture_reader.network_torch import EyesNetwork, Reading

_BATCH = 64


@torch.no_grad()
def judge_photographs(
    network: EyesNetwork, photographs: Photographs, size: int, device: torch.device
) -> dict[str, float]:
    """How well a network reads photographs at one look.

    Returns:
        The shares of `PhotographScores`; ``nothing``: share of those that show nothing to read that are said
        to show nobody; ``one``: share of the others that are said to show one.
    """
    scores = PhotographScores()
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
            if one.main is None:
                scores.add(NOTHING, FIGURES[int(figures)] == "none")
                continue
            scores.add(ONE, FIGURES[int(figures)] == "one")
            parts = [name for name, logit in zip(PARTS, present, strict=True) if logit > 0]
            words = {part: _likeliest(logits) for part, logits in zip(PARTS, statements, strict=True)}
            scores.add_photograph(one, parts, words.__getitem__)
    return scores.shares()


def _likeliest(statements: np.ndarray) -> dict[str, str]:
    """Of each claim the word with the highest of logits (S,)."""
    found: dict[str, str] = {}
    for k in np.argsort(-statements):
        found.setdefault(*statement_labels()[int(k)])
    return found


def _square(photograph: Photograph, size: int) -> np.ndarray:
    pixels = photograph.pixels()
    height, width = pixels.shape[:2]
    side = max(height, width)
    return cut_square(pixels, ((width - side) // 2, (height - side) // 2, side), size)

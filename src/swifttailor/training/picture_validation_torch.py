"""How well a picture reader reads garments that it has not learnt from."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import torch
from torch import Tensor

from swifttailor.data.pictures.bank import PictureBank
from swifttailor.data.pictures.blocks import Family, draw
from swifttailor.data.pictures.scenes import View, Wardrobe
from swifttailor.evaluation.pictures.reading import claims_read
from swifttailor.picture_reader.labels import GUESS
from swifttailor.picture_reader.network_torch import EyesNetwork, Reading
from swifttailor.picture_reader.truth import TRUE, UNCLEAR
from swifttailor.training.picture_batch_torch import TruthTable
from swifttailor.training.picture_calibration import calibration_error, fit_scales
from swifttailor.training.picture_config import PictureConfig

SHOWN: tuple[tuple[Family, View], ...] = (
    ("plain", "front"),
    ("studio", "front"),
    ("studio", "back"),
    ("people", "front"),
    ("people", "free"),
    ("held out", "front"),
)
"""The pictures of each garment: how it looks, and from where."""
_BATCH = 64


class ValidationPictures:
    """The same pictures every time."""

    def __init__(self, bank: PictureBank, config: PictureConfig) -> None:
        """Draws the pictures `SHOWN` of each of the first garments of a bank."""
        size = config.network.image_size
        self.garments = min(config.validation_garments, len(bank))
        wardrobe = Wardrobe(bank)
        made, masks, numbers, parts = [], [], [], []
        for k in range(self.garments):
            part = bank.part(k)
            for n, (family, view) in enumerate(SHOWN):
                chance = np.random.default_rng([config.seed, 9, k, n])
                scene = draw(wardrobe, k, family, view, chance, size)
                made.append(scene.pixels)
                masks.append(scene.masks[:, :, part])
                numbers.append(k)
                parts.append(part)
        self.pictures, self.masks = np.stack(made), np.stack(masks)
        self.numbers, self.parts = np.array(numbers), np.array(parts)
        table = TruthTable(bank)
        self.judged = table.statements.numpy()[self.numbers]
        self.panels = table.panels.numpy()[self.numbers]

    def __len__(self) -> int:
        return len(self.pictures)


class Calibration(NamedTuple):
    """How sure statements should be."""

    scales: np.ndarray[Any, Any]
    """(S, 2) see `PictureReader.scales`."""
    before: float
    """Mean difference of certainty and truth without them."""
    after: float


@torch.no_grad()
def read_all(network: EyesNetwork, pictures: np.ndarray[Any, Any], device: torch.device) -> Reading:
    """What a network says of pictures (n, size, size, 3) uint8, told where it saw the wearer at first."""
    parts: list[list[Tensor]] = []
    for start in range(0, len(pictures), _BATCH):
        batch = torch.from_numpy(pictures[start : start + _BATCH]).permute(0, 3, 1, 2).float() / 255
        batch = batch.to(device).contiguous(memory_format=torch.channels_last)
        guess = torch.zeros(len(batch), len(GUESS), device=device)
        guess[:, :-1] = network(batch, guess).view
        guess[:, -1] = 1
        parts.append([value.float().cpu() for value in network(batch, guess)])
    return Reading(*(torch.cat(column) for column in zip(*parts, strict=True)))


def judge(network: EyesNetwork, held: ValidationPictures, device: torch.device) -> dict[str, Any]:
    """How well a network reads.

    Returns:
        ``claims``: of each claim the share of pictures whose likeliest word is not false, of those that show
        a garment of which one is true; ``not_false``: of all claims together; ``by_look``: the same by look
        and view; ``panels``: share of pictures with exactly the right panel names; ``mask``:
        intersection over union.
    """
    reading = read_all(network, held.pictures, device)
    rows = np.arange(len(held))
    logits = reading.statements.numpy()[rows, held.parts]
    right: dict[str, float] = {}
    of_look: list[list[np.ndarray[Any, Any]]] = [[] for _ in SHOWN]
    everything = []
    for claim, (asked, good) in claims_read(logits, held.judged).items():
        right[claim] = round(float(good.mean()), 4)
        everything.append(good)
        for n in range(len(SHOWN)):
            of_look[n].append(good[asked % len(SHOWN) == n])
    panels = (reading.panels.numpy()[rows, held.parts] > 0) == (held.panels > 0)
    mask, shown = reading.masks.numpy()[rows, held.parts] > 0, held.masks > 127
    inside = (mask & shown).sum(axis=(1, 2)) / np.maximum((mask | shown).sum(axis=(1, 2)), 1)
    names = [f"{family} {view}" for family, view in SHOWN]
    return {
        "pictures": len(held),
        "not_false": round(float(np.concatenate(everything).mean()), 4),
        "by_look": {
            name: round(float(np.concatenate(part).mean()), 4)
            for name, part in zip(names, of_look, strict=True)
        },
        "panels": round(float(panels.all(axis=1).mean()), 4),
        "mask": round(float(inside.mean()), 4),
        "claims": right,
    }


def calibrate(network: EyesNetwork, held: ValidationPictures, device: torch.device) -> Calibration:
    """What makes the statements of a network as sure as they are right.

    Fitted on every second garment; the error afterwards is that of the others. Looks that are held out have
    no part in either.
    """
    reading = read_all(network, held.pictures, device)
    rows = np.arange(len(held))
    logits = reading.statements.numpy()[rows, held.parts].astype(np.float64)
    known = np.array([SHOWN[k % len(SHOWN)][0] != "held out" for k in range(len(held))])
    half = held.numbers % 2 == 0
    scales = fit_scales(logits[known & half], held.judged[known & half])
    rest = known & ~half
    clear, true = held.judged[rest] != UNCLEAR, held.judged[rest] == TRUE
    before, after = (
        calibration_error((1 / (1 + np.exp(-said)))[clear], true[clear])
        for said in (logits[rest], logits[rest] * scales[:, 0] + scales[:, 1])
    )
    return Calibration(scales, before, after)

"""How well a picture reader reads garments that it has not learnt from."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np
import torch
from torch import Tensor

from swifttailor.data.pictures.bank import PictureBank
from swifttailor.data.pictures.blocks import Family, draw
from swifttailor.data.pictures.scenes import View, Wardrobe
from swifttailor.evaluation.pictures.reading import claims_read
from swifttailor.picture_reader.close_ups import WHOLE, sees
from swifttailor.picture_reader.labels import GUESS
from swifttailor.picture_reader.network_torch import EyesNetwork, Reading
from swifttailor.picture_reader.truth import TRUE, UNCLEAR
from swifttailor.training.picture_calibration import calibration_error, fit_scales
from swifttailor.training.picture_config import PictureConfig
from swifttailor.training.picture_truth_torch import TruthTable

Looks = tuple[tuple[Family, View], ...]
SHOWN: Looks = (
    ("plain", "front"),
    ("studio", "front"),
    ("studio", "back"),
    ("people", "front"),
    ("people", "free"),
    ("held out", "front"),
)
"""The pictures of each garment: how it looks, and from where."""
CLOSE: Looks = (("plain", "front"), ("people", "front")) * 2
"""The close-ups of each garment, each of something by lot."""
LAID: Looks = (("laid", "front"), ("laid", "back"))
"""Both for a network that learns to read garments that nobody wears."""
PLAIN: Looks = (("plain", "front"), ("plain", "back"))
"""Both for a network that learns to read plain pictures alone."""
_BATCH = 64


class ValidationPictures:
    """The same pictures every time."""

    def __init__(self, bank: PictureBank, config: PictureConfig) -> None:
        """Draws the pictures `SHOWN`, and those of `CLOSE`, of each of the first garments of a bank."""
        self.garments = min(config.validation_garments, len(bank))
        self.only_near = config.close == 1
        self.looks, near = (PLAIN, 2 * PLAIN) if config.only_plain else (SHOWN, CLOSE)
        if config.only_laid:
            self.looks, near = LAID, ()
        table, wardrobe = TruthTable(bank), Wardrobe(bank)
        self.whole = _drawn(wardrobe, table, self.garments, self.looks, config, close=False)
        self.near = _drawn(wardrobe, table, self.garments, near, config, close=True) if near else None
        """None of a network that never looks from near."""

    def __len__(self) -> int:
        return len(self.whole.pictures)


class Shown(NamedTuple):
    """Some pictures and what is true of them."""

    pictures: np.ndarray[Any, Any]
    masks: np.ndarray[Any, Any]
    numbers: np.ndarray[Any, Any]
    parts: np.ndarray[Any, Any]
    views: np.ndarray[Any, Any]
    judged: np.ndarray[Any, Any]
    """What a close-up does not tell is unclear."""
    panels: np.ndarray[Any, Any]


def _drawn(
    wardrobe: Wardrobe,
    table: TruthTable,
    garments: int,
    shown: Looks,
    config: PictureConfig,
    *,
    close: bool,
) -> Shown:
    scenes, numbers = [], np.repeat(np.arange(garments), len(shown))
    parts = np.array([wardrobe.bank.part(int(k)) for k in numbers])
    for place, number in enumerate(numbers):
        family, view = shown[place % len(shown)]
        chance = np.random.default_rng([config.seed, 9, int(number), place % len(shown)])
        size = config.network.image_size
        scenes.append(
            draw(wardrobe, int(number), family, view, chance, size, close=close, parts=config.parts)
        )
    judged = table.statements.numpy()[numbers]
    shown_of = np.array([scene.close_up for scene in scenes])
    views = np.stack([scene.views for scene in scenes])
    told = sees(shown_of, views[:, 1]).statements
    if close:
        told[shown_of == WHOLE] = False
    return Shown(
        np.stack([scene.pixels for scene in scenes]),
        np.stack([scene.masks[:, :, part] for scene, part in zip(scenes, parts, strict=True)]),
        numbers,
        parts,
        views,
        np.where(told, judged, UNCLEAR),
        table.panels.numpy()[numbers],
    )


class Calibration(NamedTuple):
    """How sure statements should be."""

    scales: np.ndarray[Any, Any]
    """(S, 2) see `PictureReader.scales`."""
    before: float
    """Mean difference of certainty and truth without them."""
    after: float


@torch.no_grad()
def read_all(network: EyesNetwork, shown: Shown, device: torch.device, *, seen: bool = False) -> Reading:
    """What a network says of pictures, told where it saw the wearer at first, or where he is if `seen`."""
    parts: list[list[Tensor]] = []
    for start in range(0, len(shown.pictures), _BATCH):
        batch = torch.from_numpy(shown.pictures[start : start + _BATCH]).permute(0, 3, 1, 2).float() / 255
        batch = batch.to(device).contiguous(memory_format=torch.channels_last)
        guess = torch.zeros(len(batch), len(GUESS), device=device)
        if seen:
            guess[:, :-1] = torch.from_numpy(shown.views[start : start + _BATCH])
        else:
            guess[:, :-1] = Reading(*network(batch, guess)).view
        guess[:, -1] = 1
        parts.append([value.float().cpu() for value in network(batch, guess)])
    return Reading(*(torch.cat(column) for column in zip(*parts, strict=True)))


def judge(network: EyesNetwork, held: ValidationPictures, device: torch.device) -> dict[str, Any]:
    """How well a network reads.

    Returns:
        ``claims``: of each claim the share of pictures whose likeliest word is not false, of those that show
        a garment of which one is true; ``not_false``: of all claims together; ``by_look``: the same by look
        and view; ``near``: the claims that close-ups tell of; ``panels``: share of pictures with exactly the
        right panel names; ``mask``: intersection over union. A share of nothing is None.
    """
    shown = held.whole
    reading = read_all(network, shown, device)
    rows = np.arange(len(held))
    looks = held.looks
    of_look: list[list[np.ndarray[Any, Any]]] = [[] for _ in looks]
    found = claims_read(reading.statements.numpy()[rows, shown.parts], shown.judged)
    for asked, good in found.values():
        for n in range(len(looks)):
            of_look[n].append(good[asked % len(looks) == n])
    found_near = {}
    if held.near is not None:
        near = read_all(network, held.near, device, seen=True).statements.numpy()
        found_near = claims_read(near[np.arange(len(near)), held.near.parts], held.near.judged)
    panels = (reading.panels.numpy()[rows, shown.parts] > 0) == (shown.panels > 0)
    mask, true = reading.masks.numpy()[rows, shown.parts] > 0, shown.masks > 127
    inside = (mask & true).sum(axis=(1, 2)) / np.maximum((mask | true).sum(axis=(1, 2)), 1)
    names = [f"{family} {view}" for family, view in looks]
    return {
        "pictures": len(held),
        "not_false": _share_of(good for _, good in found.values()),
        "by_look": {name: _share_of(part) for name, part in zip(names, of_look, strict=True)},
        "near": {claim: _share_of([good]) for claim, (_, good) in found_near.items()},
        "near_not_false": _share_of(good for _, good in found_near.values()),
        "panels": round(float(panels.all(axis=1).mean()), 4),
        "mask": round(float(inside.mean()), 4),
        "claims": {claim: _share_of([good]) for claim, (_, good) in found.items()},
    }


def _share_of(parts: Iterable[np.ndarray[Any, Any]]) -> float | None:
    """None of nothing: files hold no values that are not numbers."""
    found = list(parts)
    return round(float(np.concatenate(found).mean()), 4) if found else None


def calibrate(network: EyesNetwork, held: ValidationPictures, device: torch.device) -> Calibration:
    """What makes the statements of a network as sure as they are right.

    Fitted on every second garment; the error afterwards is that of the others. Looks that are held out have
    no part in either. Of a network that has learnt from close-ups alone, close-ups decide.
    """
    shown = held.near if held.only_near and held.near is not None else held.whole
    count = len(shown.pictures)
    reading = read_all(network, shown, device, seen=held.only_near)
    logits = reading.statements.numpy()[np.arange(count), shown.parts].astype(np.float64)
    known = np.ones(count, bool)
    if not held.only_near:
        known = np.array([held.looks[k % len(held.looks)][0] != "held out" for k in range(count)])
    half = shown.numbers % 2 == 0
    scales = fit_scales(logits[known & half], shown.judged[known & half])
    rest = known & ~half
    clear, true = shown.judged[rest] != UNCLEAR, shown.judged[rest] == TRUE
    before, after = (
        calibration_error((1 / (1 + np.exp(-said)))[clear], true[clear])
        for said in (logits[rest], logits[rest] * scales[:, 0] + scales[:, 1])
    )
    return Calibration(scales, before, after)

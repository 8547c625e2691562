"""From samples to the tensors of one optimiser step, on any device."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import torch
from torch import Tensor

from swifttailor.data.reader import SplitReader
from swifttailor.garment_sewer.augmentation import (
    mirror,
    mirror_points,
    move_panels,
    random_cells,
    random_steps,
)
from swifttailor.garment_sewer.conditioning import Conditioning, channel_columns
from swifttailor.garment_sewer.losses_torch import Truth
from swifttailor.training.sewer_config import SewerConfig
from swifttailor.training.sewer_samples import SewerSample, SewerSamples


@dataclass(frozen=True, eq=False)
class Batch:
    """What a network is given, and what it should have answered."""

    conditioning: Tensor
    """(B, C, H, W)."""
    prior: Tensor
    """(B, 3, H, W) cm."""
    truth: Truth


class TrainingBatches:
    """The batches of a training, each determined by its number alone: no state to save or restore.

    On a GPU every sample is kept in its memory once it was read (about 3 MB each at 256 pixels).
    """

    def __init__(
        self,
        samples: SewerSamples,
        reader: SplitReader,
        config: SewerConfig,
        device: torch.device,
        *,
        part: int = 0,
        parts: int = 1,
    ) -> None:
        self.samples, self.reader, self.config, self.device = samples, reader, config, device
        self.part, self.parts = part, parts
        limit = config.training_garments
        self._chosen = np.random.default_rng([config.seed, 6]).permutation(len(samples))[: limit or None]
        self._kept: dict[tuple[int, int], SewerSample] | None = {} if device.type == "cuda" else None

    def __getitem__(self, step: int) -> Batch:
        """This process's share of the batch of an optimiser step, from 0."""
        size, count = self.config.batch_size, len(self._chosen)
        chosen = []
        for place in range(step * size + self.part, (step + 1) * size, self.parts):
            epoch, number = divmod(place, count)
            order = self._order(epoch)
            chosen.append(
                self._varied(int(order[number]), np.random.default_rng([self.config.seed, 1, place]))
            )
        return assemble(chosen, self.config.conditioning)

    def _order(self, epoch: int) -> np.ndarray:
        if getattr(self, "_epoch", None) != epoch:
            order = self.reader.order(self.config.seed, epoch)
            self._epoch, self._numbers = epoch, order[np.isin(order, self._chosen)]
        return self._numbers

    def _varied(self, k: int, chance: np.random.Generator) -> SewerSample:
        config = self.config
        sample = self._read(k, int(chance.integers(config.layouts)))
        if chance.random() < config.mirror:
            sample = replace(sample, table=mirror(sample.table), target=mirror_points(sample.target))
        if chance.random() < config.repack:
            boxes = sample.table.panel_box.cpu().numpy()
            if config.conditioning.layout == "per_panel":
                steps = random_cells(len(boxes), sample.table.resolution, chance)
            else:
                steps = random_steps(boxes, sample.table.resolution, chance)
            table = move_panels(sample.table, torch.as_tensor(steps, device=self.device))
            sample = replace(sample, table=table)
        return sample

    def _read(self, k: int, layout: int) -> SewerSample:
        if self._kept is None:
            return to_tensors(self.samples.get(k, layout), self.device)
        if (k, layout) not in self._kept:
            self._kept[k, layout] = to_tensors(self.samples.get(k, layout), self.device)
        return self._kept[k, layout]


def to_tensors(sample: SewerSample, device: torch.device) -> SewerSample:
    """The sample with tensors on a device instead of numpy arrays."""
    return sample.map(lambda array: torch.as_tensor(array, device=device))


def assemble(samples: Sequence[SewerSample], conditioning: Conditioning) -> Batch:
    """Draws samples made of tensors into images.

    Args:
        samples: Of one resolution, on one device.
        conditioning: Which channels.
    """
    size = samples[0].table.resolution
    device = samples[0].target.device
    channels = conditioning.count
    # All that is drawn of a pixel: the channels, prior, target, local position, and four single values.
    images = torch.zeros((len(samples), channels + 12, size * size), device=device)
    pairs, sides = [], []
    for k, sample in enumerate(samples):
        table = sample.table
        columns = [
            *channel_columns(table, conditioning.channels),
            *table.prior.unbind(1),
            *sample.target.unbind(1),
            *table.local().unbind(1),
            (table.panel + 1).float(),
            table.contour.float(),
            sample.edge_distance.float(),
            sample.ignores_arms[table.panel].float(),
        ]
        images[k, :, table.pixels] = torch.stack(columns)
        place = table.pixels + k * size * size
        sewn = torch.nonzero(table.partner >= 0)[:, 0]
        pairs.append(torch.stack([place[sewn], place[table.partner[sewn]]], dim=1))
        sides.append(torch.where(sample.sides >= 0, place[sample.sides.clamp(min=0)], -1))
    shaped = images.view(len(samples), channels + 12, size, size)
    prior, target, local, single = shaped[:, channels:].split([3, 3, 2, 4], dim=1)
    panel = single[:, 0].long() - 1
    truth = Truth(
        target=target,
        occupancy=(panel >= 0).float()[:, None],
        panel=panel,
        contour=single[:, 1] > 0,
        local=local,
        edge_distance=single[:, 2],
        ignores_arms=single[:, 3] > 0,
        pairs=torch.cat(pairs),
        sides=torch.cat(sides),
    )
    return Batch(shaped[:, :channels], prior, truth)

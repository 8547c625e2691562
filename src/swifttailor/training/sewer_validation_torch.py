"""How good a GarmentSewer is on garments it was not trained on, in numbers and pictures."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
import torch

from swifttailor.body import Body
from swifttailor.data.reader import SplitReader
from swifttailor.evaluation.garment_error import GarmentError, measure_error, summarize
from swifttailor.evaluation.spread import spread
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer.closing import close_seams
from swifttailor.garment_sewer.network_torch import SewerNetwork
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.ggi.outline_decode import OutlineSampler, outline_sampler
from swifttailor.training.sewer_batch_torch import assemble, to_tensors
from swifttailor.training.sewer_config import SewerConfig
from swifttailor.training.sewer_samples import SewerSamples, choose_layout

_PICTURE = (900, 540)


@dataclass(frozen=True, eq=False)
class _Known:
    sampler: OutlineSampler
    drape: np.ndarray


class Validation:
    """Some garments of a split, always the same, evenly spread over it."""

    def __init__(
        self, samples: SewerSamples, reader: SplitReader, config: SewerConfig, device: torch.device
    ) -> None:
        self.samples, self.reader, self.config, self.device = samples, reader, config, device
        self.numbers = spread(range(len(reader)), config.validation_garments)
        self._known: dict[int, _Known] = {}

    @cached_property
    def _body(self) -> BodyDistance:
        return BodyDistance.of(Body.default())

    def measure(self, network: SewerNetwork) -> dict[str, Any]:
        """Means over the garments, and over those of each kind (`summarize`)."""
        return summarize([self.error_of(network, k) for k in self.numbers])

    def error_of(self, network: SewerNetwork, k: int) -> GarmentError:
        """The error of garment number k of the split."""
        known = self._of(k)
        return measure_error(known.sampler.mesh, self._predict(network, k), known.drape, self._body)

    def draw(self, network: SewerNetwork, path: Path) -> None:
        """Draws garments as they are made of predictions, and their drapes beside them, from three sides.

        Raises:
            InputError: The file cannot be written.
        """
        from PIL import Image

        from swifttailor.atomic_files import write_atomically
        from swifttailor.garment.preview import render_preview

        chosen = self.numbers[:: max(1, len(self.numbers) // self.config.pictures)][: self.config.pictures]
        sheet = Image.new("RGB", (_PICTURE[0] * 2, _PICTURE[1] * len(chosen)))
        for row, k in enumerate(chosen):
            known = self._of(k)
            mesh = known.sampler.mesh
            sewn = close_seams(mesh, self._predict(network, k), self._body)
            for column, vertices in enumerate((sewn, known.drape)):
                picture = render_preview(Garment(mesh, vertices), Body.default(), size=_PICTURE)
                sheet.paste(picture, (column * _PICTURE[0], row * _PICTURE[1]))
        write_atomically(path, lambda temporary: sheet.save(temporary), overwrite=True)

    def _of(self, k: int) -> _Known:
        if k not in self._known:
            sample = self.reader[k]
            layout = choose_layout(sample, self.samples.resolution, 0, self.samples.kind)
            self._known[k] = _Known(outline_sampler(layout, sample.mesh), sample.vertices)
        return self._known[k]

    @torch.no_grad()
    def _predict(self, network: SewerNetwork, k: int) -> np.ndarray:
        """(m, 3) cm at the flat vertices of the garment's mesh."""
        sample = to_tensors(self.samples.get(k), self.device)
        batch = assemble([sample], self.config.conditioning)
        image = network(batch.conditioning, batch.truth.occupancy, batch.prior)[0]
        values = image.reshape(3, -1)[:, sample.table.pixels].T
        return self._of(k).sampler.weights @ values.double().cpu().numpy()

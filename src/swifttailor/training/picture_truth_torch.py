"""What is true of pictures, as a network is to say it. It loads torch."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor

from swifttailor.data.pictures.bank import PictureBank
from swifttailor.data.pictures.panel_cells import SEAM
from swifttailor.data.pictures.photographs import Photographs
from swifttailor.data.pictures.scenes import UNTOLD
from swifttailor.parameter_reader.placed_designs import PlacedDesigns
from swifttailor.picture_reader.network_torch import scaled
from swifttailor.picture_reader.truth import TRUE, UNCLEAR
from swifttailor.picture_reader.units import BOX_CM
from swifttailor.training.design_table_torch import DesignTable


class Answers(NamedTuple):
    """What is true of B pictures, as `network_torch.Reading` says it; masks of what counts beside it."""

    present: Tensor
    """(B, 2) 0 or 1."""
    told: Tensor
    """(B, 2) whether that is known."""
    whole: Tensor
    """(B,) whether it is no close-up: these tell of one garment, and not of all of it."""
    placed: Tensor
    """(B,) whether `view` and `masks` are known."""
    statements: Tensor
    """(B, 2, S) 0 or 1."""
    clear: Tensor
    """(B, 2, S) whether that is certain, and told."""
    has: Tensor
    """(B, 2, M) 0 or 1."""
    measured: Tensor
    """(B, 2, M) whether that is told."""
    measures: Tensor
    """(B, 2, M) `scaled`; 0 where there is none."""
    panels: Tensor
    """(B, 2, P) 0 or 1."""
    named: Tensor
    """(B, 2, P) whether that is told."""
    boxes: Tensor
    """(B, 2, P, 5)."""
    view: Tensor
    """(B, 6)."""
    figures: Tensor
    """(B,) number of `FIGURES`."""
    masks: Tensor
    """(B, 2, h, w) shares."""
    places: Tensor
    """(B, 3, h, w) metres; NaN where nobody is."""
    kinds: Tensor
    """(B, h, w) number of `PANEL_KINDS`; -1 where no garment is."""
    seams: Tensor
    """(B, h, w) 0 or 1."""
    designs: Tensor
    """(B, 2, D, V) how right each value of each design parameter is; zeros where it does not matter."""


class OfEach(NamedTuple):
    """Something of each statement, measure and panel."""

    statements: Tensor
    """(..., S)."""
    measures: Tensor
    """(..., M)."""
    panels: Tensor
    """(..., P)."""


class TruthTable:
    """What is true of all garments of a bank, as tensors."""

    def __init__(
        self,
        bank: PictureBank,
        device: torch.device | None = None,
        designs: PlacedDesigns | None = None,
        *,
        photographs: Photographs | None = None,
    ) -> None:
        known = bank.truths(range(len(bank)))
        names = bank.ids
        self.garments = len(bank)
        if photographs is not None:
            behind = photographs.truths()
            known = {name: np.concatenate([v, behind[name]]) for name, v in known.items()}
            names = [*names, *(f"photographed {k}" for k in range(len(behind["part"])))]
        found = {name: torch.from_numpy(v).to(device or "cpu") for name, v in known.items()}
        self.statements, self.measures = found["statements"], found["measures"].float()
        self.panels, self.boxes = found["panels"], found["boxes"]
        self.designs = DesignTable(names, designs, device)

    def answers(
        self,
        garments: Tensor,
        whole: Tensor,
        placed: Tensor,
        told: OfEach,
        designs: Tensor,
        views: Tensor,
        figures: Tensor,
        masks: Tensor,
        places: Tensor,
        cells: Tensor,
    ) -> Answers:
        """For pictures of garments (B, 2), -1 for none, `UNTOLD` where that is not known.

        Args:
            garments: Numbers in the bank.
            whole: (B,) whether it is no close-up.
            placed: (B,) as `Answers` has it.
            told: What each picture tells of, see `sees`.
            designs: (B, D) which design parameters it tells, see `sees_designs`.
            views: The others are as `Answers` has them.
            figures: The same.
            masks: The same.
            places: The same.
            cells: (B, h, w) as `panel_cells` has them; NaN outside the picture.
        """
        cells = cells.nan_to_num(0.0).long()
        present = garments >= 0
        k = garments.clamp_min(0)
        judged, measures, panels = self.statements[k], self.measures[k], self.panels[k]
        told = OfEach(*(table[:, None] & present[..., None] for table in told))
        # Of photographs neither measures nor panels are known.
        drawn = (garments < self.garments)[..., None]
        told = told._replace(measures=told.measures & drawn, panels=told.panels & drawn)
        designed = self.designs.answers(k, present[..., None] & designs[:, None])
        designed = torch.where(drawn[..., None], designed, self.designs.unknown(k))
        return Answers(
            present.float(),
            garments != UNTOLD,
            whole,
            placed,
            (judged == TRUE).float(),
            (judged != UNCLEAR) & told.statements,
            (measures.isfinite() & present[..., None]).float(),
            told.measures,
            scaled(measures.nan_to_num(0.0)),
            panels.float() * present[..., None],
            told.panels,
            self.boxes[k].float() / BOX_CM,
            views,
            figures,
            masks,
            places,
            cells % SEAM - 1,
            (cells >= SEAM).float(),
            designed,
        )

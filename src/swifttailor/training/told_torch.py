"""What of a pattern a network is told in training: all, or as pictures and words tell it. It loads torch."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import torch
from torch import Tensor

from swifttailor.parameter_reader.features import BOX_UNIT_CM
from swifttailor.pattern_library.sought import SURE, Sought
from swifttailor.picture_reader.truth import TRUE, Truth

WORDY, FORESEEN = 0.4, 0.7
"""Share of patterns of which words tell, and of these the share of which panels are foreseen, too."""
MOST_DOUBT = 0.35


class Told:
    """What is true of patterns, and what of it is told."""

    def __init__(self, truths: Sequence[Truth]) -> None:
        full = [Sought.of_truth(truth) for truth in truths]

        def stacked(name: str) -> Tensor:
            return torch.from_numpy(np.stack([getattr(one, name) for one in full]))

        self.statements, self.has, self.panels = map(stacked, ("statements", "has", "panels"))
        self.measures = stacked("measured")[..., 0]
        self.boxes, self.placed = stacked("boxes"), stacked("placed").clamp(max=1)
        self.true = torch.from_numpy(np.stack([truth.statements == TRUE for truth in truths]))

    def all_of(self, rows: Tensor) -> Tensor:
        """(B, F) everything, without a mistake."""
        ones = [torch.ones_like(x[rows]) for x in (self.statements, self.has, self.panels)]
        return _features(
            (self.statements[rows], ones[0]),
            (self.has[rows], ones[1], self.measures[rows]),
            (self.panels[rows], ones[2]),
            (self.boxes[rows], self.placed[rows]),
        )

    def by_chance(self, rows: Tensor, chance: torch.Generator) -> Tensor:
        """(B, F) as pictures tell it, with mistakes, or as few words do."""
        count = len(rows)

        def lots(*shape: int) -> Tensor:
            return torch.rand(*shape, generator=chance)

        doubt = MOST_DOUBT * lots(count, 1)

        def doubted(values: Tensor) -> Tensor:
            logits = torch.logit(values.clamp(1e-3, 1 - 1e-3)) * (1 - doubt)
            off = 4 * doubt * torch.randn(values.shape, generator=chance)
            return torch.sigmoid(logits + off).clamp(1 - SURE, SURE)

        statements, has, panels = self.statements[rows], self.has[rows], self.panels[rows]
        measures, placed = self.measures[rows], self.placed[rows]
        off_measures = measures + 0.3 * doubt * torch.randn(measures.shape, generator=chance)
        off = 12 * doubt[..., None] * torch.randn(self.boxes[rows].shape, generator=chance)
        boxes = self.boxes[rows] + off * (placed > 0)[..., None]
        words = lots(count, 1) < WORDY
        said = (lots(*statements.shape) < 0.15 + 0.75 * lots(count, 1)) & self.true[rows]
        told = (lots(*has.shape) < 0.3 * lots(count, 1)) & (has > 0.5)
        named = ~words | (lots(count, 1) < FORESEEN)
        asked = torch.where(said, torch.full_like(statements, SURE), torch.full_like(statements, 0.5))
        asked_has = torch.where(told, torch.full_like(has, SURE), torch.full_like(has, 0.5))
        return _features(
            (torch.where(words, asked, doubted(statements)), (~words | said).float()),
            (
                torch.where(words, asked_has, doubted(has)),
                (~words | told).float(),
                torch.where(words, measures, off_measures),
            ),
            (doubted(panels), named.float().expand_as(panels)),
            (boxes, placed * (~words).float()),
        )


def _features(
    said: tuple[Tensor, Tensor],
    measured: tuple[Tensor, Tensor, Tensor],
    named: tuple[Tensor, Tensor],
    placed: tuple[Tensor, Tensor],
) -> Tensor:
    """(B, F) the same as `features_of`, of many."""
    (statements, told), (has, known, values), (panels, names), (boxes, there) = said, measured, named, placed
    rows = [told * (2 * statements - 1), told, known * (2 * has - 1), known, known * has * values]
    rows += [names * (2 * panels - 1), names, (there[..., None] * boxes / BOX_UNIT_CM).flatten(1)]
    return torch.cat(rows, 1).float()

"""How well a PatternMaker continues unknown patterns, each token from the true ones before it."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
import torch
import torch.nn.functional as F

from swifttailor.evaluation.spread import spread
from swifttailor.pattern_maker.asking.foresight import BOX
from swifttailor.pattern_maker.network.network_torch import PatternMakerNetwork
from swifttailor.pattern_maker.tokens.normalization import POINT_SCALE, TRANSLATION_SCALE
from swifttailor.pattern_maker.tokens.vocabulary import COMMANDS, MOVE, PANEL_TOKENS, SIZE
from swifttailor.training.maker_batch_torch import Batch, assemble, with_plans
from swifttailor.training.maker_config import MakerConfig
from swifttailor.training.maker_samples import TASKS, MakerSamples

BATCH = 16


class Validation:
    """Some samples of each task, always the same."""

    def __init__(self, samples: MakerSamples, config: MakerConfig, device: torch.device) -> None:
        self.samples, self.config, self.device = samples, config, device

    @torch.no_grad()
    def measure(self, network: PatternMakerNetwork) -> dict[str, Any]:
        """Of each task, medians of errors in cm among others.

        Returns:
            By task ``token_accuracy``, the share of tokens that are the most probable ones, ``token_loss``,
            ``corner_cm`` and ``placement_cm``; ``panels_foreseen``, the share of the prompts of which the
            panels of the answer are all known before it begins, and no others; and ``foreseen_cm``, how far
            the sides of these panels' boxes are off then.
        """
        return {task: self._measure(network, batches) for task, batches in self._batches.items()}

    @cached_property
    def _batches(self) -> dict[str, list[Batch]]:
        found: dict[str, list[Batch]] = {}
        count = len(self.samples.bank)
        for number, task in enumerate(TASKS):
            able = [k for k in range(count) if task in self.samples.tasks_of(k)]
            if not able or not getattr(self.config.tasks, task):
                continue
            chance = np.random.default_rng([0, 6, number])
            chosen = spread(able, self.config.validation_samples)
            plans = [self.samples.plan_task(garment, task, chance) for garment in chosen]
            plans.sort(key=lambda plan: plan.length)
            made = [self.samples.make(plan, clean=True) for plan in plans]
            size = self.config.network.image_size
            parts = [made[k : k + BATCH] for k in range(0, len(made), BATCH)]
            found[task] = [assemble(part, size, network=self.config.network) for part in parts]
        return found

    def _measure(self, network: PatternMakerNetwork, batches: list[Batch]) -> dict[str, float]:
        losses, right, corners, placements, foresight, boxes = [], [], [], [], [], []
        for batch in batches:
            batch = with_plans(batch.to(self.device), network)
            tokens = batch.next_tokens
            logits, numbers, foreseen = network(*batch.given)
            panels = slice(PANEL_TOKENS.start, PANEL_TOKENS.stop)
            same = (foreseen[:, panels] > 0) == (batch.present[:, panels] > 0)
            foresight.append(same.all(-1).float())
            panel_numbers = foreseen[:, SIZE:].unflatten(1, batch.panel_numbers.shape[1:])
            sides = (panel_numbers - batch.panel_numbers)[..., BOX][batch.panels_known[..., BOX.start]]
            boxes.append((sides.view(-1, 2, 2).abs() * sides.new_tensor(POINT_SCALE)).flatten())
            losses.append(F.cross_entropy(logits, tokens, reduction="none"))
            right.append((logits.argmax(-1) == tokens).float())
            off = numbers - batch.next_numbers
            of_edges = (tokens >= COMMANDS.start) & (tokens < COMMANDS.stop)
            corners.append(_lengths(off[of_edges, :2], POINT_SCALE))
            placements.append(_lengths(off[tokens == MOVE, :3], TRANSLATION_SCALE))
        return {
            "token_accuracy": torch.cat(right).mean().item(),
            "token_loss": torch.cat(losses).mean().item(),
            "corner_cm": torch.cat(corners).median().item(),
            "placement_cm": torch.cat(placements).median().item(),
            "panels_foreseen": torch.cat(foresight).mean().item(),
            "foreseen_cm": torch.cat(boxes).median().item(),
        }


def _lengths(vectors: torch.Tensor, scale: np.ndarray) -> torch.Tensor:
    return (vectors * torch.as_tensor(scale, dtype=vectors.dtype, device=vectors.device)).norm(dim=-1)

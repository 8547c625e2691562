"""What a PatternMaker learns by (paper, Sec. 4.1). Import this where it is needed: it loads torch."""

from __future__ import annotations

import torch
import torch.nn.functional as F
from torch import Tensor

from swifttailor.pattern_maker.asking.copying import UNCHANGED
from swifttailor.pattern_maker.tokens.token_sequence import padded_mask
from swifttailor.pattern_maker.tokens.vocabulary import MOVE, SIZE
from swifttailor.training.maker_batch_torch import Batch
from swifttailor.training.maker_config import MakerLosses

FORESIGHT_BETA = 0.2
"""Where the error of foreseen numbers turns from squared to absolute, normalised units: about 5 cm."""


def compute_losses(
    logits: Tensor, numbers: Tensor, foreseen: Tensor, batch: Batch, weights: MakerLosses
) -> dict[str, Tensor]:
    """Cross entropy of the tokens and error of their numbers (AIpparel), and what of the answer is foreseen.

    Args:
        logits: (n, outputs).
        numbers: (n, 8) predicted.
        foreseen: (B + R, `FORESEEN`) of the answers to all prompts, those that are only read included.
        batch: With the truth.
        weights: How they are added.

    Returns:
        ``tokens``, ``numbers``, ``foresight``, ``foreseen_numbers`` and ``total``.
    """
    tokens = batch.next_tokens
    outputs = logits.shape[-1]
    mask = torch.tensor(padded_mask(outputs), device=tokens.device)[tokens]
    penalty = number_penalty(numbers, batch.next_numbers, tokens, weights.penalty)
    other, elsewhere = _unlike_counterparts(batch, mask)
    extra = weights.changed - 1
    of_tokens = (F.cross_entropy(logits, tokens, reduction="none") * (1 + extra * other)).mean()
    each = (penalty * mask).sum(-1) * (1 + extra * elsewhere)
    if weights.by_kind:
        kinds = tokens.new_zeros(outputs, dtype=torch.float32)
        sums = kinds.index_add(0, tokens, each)
        counts = kinds.index_add(0, tokens, torch.ones_like(each))
        of_numbers = (sums / counts.clamp(min=1)).sum()
    else:
        of_numbers = each.sum() / mask.any(-1).sum().clamp(min=1)
    foresight = F.binary_cross_entropy_with_logits(foreseen[:, :SIZE], batch.present)
    apart = F.smooth_l1_loss(
        foreseen[:, SIZE:].unflatten(1, batch.panel_numbers.shape[1:]),
        batch.panel_numbers,
        beta=FORESIGHT_BETA,
        reduction="none",
    )
    foreseen_numbers = (apart * batch.panels_known).sum() / batch.panels_known.sum().clamp(min=1)
    return {
        "tokens": of_tokens,
        "numbers": of_numbers,
        "foresight": foresight,
        "foreseen_numbers": foreseen_numbers,
        # Added with weight 0 as well: several processes wait for the gradients of all weights.
        "total": of_tokens
        + weights.numbers * of_numbers
        + weights.foresight * foresight
        + weights.foreseen_numbers * foreseen_numbers,
    }


def _unlike_counterparts(batch: Batch, mask: Tensor) -> tuple[Tensor, Tensor]:
    """Which tokens (n,) of the answers are not their counterparts; and these with those of other numbers."""
    own = batch.copied.flatten()[batch.answers]
    numbers = batch.copied_numbers.flatten(0, 1)[batch.answers]
    other = (own >= 0) & (own != batch.next_tokens)
    apart = ((numbers - batch.next_numbers).abs() * mask).amax(-1) > UNCHANGED
    return other, other | ((own >= 0) & apart)


def number_penalty(predicted: Tensor, true: Tensor, tokens: Tensor, kind: str, beta: float = 0.05) -> Tensor:
    """(n, 8) how far numbers are off; of a quaternion the nearer of both signs is taken.

    Args:
        predicted: (n, 8).
        true: (n, 8).
        tokens: (n,) of patterns, whose numbers they are.
        kind: ``squared``, or ``absolute`` (squared below `beta`, normalised units).
        beta: See there.
    """
    agreement = (predicted[:, 3:7] * true[:, 3:7]).sum(-1, keepdim=True).detach()
    sign = torch.where((agreement < 0) & (tokens == MOVE)[:, None], -1.0, 1.0)
    true = torch.cat([true[:, :3], true[:, 3:7] * sign, true[:, 7:]], dim=-1)
    if kind == "squared":
        return (predicted - true).square()
    return F.smooth_l1_loss(predicted, true, beta=beta, reduction="none")

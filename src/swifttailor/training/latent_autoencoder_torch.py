"""The first stage of a latent diffusion: an auto-encoder of panel tensors. It loads torch."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import torch
from torch import Tensor, nn
from torch.nn import functional as F

from swifttailor.errors import PatternError
from swifttailor.latent_diffusion import tensor_layout as at
from swifttailor.latent_diffusion.network_torch import PatternDecoder, PatternEncoder, WholeDecoder, quantised
from swifttailor.latent_diffusion.tensor_pattern import pattern_of
from swifttailor.pattern import Pattern
from swifttailor.training.latent_bank import TensorBank

WIDTH, HIDDEN, ENCODER_BLOCKS, DECODER_BLOCKS = 160, 448, 2, 3
_UNITS = [10.0] * 2 + [0.2] * 6 + [0.3] + [10.0] * 3 + [0.2] * 4 + [10.0] * 3
"""What 1 stands for in a network: 10 cm, a fifth of a chord, ..."""
_COUNTS = [1.0] * 9 + [2.0] * 3 + [0.5] * 7
"""How much each number counts: by tags stitches are found, and placements stand on every edge."""
_SHARP = 0.05
"""Beyond so many units a mistake counts in proportion, not squared."""


@dataclass(frozen=True, eq=False)
class Panels:
    """Panel tensors as the networks read them, panel by panel."""

    rows: Tensor
    """(P, EDGES, NUMBERS) in units of the network, half precision; 0 where nothing is."""
    slots: Tensor
    """(P,)."""
    first: Tensor
    """(N + 1,) number of the first panel of each pattern."""
    middle: Tensor
    """(slots, EDGES, continuous numbers) what 0 stands for."""

    @staticmethod
    def of(bank: TensorBank, middle: Tensor | None = None) -> Panels:
        """Of a bank.

        Args:
            bank: Of patterns.
            middle: Of the patterns that are learnt from; the means of this bank when None.
        """
        rows, slots = torch.from_numpy(bank.rows).clone(), torch.from_numpy(bank.slot).long()
        first = torch.from_numpy(np.searchsorted(bank.owner, np.arange(len(bank) + 1)))
        _turn_alike(rows, slots)
        said = told(rows)
        if middle is None:
            count = torch.zeros(len(at.SLOTS), *said.shape[1:]).index_add_(0, slots, said.float())
            total = torch.zeros_like(count).index_add_(0, slots, rows[..., at.CONTINUOUS] * said)
            middle = total / count.clamp(min=1)
        rows[..., at.CONTINUOUS] = (rows[..., at.CONTINUOUS] - middle[slots]) / units() * said
        return Panels(rows.half(), slots, first, middle)

    def __len__(self) -> int:
        return len(self.first) - 1

    def batch(self, patterns: Tensor) -> tuple[Tensor, Tensor, Tensor]:
        """Rows (B, P, EDGES, NUMBERS), slots (B, P) and which panels there are (B, P)."""
        start, end = self.first[patterns], self.first[patterns + 1]
        place = torch.arange(int((end - start).max()))
        there = place < (end - start)[:, None]
        which = (start[:, None] + place).clamp(max=len(self.slots) - 1)
        return self.rows[which].float() * there[..., None, None], self.slots[which] * there, there

    def draw(self, count: int, chance: torch.Generator) -> Tensor:
        """Numbers of `count` patterns; of twice as many that were drawn, those of most or fewest panels.

        So little is padded, and each pattern is drawn as often as another.

        Args:
            count: Of patterns.
            chance: Draws them.
        """
        drawn = torch.randint(len(self), (2 * count,), generator=chance)
        sizes = torch.diff(self.first)[drawn].argsort()
        large = bool(torch.rand((), generator=chance) < 0.5)
        return drawn[sizes[count:] if large else sizes[:count]]


def units() -> Tensor:
    """(continuous numbers,) what 1 stands for in the networks."""
    return torch.tensor(_UNITS)


def told(rows: Tensor) -> Tensor:
    """(..., continuous numbers) which numbers of edges say anything, by their bits."""
    kind = rows[..., at.KIND.start] + 2 * rows[..., at.KIND.start + 1]
    there = rows[..., at.THERE] > 0.5
    parts = [(there, 2), (there & (kind == 1), 2), (there & (kind == 2), 4), (there & (kind == 3), 1)]
    parts += [(there & (rows[..., at.FREE] < 0.5), 3), (there, 7)]
    return torch.cat([part[..., None].expand(*part.shape, count) for part, count in parts], -1)


def told_bits(rows: Tensor) -> Tensor:
    """(..., bits) the same of bits; which edges there are is told of all slots."""
    there = rows[..., at.THERE] > 0.5
    arc = there & (rows[..., at.KIND] > 0.5).all(-1)
    stitched = there & (rows[..., at.FREE] < 0.5)
    every = torch.ones_like(there)
    return torch.stack([arc, arc, *[there] * 6, stitched, every], -1)


class AutoEncoder(nn.Module):
    """Encoder and decoder together."""

    counts: Tensor

    def __init__(self) -> None:
        """With random weights."""
        super().__init__()
        self.encoder = PatternEncoder(width=WIDTH, hidden=HIDDEN, blocks=ENCODER_BLOCKS)
        self.decoder = PatternDecoder(width=WIDTH, hidden=HIDDEN, blocks=DECODER_BLOCKS)
        self.register_buffer("counts", torch.tensor(_COUNTS))

    def loss(self, panels: Panels, patterns: Tensor) -> Tensor:
        """How far what comes out is from what went in."""
        rows, slots, there = panels.batch(patterns)
        latents = quantised(self.encoder(rows, slots, there))
        found = self.decoder(latents, slots, there)[there]
        rows = rows[there]
        edges = rows[..., at.THERE].sum()
        off = F.smooth_l1_loss(
            found[..., at.CONTINUOUS], rows[..., at.CONTINUOUS], beta=_SHARP, reduction="none"
        )
        numbers = (off * self.counts * told(rows)).sum() / edges
        wrong = F.binary_cross_entropy_with_logits(found[..., at.BITS], rows[..., at.BITS], reduction="none")
        bits = (wrong * told_bits(rows)).sum() / edges
        which = torch.zeros(len(patterns), len(at.SLOTS)).scatter_reduce(1, slots, there.float(), "amax")
        logits = self.decoder.which_panels(latents)
        panels_off = F.binary_cross_entropy_with_logits(logits, which, reduction="sum") / len(patterns)
        return numbers + 0.5 * bits + 0.3 * panels_off

    @torch.no_grad()
    def latents(self, panels: Panels) -> Tensor:
        """(N, LATENTS, WIDE) of all patterns, quantised."""
        parts = [quantised(self.encoder(*panels.batch(part))) for part in torch.arange(len(panels)).split(64)]
        return torch.cat(parts)

    def whole_decoder(self, panels: Panels) -> WholeDecoder:
        """The decoder as it is used."""
        return WholeDecoder(self.decoder, panels.middle, units()).eval()


@torch.no_grad()
def figures_of(decoder: WholeDecoder, latents: Tensor, truths: Sequence[Pattern]) -> dict[str, Any]:
    """How much of patterns comes back: of the panels that there should be unless it says otherwise.

    Args:
        decoder: As it is used.
        latents: (N, LATENTS, WIDE) of these patterns.
        truths: (N).
    """
    sums: Counter[str] = Counter()
    corners, places, shared = [], [], 0
    for latent, truth in zip(latents, truths, strict=True):
        try:
            found = pattern_of(decoder(latent[None])[0].double().numpy())
        except PatternError:
            sums["no pattern"] += 1
            continue
        both = [(a, found.panel(a.name)) for a in truth.panels if a.name in {p.name for p in found.panels}]
        alike = [(a, b) for a, b in both if len(a.edges) == len(b.edges)]
        shared += len(both)
        sums["panel_count"] += len(truth.panels) == len(found.panels)
        same = len(truth.panels) == len(both) == len(found.panels)
        sums["panels"] += same
        sums["edge_counts"] += same and len(alike) == len(both)
        sums["stitches"] += set(truth.stitches) == set(found.stitches)
        sums["right_stitches"] += len(set(truth.stitches) & set(found.stitches))
        sums["true_stitches"] += len(truth.stitches)
        sums["found_stitches"] += len(found.stitches)
        sums["edges_right"] += len(alike)
        for a, b in alike:
            own, other = a.vertices - a.vertices.mean(0), b.vertices - b.vertices.mean(0)
            corners.append(float(np.linalg.norm(own - other, axis=1).mean()))
            at_own, at_other = (p.to_world(p.vertices.mean(0)[None])[0] for p in (a, b))
            places.append(float(np.linalg.norm(at_own - at_other)))
    count = max(1, len(truths))
    whole = ("no pattern", "panel_count", "panels", "edge_counts", "stitches")
    shares = {name: round(sums[name] / count, 3) for name in whole}
    both_ways = sums["true_stitches"] + sums["found_stitches"]
    return shares | {
        "patterns": len(truths),
        "panels_with_right_edge_count": round(sums["edges_right"] / max(1, shared), 3),
        "stitch_f1": round(2 * sums["right_stitches"] / max(1, both_ways), 3),
        "corners_off_cm": round(float(np.mean(corners)), 2) if corners else None,
        "places_off_cm": round(float(np.mean(places)), 2) if places else None,
    }


def _turn_alike(rows: Tensor, slots: Tensor) -> None:
    """Gives the quaternions of a slot one sign, as far as that can be: q and -q are one rotation.

    The sign is that of the product with a direction of the slot, which is nowhere near at right angles to
    common rotations.
    """
    turns = rows[..., at.TURN]
    weights = torch.tensor([0.3, 0.6, 0.2, 1.0])
    there = rows[..., at.THERE][..., None]
    sign = torch.where((turns * weights).sum(-1, keepdim=True) < 0, -1.0, 1.0)
    rows[..., at.TURN] = turns * sign * there

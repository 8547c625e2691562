"""Batches of pictures, each time cut, turned and lit otherwise, with what is true of the garments in them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import torch
from torch import Tensor
from torch.nn import functional as F
from torch.utils.data import DataLoader, Dataset

from swifttailor.data.pictures.bank import PictureBank
from swifttailor.data.pictures.blocks import Block, Blocks
from swifttailor.data.pictures.photographs import Photographs
from swifttailor.parameter_reader.placed_designs import PlacedDesigns
from swifttailor.picture_reader.close_designs import sees_designs
from swifttailor.picture_reader.close_ups import WHOLE, sees
from swifttailor.picture_reader.figures import FIGURES
from swifttailor.picture_reader.labels import MASK_STRIDE
from swifttailor.training.picture_config import PictureConfig
from swifttailor.training.picture_pool_torch import PicturePool
from swifttailor.training.picture_truth_torch import Answers, OfEach, TruthTable

_AHEAD = 8
"""Blocks that are in a pool before anything is learnt from it."""


class PictureBatches:
    """Batches of an endless training, each determined by its number."""

    def __init__(
        self,
        bank: PictureBank,
        config: PictureConfig,
        *,
        workers: int = 1,
        part: tuple[int, int] = (0, 1),
        device: torch.device | None = None,
        designs: PlacedDesigns | None = None,
        photographs: Photographs | None = None,
    ) -> None:
        """Prepares to draw.

        Args:
            bank: Garments.
            config: Of the training.
            workers: Processes that draw; 0 draws in this one.
            part: Number of this process among those that train, and how many these are: each draws
                blocks of its own, and has its share of a batch.
            device: Where batches are made, and pictures kept; the processor when None.
            designs: Of the garments, as far as they are known.
            photographs: To take the share of photographs from.
        """
        self.config, self.workers = config, workers
        self._device = device or torch.device("cpu")
        self._rank, self._count = part
        self._size = config.batch_size // self._count
        drawn = config.network.image_size
        self.blocks = Blocks(
            bank,
            seed=config.seed,
            size=drawn,
            count=config.block,
            shares=config.shares,
            close=config.close,
            near=config.near,
            parts=config.parts,
            photographs=photographs,
            cut_out=config.cut_out,
        )
        self.truths = TruthTable(bank, self._device, designs, photographs=photographs)
        self._each = config.block * config.echo // self._size
        self._next, self._loaded = -1, iter(())
        self._block: Block | None = None
        blocks_kept = max(config.pool // (config.block * self._count), 1)
        self._pool = PicturePool(config.block * blocks_kept, self._device) if config.pool else None

    def __getitem__(self, step: int) -> tuple[Tensor, Tensor, Answers]:
        """Of a step pictures (B, 3, size, size), guesses at their cameras (B, 7), and the truth."""
        shown = self._of_a_block(step) if self._pool is None else self._of_the_pool(step, self._pool)
        device, strength = self._device, self.config.variation
        chance = torch.Generator(device).manual_seed(hash((self.config.seed, self._rank, step)) % (1 << 31))
        pictures = shown["pixels"].to(device).permute(0, 3, 1, 2).float() / 255
        masks = shown["masks"].to(device).permute(0, 3, 1, 2).float() / 255
        places = shown["places"].to(device).permute(0, 3, 1, 2).float()
        cells = shown["cells"].to(device)[:, None].float()
        on_cells = torch.cat([places, cells], 1)
        figures, close_up = shown["figures"].to(device), shown["close_up"].to(device)
        views = shown["views"].to(device)
        pictures, masks, on_cells, views = moved(pictures, masks, on_cells, views, chance, strength)
        pictures = relit(pictures, chance, strength)
        guess = guessed(views, figures, close_up, chance, self.config.unguessed)
        near, cosine = shown["close_up"].numpy(), shown["views"][:, 1].numpy()
        garments = shown["garments"].to(device)
        # A close-up tells of one garment alone.
        asymmetric = self.truths.designs.asymmetric[garments.amax(dim=1).clamp_min(0)].cpu().numpy()
        designs = sees_designs(near, cosine, asymmetric, self.truths.designs.names)
        answers = self.truths.answers(
            garments,
            close_up == WHOLE,
            shown["placed"].to(device),
            OfEach(*(torch.from_numpy(table).to(device) for table in sees(near, cosine))),
            torch.from_numpy(designs).to(device),
            views,
            figures,
            masks,
            on_cells[:, :3],
            on_cells[:, 3],
        )
        return pictures, guess, answers

    def _of_a_block(self, step: int) -> dict[str, Tensor]:
        number, place = divmod(step, self._each)
        number = number * self._count + self._rank
        block = self._take(number)
        orders = [
            np.random.default_rng([self.config.seed, 5, number, e]).permutation(self.config.block)
            for e in range(self.config.echo)
        ]
        chosen = np.concatenate(orders)[place * self._size : (place + 1) * self._size]
        return {name: torch.from_numpy(value[chosen]) for name, value in vars(block).items()}

    def _of_the_pool(self, step: int, pool: PicturePool) -> dict[str, Tensor]:
        due = step * self._size // (self.config.block * self.config.echo)
        if not pool.added:  # a training that is resumed begins with an empty pool
            pool.added = due
        while pool.added <= due + _AHEAD:
            pool.add(self._take(pool.added * self._count + self._rank))
        lots = np.random.default_rng([self.config.seed, 6, step, self._rank])
        few = len(pool) < self._size
        return pool.take(lots.choice(len(pool), self._size, replace=few))

    def _take(self, number: int) -> Block:
        if self._block is None or self._next != number + self._count:
            if self._next != number:
                self._loaded = self._load(number)
            self._block, self._next = next(self._loaded), number + self._count
        return self._block

    def _load(self, first: int) -> Iterator[Block]:
        if not self.workers:
            return (self.blocks[k] for k in range(first, 1 << 40, self._count))
        loader = DataLoader(
            _Drawn(self.blocks),
            batch_size=None,
            sampler=range(first, 1 << 40, self._count),
            num_workers=self.workers,
            prefetch_factor=2,
            collate_fn=_as_it_is,
            worker_init_fn=_one_thread,
            multiprocessing_context="spawn",
        )
        return iter(loader)


class _Drawn(Dataset[Block]):
    """Blocks as torch's processes ask for them."""

    def __init__(self, blocks: Blocks) -> None:
        self.blocks = blocks

    def __getitem__(self, index: int) -> Block:
        return self.blocks[index]


def _as_it_is(block: Any) -> Any:
    return block


def _one_thread(_: int) -> None:
    torch.set_num_threads(1)


def moved(
    pictures: Tensor,
    masks: Tensor,
    on_cells: Tensor,
    views: Tensor,
    chance: torch.Generator,
    strength: float,
) -> tuple[Tensor, Tensor, Tensor, Tensor]:
    """The same pictures nearer, farther, aside and tilted, each otherwise; all else goes with them.

    Args:
        pictures: (B, 3, size, size).
        masks: (B, 2, size / 4, size / 4).
        on_cells: (B, n, size / 4, size / 4) what is true of whole cells; NaN comes in from outside.
        views: (B, 6) `labels.VIEW`.
        chance: Decides.
        strength: Factor on how different they are.
    """
    count = len(pictures)

    def lots(*shape: int) -> Tensor:
        return strength * (2 * torch.rand(*shape, generator=chance, device=chance.device) - 1)

    scale = torch.exp(0.18 * lots(count))
    angle = torch.deg2rad(5.0 * lots(count))
    shift = 0.07 * lots(count, 2)
    cosine, sine = torch.cos(angle) / scale, torch.sin(angle) / scale
    # From where in the old picture each point of the new one is taken; both run from -1 to 1.
    turn = torch.stack([torch.stack([cosine, sine], 1), torch.stack([-sine, cosine], 1)], 1)
    at = -(turn @ (2 * shift)[:, :, None])
    theta = torch.cat([turn, at], 2)
    grid = F.affine_grid(theta, list(pictures.shape), align_corners=False)
    pictures = F.grid_sample(pictures, grid, padding_mode="border", align_corners=False)
    coarse = grid[:, MASK_STRIDE // 2 :: MASK_STRIDE, MASK_STRIDE // 2 :: MASK_STRIDE]
    masks = F.grid_sample(masks, coarse, padding_mode="zeros", align_corners=False)
    on_cells = F.grid_sample(on_cells, coarse, mode="nearest", padding_mode="border", align_corners=False)
    outside = (coarse.abs() > 1).any(-1)[:, None]
    on_cells = torch.where(outside, torch.nan, on_cells)
    back = scale[:, None, None] ** 2 * turn.transpose(1, 2)
    views = views.clone()
    views[:, 4:6] = (back @ views[:, 4:6, None])[:, :, 0] + shift
    views[:, 3] += torch.log(scale)
    return pictures, masks, on_cells, views


def guessed(
    views: Tensor, figures: Tensor, close_up: Tensor, chance: torch.Generator, unguessed: float
) -> Tensor:
    """`labels.GUESS` (B, 7) as a first look may have it: about right, far off now and then, or none yet.

    Args:
        views: (B, 6) true ones.
        figures: (B,) number of `FIGURES`; where there is not one, the guess is anything.
        close_up: (B,) number of `CLOSE_UPS`, or `WHOLE`; close-ups are never the first look.
        chance: Decides.
        unguessed: Share without, of those of whole garments.
    """
    count = len(views)
    one = (figures == FIGURES.index("one"))[:, None]
    device = chance.device
    off = torch.randn(count, 1, generator=chance, device=device).abs() * torch.tensor([_OFF], device=device)
    found = torch.where(one, views, torch.tensor([_ANYWHERE], device=device))
    found = found + off * torch.randn(count, 6, generator=chance, device=device)
    lots = torch.rand(count, 1, generator=chance, device=device)
    known = (lots >= unguessed) | (close_up != WHOLE)[:, None]
    return known.float() * torch.cat([found, torch.ones_like(lots)], 1)


_OFF = (0.2, 0.2, 0.1, 0.06, 0.025, 0.03)
"""How far off guesses usually are, in the units of `VIEW`."""
_ANYWHERE = (0.0, 1.0, 0.0, -0.8, 0.0, 0.0)
"""A view where nobody is."""


def relit(pictures: Tensor, chance: torch.Generator, strength: float) -> Tensor:
    """The same pictures (B, 3, h, w) brighter, darker, tinted, greyer, blurred or grainy."""
    count, device = len(pictures), chance.device

    def lots(*shape: int) -> Tensor:
        return strength * (2 * torch.rand(*shape, generator=chance, device=device) - 1)

    def some(share: float) -> Tensor:
        return (torch.rand(count, 1, 1, 1, generator=chance, device=device) < share * strength).float()

    gain = torch.exp(0.25 * lots(count, 1, 1, 1) + 0.08 * lots(count, 3, 1, 1))
    gamma = torch.exp(0.2 * lots(count, 1, 1, 1))
    pictures = (pictures.clamp_min(1e-4) ** gamma) * gain + 0.06 * lots(count, 1, 1, 1)
    pictures = pictures + some(0.08) * (pictures.mean(1, keepdim=True) - pictures)
    pictures = pictures + some(0.2) * (F.avg_pool2d(pictures, 3, 1, 1) - pictures)
    noise = 0.05 * strength * torch.rand(count, 1, 1, 1, generator=chance, device=device) ** 2
    pictures = pictures + noise * torch.randn(pictures.shape, generator=chance, device=device)
    return pictures.clamp(0, 1)

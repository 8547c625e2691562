"""The sum that tells photographs from drawings, on the trunk of worn_heads.zip.

``python scripts/train_photograph_head_torch.py --data SEWN FOLDER...``

The folders have lists of photographs (docs/picture-reader.md), SEWN the splits ``train`` and ``validation``
of a data set of garments: of these, pictures are drawn of people, in studios and of what nobody wears.
The trunk stays as it is; a logistic regression is fitted to what it makes of the photographs that networks
learn from and of as many drawings as --drawn says. Prints how many of those that validate are right, and
writes src/swifttailor/picture_reader/photograph_head.onnx (--out). Needs the extra ``train``.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import nn

from fitted_regressions import fitted
from swifttailor.arrays import Array, Pixels
from swifttailor.cli.item_progress import ItemProgress
from swifttailor.data.pictures.bank import PictureBank
from swifttailor.data.pictures.blocks import Family, draw
from swifttailor.data.pictures.photograph_lists import SPLITS
from swifttailor.data.pictures.photographs import Photographs
from swifttailor.data.pictures.scenes import VIEWS, Wardrobe
from swifttailor.networks.model_file import write_graph
from swifttailor.networks.onnx_export_torch import export_graph
from swifttailor.picture_reader.photograph_head import INPUT, KIND, LEAST_LOGIT, OUTPUT, SHIPPED
from swifttailor.picture_reader.worn_heads import WornHeads, features_of

FAMILIES: tuple[Family, ...] = ("people", "people", "people", "laid", "studio", "people", "people")
HELD_OUT: Family = "held out"
"""Validates in the place of the last."""
SIZES = (256, 400, 640)
RIDGE = 0.1
"""Of 0.1, 0.3 and 1 the best for what validates."""


class Head(nn.Module):
    """Logit of a photograph, of features (1, F)."""

    def __init__(self, weights: Array) -> None:
        super().__init__()
        self.last = nn.Linear(len(weights) - 1, 1)
        told = weights[:, 1] - weights[:, 0]
        self.last.weight.data = torch.tensor(told[None, :-1], dtype=torch.float32)
        self.last.bias.data = torch.tensor(told[-1:], dtype=torch.float32)

    def forward(self, whole: torch.Tensor) -> torch.Tensor:
        """(1, 1)."""
        logit: torch.Tensor = self.last(whole)
        return logit


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("folders", type=Path, nargs="+")
    parser.add_argument("--data", type=Path, required=True, help="garments to draw")
    parser.add_argument("--drawn", type=int, nargs=2, default=(700, 300), help="pictures of either split")
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--out", type=Path, default=SHIPPED)
    options = parser.parse_args()
    torch.set_num_threads(1)
    trunk = WornHeads.load().trunk
    signs, photographs = [], []
    for split, drawn in zip(SPLITS[:2], options.drawn, strict=True):
        listed = Photographs(options.folders, split)
        pictures = drawings(options.data / split, drawn, options.seed, held_out=split != SPLITS[0])
        found = [looked_at(trunk, (one.pixels() for one in listed.photographs), len(listed))]
        found.append(looked_at(trunk, pictures, drawn))
        signs.append(np.concatenate(found))
        photographs.append(np.arange(len(signs[-1])) < len(found[0]))
    weights = fitted(signs[0], np.stack([~photographs[0], photographs[0]], axis=1), RIDGE)
    told = (signs[1] @ weights[:-1] + weights[-1]) @ [-1, 1]
    right = {
        "photographs": round(float((told[photographs[1]] >= LEAST_LOGIT).mean()), 3),
        "drawings": round(float((told[~photographs[1]] < LEAST_LOGIT).mean()), 3),
    }
    example = (torch.rand(1, signs[0].shape[1]),)
    graph = export_graph(Head(weights).eval(), example, ({},), (INPUT,), (OUTPUT,))
    names = " ".join(folder.name for folder in options.folders)
    card: dict[str, Any] = {
        "model": "a logistic regression on the trunk of worn_heads.zip",
        "command": f"python scripts/train_photograph_head_torch.py --data {options.data.name} {names}",
        "photographs_sha256": Photographs(options.folders, SPLITS[0]).checksum(),
        "photographs": int(photographs[0].sum()),
        "drawings": int((~photographs[0]).sum()),
        "seed": options.seed,
        "validation_right": right,
        "ridge": RIDGE,
    }
    write_graph(options.out, KIND, graph, card)
    sys.stdout.write(f"{options.out}: right {right}\n")


def looked_at(trunk: Any, pictures: Iterator[Pixels], count: int) -> NDArray[np.float64]:
    """(n, F) what the trunk makes of all of each picture."""
    signs = []
    with ItemProgress(count, "pictures looked at") as progress:
        for pixels in pictures:
            height, width = pixels.shape[:2]
            side = max(height, width)
            whole = ((width - side) // 2, (height - side) // 2, side)
            signs.append(features_of(trunk, np.ascontiguousarray(pixels), whole))
            progress.add(1)
    return np.array(signs, np.float64)


def drawings(split: Path, count: int, seed: int, *, held_out: bool) -> Iterator[Pixels]:
    """Pictures of garments of a split, each garment, look and size by lot."""
    bank = PictureBank([split])
    bank.prepare(report=print)
    wardrobe = Wardrobe(bank)
    families = (*FAMILIES[:-1], HELD_OUT if held_out else FAMILIES[-1])
    for k in range(count):
        chance = np.random.default_rng([seed, k, count])
        size = int(chance.choice(SIZES))
        number = int(chance.integers(len(bank)))
        yield draw(wardrobe, number, families[k % len(families)], VIEWS[k % len(VIEWS)], chance, size).pixels


if __name__ == "__main__":
    main()

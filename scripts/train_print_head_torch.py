"""The sums that tell prints, on the trunk of worn_heads.zip.

``python scripts/train_print_head_torch.py clothing-dataset [worn/magento2 worn/venia]``

The folders have lists of photographs (docs/picture-reader.md); which prints they show, people have written
down (benchmarks/photographs). The trunk stays as it is; a logistic regression is fitted to what it makes of
squares of cloth, another to that and to what it makes of whole garments. Squares are turned by a quarter as
well, where stripes across run down. Prints how many of those that validate are right, and writes
src/swifttailor/picture_reader/print_head.onnx (--out). Needs the extra ``train``.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import nn

from fitted_regressions import fitted
from swifttailor.arrays import Array
from swifttailor.cli.item_progress import ItemProgress
from swifttailor.data.pictures.photograph_lists import SPLITS
from swifttailor.data.pictures.photographs import Photographs
from swifttailor.evaluation.pictures.prints import KnownPrints, known_prints
from swifttailor.networks.model_file import write_graph
from swifttailor.networks.onnx_export_torch import export_graph
from swifttailor.picture_reader.cut_square import cut_square
from swifttailor.picture_reader.print_head import (
    INPUTS,
    KIND,
    OUTPUTS,
    PRINTS,
    SHIPPED,
    alone,
    square_of_cloth,
)
from swifttailor.picture_reader.reader import PictureReader
from swifttailor.picture_reader.squares import scaled
from swifttailor.picture_reader.worn_heads import SIZE, WornHeads, features_of
from swifttailor.tailor.looking import SeenPicture, parts_seen

RIDGE = 0.03
"""Of 0.01, 0.03, 0.1 and 0.3 as good as any for the photographs that validate; for each way of looking."""
SIDES = (1.0, 0.7, 1.25)
"""Of the squares of cloth that are learnt from, in that which is looked at."""
PRINTS_KNOWN = Path(__file__).parents[1] / "benchmarks" / "photographs" / "prints.csv"
TURNED = {"across": "down", "down": "across"}


class Head(nn.Module):
    """Logits of prints, of the features of cloth (1, F), and of both cloth and garment."""

    def __init__(self, near: Array, both: Array) -> None:
        super().__init__()
        self.near, self.both = (nn.Linear(len(one) - 1, len(PRINTS)) for one in (near, both))
        for last, one in ((self.near, near), (self.both, both)):
            last.weight.data = torch.tensor(one[:-1].T, dtype=torch.float32)
            last.bias.data = torch.tensor(one[-1], dtype=torch.float32)

    def forward(self, cloth: torch.Tensor, garment: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor]:
        """(1, prints) each."""
        return self.near(cloth), self.both(torch.cat([cloth, garment], 1))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("folders", type=Path, nargs="+")
    parser.add_argument("--prints", type=Path, default=PRINTS_KNOWN)
    parser.add_argument("--out", type=Path, default=SHIPPED)
    options = parser.parse_args()
    torch.set_num_threads(1)
    learnt, held = (looked_at(options.folders, split, known_prints(options.prints)) for split in SPLITS[:2])
    near, both = regressions(*learnt)
    cloth, garment, words = held
    asked = np.stack([cloth[:, 0], garment], axis=1)
    said = [told(asked[:, 0], near), told(asked.reshape(len(asked), -1), both)]
    right = accepted(words)[np.arange(len(words)), (said[0] + said[1]).argmax(axis=1)]
    example = tuple(torch.rand(1, cloth.shape[-1]) for _ in INPUTS)
    graph = export_graph(Head(near, both).eval(), example, ({}, {}), INPUTS, OUTPUTS)
    names = " ".join(folder.name for folder in options.folders)
    counts = {name: sum(name in some for some in learnt[2]) for name in PRINTS}
    card: dict[str, Any] = {
        "model": "two logistic regressions on the trunk of worn_heads.zip",
        "command": f"python scripts/train_print_head_torch.py {names}",
        "photographs": counts,
        "validation_right": round(float(right.mean()), 3),
        "ridge": RIDGE,
    }
    write_graph(options.out, KIND, graph, card)
    sys.stdout.write(f"{options.out}: of {counts}; right {right.mean():.3f} of {len(right)}\n")


def looked_at(
    folders: list[Path], split: str, known: KnownPrints
) -> tuple[Array, Array, list[tuple[str, ...]]]:
    """Features of cloth (n, looks, F) and of garments (n, F), and which prints each may have.

    Looks: each of `SIDES`, as it is and mirrored, then the same turned by a quarter.
    """
    trunk, reader = WornHeads.load().trunk, PictureReader.load()
    cloths, garments, words = [], [], []
    photographs = [one for one in Photographs(folders, split).photographs if one.main]
    with ItemProgress(len(photographs), "photographs looked at") as progress:
        for one in photographs:
            progress.add(1)
            if not any(name == one.path.stem for name, _ in known):
                continue
            pixels = one.pixels()
            read = reader.read(pixels)
            for name in parts_seen([SeenPicture(pixels, read)])[: 2 if one.is_worn else 1]:
                part = next(each for each in read.parts if each.part == name)
                some, square = known.get((one.path.stem, name)), square_of_cloth(part.mask)
                if some and square is not None:
                    cloths.append(looks(trunk, pixels, square))
                    shown = alone(pixels, part.mask)
                    garments.append(features_of(trunk, shown, (0, 0, SIZE), mirrored=False))
                    words.append(some)
    return np.array(cloths, np.float64), np.array(garments, np.float64), words


def looks(trunk: Any, pixels: NDArray[np.uint8], square: tuple[int, int, int]) -> Array:
    """(looks, F) of a square of cloth, see `looked_at`."""
    shown = [cut_square(pixels, scaled(square, side), SIZE) for side in SIDES]
    shown += [one[:, ::-1] for one in shown]
    shown += [np.rot90(one) for one in shown]
    whole = (0, 0, SIZE)
    return np.array([features_of(trunk, np.ascontiguousarray(one), whole, mirrored=False) for one in shown])


def regressions(cloth: Array, garment: Array, words: list[tuple[str, ...]]) -> tuple[Array, Array]:
    """Weights (F + 1, prints) of what cloth tells, and (2 F + 1, prints) of what both tell."""
    count = cloth.shape[1]
    turned = [tuple(TURNED.get(name, name) for name in some) for some in words]
    as_is, as_turned = accepted(words), accepted(turned)
    each = [as_is if k < count // 2 else as_turned for k in range(count)]
    near = fitted(np.concatenate(list(cloth.swapaxes(0, 1))), np.concatenate(each), RIDGE * count)
    straight = range(count // 2)
    pairs = np.concatenate([np.column_stack([cloth[:, k], garment]) for k in straight])
    return near, fitted(pairs, np.concatenate([as_is for _ in straight]), RIDGE * len(straight))


def told(signs: Array, weights: Array) -> Array:
    """(n, prints) logarithms of shares."""
    logits = signs @ weights[:-1] + weights[-1]
    found: Array = logits - np.logaddexp.reduce(logits, axis=1, keepdims=True)
    return found


def accepted(words: list[tuple[str, ...]]) -> NDArray[np.bool_]:
    """(n, prints) which may be true."""
    return np.array([[name in some for name in PRINTS] for some in words])


if __name__ == "__main__":
    main()

"""The sums that tell what clothes are that nobody wears, on the trunk of worn_heads.zip.

``python scripts/train_laid_heads_torch.py clothing-dataset``

The folder has a list of photographs of which the kind is known (docs/picture-reader.md). The trunk stays as
it is; of each question a logistic regression is fitted to what it makes of the photographs that networks
learn from. Prints how many of those that validate are right, and writes
src/swifttailor/picture_reader/laid_heads.onnx (--out). Needs the extra ``train``.
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
from swifttailor.data.pictures.photograph_labels import KINDS, PhotographKind
from swifttailor.data.pictures.photograph_lists import SPLITS
from swifttailor.data.pictures.photographs import Photographs
from swifttailor.networks.model_file import write_graph
from swifttailor.networks.onnx_export_torch import export_graph
from swifttailor.picture_reader.labels import PARTS, statement_labels
from swifttailor.picture_reader.laid_heads import ASKED, KIND, NAME, PART, SHIPPED, VIEWS
from swifttailor.picture_reader.squares import scaled
from swifttailor.picture_reader.worn_heads import COLLARED, WornHeads, features_of

NAME_OF = {id(kind): name for name, kind in KINDS.items()}
COLLAR, TURNED_DOWN = "collar", "lapel"
RIDGE = 0.1
"""Of 0.1, 0.3 and 1 the best for the photographs that validate."""


class Heads(nn.Module):
    """Logits of the words of each question, of the features of two views."""

    def __init__(self, weights: dict[str, Array]) -> None:
        super().__init__()
        self.last = nn.ModuleList()
        for one in weights.values():
            last = nn.Linear(one.shape[0] - 1, one.shape[1])
            last.weight.data = torch.tensor(one[:-1].T, dtype=torch.float32)
            last.bias.data = torch.tensor(one[-1], dtype=torch.float32)
            self.last.append(last)

    def forward(self, whole: torch.Tensor, inner: torch.Tensor) -> tuple[torch.Tensor, ...]:
        """(1, words) each of features (1, F) each."""
        both = torch.cat([whole, inner], 1)
        return tuple(last(both) for last in self.last)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("folders", type=Path, nargs="+")
    parser.add_argument("--out", type=Path, default=SHIPPED)
    options = parser.parse_args()
    torch.set_num_threads(1)
    learnt, validating = (Photographs(options.folders, split) for split in SPLITS[:2])
    signs, kinds = looked_at(learnt)
    held_signs, held_kinds = looked_at(validating)
    words = {name: words_of(name) for name in ASKED}
    weights, counts, right = {}, {}, {}
    for name in ASKED:
        known, accepted = known_of(kinds, name, words[name])
        weights[name] = fitted(signs[known], accepted, RIDGE)
        if (
            name == COLLAR
        ):  # as if half of all clothes had one: how many have is known to the network that reads
            weights[name][-1] -= np.log(accepted.mean(axis=0))
        counts[name] = int(known.sum())
        known, accepted = known_of(held_kinds, name, words[name])
        said = (held_signs[known] @ weights[name][:-1] + weights[name][-1]).argmax(axis=1)
        right[name] = round(float(accepted[np.arange(len(said)), said].mean()), 3)
    example = tuple(torch.rand(1, signs.shape[1] // len(VIEWS)) for _ in VIEWS)
    graph = export_graph(Heads(weights).eval(), example, ({}, {}), tuple(VIEWS), tuple(ASKED))
    card: dict[str, Any] = {
        "model": "a logistic regression for each question, on the trunk of worn_heads.zip",
        "command": "python scripts/train_laid_heads_torch.py clothing-dataset",
        "photographs_sha256": learnt.checksum(),
        "photographs": counts,
        "validation_right": right,
        "ridge": RIDGE,
        "words": words,
    }
    write_graph(options.out, KIND, graph, card)
    sys.stdout.write(f"{options.out}: {options.out.stat().st_size / 1e3:.0f} kB, {counts}; right {right}\n")


def looked_at(photographs: Photographs) -> tuple[Array, list[PhotographKind]]:
    """(n, 2 F) what the trunk makes of photographs of clothes, and what is known of each."""
    trunk = WornHeads.load().trunk
    some = [one for one in photographs.photographs if one.main is not None and not one.is_worn]
    signs, kinds = [], []
    with ItemProgress(len(some), "photographs looked at") as progress:
        for one in some:
            pixels = one.pixels()
            height, width = pixels.shape[:2]
            side = max(height, width)
            whole = ((width - side) // 2, (height - side) // 2, side)
            views = [features_of(trunk, pixels, scaled(whole, scale)) for scale in VIEWS.values()]
            signs.append(np.concatenate(views).astype(np.float64))
            kinds += [kind for kind in (one.main,) if kind is not None]
            progress.add(1)
    return np.array(signs), kinds


def words_of(name: str) -> tuple[str, ...]:
    """What is told of a question."""
    which = ASKED[name]
    if name == NAME:
        return tuple(KINDS)
    if name == PART or which is None:
        return PARTS
    if name == COLLAR:
        return "none", COLLARED
    return tuple(word for claim, word in statement_labels() if claim == which[1])


def known_of(
    kinds: list[PhotographKind], name: str, words: tuple[str, ...]
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """(n,) of which photographs an answer is known, and of those (k, words) which words may be true."""
    which, accepted = ASKED[name], []
    for kind in kinds:
        if which is None:
            accepted.append([word in (kind.part, NAME_OF[id(kind)]) for word in words])
            continue
        part, claim = which
        # What they are outweighs what they may be: shorts are taken for no trousers.
        true = set(kind.are.get(claim, ()) or kind.may_be.get(claim, ()))
        if name == COLLAR and true:  # what is seldom turned down has hardly any
            true = {COLLARED if TURNED_DOWN in true else "none"}
        here = kind.part == PARTS[part]
        accepted.append([here and word in true for word in words])
    told = np.array(accepted)
    known = told.any(axis=1) & ~told.all(axis=1)
    return known, told[known]


if __name__ == "__main__":
    main()

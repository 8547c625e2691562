"""From trained weights to the model file that is used without torch.

Import this module in the function that needs it: it loads torch and transformers.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import torch
from torch import Tensor, nn

from swifttailor.errors import InputError
from swifttailor.networks.onnx_export_torch import export_graph
from swifttailor.networks.text_tokenizer import TextTokenizer
from swifttailor.networks.trained_weights_torch import trained_network
from swifttailor.pattern_maker.asking.foresight import PANEL_NUMBERS
from swifttailor.pattern_maker.asking.prompt import OWN_TOKENS
from swifttailor.pattern_maker.network.building_torch import build_network
from swifttailor.pattern_maker.network.decoder_torch import CachedDecoder
from swifttailor.pattern_maker.network.model_file import network_of, write_model
from swifttailor.pattern_maker.network.network_torch import PatternMakerNetwork
from swifttailor.pattern_maker.network.runtime import Runtime, signature
from swifttailor.pattern_maker.tokens.vocabulary import MOVE, NUMBERS, SIZE

_STEPS = 6


def load_weights(
    weights: Path, card: dict[str, Any], text_size: int, *, half: bool = False
) -> PatternMakerNetwork:
    """A trained network.

    Args:
        weights: weights.safetensors of a run.
        card: Its card.
        text_size: Tokens of text.
        half: Whether its weights are rounded to what float16 holds.

    Raises:
        InputError: The file is missing, damaged, or of another network.
    """
    return trained_network(lambda: build_network(network_of(card), text_size), weights, half=half)


def export(weights: Path, card: dict[str, Any], path: Path, *, half: bool = False) -> Path:
    """Writes the model file of a run.

    Args:
        weights: weights.safetensors of the run.
        card: Its card, which goes into the file.
        path: File to write, ``.zip``.
        half: Whether to round the weights to float16, which halves the file.

    Raises:
        InputError: The weights cannot be used or the file not be written.
        MissingExtraError: onnx or onnxscript is not installed.
    """
    if card.get("config", {}).get("network", {}).get("pretrained"):
        raise InputError(
            "A network that began with a pretrained InternVL is run by torch; there is no model file of it."
        )
    text = TextTokenizer.shipped()
    network = load_weights(weights, card, text.size, half=half)
    return write_model(path, make_graphs(network), text, card)


def make_graphs(network: PatternMakerNetwork) -> dict[str, bytes]:
    """The parts of a network as ONNX graphs, by their names in `GRAPHS`.

    Raises:
        MissingExtraError: onnx or onnxscript is not installed.
    """
    network = network.eval()
    decoder, hidden = CachedDecoder(network).eval(), network.hidden_size
    side = network.image_size
    rows, new, old = (
        torch.export.Dim(n, min=1, max=m) for n, m in (("rows", 4096), ("new", 8192), ("old", 8192))
    )
    cache = torch.zeros(len(decoder.layers), 2, decoder.groups, 5, decoder.size)
    given: dict[str, tuple[nn.Module, tuple[Tensor, ...], tuple[Any, ...]]] = {
        "vision": (_Vision(network), (torch.zeros(2, 3, side, side),), ({0: rows},)),
        "embed": (
            _Embed(network),
            (torch.full((2, 3), network.text_size + MOVE), torch.zeros(2, 3, NUMBERS)),
            ({0: rows, 1: new}, {0: rows, 1: new}),
        ),
        "decoder": (
            decoder,
            (
                torch.zeros(2, 3, hidden),
                torch.zeros(2, 3, dtype=torch.int64),
                torch.ones(2, 8),
                cache,
                cache.clone(),
            ),
            (
                {0: rows, 1: new},
                {0: rows, 1: new},
                {0: rows, 1: torch.export.Dim.DYNAMIC},
                {1: rows, 3: old},
                {1: rows, 3: old},
            ),
        ),
        "regress": (
            _Method(network.regress),
            (torch.zeros(2, hidden), torch.full((2,), MOVE)),
            ({0: rows}, {0: rows}),
        ),
    }
    if network.copying:
        given["counterpart"] = (_Method(network.embed_counterparts), *given["embed"][1:])
        given["leaning"] = (_Method(network.lean), (torch.zeros(2, hidden),), ({0: rows},))
    if network.planning:
        given["plan"] = (_Plan(network), (torch.zeros(2, hidden),), ({0: rows},))
        given["planned"] = (_Method(network.embed_planned), *given["embed"][1:])
        given["trust"] = (_Method(network.trust), (torch.zeros(2, hidden),), ({0: rows},))
        given["panels"] = (network.panel_in, (torch.zeros(2, PANEL_NUMBERS),), ({0: rows},))
    return {
        name: export_graph(module, example, shapes, *signature(name, planning=network.planning))
        for name, (module, example, shapes) in given.items()
    }


def compare(first: Runtime, second: Runtime, text_size: int, *, image_size: int, seed: int = 0) -> float:
    """Largest difference between what two runtimes make of the same random input, relative to its size.

    Both are given the same tokens and numbers: what each would write by itself may part for a rounding error.
    """
    chance = np.random.default_rng(seed)
    pictures = chance.normal(size=(2, 3, image_size, image_size)).astype(np.float32)
    tokens = chance.integers(text_size + OWN_TOKENS, size=(2, 9))
    numbers = chance.normal(size=(2, 9, NUMBERS)).astype(np.float32)
    known = np.ones((2, 9), np.float32)
    known[1, 6:] = 0
    results = []
    for runtime in (first, second):
        found = [runtime.look(pictures), runtime.embed(tokens, numbers)]
        if first.plans and second.plans:
            found.append(runtime.foresee(found[1], known))
        _, logits, cache = runtime.decode(found[1], known, runtime.empty_cache(2))
        found.append(logits * known[..., None])
        for step in range(_STEPS):
            one = runtime.embed(tokens[:, step : step + 1], numbers[:, step : step + 1])
            states, logits, cache = runtime.decode(one, np.ones((2, 1), np.float32), cache)
            found += [states, logits, runtime.regress(states[:, 0], np.array([MOVE, MOVE + 1 + step % 8]))]
            if first.copies and second.copies:
                own = np.clip(tokens[:, step : step + 1] - text_size, 0, SIZE - 1)
                found.append(runtime.embed_counterparts(own, numbers[:, step : step + 1]))
                found.append(runtime.lean(states[:, 0]))
                if first.plans and second.plans:
                    found.append(runtime.embed_planned(own, numbers[:, step : step + 1]))
                    found.append(runtime.trust(states[:, 0]))
                    found.append(runtime.embed_panels(np.resize(numbers, (2, PANEL_NUMBERS))))
        results.append(found)
    return max(float(np.abs(a - b).max() / max(np.abs(a).max(), 1e-6)) for a, b in zip(*results, strict=True))


class _Method(nn.Module):
    """A network of which one method is called."""

    def __init__(self, method: Any) -> None:
        super().__init__()
        self.network, self.forward = method.__self__, method


class _Vision(nn.Module):
    def __init__(self, network: PatternMakerNetwork) -> None:
        super().__init__()
        self.vlm = network.vlm

    def forward(self, pictures: Tensor) -> Tensor:
        return self.vlm.get_image_features(pictures).pooler_output


class _Embed(nn.Module):
    """`PatternMakerNetwork.embed` without pictures, and without choosing rows, which graphs are slow at."""

    def __init__(self, network: PatternMakerNetwork) -> None:
        super().__init__()
        self.text, self.network = network.vlm.get_input_embeddings(), network

    def forward(self, tokens: Tensor, numbers: Tensor) -> Tensor:
        own = tokens - self.network.text_size
        text = self.text(tokens.clamp(max=self.network.text_size - 1))
        embedded = torch.where((own < 0)[..., None], text, self.network.own_embedding(own.clamp(min=0)))
        carries = self.network.carries_numbers(own)[..., None]
        return embedded + torch.where(carries, self.network.embed_numbers(own, numbers), 0.0)


class _Plan(nn.Module):
    def __init__(self, network: PatternMakerNetwork) -> None:
        super().__init__()
        self.head = network.foresight_head

    def forward(self, early: Tensor) -> Tensor:
        return self.head(early)

"""From trained weights to the model file of a wish reader. Import this where it is needed: it loads torch."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

import numpy as np
import torch

from swifttailor.errors import InputError
from swifttailor.networks.model_file import write_graph
from swifttailor.networks.onnx_export_torch import export_graph
from swifttailor.networks.text_tokenizer import TextTokenizer
from swifttailor.networks.trained_weights_torch import trained_network
from swifttailor.wishes.labels import number_labels, statement_labels
from swifttailor.wishes.network_torch import ReaderConfig, WishNetwork
from swifttailor.wishes.reader import INPUTS, KIND, OUTPUTS, SPOKEN_INPUTS, SPOKEN_KIND, WishReader
from swifttailor.wishes.text_tokens import EXTRA_TOKENS, PADDING
from swifttailor.wishes.word_vectors import SIZE

_EXAMPLE_TOKENS = 7
assert PADDING == EXTRA_TOKENS - 1, "padding is the last token"


def build_network(size: dict[str, Any]) -> WishNetwork:
    """A network with random weights for the tokens and labels of this version.

    Args:
        size: Width, layers, heads, dropout, and whether it is told what words are like.
    """
    tokens = TextTokenizer.shipped().size + EXTRA_TOKENS
    return WishNetwork(ReaderConfig(tokens, len(statement_labels()), len(number_labels()), **size))


def labels_checksum() -> str:
    """Of the labels that the outputs of a network stand for, in their order."""
    return hashlib.sha256(json.dumps([statement_labels(), number_labels()]).encode()).hexdigest()


def load_weights(weights: Path, card: dict[str, Any], *, half: bool = False) -> WishNetwork:
    """A trained network.

    Args:
        weights: weights.safetensors of a run.
        card: Its card.
        half: Whether its weights are rounded to what float16 holds.

    Raises:
        InputError: The file is missing, damaged, or of another network.
    """
    if card.get("labels_sha256") != labels_checksum():
        raise InputError(
            f"The weights '{weights}' were trained for other statements than this version's. Export them "
            "with the version that trained them, or train again."
        )
    return trained_network(lambda: build_network(card["config"]["network"]), weights, half=half)


def export(network: WishNetwork, card: dict[str, Any], path: Path) -> Path:
    """Writes the model file, which `WishReader.load` opens.

    Args:
        network: Trained.
        card: What it was trained on and how good it is.
        path: File to write, ``.onnx``.

    Raises:
        InputError: The file cannot be written.
        MissingExtraError: onnx or onnxscript is not installed.
    """
    length = torch.export.Dim("length", min=2, max=network.places.num_embeddings)
    tokens, meanings = (
        torch.zeros(1, _EXAMPLE_TOKENS, dtype=torch.long),
        torch.zeros(1, _EXAMPLE_TOKENS, SIZE),
    )
    kind, inputs = (SPOKEN_KIND, SPOKEN_INPUTS) if network.config.meanings else (KIND, INPUTS)
    example = (tokens, meanings)[: len(inputs)]
    graph = export_graph(network.eval(), example, ({1: length},) * len(inputs), inputs, OUTPUTS)
    says = {"tokens": network.config.tokens, "statements": statement_labels(), "numbers": number_labels()}
    return write_graph(path, kind, graph, card, **says)


def compare(reader: WishReader, network: WishNetwork, *, seed: int = 0) -> float:
    """Largest difference between what a reader and a network make of the same random tokens and vectors."""
    chance, apart = np.random.default_rng(seed), 0.0
    for length in (2, _EXAMPLE_TOKENS, network.places.num_embeddings):
        tokens = chance.integers(network.config.tokens - 1, size=(1, length))
        given = {"tokens": tokens}
        if network.config.meanings:
            given["meanings"] = chance.standard_normal((1, length, SIZE), dtype=np.float32)
        found = reader.session.run(None, given)
        with torch.no_grad():
            made = network(*map(torch.from_numpy, given.values()))
        differences = (np.abs(f - m.numpy()).max() for f, m in zip(found, made, strict=True))
        apart = max(apart, *map(float, differences))
    return apart

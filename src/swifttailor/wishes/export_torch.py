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
from swifttailor.networks.word_pieces import WordPieces
from swifttailor.wishes.labels import number_labels, statement_labels
from swifttailor.wishes.network_torch import ReaderConfig, WishNetwork
from swifttailor.wishes.reader import INPUTS, KIND, OUTPUTS, SPOKEN_KIND, WishReader
from swifttailor.wishes.spoken_network_torch import SpokenNetwork
from swifttailor.wishes.text.text_tokens import EXTRA_TOKENS, PADDING, Tokenizer

_EXAMPLE_TOKENS = 7
assert PADDING == EXTRA_TOKENS - 1, "padding is the last token"
_OWN, _MINILM = "own", "minilm"


def build_network(size: dict[str, Any]) -> WishNetwork | SpokenNetwork:
    """A network with random weights for the tokens and labels of this version.

    Args:
        size: Width, layers, heads and dropout, and which encoder: ``own`` or ``minilm``.
    """
    size = dict(size)
    encoder = size.pop("encoder", _OWN)
    tokens = tokenizer_of(encoder).size + EXTRA_TOKENS
    config = ReaderConfig(tokens, len(statement_labels()), len(number_labels()), **size)
    return SpokenNetwork(config) if encoder == _MINILM else WishNetwork(config)


def tokenizer_of(encoder: str) -> Tokenizer:
    """What makes the tokens that an encoder reads."""
    return WordPieces.shipped() if encoder == _MINILM else TextTokenizer.shipped()


def labels_checksum() -> str:
    """Of the labels that the outputs of a network stand for, in their order."""
    return hashlib.sha256(json.dumps([statement_labels(), number_labels()]).encode()).hexdigest()


def load_weights(
    weights: Path, card: dict[str, Any], *, half: bool = False, int8: bool = False
) -> WishNetwork | SpokenNetwork:
    """A trained network.

    Args:
        weights: weights.safetensors of a run.
        card: Its card.
        half: Whether its weights are rounded to what float16 holds.
        int8: Whether its matrices are rounded to what bytes hold.

    Raises:
        InputError: The file is missing, damaged, or of another network.
    """
    if card.get("labels_sha256") != labels_checksum():
        raise InputError(
            f"The weights '{weights}' were trained for other statements than this version's. Export them "
            "with the version that trained them, or train again."
        )
    return trained_network(
        lambda: build_network(card["config"]["network"]), weights, half=half, eight_bits=int8
    )


def export(
    network: WishNetwork | SpokenNetwork, card: dict[str, Any], path: Path, *, int8: bool = False
) -> Path:
    """Writes the model file, which `WishReader.load` opens.

    Args:
        network: Trained.
        card: What it was trained on and how good it is.
        path: File to write, ``.onnx``.
        int8: Whether it computes with its matrices, rounded to what bytes hold, in 8 bits.

    Raises:
        InputError: The file cannot be written.
        MissingExtraError: onnx or onnxscript is not installed.
    """
    length = torch.export.Dim("length", min=2, max=network.places.num_embeddings)
    example = (torch.zeros(1, _EXAMPLE_TOKENS, dtype=torch.long),)
    kind = SPOKEN_KIND if isinstance(network, SpokenNetwork) else KIND
    graph = export_graph(network.eval(), example, ({1: length},), INPUTS, OUTPUTS, row_products=int8)
    says = {"tokens": network.config.tokens, "statements": statement_labels(), "numbers": number_labels()}
    return write_graph(path, kind, graph, card, **says)


def compare(
    reader: WishReader, network: WishNetwork | SpokenNetwork, *, seed: int = 0
) -> tuple[float, float]:
    """Largest difference between what a reader and a network make of the same tokens; the largest logit."""
    chance, apart, reach = np.random.default_rng(seed), 0.0, 0.0
    for length in (2, _EXAMPLE_TOKENS, network.places.num_embeddings):
        tokens = chance.integers(network.config.tokens - 1, size=(1, length))
        found = reader.session.run(None, {"tokens": tokens})
        with torch.no_grad():
            made = network(torch.from_numpy(tokens))
        differences = (np.abs(f - m.numpy()).max() for f, m in zip(found, made, strict=True))
        apart = max(apart, *map(float, differences))
        reach = max(reach, *(float(m.abs().max()) for m in made))
    return apart, reach

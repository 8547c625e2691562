"""From trained weights to the model file of a picture reader. Import where needed: it loads torch."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray

from swifttailor.errors import InputError
from swifttailor.networks.model_file import write_graph
from swifttailor.networks.onnx_export_torch import export_graph
from swifttailor.networks.trained_weights_torch import trained_network
from swifttailor.picture_reader.close_ups import ALL_PARTS, CLOSE_UPS
from swifttailor.picture_reader.labels import GUESS, labels_checksum, statement_labels
from swifttailor.picture_reader.network_torch import EyesConfig, EyesNetwork
from swifttailor.picture_reader.panel_kinds import PANEL_KINDS
from swifttailor.picture_reader.reader import DESIGNS, INPUTS, KIND, OUTPUTS, PictureReader
from swifttailor.picture_reader.seen_design import IN_CARD, NEAR_IN_CARD


def build_network(size: dict[str, Any]) -> EyesNetwork:
    """A network with random weights for the labels of this version.

    Args:
        size: Fields of `EyesConfig`.
    """
    fields: dict[str, Any] = {k: tuple(v) if isinstance(v, list) else v for k, v in size.items()}
    return EyesNetwork(EyesConfig(**fields))


def load_weights(
    weights: Path, card: dict[str, Any], *, half: bool = False, eight_bits: bool = False
) -> EyesNetwork:
    """A trained network.

    Args:
        weights: weights.safetensors of a run.
        card: Its card.
        half: Whether its weights are rounded to what float16 holds.
        eight_bits: Whether its matrices are rounded to what bytes hold.

    Raises:
        InputError: The file is missing, damaged, or of another network.
    """
    if card.get("labels_sha256") != labels_checksum():
        raise InputError(
            f"The weights '{weights}' were trained for other statements than this version's. Export them "
            "with the version that trained them, or train again."
        )
    return trained_network(
        lambda: build_network(card["config"]["network"]), weights, half=half, eight_bits=eight_bits
    )


def export(
    network: EyesNetwork,
    card: dict[str, Any],
    path: Path,
    scales: NDArray[Any] | None = None,
    close_ups: Sequence[str] | None = None,
) -> Path:
    """Writes the model file, which `PictureReader.load` opens.

    Args:
        network: Trained.
        card: What it was trained on and how good it is.
        path: File to write, ``.onnx``.
        scales: (S, 2), see `PictureReader.scales`; as the network says it when None.
        close_ups: What it is to look at from near: see `CloseUp.part`; all it has learnt
            from when None.

    Raises:
        InputError: The file cannot be written, or the network has not learnt from such close-ups.
        MissingExtraError: onnx or onnxscript is not installed.
    """
    size = network.config.image_size
    example = torch.zeros(1, 3, size, size), torch.zeros(1, len(GUESS))
    names = outputs_of(network)
    graph = export_graph(network.eval(), example, (None, None), INPUTS, names)
    if scales is None:
        scales = np.tile(np.array([1.0, 0.0]), (len(statement_labels()), 1))
    said = [[round(float(v), 4) for v in row] for row in scales]
    config = card.get("config", {})
    parts = config.get("parts", ALL_PARTS) if config.get("close") else ()
    learnt = [c for c in CLOSE_UPS if c.part in parts]
    known = sorted({c.part for c in learnt})
    for word in close_ups or ():
        if word not in known:
            accepted = ", ".join(known) or "none: it was trained without"
            raise InputError(f"It has learnt from no close-ups '{word}'; accepted: {accepted}.")
    looked_at = [c.name for c in learnt if close_ups is None or c.part in close_ups]
    return write_graph(
        path,
        KIND,
        graph,
        {name: value for name, value in card.items() if name != IN_CARD},
        labels_sha256=labels_checksum(),
        panel_kinds=PANEL_KINDS,
        close_ups=looked_at,
        scales=said,
        parameters=card.get(IN_CARD, []),
        near_designs=bool(card.get(NEAR_IN_CARD, False)),
    )


def compare(reader: PictureReader, network: EyesNetwork, *, seed: int = 0) -> float:
    """Largest difference between what a reader and a network make of the same random picture."""
    size = network.config.image_size
    chance = np.random.default_rng(seed)
    picture, guess = chance.random((1, 3, size, size), np.float32), chance.random((1, 7), np.float32)
    found = reader.session.run(list(outputs_of(network)), {"pictures": picture, "guess": guess})
    with torch.no_grad():
        made = network.eval()(torch.from_numpy(picture), torch.from_numpy(guess))
    return max(float(np.abs(f - m.numpy()).max()) for f, m in zip(found, made, strict=True))


def outputs_of(network: EyesNetwork) -> tuple[str, ...]:
    """Names of what a network says: designs only if it reads them."""
    return (*OUTPUTS, DESIGNS) if network.config.design_values else OUTPUTS

"""From trained weights to the model file that is used without torch, or to a model that torch runs."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import torch

from swifttailor.arrays import Singles
from swifttailor.errors import InputError
from swifttailor.garment_sewer.conditioning import Conditioning
from swifttailor.garment_sewer.model_file import EIGHT_BIT, INPUTS, KIND, OUTPUTS, SewerModel
from swifttailor.garment_sewer.network_config import NetworkConfig
from swifttailor.garment_sewer.network_torch import SewerNetwork, build_network
from swifttailor.networks.model_file import write_graph
from swifttailor.networks.onnx_export_torch import export_graph
from swifttailor.networks.trained_weights_torch import trained_network


def load_weights(weights: Path, card: dict[str, Any], *, half: bool = False) -> SewerNetwork:
    """A trained network.

    Args:
        weights: weights.safetensors of a run.
        card: Its card.
        half: Whether its weights are rounded to what float16 holds.

    Raises:
        InputError: The file is missing, damaged, or of another network.
    """
    conditioning, config = _shape(card)
    return trained_network(lambda: build_network(config, conditioning.count), weights, half=half)


def torch_model(
    weights: Path, card: dict[str, Any], *, half: bool = False, precision: torch.dtype = torch.float32
) -> SewerModel:
    """A network that torch runs, on a GPU where there is one.

    Args:
        weights: weights.safetensors of a run.
        card: Its card.
        half: Whether its weights are rounded to what float16 holds.
        precision: That it computes in.

    Raises:
        InputError: See `load_weights`.
    """
    conditioning, config = _shape(card)
    device = torch.device("cuda" if torch.cuda.is_available() else "cpu")
    network = load_weights(weights, card, half=half).to(device)

    @torch.inference_mode()
    def predict(conditioning: Singles, occupancy: Singles, prior: Singles) -> Singles:
        given = (torch.as_tensor(a, device=device) for a in (conditioning, occupancy, prior))
        with torch.autocast(device.type, precision, enabled=precision != torch.float32):
            return network(*given).cpu().numpy()

    return SewerModel(predict, conditioning, config.resolution, config.patch_size, card)


def export(
    weights: Path, card: dict[str, Any], path: Path, *, half: bool = False, int8: bool = False
) -> Path:
    """Writes the model file.

    Args:
        weights: weights.safetensors of a run.
        card: Its card, which goes into the file.
        path: File to write, ``.onnx``.
        half: Whether to round the weights to float16, which halves the file.
        int8: Whether the transformer's products are of 8 bits, which is faster.

    Raises:
        InputError: The weights cannot be used or the file not be written.
        MissingExtraError: onnx or onnxscript is not installed.
    """
    network = load_weights(weights, card, half=half)
    config: Any = network.config  # transformers says of its numbers that they may be missing or pairs
    size, channels = config.image_size, config.num_channels
    example = (
        torch.zeros(2, channels, size, size),
        torch.ones(2, 1, size, size),
        torch.zeros(2, 3, size, size),
    )
    batch = torch.export.Dim("batch", min=1, max=4096)
    patch = config.patch_size
    height, width = (patch * torch.export.Dim(name, min=2, max=256) for name in ("rows", "columns"))
    shape = {0: batch, 2: height, 3: width}
    graph = export_graph(network, example, (shape, shape, shape), INPUTS, OUTPUTS, int8=int8)
    return write_graph(path, KIND, graph, card, **({"products": EIGHT_BIT} if int8 else {}))


def read_card(run: Path) -> dict[str, Any]:
    """The card of a run.

    Raises:
        InputError: It is missing or damaged.
    """
    try:
        card = json.loads((run / "card.json").read_text(encoding="utf-8"))
        _shape(card)
    except (OSError, ValueError, KeyError, TypeError, RecursionError) as error:
        raise InputError(f"'{run}' holds no card.json of a trained GarmentSewer: {error}.") from error
    return card


def _shape(card: dict[str, Any]) -> tuple[Conditioning, NetworkConfig]:
    config = card["config"]
    network = dict(config["network"])
    for name in ("decoder_sizes", "convolutions"):
        network[name] = tuple(network.get(name, ()))
    network["pretrained"] = ""
    return Conditioning.of_card(card), NetworkConfig(**network)


@dataclass(frozen=True)
class Comparison:
    """Two models, asked the same."""

    apart_cm: float
    """Largest difference between their predictions."""
    reach_cm: float
    """Largest prediction, measured from the prior where there is one."""


def compare(first: SewerModel, second: SewerModel, *, seed: int = 0) -> Comparison:
    """Compares what two models predict for the same random images, which are unlike any garment."""
    chance = np.random.default_rng(seed)
    size = first.resolution
    given = [
        chance.normal(size=(2, n, size, size)).astype(np.float32) for n in (first.conditioning.count, 1, 3)
    ]
    given[1] = (given[1] > 0).astype(np.float32)
    one, other = first.network(*given), second.network(*given)
    return Comparison(float(np.abs(one - other).max()), float(np.abs(other - given[2]).max()))

"""The file of a trained GarmentSewer: an ONNX graph, with what it must be shown written inside."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from swifttailor.arrays import Singles
from swifttailor.garment_sewer.conditioning import Conditioning
from swifttailor.networks.model_file import GRAPH, ModelKind, open_model

INPUTS = ("conditioning", "occupancy", "prior")
OUTPUTS = ("positions",)
KIND = ModelKind("GarmentSewer", "swifttailor garment-sewer 1", 2**31, ({GRAPH: (INPUTS, OUTPUTS)},))
EIGHT_BIT = "int8"
"""What the file says of its ``products`` where they are of 8 bits."""


class Network(Protocol):
    """What predicts, whichever library runs it."""

    def __call__(self, conditioning: Singles, occupancy: Singles, prior: Singles) -> Singles:
        """Positions (B, 3, H, W) in cm, of (B, C, H, W), (B, 1, H, W) and (B, 3, H, W)."""
        ...


@dataclass(frozen=True, eq=False)
class SewerModel:
    """A network ready to run, and how it wants to be asked."""

    network: Network
    conditioning: Conditioning
    resolution: int
    """Pixels along each side that it was trained at."""
    patch_size: int
    """Divides the sizes that it can be given."""
    card: dict[str, Any]
    """What it was trained on and how good it is."""


def load_model(path: Path | str, *, threads: int = 1) -> SewerModel:
    """Opens a model file with onnxruntime.

    Args:
        path: File that ``swifttailor train export`` has written.
        threads: Processor cores to run on.

    Raises:
        InputError: It is missing, damaged, or another kind of file.
    """
    model = open_model(path, KIND, threads=threads)
    with model.says("what it must be shown"):
        card = model.about["card"]
        conditioning, shape = Conditioning.of_card(card), card["config"]["network"]
        resolution, patch = int(shape["resolution"]), int(shape["patch_size"])
    model.require({"the channels": (model.shape_given(GRAPH, INPUTS[0])[1], conditioning.count)})
    session = model.sessions[GRAPH]
    # With 8 bits a garment must not be rounded by the range of others; one by one takes no longer on a CPU.
    together = 1 if model.about.get("products") == EIGHT_BIT else None

    def predict(conditioning: Singles, occupancy: Singles, prior: Singles) -> Singles:
        given = dict(zip(INPUTS, (conditioning, occupancy, prior), strict=True))
        count = len(conditioning)
        parts = [
            session.run(None, {name: images[k : k + (together or count)] for name, images in given.items()})[
                0
            ]
            for k in range(0, count, together or count)
        ]
        return np.concatenate(parts) if len(parts) > 1 else parts[0]

    return SewerModel(predict, conditioning, resolution, patch, card)

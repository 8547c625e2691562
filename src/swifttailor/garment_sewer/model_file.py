"""The file of a trained network: ONNX, with what it must be shown written inside."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from swifttailor.arrays import Singles
from swifttailor.errors import InputError
from swifttailor.garment_sewer.conditioning import Conditioning
from swifttailor.networks.onnx_session import open_session

FORMAT = "swifttailor garment-sewer 1"
CARD_KEY = "swifttailor"
INPUTS = ("conditioning", "occupancy", "prior")
MAX_BYTES = 2**31


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


def model_card(card: dict[str, Any], *, int8: bool = False) -> str:
    """The card of a run as it is written into a model file.

    Args:
        card: Of the run.
        int8: Whether products are of 8 bits.
    """
    about = {"format": FORMAT, "card": card} | ({"products": "int8"} if int8 else {})
    return json.dumps(about, separators=(",", ":"), allow_nan=False)


def load_model(path: Path | str, *, threads: int = 1) -> SewerModel:
    """Opens a model file with onnxruntime.

    Args:
        path: File that ``swifttailor train garment-sewer`` or its export has written.
        threads: Processor cores to run on.

    Raises:
        InputError: It is missing, damaged, or another kind of file.
    """
    path = Path(path)
    try:
        if path.stat().st_size > MAX_BYTES:
            raise InputError(f"'{path}' is larger than 2 GB; a GarmentSewer's file is smaller.")
        data = path.read_bytes()
    except OSError as error:
        raise InputError(f"Cannot read the weights '{path}': {error.strerror or error}.") from error
    session = open_session(data, str(path), "GarmentSewer", threads=threads)
    about = _about(session, path)
    inputs = [i.name for i in session.get_inputs()]
    if inputs != list(INPUTS):
        raise InputError(
            f"'{path}' is another network: it takes {', '.join(inputs)}, not {', '.join(INPUTS)}."
        )
    try:
        config = about["card"]["config"]
        conditioning = Conditioning(
            config["conditioning"]["prior"], tuple(config["conditioning"]["channels"])
        )
        resolution, patch = int(config["network"]["resolution"]), int(config["network"]["patch_size"])
    except (KeyError, TypeError, ValueError) as error:
        raise InputError(f"'{path}' does not say what it must be shown: {error!r} is missing.") from error
    channels = session.get_inputs()[0].shape[1]
    if channels != conditioning.count:
        raise InputError(
            f"'{path}' contradicts itself: the network takes {channels} channels, its card says "
            f"{conditioning.count}."
        )

    # With 8 bits a garment must not be rounded by the range of others; one by one takes no longer on a CPU.
    together = 1 if about.get("products") == "int8" else None

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

    return SewerModel(predict, conditioning, resolution, patch, about["card"])


def _about(session: Any, path: Path) -> dict[str, Any]:
    text = session.get_modelmeta().custom_metadata_map.get(CARD_KEY, "")
    try:
        about = json.loads(text)
        known = about["format"]
    except (ValueError, KeyError, TypeError):
        known = None
    if known != FORMAT:
        raise InputError(
            f"'{path}' is a network, but no GarmentSewer of this version ({known or 'nothing'} instead of "
            f"'{FORMAT}'). Export it again with this version."
        )
    return about
